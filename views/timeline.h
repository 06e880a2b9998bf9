// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "views/hit_columns.h"

#include <QAbstractSlider>

namespace cradle {

/// The bar of the whole recording: shows the moment and the hits, and goes to any moment by
/// mouse or keys. Its value is the index of the frame shown.
class Timeline final : public QAbstractSlider
{
    Q_OBJECT
public:
    /// A moment that somebody else points at.
    struct Mark {
        enum class Kind {
            Failure, ///< of a check
            Error    ///< of the program, which stopped there
        };

        double time = 0.0; ///< s
        Kind kind = Kind::Failure;
        QString label;

        friend bool operator==(const Mark &, const Mark &) = default;
    };
    /// A text below the bar.
    struct Label {
        QRectF rect; ///< px
        QString text;
        QColor colour;
    };

    explicit Timeline(Simulation &simulation, QWidget *parent = nullptr);

    void setMarks(std::vector<Mark> marks);
    [[nodiscard]] const std::vector<Mark> &marks() const { return m_marks; }
    /// Those of them that the run has reached, and where its program stopped.
    [[nodiscard]] std::vector<Mark> recordedMarks() const;

    [[nodiscard]] double xOf(double time) const;     ///< px
    [[nodiscard]] double timeAt(double x) const;     ///< s, within the recording
    [[nodiscard]] std::vector<Label> labels() const; ///< none covers another

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

public slots:
    void seekPreviousHit();
    void seekFollowingHit(); ///< among the recorded ones

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void showFrame();
    void seekTo(double x);
    void seekHit(const Encounter &hit);
    void retranslate();
    void addEndLabels(std::vector<Label> &labels) const;
    void addMarkLabels(std::vector<Label> &labels) const;
    [[nodiscard]] std::optional<std::size_t> shownHit() const; ///< the last one so far
    void addShownHitLabel(std::vector<Label> &labels, const std::vector<HitColumn> &all) const;
    void addHitLabels(std::vector<Label> &labels, const std::vector<HitColumn> &all) const;
    void addLabel(std::vector<Label> &labels, double x, const QString &text,
                  const QColor &colour) const;
    void addHitLabel(std::vector<Label> &labels, const HitColumn &column) const;
    void drawHits(QPainter &painter, const std::vector<HitColumn> &columns) const;
    void drawContacts(QPainter &painter) const;
    void drawMarks(QPainter &painter) const;
    [[nodiscard]] std::vector<Label> labelsAt(const std::vector<HitColumn> &columns) const;
    /// Whether more than \p part of the columns of the bar have hits.
    [[nodiscard]] bool isFuller(const std::vector<HitColumn> &columns, double part) const;
    [[nodiscard]] QRectF bar() const;
    [[nodiscard]] QFont fontOf(const QString &text) const;
    [[nodiscard]] std::vector<HitColumn> columns() const;

    Simulation &m_simulation;
    std::vector<Mark> m_marks;
    bool m_following = false; ///< the value follows the simulation, not the other way round
};

} // namespace cradle
