// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointF>
#include <QTimer>
#include <QWidget>

#include <deque>

namespace cradle {

/// Lies over a window while it is shown to many: draws where the pointer went as a trail that
/// fades, or makes all of it black. It takes neither clicks nor keys.
class PresentationLayer final : public QWidget
{
    Q_OBJECT
public:
    /// \param window  its parent, which it covers
    explicit PresentationLayer(QWidget *window);

    void setBlack(bool black);
    [[nodiscard]] bool isBlack() const { return m_black; }
    [[nodiscard]] std::size_t trailLength() const { return m_trail.size(); } ///< points

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    struct Point {
        QPointF place; ///< px
        qint64 time;   ///< ms
    };

    void forget();

    std::deque<Point> m_trail;
    QElapsedTimer m_clock;
    QTimer m_fading;
    bool m_black = false;
};

} // namespace cradle
