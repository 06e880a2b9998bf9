// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

namespace cradle {

/// How numbers and dates are written in a language, with the digits 0 to 9 that programs, charts
/// and values have. \param language  a code such as ar
[[nodiscard]] QLocale spokenLocale(const QString &language);

/// Words or numbers one after the other, as the language that is spoken parts them.
[[nodiscard]] QString spokenList(const QStringList &things);

/// What the html element of a page needs: ` dir="rtl"` where one reads from the right, else
/// nothing. \param language  a code such as ar
[[nodiscard]] QString directionAttribute(const QString &language);

} // namespace cradle
