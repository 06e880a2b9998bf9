// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/spoken.h"

#include "app/language.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QLocale>

namespace cradle::cli {

namespace {

struct SpokenText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

} // namespace

QString languageFault(const QString &code)
{
    if (code.isEmpty() || languages().contains(code))
        return {};
    return SpokenText::tr("--language %1: one of %2 is right")
        .arg(code, languages().join(QLatin1String(", ")));
}

void speak(const QString &code)
{
    const bool english = code.isEmpty() || code == QLatin1String("en");
    setLanguage(english ? QStringLiteral("en") : code);
    QLocale::setDefault(english ? QLocale::c() : spokenLocale(code));
}

} // namespace cradle::cli
