// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// \p text as it is set in a pane: a unit breaks neither from its number nor inside, a vector
/// not between its numbers, and a minus before a number is a minus sign.
QString withUnits(QString text);

/// \p message as a sentence: as of withUnits(), and with a full stop unless it ends a sentence.
QString asSentence(const QString &message);

} // namespace cradle
