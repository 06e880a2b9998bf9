// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace cradle {

/// The languages that the application speaks, by code ("en", "de"): English first. Found as
/// cradle_CODE.qm among the resources and in the folder "translations" of the user's data.
QStringList languages();

/// The name of a language in itself ("Deutsch").
QString languageName(const QString &code);

/// The language in force.
QString currentLanguage();

/// Speaks \p code from now on; an empty or unknown one is the system's language, or English.
/// Widgets get QEvent::LanguageChange.
void setLanguage(const QString &code);

} // namespace cradle
