// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QStandardPaths>
#include <QTranslator>

#include <memory>
#include <vector>

namespace cradle {

namespace {

QString inForce = QStringLiteral("en");
std::vector<std::unique_ptr<QTranslator>> installed;

const QString sourceLanguage = QStringLiteral("en");

/// The key that Qt names otherwise than the texts here and the keyboards of some languages do.
[[maybe_unused]] constexpr const char *returnKey = QT_TRANSLATE_NOOP("QShortcut", "Return");

/// Where languages are found: those that are shipped, and those that somebody has added.
QStringList folders()
{
    return QStringList(QStringLiteral(":/translations"))
           + QStandardPaths::locateAll(QStandardPaths::AppDataLocation,
                                       QStringLiteral("translations"),
                                       QStandardPaths::LocateDirectory);
}

void install(const QString &name, const QString &folder)
{
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(name, folder) || !QCoreApplication::installTranslator(translator.get()))
        return;
    installed.push_back(std::move(translator));
}

} // namespace

QStringList languages()
{
    QStringList codes;
    const QString prefix = QStringLiteral("cradle_");
    for (const QString &folder : folders()) {
        for (const QString &file : QDir(folder).entryList({prefix + QStringLiteral("*.qm")}))
            codes.append(file.mid(prefix.size()).chopped(3));
    }
    codes.removeDuplicates();
    codes.removeAll(sourceLanguage);
    codes.sort();
    codes.prepend(sourceLanguage);
    return codes;
}

QString languageName(const QString &code)
{
    const QLocale locale(code);
    // Not "American English": there is one English.
    QString name = code == sourceLanguage ? QStringLiteral("English") : locale.nativeLanguageName();
    if (name.isEmpty())
        return code;
    name[0] = name[0].toUpper();
    return name;
}

QString currentLanguage()
{
    return inForce;
}

void setLanguage(const QString &code)
{
    QString wanted = code;
    const QStringList known = languages();
    if (!known.contains(wanted))
        wanted = QLocale::system().name().left(2);
    if (!known.contains(wanted))
        wanted = sourceLanguage;
    installed.clear(); // A translator that is destroyed removes itself from the application.
    inForce = wanted;
    install(QStringLiteral("qtbase_") + wanted, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    for (const QString &folder : folders())
        install(QStringLiteral("cradle_") + wanted, folder);
}

} // namespace cradle
