// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

#include <vector>

namespace cradle {

/// The steps of a lab as a row of dots: filled with a tick for passed, ringed for the one that is
/// open. A click opens a step; Left and Right go along the row, Return opens.
class StepDots final : public QWidget
{
    Q_OBJECT
public:
    explicit StepDots(QWidget *parent = nullptr);

    /// \param current  −1: none
    void setSteps(const QStringList &titles, const std::vector<bool> &passed, int current);
    /// Where the dot of a step is, px.
    [[nodiscard]] QRectF dotRect(int step) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void stepChosen(int step);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    [[nodiscard]] int stepAt(QPointF place) const; ///< −1: none
    [[nodiscard]] int count() const { return static_cast<int>(m_titles.size()); }
    [[nodiscard]] QString textOf(int step) const;
    void mark(int step);
    void describe();

    QStringList m_titles;
    std::vector<bool> m_passed;
    int m_current = -1;
    int m_marked = -1; ///< by the pointer or the keys
};

} // namespace cradle
