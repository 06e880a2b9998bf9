// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/made_class.h"

#include "tasks/work/student_work.h"
#include "tasks/work/work_archive.h"

#include "model/files/preset_json.h"

using namespace cradle;
using namespace cradle::classes;

/// What a student did, as files of a workspace hold it, which anybody may have written.
class TestStudentWork : public QObject
{
    Q_OBJECT
private slots:
    void filesOfAWorkspaceAreRead();
    void filesThatAreTooLargeAreNamed();
    void workIsReadAsFarAsItCanBe();
    void guessesAreReadBack();
    void keptProgramsAreReadBackUpToTenThousand();
    void filesToHandInAreNamedAfterTheStudent_data();
    void filesToHandInAreNamedAfterTheStudent();
};

void TestStudentWork::filesOfAWorkspaceAreRead()
{
    const Made made;
    for (const char *path : {"lab.lua", "cradle.json", "predictions.json", "answers.json",
                             "steps/L1.lua", "presets/L1.json", "notes/L1.md", "other.lua",
                             "steps/L1.txt", "steps/deep/L2.lua", "presets/L1.lua"})
        made.file(path, path);
    const auto files = readWorkFiles(QFile::decodeName(made.root()));
    QVERIFY(files.ok());
    QCOMPARE(files->keys(), (QStringList{text("answers.json"), text("cradle.json"), text("lab.lua"),
                                         text("notes/L1.md"), text("predictions.json"),
                                         text("presets/L1.json"), text("steps/L1.lua")}));
    for (auto it = files->cbegin(); it != files->cend(); ++it)
        QCOMPARE(*it, it.key().toUtf8());
    QVERIFY(!readWorkFiles(QFile::decodeName(made.root() + "/nowhere")));
    QVERIFY(!readWorkFiles(QFile::decodeName(made.root() + "/lab.lua")));
    QVERIFY(!readWork(QFile::decodeName(made.root() + "/nowhere"), labOfTwo()));
}

/// At most 8 MiB.
void TestStudentWork::filesThatAreTooLargeAreNamed()
{
    for (const qsizetype more : {0, 1}) {
        const Made made;
        made.file("notes/L1.md", QByteArray(8 * 1024 * 1024 + more, 'x'));
        const auto files = readWorkFiles(QFile::decodeName(made.root()));
        QCOMPARE(files.ok(), more == 0);
        QVERIFY(files || files.error().file.endsWith(text("notes/L1.md")));
    }
}

void TestStudentWork::workIsReadAsFarAsItCanBe()
{
    Preset scene;
    scene.gravity = {0.0, -3.0};
    const StudentWork work = workFrom({{text("steps/L1.lua"), "x = 1"},
                                       {text("presets/L1.json"), writePreset(scene)},
                                       {text("notes/L1.md"), "a *note*"},
                                       {text("steps/L2.lua"), "x\xff"},
                                       {text("presets/L2.json"), "{"},
                                       {text("cradle.json"), "{"},
                                       {text("note-to-teacher.txt"), "please"}},
                                      labOfTwo());
    const StepWork &first = work.step(text("L1"));
    QCOMPARE(first.program, std::optional(text("x = 1")));
    QVERIFY(first.programFault.isEmpty());
    QVERIFY(first.scene.has_value());
    QCOMPARE(first.scene->gravity, scene.gravity);
    QCOMPARE(first.note, text("a *note*"));
    QVERIFY(!first.isEmpty());
    const StepWork &second = work.step(text("L2"));
    QVERIFY(!second.program && !second.scene);
    QVERIFY(second.programFault.contains(text("steps/L2.lua")));
    QVERIFY(work.step(text("nowhere")).isEmpty());
    QCOMPARE(work.noteToTeacher, text("please"));
    QVERIFY(workFrom({}, labOfTwo()).step(text("L1")).isEmpty());
}

void TestStudentWork::guessesAreReadBack()
{
    Guess sure;
    sure.answer = 2;
    sure.watched = true;
    Guess unsure;
    unsure.answer = Guess::notSure;
    unsure.revealed = true;
    const QByteArray bytes =
        predictionsText({{text("L1"), sure}, {text("L2"), unsure}, {text("L3"), Guess{}}});
    const auto read = predictionsFrom(bytes);
    QCOMPARE(read.size(), std::size_t(2)); // who did nothing is not written
    QCOMPARE(read.at(text("L1")), sure);
    QCOMPARE(read.at(text("L2")), unsure);
    const auto odd = predictionsFrom(R"({"a": {"answer": -2}, "b": {"answer": 1.5}, "c": 7})");
    QCOMPARE(odd.size(), std::size_t(3));
    for (const auto &[id, guess] : odd)
        QCOMPARE(guess, Guess{});
}

void TestStudentWork::keptProgramsAreReadBackUpToTenThousand()
{
    KeptProgram one{{.id = QString(64, u'a'),
                     .taskId = text("L1"),
                     .when = QDateTime::fromString(text("2026-05-04T03:02:01Z"), Qt::ISODate),
                     .note = {.reason = VersionReason::Checked, .passed = true}},
                    text("x = 1")};
    const auto read = historyFrom(historyText({one}));
    QCOMPARE(read.size(), std::size_t(1));
    QCOMPARE(read[0].version.id, one.version.id);
    QCOMPARE(read[0].version.taskId, one.version.taskId);
    QCOMPARE(read[0].version.when, one.version.when);
    QCOMPARE(read[0].version.note.passed, one.version.note.passed);
    QCOMPARE(read[0].text, one.text);
    one.version.id += u'b';
    one.text.clear();
    const auto many = historyFrom(historyText(std::vector<KeptProgram>(10'001, one)));
    QCOMPARE(many.size(), std::size_t(10'000));
    QCOMPARE(many[0].version.id, QString(64, u'a'));
}

void TestStudentWork::filesToHandInAreNamedAfterTheStudent_data()
{
    QTest::addColumn<QString>("student");
    QTest::addColumn<QString>("name");
    QTest::newRow("plain") << text("Ada Lovelace") << text("Ada-Lovelace");
    QTest::newRow("marks and signs") << text("  José  (2)!") << text("Jose-2");
    QTest::newRow("nothing of a name") << text("!?") << text("student");
    QTest::newRow("long") << QString(61, u'x') << QString(60, u'x');
    QTest::newRow("a letter") << text("A.") << text("A");
}

void TestStudentWork::filesToHandInAreNamedAfterTheStudent()
{
    QFETCH(QString, student);
    QFETCH(QString, name);
    QCOMPARE(workFileName(student, text("lab")), name + text("-lab") + QLatin1String(workSuffix));
}

QTEST_GUILESS_MAIN(TestStudentWork)
#include "test_student_work.moc"
