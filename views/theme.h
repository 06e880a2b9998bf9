// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>

class QWidget;

namespace cradle {

/// What a colour stands for; it means the same thing in scene, charts, tables and text.
/// Those called text below, and accent, success and warning, can be read (4.5 : 1) on window,
/// panel, scene and accentSoft; warning and text also on warningSoft; onAccent on accent and
/// success.
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
    QColor onAccent;      ///< text on accent or success
    QColor controlBorder; ///< frames of buttons and fields: 3 : 1, as square, along and the like
    QColor hover;         ///< behind what the pointer is on
    bool dark = false;
    double textContrast = 4.5;  ///< at least, of text: WCAG 2.1, 1.4.3
    double shapeContrast = 3.0; ///< at least, of what carries meaning: WCAG 2.1, 1.4.11

    static const Theme &lightTheme();
    static const Theme &darkTheme();
    /// Black on white, text 7 : 1 and shapes 4.5 : 1; for low vision and for projectors.
    static const Theme &highContrastTheme();
};

/// The user's choice in View.
enum class ThemeChoice { System, Light, Dark, HighContrast };

/// The theme in force; widgets read it anew at QEvent::PaletteChange.
const Theme &theme();

/// Sets style, palette, fonts and style sheet of the application. System means dark if the
/// palette that the desktop gave at the start is dark.
void applyTheme(ThemeChoice choice);

/// How large texts are, as a part of their usual size: 1 to 2.
void setTextScale(double scale);
double textScale();
/// \p pixels, a length that goes with the size of texts (a row, a small font), at that size.
int scaledByText(int pixels);

/// The palette of \p theme for QApplication.
QPalette paletteOf(const Theme &theme);

/// Figures that stand still: one width for all digits, the size of the application's text.
QFont numericFont();

/// Code and files that are edited: no two signs become one.
QFont codeFont();

/// Section headings: small, spaced, upper case.
QFont headingFont();

/// How the style sheet dresses a widget: a button as "primary", "success" or "link", a label as
/// "heading", "muted", "warning", "warningTitle", "success" or "successTitle", a frame as "card" or
/// "warningCard".
void setKind(QWidget *widget, const char *kind);

/// The contrast of two opaque colours by WCAG 2.1, from 1 to 21.
double contrast(const QColor &a, const QColor &b);

/// \p colour, darkened or lightened just so far that text in it can be read on \p background.
QColor readableOn(const QColor &colour, const QColor &background);

/// The same for a line or a shape that carries meaning.
QColor visibleOn(const QColor &colour, const QColor &background);

/// The colour of circle \p index where its preset names none that can be told apart, and the
/// dash that goes with it: lines differ by dash as well as by colour.
QColor circleColour(const QString &presetColour);
Qt::PenStyle circleDash(int index);

} // namespace cradle
