// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/bound_units.h"

#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>

#include <map>

namespace cradle {

namespace {

const QString space = QStringLiteral("\u00a0");
const QString slash = QStringLiteral("\u2060/\u2060"); // between word joiners

/// What to put in the place of single characters of \p text, by their place.
std::map<qsizetype, QString> bindings(const QString &text)
{
    static const QRegularExpression unit(QStringLiteral(
        "(?<=[\\d)])( )(?:kg( )m(/)s|kg(/)m³|kg( )m|kg|g(/)cm³|m(/)s²|m(/)s|N( )s|J(/)kg|"
        "mm|cm|m|ms|s|J|N|%)(?![\\w/²³])"));
    static const QRegularExpression lonely(QStringLiteral("\\bm(/)s²?(?!\\w)"));
    static const QRegularExpression vector(
        QStringLiteral("\\([−-]?\\d[\\d.]*,( )[−-]?\\d[\\d.]*\\)"));
    std::map<qsizetype, QString> found;
    for (const QRegularExpression &pattern : {unit, lonely, vector}) {
        for (auto matches = pattern.globalMatch(text); matches.hasNext();) {
            const QRegularExpressionMatch match = matches.next();
            for (int group = 1; group <= match.lastCapturedIndex(); ++group) {
                if (match.capturedLength(group) == 1)
                    found[match.capturedStart(group)] =
                        match.captured(group) == QLatin1String("/") ? slash : space;
            }
        }
    }
    return found;
}

} // namespace

void bindUnits(QTextDocument *document)
{
    QTextCursor cursor(document);
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        const QTextBlockFormat kind = block.blockFormat();
        if (kind.hasProperty(QTextFormat::BlockCodeFence)
            || kind.hasProperty(QTextFormat::BlockCodeLanguage))
            continue;
        const std::map<qsizetype, QString> found = bindings(block.text());
        // From the last to the first, so that the places before stay right.
        for (auto it = found.rbegin(); it != found.rend(); ++it) {
            cursor.setPosition(block.position() + static_cast<int>(it->first));
            cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor);
            const QTextCharFormat format = cursor.charFormat();
            if (!format.fontFixedPitch())
                cursor.insertText(it->second, format);
        }
    }
}

} // namespace cradle
