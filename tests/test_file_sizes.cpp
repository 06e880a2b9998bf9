// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/file_io.h"
#include "model/files/preset_json.h"
#include "tasks/grading/roster.h"
#include "tasks/grading/student_seed.h"
#include "tasks/workspace/workspace_info.h"
#include "tests/text.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

using Reads = bool (*)(const QString &folder, const QString &path);

/// A file that is as large as it may be is read, and one that is a byte larger is not.
class TestFileSizes : public QObject
{
    Q_OBJECT
private slots:
    void filesAreAsLargeAsTheyMayBe_data();
    void filesAreAsLargeAsTheyMayBe();
};

void TestFileSizes::filesAreAsLargeAsTheyMayBe_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content"); ///< spaces and line ends behind it change nothing
    QTest::addColumn<qsizetype>("most");
    QTest::addColumn<Reads>("reads");
    constexpr qsizetype kibibyte = 1024;
    constexpr qsizetype mebibyte = 1024 * kibibyte;
    QTest::newRow("whose workspace it is")
        << text("cradle.json") << QByteArray(R"({"format": 1, "student": "Ada"})") << 64 * kibibyte
        << Reads([](const QString &folder, const QString &) {
               return readWorkspaceInfo(folder).ok();
           });
    QTest::newRow("a roster") << text("roster.csv") << QByteArray("id,name\nada,Ada\n")
                              << 16 * mebibyte << Reads([](const QString &, const QString &path) {
                                     return readRoster(path).ok();
                                 });
    QTest::newRow("a scene") << text("scene.json") << writePreset(Preset{}) << 32 * mebibyte
                             << Reads([](const QString &, const QString &path) {
                                    return readPreset(path).ok();
                                });
    QTest::newRow("a secret") << text("secret") << QByteArray("what nobody knows of this class")
                              << 4 * kibibyte << Reads([](const QString &, const QString &path) {
                                     return readSecret(path).ok();
                                 });
}

void TestFileSizes::filesAreAsLargeAsTheyMayBe()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    QFETCH(qsizetype, most);
    QFETCH(Reads, reads);
    const QTemporaryDir folder;
    const QString path = folder.filePath(name);
    content += QByteArray(most - content.size(), '\n');
    QVERIFY(!writeFile(path, content));
    QVERIFY(reads(folder.path(), path));
    QVERIFY(!writeFile(path, content + '\n'));
    QVERIFY(!reads(folder.path(), path));
}

QTEST_GUILESS_MAIN(TestFileSizes)
#include "test_file_sizes.moc"
