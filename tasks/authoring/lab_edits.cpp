// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_edits.h"

#include "tasks/authoring/free_name.h"
#include "tasks/authoring/lab_json.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace cradle {

namespace {

struct EditText {
    Q_DECLARE_TR_FUNCTIONS(LabEdits)
};

const QString stepsKey = QStringLiteral("steps");
const QString titleKey = QStringLiteral("title");
const QString templateStep = QStringLiteral("S1");
constexpr int longestWish = 60; ///< characters of the name of a step

/// The lab that new ones are copies of.
LabFiles templateIn(const QString &language)
{
    const QString name = language == QLatin1String("de") ? language : QStringLiteral("en");
    const Result<LabFiles> files = readLabFiles(QStringLiteral(":/templates/lab-") + name);
    Q_ASSERT_X(files.ok(), "templateIn", "the template is a resource of the program");
    return *files;
}

Error indexFault(const QString &message)
{
    return {.message = message, .file = indexFile};
}

Result<LabFiles> withSteps(const LabFiles &files, const QStringList &steps)
{
    return withMember(files, indexFile, labSchema, stepsKey, toJson(steps));
}

/// \p files with those of folder \p from copied into folder \p to, or moved there.
LabFiles withFolder(const LabFiles &files, const LabFiles &source, const QString &from,
                    const QString &to)
{
    LabFiles result = files;
    const QString start = from + QLatin1Char('/');
    for (auto it = source.contents.begin(); it != source.contents.end(); ++it) {
        if (it.key().startsWith(start))
            result.contents.insert(to + QLatin1Char('/') + it.key().mid(start.size()), *it);
    }
    return result;
}

LabFiles withoutFolder(const LabFiles &files, const QString &folder)
{
    LabFiles result = files;
    result.contents.removeIf(
        [&](auto it) { return it.key().startsWith(folder + QLatin1Char('/')); });
    return result;
}

/// What keeps a new step from having that folder; nullopt if nothing does.
std::optional<Error> faultOfName(const LabFiles &files, const QString &name)
{
    static const QRegularExpression right(QStringLiteral("^[A-Za-z0-9_-]{1,64}$"));
    if (!right.match(name).hasMatch() || !faultOfLabPath(name).isEmpty())
        return indexFault(EditText::tr("\"%1\" cannot be the name of a step; letters, digits, "
                                       "dashes and underscores are right")
                              .arg(name.left(60)));
    // Some file systems do not tell capital letters.
    const QString start = name.toLower() + QLatin1Char('/');
    bool taken = stepsOf(files).contains(name, Qt::CaseInsensitive);
    for (auto it = files.contents.begin(); it != files.contents.end() && !taken; ++it)
        taken = it.key().toLower().startsWith(start);
    if (taken)
        return indexFault(EditText::tr("the lab has a folder %1 already").arg(name));
    return std::nullopt;
}

Error noSuchStep(const QString &step)
{
    return indexFault(EditText::tr("the lab has no step in the folder %1").arg(step));
}

Result<LabFiles> withId(const LabFiles &files, const QString &step, const QString &id)
{
    return withMember(files, taskPath(step), taskSchema, QStringLiteral("id"), id);
}

} // namespace

LabFiles newLab(const QString &id, const QString &title, const QString &language)
{
    const LabFiles files = templateIn(language);
    const Result<LabFiles> named = withLab(
        files, {.id = id, .title = title, .version = QStringLiteral("1.0"), .language = language});
    return named ? *named : files;
}

Result<LabForm> labForm(const LabFiles &files, const QString &language)
{
    const Result<QJsonObject> json = jsonOf(files, indexFile, labSchema);
    if (!json)
        return json.error();
    const auto text = [&](const char *key) { return json->value(QLatin1String(key)).toString(); };
    LabForm form{.id = text("id"),
                 .title = text("title"),
                 .version = text("version"),
                 .language = text("language")};
    if (isTranslation(files, language)) {
        const QString path = translatedPath(indexFile, language);
        const Result<QJsonObject> texts = jsonOf(files, path, translationSchema);
        if (texts)
            form.title = texts->value(QStringLiteral("title")).toString(form.title);
    }
    return form;
}

Result<LabFiles> withLab(const LabFiles &files, const LabForm &form, const QString &language)
{
    const Result<LabForm> own = labForm(files);
    const Result<LabForm> before = labForm(files, language);
    if (!own || !before)
        return own ? before.error() : own.error();
    const auto jsonFrom = [](const LabForm &lab, const QString &title) {
        QJsonObject json{{QStringLiteral("id"), lab.id}, {QStringLiteral("title"), title}};
        if (!lab.version.isEmpty())
            json.insert(QStringLiteral("version"), lab.version);
        if (!lab.language.isEmpty())
            json.insert(QStringLiteral("language"), lab.language);
        return json;
    };
    const bool translated = isTranslation(files, language);
    Result<LabFiles> result = withPatch(files, indexFile, labSchema, jsonFrom(*own, own->title),
                                        jsonFrom(form, translated ? own->title : form.title));
    if (!result || !translated || form.title == before->title)
        return result;
    const QString path = translatedPath(indexFile, language);
    const QJsonValue title =
        form.title.isEmpty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(form.title);
    result = withMember(*result, path, translationSchema, titleKey, title);
    if (!result)
        return result;
    const Result<QJsonObject> texts = jsonOf(*result, path, translationSchema);
    return texts && texts->isEmpty() ? withoutFile(*result, path) : result;
}

bool hasTitle(const LabFiles &files, const QString &language)
{
    if (!isTranslation(files, language))
        return true;
    const Result<QJsonObject> texts =
        jsonOf(files, translatedPath(indexFile, language), translationSchema);
    return texts && texts->contains(titleKey);
}

Result<LabFiles> withOwnLanguage(const LabFiles &files, const QString &language)
{
    if (!isTranslation(files, language))
        return files;
    for (auto it = files.contents.keyBegin(); it != files.contents.keyEnd(); ++it) {
        const QString name = it->section(QLatin1Char('/'), -1);
        if (name == QStringLiteral("lab.%1.json").arg(language)
            || name == QStringLiteral("task.%1.json").arg(language)
            || name == QStringLiteral("instructions.%1.md").arg(language)
            || name == QStringLiteral("starter.%1.lua").arg(language))
            return Error{.message = EditText::tr("the lab has translations into this language; "
                                                 "its own texts are in another"),
                         .file = *it};
    }
    return withMember(files, indexFile, labSchema, QStringLiteral("language"), language);
}

std::optional<Error> brokenFile(const LabFiles &files, const QString &step, const QString &language)
{
    const Result<LabForm> lab = labForm(files);
    const Result<TaskForm> form = taskForm(files, step, language);
    for (const Error *fault : {lab ? nullptr : &lab.error(), form ? nullptr : &form.error()}) {
        if (fault && files.contents.contains(fault->file))
            return *fault;
    }
    return std::nullopt;
}

QStringList stepsOf(const LabFiles &files)
{
    const Result<QJsonObject> json = jsonOf(files, indexFile, labSchema);
    return json ? toStrings(json->value(stepsKey)) : QStringList();
}

QStringList languagesOf(const LabFiles &files)
{
    static const QRegularExpression translated(
        QStringLiteral("(?:^|/)(?:lab|task)\\.([a-z]{2}(?:_[A-Z]{2})?)\\.json$"
                       "|/instructions\\.([a-z]{2}(?:_[A-Z]{2})?)\\.md$"
                       "|/starter\\.([a-z]{2}(?:_[A-Z]{2})?)\\.lua$"));
    QStringList languages;
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        const QRegularExpressionMatch match = translated.match(it.key());
        if (match.hasMatch())
            languages.append(match.captured(match.lastCapturedIndex()));
    }
    languages.removeAll(ownLanguage(files));
    languages.removeDuplicates();
    languages.sort();
    languages.prepend(ownLanguage(files));
    return languages;
}

QString freeStepName(const LabFiles &files, const QString &wish)
{
    // With room for a number.
    return freeName(wish.left(longestWish),
                    [&](const QString &name) { return faultOfName(files, name).has_value(); });
}

Result<LabFiles> withStepAdded(const LabFiles &files, const QString &step, const QString &title,
                               int at)
{
    if (auto fault = faultOfName(files, step))
        return *fault;
    QStringList steps = stepsOf(files);
    steps.insert(at < 0 ? steps.size() : qMin(qsizetype{at}, steps.size()), step);
    const LabFiles source = templateIn(ownLanguage(files));
    Result<LabFiles> result = withSteps(withFolder(files, source, templateStep, step), steps);
    if (result)
        result = withId(*result, step, step);
    if (!result)
        return result;
    return withMember(*result, taskPath(step), taskSchema, QStringLiteral("title"), title);
}

Result<LabFiles> withStepRemoved(const LabFiles &files, const QString &step)
{
    QStringList steps = stepsOf(files);
    if (!steps.removeOne(step))
        return noSuchStep(step);
    LabFiles rest = withoutFolder(files, step);
    for (const QString &path : foreignFiles(files, step))
        rest.contents.insert(path, files.contents.value(path));
    return withSteps(rest, steps);
}

Result<LabFiles> withStepMoved(const LabFiles &files, const QString &step, int to)
{
    QStringList steps = stepsOf(files);
    const qsizetype from = steps.indexOf(step);
    if (from < 0)
        return noSuchStep(step);
    steps.move(from, qBound(qsizetype{0}, qsizetype{to}, steps.size() - 1));
    return withSteps(files, steps);
}

Result<LabFiles> withStepRenamed(const LabFiles &files, const QString &step, const QString &name)
{
    QStringList steps = stepsOf(files);
    const qsizetype at = steps.indexOf(step);
    if (at < 0)
        return noSuchStep(step);
    if (name == step)
        return files;
    // A change of capital letters alone is no clash with itself.
    const LabFiles others = withoutFolder(files, step);
    if (step.compare(name, Qt::CaseInsensitive) != 0) {
        if (auto fault = faultOfName(files, name))
            return *fault;
    }
    steps[at] = name;
    Result<LabFiles> result = withSteps(withFolder(others, files, step, name), steps);
    const Result<TaskForm> form = taskForm(files, step);
    if (result && form && form->id == step)
        result = withId(*result, name, name);
    return result;
}

Result<LabFiles> withStepDuplicated(const LabFiles &files, const QString &step, const QString &name)
{
    QStringList steps = stepsOf(files);
    const qsizetype at = steps.indexOf(step);
    if (at < 0)
        return noSuchStep(step);
    if (auto fault = faultOfName(files, name))
        return *fault;
    steps.insert(at + 1, name);
    Result<LabFiles> result = withSteps(withFolder(files, files, step, name), steps);
    return result ? withId(*result, name, name) : result;
}

} // namespace cradle
