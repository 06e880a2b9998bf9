// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_copies.h"
#include "tasks/reading/lab_reader.h"

#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// What of a lab cannot be read is left out, and said.
class TestLabRefused : public QObject
{
    Q_OBJECT
private slots:
    void refusesALabWithoutAUsableIndex_data();
    void refusesALabWithoutAUsableIndex();
    void leavesABrokenStepOutAndSaysWhy_data();
    void leavesABrokenStepOutAndSaysWhy();
    void keepsAStepWithATextThatCannotBeRead_data();
    void keepsAStepWithATextThatCannotBeRead();
    void refusesHugeTexts_data();
    void refusesHugeTexts();
};

void TestLabRefused::refusesALabWithoutAUsableIndex_data()
{
    QTest::addColumn<QString>("place"); ///< of the message, after the file
    const auto row = [](const char *name, const char *place) {
        QTest::newRow(name) << QString::fromLatin1(place);
    };
    row("no_lab_json", ": cannot be read");
    row("no_such_folder", ": cannot be read");
    row("wrong_format", ": /format: needs a newer Cradle: format 2, this one reads 1");
    row("unknown_key", ": /author: unknown key");
    row("step_outside", ": /steps/1: ");
    row("step_dots", ": /steps/1: ");
    row("title_too_long", ": /title: ");
    row("language_word", ": /language: ");
    row("steps_text", ": /steps: ");
    row("no_id", ": \"id\" is missing");
    row("broken_syntax", ":3: this is not JSON");
    row("latin1", ":4: this is not JSON");
    row("utf16", ":1: this is not JSON");
    row("empty_file", ":1: this is not JSON");
}

void TestLabRefused::refusesALabWithoutAUsableIndex()
{
    QFETCH(QString, place);
    const QString folder = fixture(QString::fromLatin1(QTest::currentDataTag()));
    const Result<Lab> lab = readLab(folder);
    QVERIFY(!lab.ok());
    const QString text = lab.error().toString();
    QVERIFY2(text.startsWith(folder + QStringLiteral("/lab.json") + place), qPrintable(text));
}

void TestLabRefused::leavesABrokenStepOutAndSaysWhy_data()
{
    QTest::addColumn<QString>("place");
    const auto row = [](const char *name, const char *place) {
        QTest::newRow(name) << QString::fromLatin1(place);
    };
    row("step_missing", "/S9/task.json: cannot be read");
    row("task_missing", "/S2/task.json: cannot be read");
    row("duplicate_id", "/S2/task.json: /id: another step has the id S1");
    row("task_unknown_key", "/S2/task.json: /marks: unknown key");
    row("task_wrong_format", "/S2/task.json: /format: ");
    row("task_broken_syntax", "/S2/task.json:4: this is not JSON");
    row("unknown_check", "/S2/task.json: /checks/1/kind: \"teleports\"");
    row("unknown_parameter",
        "/S2/task.json: /checks/0/parameters/colour: start has no parameter \"colour\"");
    row("unknown_scene", "/S2/task.json: /checks/0/scene/kind: \"moon\"");
    row("circle_zero", "/S2/task.json: /checks/1/circles/0: 0");
    row("hint_too_long", "/S2/task.json: /hints/1: ");
    row("no_checks_key", "/S2/task.json: \"checks\" is missing");
    row("preset_outside", "/S2/task.json: /preset: ");
    row("preset_missing", "/S2/nowhere.json: cannot be read");
    row("preset_broken", "/S2/preset.json: /circles/0/radius: -1");
}

void TestLabRefused::leavesABrokenStepOutAndSaysWhy()
{
    QFETCH(QString, place);
    const QString folder = fixture(QString::fromLatin1(QTest::currentDataTag()));
    const Result<Lab> lab = readLab(folder);
    QVERIFY2(lab.ok(), lab ? "" : qPrintable(lab.error().toString()));
    QCOMPARE(lab->tasks.size(), std::size_t{1});
    QCOMPARE(lab->tasks[0].id, QStringLiteral("S1"));
    QCOMPARE(lab->findings.size(), std::size_t{1});
    QVERIFY2(said(*lab).startsWith((folder + place).toUtf8()), said(*lab).constData());
}

void TestLabRefused::keepsAStepWithATextThatCannotBeRead_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("file");
    const QString text = QStringLiteral("/S2/instructions.md: ");
    QTest::newRow("instructions_missing") << QStringLiteral("en") << text;
    QTest::newRow("instructions_latin1") << QStringLiteral("en") << text;
    QTest::newRow("translation_broken")
        << QStringLiteral("de") << QStringLiteral("/S2/task.de.json: /title: 5");
}

void TestLabRefused::keepsAStepWithATextThatCannotBeRead()
{
    QFETCH(QString, language);
    QFETCH(QString, file);
    const QString folder = fixture(QString::fromLatin1(QTest::currentDataTag()));
    const Result<Lab> lab = readLab(folder, language);
    QVERIFY(lab.ok());
    QCOMPARE(lab->tasks.size(), std::size_t{2});
    QCOMPARE(lab->findings.size(), std::size_t{1});
    QVERIFY2(said(*lab).startsWith((folder + file).toUtf8()), said(*lab).constData());
}

void TestLabRefused::refusesHugeTexts_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("tasks");
    QTest::newRow("index") << QStringLiteral("lab.json") << 0;
    QTest::newRow("task") << QStringLiteral("S2/task.json") << 1;
    QTest::newRow("instructions") << QStringLiteral("S2/instructions.md") << 2;
}

void TestLabRefused::refusesHugeTexts()
{
    QFETCH(QString, file);
    QFETCH(int, tasks);
    const QTemporaryDir folder;
    copyLab(folder.path());
    write(folder.filePath(file), QByteArray(3 * 1024 * 1024, ' '));
    const Result<Lab> lab = readLab(folder.path());
    const QByteArray text = lab ? said(*lab) : lab.error().toString().toUtf8();
    QVERIFY2(text.startsWith((folder.filePath(file) + QStringLiteral(": ")).toUtf8()),
             text.constData());
    QVERIFY2(text.contains("too large"), text.constData());
    QCOMPARE(lab ? static_cast<int>(lab->tasks.size()) : 0, tasks);
}

QTEST_GUILESS_MAIN(TestLabRefused)
#include "test_lab_refused.moc"
