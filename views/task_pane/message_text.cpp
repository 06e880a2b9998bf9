// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/message_text.h"

#include <QRegularExpression>

namespace cradle {

QString withUnits(QString text)
{
    // What a minus follows in "1-2" or "well-known" makes it a hyphen.
    static const QRegularExpression minus(QStringLiteral("(?<![\\w)-])-(?=\\.?\\d)"));
    static const QRegularExpression unit(QStringLiteral(
        "(?<=[\\d)]) (kg m/s|kg m²/s|kg|kg/m³|m/s²|m/s|mm|cm|m|ms|s|J|N|%|px)(?![\\w/²³])"));
    static const QRegularExpression product(QStringLiteral("\\bkg m(?=\\W|$)"));
    static const QRegularExpression over(QStringLiteral("\\b(m²?|g)/(s|cm)"));
    static const QRegularExpression vector(
        QStringLiteral("(?<=\\()(−?[\\d.]+(?:e[-−+]?\\d+)?), (?=−?[\\d.]+(?:e[-−+]?\\d+)?\\))"));
    text.replace(minus, QStringLiteral("−"));
    text.replace(vector, QStringLiteral("\\1,\u00a0"));
    text.replace(unit, QStringLiteral("\u00a0\\1"));
    text.replace(product, QStringLiteral("kg\u00a0m"));
    text.replace(over, QStringLiteral("\\1\u2060/\u2060\\2")); // word joiners
    return text;
}

QString asSentence(const QString &message)
{
    const QString text = withUnits(message.trimmed());
    static const QString ends = QStringLiteral(".!?…");
    return text.isEmpty() || ends.contains(text.back()) ? text : text + QLatin1Char('.');
}

} // namespace cradle
