// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>

namespace cradle {

/// The name of a control as it is read. Where letters have no mnemonics, one stands behind the
/// text: "مساعدة (&H)".
[[nodiscard]] inline QString withoutMnemonic(QString text)
{
    static const QRegularExpression behind(QStringLiteral(" ?\\(&\\w\\)"));
    return text.remove(behind).remove(QLatin1Char('&'));
}

} // namespace cradle
