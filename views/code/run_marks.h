// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// What QScintilla needs to show Arabic or Hebrew in a program: it takes the place behind the last
/// letter of a text for the width of that text. Behind words from the right that is their left end,
/// so a comment of such words alone was never drawn. Isolated, and with a mark from the left behind
/// them (U+2067 … U+2069 U+200E, which nobody sees), they have their width, and are read from the
/// right. The marks are the editor's: no file and no program has them.
[[nodiscard]] bool needsRunMarks(const QString &text);

/// Whether what follows \p before stands within marks that are there already.
[[nodiscard]] bool isWithinRunMarks(const QString &before);

/// \p program with marks round all words that go from the right, and nowhere else.
[[nodiscard]] QString withRunMarks(const QString &program);
[[nodiscard]] QString withoutRunMarks(QString program);

} // namespace cradle
