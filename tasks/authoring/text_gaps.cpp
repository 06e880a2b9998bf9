// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/text_gaps.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/lab_json.h"
#include "tasks/script/program_tokens.h"

#include <QCoreApplication>
#include <QJsonDocument>

namespace cradle {

namespace {

struct GapsText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

const QString titleKey = QStringLiteral("title");
const QString hintKeys[] = {QStringLiteral("hints"), QStringLiteral("code_hints")};

/// An object whatever is wrong with it: the reader tells of that.
QJsonObject objectIn(const LabFiles &files, const QString &path)
{
    return QJsonDocument::fromJson(files.contents.value(path)).object();
}

/// Ids of the entries of a list in task.json.
QStringList idsOf(const QJsonObject &task, const QString &list)
{
    QStringList ids;
    for (const QJsonValue &entry : task.value(list).toArray())
        ids.append(entry.toObject().value(QStringLiteral("id")).toString());
    return ids;
}

using NamedTexts = std::vector<std::pair<QString, QStringList>>;

/// What of a step is named and has a text of its own, by the key of its list.
NamedTexts namedIn(const QJsonObject &task, const QStringList &mistakes)
{
    const QString checks = QStringLiteral("checks");
    const QString remarks = QStringLiteral("remarks");
    const QString questions = QStringLiteral("questions");
    return {{questions, idsOf(task, questions)},
            {checks, idsOf(task, checks)},
            {QStringLiteral("mistakes"), mistakes},
            {remarks, idsOf(task, remarks)}};
}

/// What \p words, a step's texts in another language, have not: "title", "checks.falls".
QStringList missingIn(const QJsonObject &words, const QJsonObject &task, const NamedTexts &named)
{
    QStringList missing;
    if (words.value(titleKey).toString().isEmpty())
        missing.append(titleKey);
    for (const QString &key : hintKeys) {
        if (words.value(key).toArray().size() != task.value(key).toArray().size())
            missing.append(key);
    }
    const QString prediction = QStringLiteral("prediction");
    if (task.contains(prediction) && !words.contains(prediction))
        missing.append(prediction);
    for (const auto &[key, names] : named) {
        const QJsonObject texts = words.value(key).toObject();
        for (const QString &name : names) {
            const QJsonValue text = texts.value(name);
            if (text.isUndefined() || (text.isString() && text.toString().isEmpty()))
                missing.append(key + QLatin1Char('.') + name);
        }
    }
    return missing;
}

/// What \p words say of what the step has not, such as a mistake that was renamed.
QStringList deadIn(const QJsonObject &words, const NamedTexts &named)
{
    QStringList dead;
    for (const auto &[key, names] : named) {
        for (const QString &name : words.value(key).toObject().keys()) {
            if (!names.contains(name))
                dead.append(key + QLatin1Char('.') + name);
        }
    }
    return dead;
}

/// What of a step still says what the template of new steps says.
QStringList leftFromTemplate(const LabFiles &files, const QString &step, const LabFiles &pattern,
                             const QString &patternStep)
{
    QStringList left;
    const QJsonObject task = objectIn(files, step + QStringLiteral("/task.json"));
    const QJsonObject old = objectIn(pattern, patternStep + QStringLiteral("/task.json"));
    for (const QString &key : {titleKey, hintKeys[0], hintKeys[1]}) {
        if (task.value(key) == old.value(key) && !task.value(key).isUndefined())
            left.append(key);
    }
    const QString text = QStringLiteral("/instructions.md");
    if (textOf(files, step + text) == textOf(pattern, patternStep + text))
        left.append(QStringLiteral("instructions.md"));
    return left;
}

/// A program as Lua reads it: without comments and white space.
QStringList codeOf(const QString &source)
{
    QStringList words;
    for (const ProgramToken &token : programTokens(source))
        words.append(token.text);
    return words;
}

/// What is wrong with the starter of a step in another language, which differs in comments alone.
std::optional<Error> starterGap(const LabFiles &files, const QString &step, const QString &language)
{
    const QString own = textOf(files, step + QStringLiteral("/starter.lua"));
    const QString path = QStringLiteral("%1/starter.%2.lua").arg(step, language);
    if (!files.contents.contains(path))
        return own.contains(QLatin1String("--")) ? std::optional(Error{
                   .message = GapsText::tr("not in this language yet: the starter's comments"),
                   .file = path})
                                                 : std::nullopt;
    if (codeOf(textOf(files, path)) == codeOf(own))
        return std::nullopt;
    return Error{.message =
                     GapsText::tr("its code is not that of starter.lua; a starter in another "
                                  "language differs in comments alone"),
                 .file = path};
}

} // namespace

std::vector<Error> textGaps(const LabFiles &files)
{
    std::vector<Error> gaps;
    const QStringList languages = languagesOf(files);
    const LabFiles pattern = newLab(QStringLiteral("lab"), {}, languages.front());
    const QString patternStep = stepsOf(pattern).value(0);
    for (const QString &step : stepsOf(files)) {
        const QString path = step + QStringLiteral("/task.json");
        const QJsonObject task = objectIn(files, path);
        if (task.isEmpty())
            continue;
        const QStringList left = leftFromTemplate(files, step, pattern, patternStep);
        if (!left.isEmpty())
            gaps.push_back({.message = GapsText::tr("still the text of the template: %1")
                                           .arg(left.join(QStringLiteral(", "))),
                            .file = path});
        const NamedTexts named = namedIn(task, knownNames(files, step, KnownKind::Mistake));
        for (const QString &language : languages.mid(1)) {
            const QString translated = translatedPath(path, language);
            const QJsonObject words = objectIn(files, translated);
            QStringList missing = missingIn(words, task, named);
            const QString text = QStringLiteral("instructions.%1.md").arg(language);
            if (!files.contents.contains(step + QLatin1Char('/') + text))
                missing.append(text);
            if (const auto gap = starterGap(files, step, language))
                gaps.push_back(*gap);
            if (!missing.isEmpty())
                gaps.push_back({.message = GapsText::tr("not in this language yet: %1")
                                               .arg(missing.join(QStringLiteral(", "))),
                                .file = translated});
            const QStringList dead = deadIn(words, named);
            if (!dead.isEmpty())
                gaps.push_back({.message = GapsText::tr("of what the step has not: %1")
                                               .arg(dead.join(QStringLiteral(", "))),
                                .file = translated});
        }
    }
    return gaps;
}

} // namespace cradle
