// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QObject>
#include <QStringList>

class QTabBar;

namespace cradle {

/// Keeps the titles of tabs whole: where there is no room for all of them they stand nearer to each
/// other, and then are written smaller, though never smaller than at the usual size of texts. What
/// has no room even so is scrolled.
class FittedTabs final : public QObject
{
    Q_OBJECT
public:
    enum class Distance { Usual, Narrow };

    /// Goes with \p bar.
    /// \param distance  of the titles where there is room
    explicit FittedTabs(QTabBar &bar, Distance distance = Distance::Usual);

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// What the look of the titles follows from.
    struct Grounds {
        QStringList titles;
        int room = 0; ///< px
        QFont font;   ///< of a bar with room enough

        friend bool operator==(const Grounds &, const Grounds &) = default;
    };

    [[nodiscard]] int room() const; ///< px
    [[nodiscard]] Grounds grounds() const;
    [[nodiscard]] static int widthOf(const QStringList &titles, const QFont &font);
    void fit();

    QTabBar &m_bar;
    Distance m_distance;
    Grounds m_fitted;
    bool m_fitting = false;
};

} // namespace cradle
