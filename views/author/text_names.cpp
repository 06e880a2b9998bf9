// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/text_names.h"

#include "model/files/preset_json.h"
#include "tasks/script/lua_tokens.h"
#include "views/code/api_words.h"

#include <QRegularExpression>

namespace cradle {

namespace {

void addNames(const QString &program, QSet<QString> &words)
{
    const QByteArray text = program.toUtf8();
    for (const LuaToken &token : luaTokens(text)) {
        if (token.kind == LuaToken::Kind::Name)
            words.insert(QString::fromUtf8(token.in(text)));
    }
}

/// Keys and values of the format of presets.
QSet<QString> presetWords()
{
    QSet<QString> words;
    for (const char *word :
         {"half_width", "gravity", "restitution", "timestep", "laws",   "walls",   "circles",
          "timing",     "name",    "position",    "velocity", "radius", "density", "colour",
          "integrator", "x",       "y",           "lab",      "lua",    "preset",  "json"})
        words.insert(QLatin1String(word));
    for (const QStringList &names :
         {allWallLawNames(), allCircleLawNames(), allTimingNames(), allIntegratorNames()})
        words.unite({names.begin(), names.end()});
    return words;
}

bool isKnown(const QString &name, const TextNames &known)
{
    static const QRegularExpression circle(QStringLiteral("^circle([0-9]+)$"));
    const auto match = circle.match(name);
    if (match.hasMatch())
        return match.captured(1).toInt() >= 1 && match.captured(1).toInt() <= known.circles;
    return known.words.contains(name);
}

} // namespace

TextNames textNames(const Task &task)
{
    TextNames known{presetWords(), static_cast<int>(task.preset.circles.size())};
    for (const ApiWord &word : apiWords()) {
        known.words.insert(word.name);
        known.words.insert(word.owner);
    }
    addNames(task.solution, known.words);
    addNames(task.starter, known.words);
    for (const KnownScript &mistake : task.mistakes)
        addNames(mistake.source, known.words);
    return known;
}

std::vector<UnknownName> unknownNames(const QString &markdown, const TextNames &known)
{
    static const QRegularExpression span(QStringLiteral("(?<!`)`([^`\n]+)`(?!`)"));
    static const QRegularExpression path(
        QStringLiteral("^[A-Za-z_][A-Za-z0-9_]*([.:][A-Za-z_][A-Za-z0-9_]*)*(\\(\\))?$"));
    static const QRegularExpression separator(QStringLiteral("[.:()]+"));
    std::vector<UnknownName> unknown;
    bool fenced = false;
    qsizetype start = 0;
    int number = 0;
    for (const QString &line : markdown.split(QLatin1Char('\n'))) {
        ++number;
        if (line.trimmed().startsWith(QLatin1String("```")))
            fenced = !fenced;
        auto it = span.globalMatch(fenced ? QString() : line);
        while (it.hasNext()) {
            const auto match = it.next();
            const QString text = match.captured(1);
            if (!path.match(text).hasMatch())
                continue;
            for (const QString &name : text.split(separator, Qt::SkipEmptyParts)) {
                if (isKnown(name, known))
                    continue;
                unknown.push_back(
                    {start + match.capturedStart(1), match.capturedLength(1), text, number});
                break;
            }
        }
        start += line.size() + 1;
    }
    return unknown;
}

} // namespace cradle
