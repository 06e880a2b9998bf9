// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// The parts that the pages of a class have in common. The pages need nothing but themselves: no
/// script, no network, light and dark as the reader's system is, and light on paper.

/// A text of anybody as HTML: a name or a program cannot be taken for elements, and a direction of
/// writing in it ends with it.
[[nodiscard]] QString escaped(const QString &text);
/// The same for a name, of which nobody knows the direction of writing.
[[nodiscard]] QString escapedName(const QString &name);

/// From the doctype to the opening of the body. \param style  what the page adds to the common one
[[nodiscard]] QString pageStart(const QString &title, const QString &language,
                                const QString &style);
[[nodiscard]] QString pageEnd(const QString &footer);

[[nodiscard]] QString heading(const QString &text);
/// \param kind  a class of the page's style; none if empty
[[nodiscard]] QString paragraph(const QString &text, const char *kind = "");
/// Points, days or a count as the language of the page writes them.
[[nodiscard]] QString countText(double value);

/// A part of a program around \p line (from 1), which is marked; nothing if it has no such line.
[[nodiscard]] QString codeAround(const QString &program, int line, int context = 3);

/// What a message says below its headline; CommonMark.
[[nodiscard]] QString belowHeadline(const QString &message);

/// A word about how something stands, in a colour and with a sign of its own.
enum class Tone { Good, Open, Trouble, Quiet };
[[nodiscard]] QString badge(const QString &text, Tone tone);

} // namespace cradle
