// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct PartedText {
    Q_DECLARE_TR_FUNCTIONS(Lists)
};

} // namespace

QLocale spokenLocale(const QString &language)
{
    const QLocale usual(language);
    if (usual.zeroDigit() == QLatin1String("0"))
        return usual;
    const QList<QLocale> all =
        QLocale::matchingLocales(usual.language(), QLocale::AnyScript, QLocale::AnyTerritory);
    for (const QLocale &locale : all) {
        if (locale.zeroDigit() == QLatin1String("0") && locale.decimalPoint() == QLatin1String("."))
            return locale;
    }
    return usual;
}

QString spokenList(const QStringList &things)
{
    //: between the things of a list
    return things.join(PartedText::tr(", "));
}

QString directionAttribute(const QString &language)
{
    return QLocale(language).textDirection() == Qt::RightToLeft ? QStringLiteral(" dir=\"rtl\"")
                                                                : QString();
}

} // namespace cradle
