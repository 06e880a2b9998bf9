// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

QT_BEGIN_NAMESPACE
class QAbstractButton;
class QString;
class QVBoxLayout;
QT_END_NAMESPACE

namespace cradle {

/// Puts \p button, still without words, into \p column with \p text beside it: a button does not
/// break lines, so that a label shows them. A click on the label is one on the button.
void addAnswerRow(QVBoxLayout *column, QAbstractButton *button, const QString &text);

} // namespace cradle
