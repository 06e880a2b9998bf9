// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

#include <utility>

namespace cradle {

/// Longer by a third, accented and bracketed, places for numbers kept.
class PseudoLanguage final : public QTranslator
{
public:
    QString translate(const char *, const char *source, const char *, int) const override
    {
        const QString text = QString::fromUtf8(source);
        if (text.startsWith(QLatin1String(":/")))
            return text; // the name of a file
        QString accented = text;
        const std::pair<char16_t, char16_t> accents[] = {
            {u'a', u'á'}, {u'e', u'é'}, {u'i', u'í'}, {u'o', u'ó'}, {u'u', u'ú'}};
        for (const auto &[plain, accent] : accents)
            accented.replace(QChar(plain), QChar(accent));
        QString longer(text.size() / 3, QChar(u'~'));
        for (qsizetype i = 8; i < longer.size(); i += 8)
            longer[i] = QLatin1Char(' '); // words, which can be wrapped
        return QStringLiteral("[%1%2]").arg(accented, longer);
    }
    bool isEmpty() const override { return false; }
};

} // namespace cradle
