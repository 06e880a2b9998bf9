// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace cradle {

/// What a colour stands for; it means the same thing in scene, charts, tables and text.
struct Theme {
    QColor window;     ///< behind the panes
    QColor panel;      ///< panes, tables, charts
    QColor border;     ///< hairlines between panes
    QColor text;       ///< also the sum of all circles in charts
    QColor mutedText;  ///< captions, units, axis labels
    QColor accent;     ///< selection, Run, links
    QColor accentSoft; ///< behind a selected row
    QColor scene;      ///< behind the circles
    QColor grid;       ///< lines of the scene's and the charts' grids
    QColor square;     ///< the walls
    QColor along;      ///< the part along the normal
    QColor across;     ///< the part across it
    QColor kinetic;    ///< kinetic energy of all
    QColor potential;
    QColor dissipated;
    QColor success;       ///< passed
    QColor warning;       ///< failed: text
    QColor warningSoft;   ///< failed: background
    QColor warningBorder; ///< failed: frame
    bool dark = false;

    static const Theme &lightTheme();
    static const Theme &darkTheme();
};

/// The user's choice in View.
enum class ThemeChoice { System, Light, Dark };

/// The theme in force; widgets read it anew at QEvent::PaletteChange.
const Theme &theme();

/// Sets style, palette, fonts and style sheet of the application.
void applyTheme(ThemeChoice choice);

/// The colour of circle \p index where its preset names none that can be told apart, and the
/// dash that goes with it: lines differ by dash as well as by colour.
QColor circleColour(const QString &presetColour);
Qt::PenStyle circleDash(int index);

} // namespace cradle
