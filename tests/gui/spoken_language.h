// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/language.h"
#include "tests/gui/pseudo_language.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>

namespace cradle {

inline const QString pseudoLanguage = QStringLiteral("pseudo");

/// The language that the program speaks for a while, also the one of nobody.
class SpokenLanguage
{
public:
    SpokenLanguage() = default;
    ~SpokenLanguage()
    {
        QCoreApplication::removeTranslator(&m_pseudo);
        setLanguage(QStringLiteral("en"));
        QGuiApplication::setLayoutDirection(Qt::LeftToRight);
    }
    SpokenLanguage(const SpokenLanguage &) = delete;
    SpokenLanguage &operator=(const SpokenLanguage &) = delete;

    /// \param choose  has the program speak a language that there is
    template <typename Choose>
    void speak(const QString &language, Choose choose)
    {
        if (language == m_language)
            return;
        m_language = language;
        QCoreApplication::removeTranslator(&m_pseudo);
        const bool isPseudo = language == pseudoLanguage;
        const QString spoken = isPseudo ? QStringLiteral("en") : language;
        choose(spoken);
        if (isPseudo)
            QCoreApplication::installTranslator(&m_pseudo);
        QCoreApplication::processEvents();
        // Also where Qt's own translations are missing, which tell it the direction.
        QGuiApplication::setLayoutDirection(QLocale(spoken).textDirection());
    }

private:
    PseudoLanguage m_pseudo;
    QString m_language = QStringLiteral("en");
};

} // namespace cradle
