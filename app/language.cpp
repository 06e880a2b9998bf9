// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <memory>
#include <vector>

namespace cradle {

namespace {

QString inForce = QStringLiteral("en");
std::vector<std::unique_ptr<QTranslator>> installed;

void install(const QString &name, const QString &folder)
{
    auto translator = std::make_unique<QTranslator>();
    if (translator->load(name, folder) && QCoreApplication::installTranslator(translator.get()))
        installed.push_back(std::move(translator));
}

} // namespace

QStringList languages()
{
    return {QStringLiteral("en"), QStringLiteral("de")};
}

QString languageName(const QString &code)
{
    return code == QLatin1String("de") ? QStringLiteral("Deutsch") : QStringLiteral("English");
}

QString currentLanguage()
{
    return inForce;
}

void setLanguage(const QString &code)
{
    QString wanted = code;
    if (!languages().contains(wanted))
        wanted = QLocale::system().name().left(2);
    if (!languages().contains(wanted))
        wanted = QStringLiteral("en");
    installed.clear(); // A translator that is destroyed removes itself from the application.
    inForce = wanted;
    install(QStringLiteral("cradle_") + wanted, QStringLiteral(":/translations"));
    install(QStringLiteral("qtbase_") + wanted, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

} // namespace cradle
