// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"

#include <QLocale>

namespace cradle {

/// "Deutsch (de)": a language in its own words, with its code.
[[nodiscard]] inline QString languageWithCode(const QString &code)
{
    const QString name = code == QLatin1String("en") ? QStringLiteral("English")
                                                     : QLocale(code).nativeLanguageName();
    return QStringLiteral("%1 (%2)").arg(name, code);
}

/// The languages that a lab has texts in, its own first, and those that Cradle speaks.
[[nodiscard]] inline QStringList offeredLanguages(const LabFiles &files)
{
    QStringList codes = languagesOf(files);
    for (const QString &code :
         {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("fr"), QStringLiteral("ar")}) {
        if (!codes.contains(code))
            codes.append(code);
    }
    return codes;
}

} // namespace cradle
