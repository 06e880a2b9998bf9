// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_journal.h"

#include <QTemporaryDir>
#include <QTest>

/// Results of a class of three, as several machines write them.
namespace cradle::results {

/// A test with folders of results.
class ResultFolders : public QObject
{
protected:
    /// A folder of its own in each row of each function.
    [[nodiscard]] QString folder(const QString &name) const
    {
        return m_folder.filePath(QString::fromLatin1(QTest::currentTestFunction())
                                 + QString::fromLatin1(QTest::currentDataTag()) + name);
    }

private:
    QTemporaryDir m_folder;
};

inline Manifest manifestOf(int shard = 1, int shards = 1)
{
    Manifest made;
    made.version = {.cradle = QStringLiteral("Cradle 9"),
                    .labId = QStringLiteral("lab"),
                    .labVersion = QStringLiteral("2.1"),
                    .labHash = QStringLiteral("aa"),
                    .secretHash = QStringLiteral("bb"),
                    .language = QStringLiteral("de")};
    made.shard = {shard, shards};
    made.className = QStringLiteral("Physics 1");
    made.platform = Platform::Canvas;
    made.isolation = QStringLiteral("seccomp");
    made.missing = {{.id = QStringLiteral("z"),
                     .name = QStringLiteral("Zed"),
                     .number = QStringLiteral("26"),
                     .email = QStringLiteral("z@example.org")}};
    made.remarks = {QStringLiteral("one"), QStringLiteral("two")};
    made.classIds = {QStringLiteral("ada"), QStringLiteral("bob"), QStringLiteral("cy")};
    return made;
}

/// One more student in a folder of results.
inline void keep(ClassJournal &journal, const char *id, const QByteArray &result,
                 const DoneStudent &done = {})
{
    QVERIFY(!journal.keep(QString::fromLatin1(id), result, done));
}

/// A folder of results of one shard, with its students.
inline void judge(const QString &folder, const Manifest &manifest,
                  const std::vector<std::tuple<const char *, QByteArray, DoneStudent>> &students,
                  bool ends = true)
{
    auto journal = ClassJournal::open(folder);
    QVERIFY(journal.ok());
    QVERIFY(!journal->begin(manifest));
    for (const auto &[id, result, done] : students)
        keep(*journal, id, result, done);
    if (ends)
        QVERIFY(!journal->finish(true));
}

} // namespace cradle::results
