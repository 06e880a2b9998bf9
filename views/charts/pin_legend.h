// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace cradle {

/// Lines that tell what the pale curves of a chart are: a dash as they are drawn, and what the run
/// that goes on does otherwise.
class PinLegend final : public QWidget
{
    Q_OBJECT
public:
    struct Line {
        QString text;
        QString details; ///< all of it, where the text has no room
        Qt::PenStyle dash = Qt::DashLine;

        friend bool operator==(const Line &, const Line &) = default;
    };

    explicit PinLegend(QWidget *parent = nullptr);

    /// Hidden without any.
    void setLines(const std::vector<Line> &lines);
    [[nodiscard]] const std::vector<Line> &lines() const { return m_lines; }
    /// Draws them at \p rect, for pictures.
    void paint(QPainter &painter, const QRectF &rect) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    std::vector<Line> m_lines;
};

} // namespace cradle
