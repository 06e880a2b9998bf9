// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

QT_BEGIN_NAMESPACE
class QComboBox;
QT_END_NAMESPACE

namespace cradle {

/// Writes \p texts as the items of \p box, which keeps what is chosen and what its items hold; the
/// least width of the box is that of the new texts.
void setItemTexts(QComboBox &box, const QStringList &texts);

} // namespace cradle
