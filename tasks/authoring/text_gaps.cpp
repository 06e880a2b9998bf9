// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/text_gaps.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/lab_json.h"
#include "tasks/lab/mode.h"
#include "tasks/script/program_tokens.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QRegularExpression>

namespace cradle {

namespace {

struct GapsText {
    Q_DECLARE_TR_FUNCTIONS(LabReader)
};

const QString titleText = QStringLiteral("title");
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

/// Whether a text is of words, which no other language has alike: "5.8 m" may well be the same.
bool isOfWords(const QString &text)
{
    static const QRegularExpression words(QStringLiteral("\\p{L}{3,}\\W+\\p{L}{3,}"));
    return words.match(text).hasMatch();
}

/// The texts of a prediction that are still those of the lab's own language.
QStringList sameInPrediction(const QJsonObject &words, const QJsonObject &own)
{
    const QString prediction = QStringLiteral("prediction.");
    QStringList same;
    for (const QString &key : {QStringLiteral("question"), QStringLiteral("outcome")}) {
        const QString text = own.value(key).toString();
        if (isOfWords(text) && words.value(key).toString() == text)
            same.append(prediction + key);
    }
    const QJsonArray answers = own.value(QStringLiteral("answers")).toArray();
    const QJsonArray translated = words.value(QStringLiteral("answers")).toArray();
    for (qsizetype i = 0; i < answers.size(); ++i) {
        if (isOfWords(answers[i].toString()) && translated.at(i) == answers[i])
            same.append(prediction + QStringLiteral("answers.%1").arg(i + 1));
    }
    return same;
}

/// What \p words, a step's texts in another language, have not: "title", "checks.falls".
QStringList missingIn(const QJsonObject &words, const QJsonObject &task, const NamedTexts &named)
{
    QStringList missing;
    if (words.value(titleText).toString().isEmpty())
        missing.append(titleText);
    for (const QString &key : hintKeys) {
        if (words.value(key).toArray().size() != task.value(key).toArray().size())
            missing.append(key);
    }
    const QString prediction = QStringLiteral("prediction");
    if (task.contains(prediction) && !words.contains(prediction))
        missing.append(prediction);
    missing +=
        sameInPrediction(words.value(prediction).toObject(), task.value(prediction).toObject());
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
    const QJsonObject task = objectIn(files, taskPath(step));
    const QJsonObject old = objectIn(pattern, taskPath(patternStep));
    for (const QString &key : {titleText, hintKeys[0], hintKeys[1]}) {
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

/// The pictures that a text names and the step has not.
QStringList missingPictures(const LabFiles &files, const QString &step, const QString &text)
{
    static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]*\\]\\(([^)\\s]+)[^)]*\\)"));
    QStringList missing;
    for (auto it = picture.globalMatch(text); it.hasNext();) {
        const QString name = it.next().captured(1);
        if (!name.contains(QLatin1Char(':'))
            && !files.contents.contains(step + QLatin1Char('/') + name))
            missing.append(name);
    }
    missing.removeDuplicates();
    return missing;
}

/// Comments that look like the beginning of a part and are none: "<!-- Code -->".
QStringList unknownParts(const QString &text)
{
    static const QRegularExpression comment(QStringLiteral("^<!--\\s*(\\S+)\\s*-->\\s*$"),
                                            QRegularExpression::MultilineOption);
    const QStringList parts = partWords();
    QStringList unknown;
    for (auto it = comment.globalMatch(text); it.hasNext();) {
        const QString word = it.next().captured(1);
        if (!parts.contains(word))
            unknown.append(word);
    }
    unknown.removeDuplicates();
    return unknown;
}

/// What the instructions of a step, in any language, name and have not.
void findInstructionGaps(const LabFiles &files, const QString &step, std::vector<Error> &gaps)
{
    const QString start = step + QStringLiteral("/instructions.");
    for (auto it = files.contents.lowerBound(start);
         it != files.contents.end() && it.key().startsWith(start); ++it) {
        const QString text = textOf(files, it.key());
        const QStringList pictures = missingPictures(files, step, text);
        if (!pictures.isEmpty())
            gaps.push_back({.message = GapsText::tr("there is no picture %1 in the step's folder")
                                           .arg(pictures.join(QStringLiteral(", "))),
                            .file = it.key()});
        const QStringList parts = unknownParts(text);
        if (!parts.isEmpty())
            gaps.push_back({.message = GapsText::tr("<!-- %1 --> begins no part; explore, code and "
                                                    "all do")
                                           .arg(parts.join(QStringLiteral(", "))),
                            .file = it.key()});
    }
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
        const QString path = taskPath(step);
        const QJsonObject task = objectIn(files, path);
        if (task.isEmpty())
            continue;
        const QStringList left = leftFromTemplate(files, step, pattern, patternStep);
        if (!left.isEmpty())
            gaps.push_back({.message = GapsText::tr("still the text of the template: %1")
                                           .arg(left.join(QStringLiteral(", "))),
                            .file = path});
        findInstructionGaps(files, step, gaps);
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
