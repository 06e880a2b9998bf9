// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/progress.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "model/files/preset_json.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

struct ProgressText {
    Q_DECLARE_TR_FUNCTIONS(Progress)
};

constexpr qint64 maxBytes = 64 * 1024 * 1024;
constexpr int lockPatience = 2000; ///< ms; saving takes some

QJsonObject jsonOf(const Guess &guess)
{
    QJsonObject json;
    if (guess.answer)
        json.insert(QStringLiteral("answer"), *guess.answer);
    json.insert(QStringLiteral("watched"), guess.watched);
    json.insert(QStringLiteral("revealed"), guess.revealed);
    return json;
}

Guess guessFrom(const QJsonObject &json)
{
    Guess guess;
    const QJsonValue answer = json.value(QStringLiteral("answer"));
    if (answer.isDouble() && answer.toInt(-2) >= Guess::notSure)
        guess.answer = answer.toInt();
    guess.watched = json.value(QStringLiteral("watched")).toBool();
    guess.revealed = json.value(QStringLiteral("revealed")).toBool();
    return guess;
}

QJsonObject jsonOf(const TaskProgress &task)
{
    QJsonObject json{{QStringLiteral("passed"), task.passed},
                     {QStringLiteral("hints"), task.hintsOpened}};
    if (task.edited)
        json.insert(QStringLiteral("preset"),
                    QJsonDocument::fromJson(writePreset(*task.edited)).object());
    if (task.pass.when.isValid())
        json.insert(QStringLiteral("passed_at"), task.pass.when.toString(Qt::ISODate));
    if (!task.pass.commit.isEmpty())
        json.insert(QStringLiteral("commit"), task.pass.commit);
    if (task.guess != Guess{})
        json.insert(QStringLiteral("prediction"), jsonOf(task.guess));
    if (!task.answers.isEmpty())
        json.insert(QStringLiteral("answers"), task.answers);
    return json;
}

TaskProgress taskFrom(const QJsonObject &json)
{
    TaskProgress task;
    task.passed = json.value(QStringLiteral("passed")).toBool();
    task.hintsOpened = json.value(QStringLiteral("hints")).toInt();
    task.pass.when =
        QDateTime::fromString(json.value(QStringLiteral("passed_at")).toString(), Qt::ISODate);
    task.pass.commit = json.value(QStringLiteral("commit")).toString();
    task.guess = guessFrom(json.value(QStringLiteral("prediction")).toObject());
    task.answers = json.value(QStringLiteral("answers")).toObject();
    const QJsonValue preset = json.value(QStringLiteral("preset"));
    if (preset.isObject()) {
        // A preset that an older or newer version wrote and this one refuses is left out.
        if (auto read = parsePreset(QJsonDocument(preset.toObject()).toJson()))
            task.edited = *read;
    }
    return task;
}

/// Gives a file that cannot be read a name of its own beside it, so that it is never written over.
QString moveAside(const QString &path)
{
    QString aside = path + QStringLiteral(".unreadable");
    for (int n = 2; QFileInfo::exists(aside); ++n)
        aside = path + QStringLiteral(".unreadable-%1").arg(n);
    QFile::rename(path, aside);
    return aside;
}

LabProgress labFrom(const QJsonObject &json)
{
    LabProgress progress;
    progress.currentTask = json.value(QStringLiteral("current")).toString();
    const QJsonObject tasks = json.value(QStringLiteral("tasks")).toObject();
    for (auto task = tasks.begin(); task != tasks.end(); ++task)
        progress.tasks[task.key()] = taskFrom(task.value().toObject());
    return progress;
}

QJsonObject jsonOf(const LabProgress &lab)
{
    QJsonObject tasks;
    for (const auto &[taskId, task] : lab.tasks)
        tasks.insert(taskId, jsonOf(task));
    return {{QStringLiteral("current"), lab.currentTask}, {QStringLiteral("tasks"), tasks}};
}

/// A file that is progress as a whole; what is wrong inside of it is left out, value by value, so
/// that no slip of a disk or of a hand takes what else was passed.
Result<std::map<QString, LabProgress>> labsIn(const QString &path)
{
    const Result<QByteArray> text = readFile(path, maxBytes);
    if (!text)
        return text.error();
    const auto json = parseJson(*text, QStringLiteral(":/schemas/progress.schema.json"), path);
    if (!json)
        return json.error();
    std::map<QString, LabProgress> labs;
    const QJsonObject all = json->value(QStringLiteral("labs")).toObject();
    for (auto lab = all.begin(); lab != all.end(); ++lab)
        labs[lab.key()] = labFrom(lab.value().toObject());
    return labs;
}

/// What was passed once, by whatever window, stays passed.
void keepPasses(LabProgress &lab, const LabProgress &other)
{
    for (const auto &[id, theirs] : other.tasks) {
        TaskProgress &ours = lab.tasks[id];
        if (!ours.passed && theirs.passed)
            ours.pass = theirs.pass;
        ours.passed = ours.passed || theirs.passed;
        ours.hintsOpened = std::max(ours.hintsOpened, theirs.hintsOpened);
    }
}

} // namespace

ProgressStore::ProgressStore(QString path)
    : m_path(std::move(path))
{
}

LabProgress &ProgressStore::lab(const QString &labId)
{
    const auto found = m_labs.find(labId);
    return found != m_labs.end() ? found->second : m_labs[labId] = m_read[labId];
}

std::optional<Error> ProgressStore::load()
{
    m_labs.clear();
    m_read.clear();
    if (!QFileInfo::exists(m_path))
        return std::nullopt;
    auto labs = labsIn(m_path);
    if (labs) {
        m_read = std::move(*labs);
        return std::nullopt;
    }
    return Error{.message = ProgressText::tr("your progress could not be read (%2) and was moved "
                                             "to %1; Cradle begins anew")
                                .arg(moveAside(m_path), labs.error().message),
                 .file = m_path};
}

const TaskProgress *ProgressStore::find(const QString &labId, const QString &taskId) const
{
    const auto open = m_labs.find(labId);
    const auto read = m_read.find(labId);
    const LabProgress *lab = open != m_labs.end()   ? &open->second
                             : read != m_read.end() ? &read->second
                                                    : nullptr;
    if (!lab)
        return nullptr;
    const auto task = lab->tasks.find(taskId);
    return task == lab->tasks.end() ? nullptr : &task->second;
}

bool ProgressStore::isPassed(const QString &labId, const QString &taskId) const
{
    const TaskProgress *task = find(labId, taskId);
    return task && task->passed;
}

QJsonObject ProgressStore::answersOf(const QString &labId, const QString &taskId) const
{
    const TaskProgress *task = find(labId, taskId);
    return task ? task->answers : QJsonObject{};
}

std::optional<Error> ProgressStore::save() const
{
    if (m_path.isEmpty())
        return std::nullopt;
    auto error = makeFolder(QFileInfo(m_path).absolutePath());
    // Two windows that save at once must not read before the other has written.
    QLockFile alone(m_path + QStringLiteral(".lock"));
    if (!error)
        alone.tryLock(lockPatience);
    QJsonObject labs;
    std::optional<std::map<QString, LabProgress>> there;
    if (QFileInfo::exists(m_path)) {
        if (auto kept = labsIn(m_path))
            there = std::move(*kept);
        else
            moveAside(m_path);
    }
    for (const auto &[id, lab] : there ? *there : m_read)
        labs.insert(id, jsonOf(lab));
    for (const auto &[id, lab] : m_labs) {
        LabProgress merged = lab;
        if (there && there->contains(id))
            keepPasses(merged, there->at(id));
        labs.insert(id, jsonOf(merged));
    }
    const QJsonObject json{{QStringLiteral("format"), 1}, {QStringLiteral("labs"), labs}};
    if (!error)
        error = writeFile(m_path, QJsonDocument(json).toJson());
    if (!error)
        return std::nullopt;
    return Error{.message =
                     ProgressText::tr("your progress could not be saved: %1").arg(error->message),
                 .file = m_path};
}

} // namespace cradle
