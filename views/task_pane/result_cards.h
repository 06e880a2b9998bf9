// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"

#include <QString>

QT_BEGIN_NAMESPACE
class QVBoxLayout;
QT_END_NAMESPACE

namespace cradle {

class FormulaRenderer;

/// A text of a lab about a program: its first line, and the rest, which is CommonMark.
struct HeadedText {
    QString headline;
    QString body;
};
[[nodiscard]] HeadedText splitHeadline(const QString &markdown);

/// Puts a frame with a headline into \p column.
/// \param kind  "warningCard" for what went wrong, "card" for a word on the way
/// \return the layout of the frame, to put more below
QVBoxLayout *addCard(QVBoxLayout *column, const char *kind, const QString &headline);

/// Adds a text of the lab: CommonMark with formulas.
void addMarkdown(QVBoxLayout *column, const HeadedText &text, FormulaRenderer *renderer);

/// Of a program that stopped: what, and "Line 12, in step 40, at 0.65 s: why".
[[nodiscard]] HeadedText describeError(const ProgramError &error);

} // namespace cradle
