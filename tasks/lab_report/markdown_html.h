// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <functional>

namespace cradle {

/// Writes a formula as HTML; an empty answer makes it plain text.
using FormulaHtml = std::function<QString(const QString &tex, bool display)>;

/// A student's Markdown as HTML: headings, lists, fenced code, paragraphs, emphasis, code; formulas
/// as \p formula writes them. All else is text: no links, pictures or tags come out of it, so that
/// a page from anybody's notes loads and runs nothing.
[[nodiscard]] QString markdownHtml(const QString &markdown, const FormulaHtml &formula = {});

} // namespace cradle
