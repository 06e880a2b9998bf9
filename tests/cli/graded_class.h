// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/program_run.h"

#include <QDir>
#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>

namespace cradle::programs {

/// A class of the small lab, and what cradle-cli grade makes of it.
class GradedClass
{
public:
    GradedClass()
    {
        QDir(m_folder.path()).mkpath(QStringLiteral("class"));
        put(QStringLiteral("secret"), "the secret of this test\n");
    }

    /// Writes a file below the temporary folder.
    void put(const QString &path, const QByteArray &content) const
    {
        const QString whole = at(path);
        QDir().mkpath(QFileInfo(whole).path());
        QFile file(whole);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
    }
    void putProgram(const QString &student, const QString &step, const QByteArray &program) const
    {
        put(QStringLiteral("class/%1/steps/%2.lua").arg(student, step), program);
    }
    /// A student who has solved one step, fails another and lacks the third.
    void putStudent(const QString &student) const
    {
        putProgram(student, QStringLiteral("BALL1"), solution("BALL1"));
        putProgram(student, QStringLiteral("BALL2"), solution("BALL1"));
    }
    static QByteArray solution(const char *step)
    {
        return contentOf(sourcePath("tasks/labs/bouncing-ball/") + QLatin1String(step)
                         + QStringLiteral("/solution.lua"));
    }

    [[nodiscard]] QString at(const QString &path) const { return m_folder.filePath(path); }
    [[nodiscard]] QStringList arguments(const QString &out, const QStringList &more = {}) const
    {
        return QStringList{QStringLiteral("grade"),    at(QStringLiteral("class")),
                           QStringLiteral("--lab"),    sourcePath("tasks/labs/bouncing-ball"),
                           QStringLiteral("--secret"), at(QStringLiteral("secret")),
                           QStringLiteral("--out"),    at(out)}
               + more;
    }
    [[nodiscard]] Outcome grade(const QString &out, const QStringList &more = {}) const
    {
        return runCli(arguments(out, more));
    }

    /// All files below a folder, by path; what is hidden, too.
    [[nodiscard]] QMap<QString, QByteArray> files(const QString &folder) const
    {
        QMap<QString, QByteArray> found;
        QDirIterator each(at(folder), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (each.hasNext()) {
            const QString path = each.next();
            found.insert(QDir(at(folder)).relativeFilePath(path), contentOf(path));
        }
        return found;
    }
    /// The files that two folders do not both have alike.
    [[nodiscard]] QStringList differing(const QString &one, const QString &other) const
    {
        const auto first = files(one);
        const auto second = files(other);
        QStringList paths = first.keys() + second.keys();
        paths.removeDuplicates();
        paths.removeIf([&](const QString &path) {
            return first.contains(path) && second.contains(path) && first[path] == second[path];
        });
        return first.isEmpty() ? QStringList{QStringLiteral("nothing there")} : paths;
    }
    [[nodiscard]] QJsonObject json(const QString &path) const
    {
        return QJsonDocument::fromJson(contentOf(at(path))).object();
    }
    /// "passed", "failed", "missing" or "not_graded" of the steps, in order.
    [[nodiscard]] QStringList verdicts(const QString &out, const QString &id) const
    {
        QStringList found;
        const QJsonObject student = json(QStringLiteral("%1/students/%2.json").arg(out, id));
        for (const QJsonValue &step : student.value(QStringLiteral("steps")).toArray())
            found.append(step.toObject().value(QStringLiteral("status")).toString());
        return found;
    }

private:
    QTemporaryDir m_folder;
};

} // namespace cradle::programs
