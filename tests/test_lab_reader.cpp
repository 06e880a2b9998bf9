// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_copies.h"
#include "tasks/reading/lab_reader.h"

#include "model/files/preset_json.h"

#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

class TestLabReader : public QObject
{
    Q_OBJECT
private slots:
    void readsALab();
    void remarksSayWhatIsCompared();
    void readsTheStudentsLanguage();
    void takesItsOwnLanguageWhereThereIsNoOther();
    void lawsAreThoseOfTheSceneThatPasses();
    void hashChangesWithAnyFile_data();
    void hashChangesWithAnyFile();
    void hashIsThatOfNamesAndContents();
    void stepReadAloneIsTheSame();
    void stepThatCannotBeFoundReadsAll();
};

void TestLabReader::readsALab()
{
    const Result<Lab> lab = readLab(fixture(QStringLiteral("good")));
    QVERIFY2(lab.ok(), lab ? "" : qPrintable(lab.error().toString()));
    QVERIFY2(lab->findings.empty(), said(*lab).constData());
    QCOMPARE(lab->id, QStringLiteral("small"));
    QCOMPARE(lab->title, QStringLiteral("A small lab"));
    QCOMPARE(lab->version, QStringLiteral("0.1"));
    QCOMPARE(lab->language, QStringLiteral("en"));
    QCOMPARE(lab->tasks.size(), std::size_t{2});
    QCOMPARE(lab->indexOf(QStringLiteral("S2")), 1);
    QCOMPARE(lab->indexOf(QStringLiteral("S3")), -1);
    const Task &task = lab->tasks[0];
    QCOMPARE(task.title, QStringLiteral("Begin"));
    QCOMPARE(task.commit, QStringLiteral("Did step 1"));
    QCOMPARE(task.hints.size(), 3);
    QVERIFY(task.instructions.startsWith(QStringLiteral("# Step 1")));
    QCOMPARE(task.preset.name, QStringLiteral("Two circles"));
    QVERIFY(!task.extra && lab->tasks[1].extra);
    QCOMPARE(task.checks.size(), std::size_t{2});
    QCOMPARE(task.checks[0].kind, QStringLiteral("start"));
    // Circles are counted from 1 in the file; without a list it is the first.
    QCOMPARE(task.checks[0].circles, std::vector<int>{0});
    QCOMPARE(task.checks[1].circles, (std::vector<int>{0, 1}));
    QVERIFY(task.checks[0].parameters.contains(QStringLiteral("velocity")));
}

void TestLabReader::remarksSayWhatIsCompared()
{
    const Lab lab = *readLab(QStringLiteral(":/labs/lab-4.2"));
    QStringList read;
    for (const Task &task : lab.tasks) {
        for (const RemarkSpec &remark : task.remarks) {
            using Compare = RemarkSpec::Compare;
            read.append(remark.script.name + QLatin1Char(' ')
                        + (remark.compare == Compare::Fields      ? QStringLiteral("fields")
                           : remark.compare == Compare::Positions ? QStringLiteral("positions")
                                                                  : QStringLiteral("velocities")));
        }
    }
    for (const char *remark :
         {"integer-four-thirds fields", "frozen-on-floor positions", "small-margin velocities"})
        QVERIFY2(read.contains(QLatin1String(remark)), remark);
}

void TestLabReader::readsTheStudentsLanguage()
{
    const Lab lab = *readLab(fixture(QStringLiteral("good")), QStringLiteral("de"));
    QVERIFY2(lab.findings.empty(), said(lab).constData());
    QCOMPARE(lab.title, QStringLiteral("Ein kleines Lab"));
    QCOMPARE(lab.tasks[0].title, QStringLiteral("Anfangen"));
    QCOMPARE(lab.tasks[0].hints[0], QStringLiteral("Ein Schubs."));
    QVERIFY(lab.tasks[0].instructions.contains(QStringLiteral("größer")));
    QCOMPARE(lab.tasks[0].checks[0].title, QStringLiteral("Er startet mit (2, 0) m/s"));
    // What a grader compares is in one language.
    QCOMPARE(lab.tasks[0].commit, QStringLiteral("Did step 1"));
    QCOMPARE(lab.tasks[0].checks[0].id, QStringLiteral("start"));
}

void TestLabReader::takesItsOwnLanguageWhereThereIsNoOther()
{
    const Lab german = *readLab(fixture(QStringLiteral("good")), QStringLiteral("de"));
    QCOMPARE(german.tasks[0].checks[1].title, QStringLiteral("Walls reflect"));
    QVERIFY(german.tasks[1].instructions.startsWith(QStringLiteral("# Step 2")));
    QCOMPARE(german.tasks[1].title, QStringLiteral("Weitermachen"));
    QCOMPARE(german.tasks[1].hints.size(), 3); // not some in one and some in another language
    const Lab french = *readLab(fixture(QStringLiteral("good")), QStringLiteral("fr"));
    QVERIFY(french.findings.empty());
    QCOMPARE(french.tasks[0].title, QStringLiteral("Begin"));
}

void TestLabReader::lawsAreThoseOfTheSceneThatPasses()
{
    const QTemporaryDir folder;
    copyLab(folder.path());
    const auto first = [&] { return readLab(folder.path())->tasks[0]; };
    QVERIFY(!first().laws);
    const QString solution = folder.filePath(QStringLiteral("S1/solution-preset.json"));
    Preset preset = first().preset;
    preset.laws = {WallLaw::Reflect, CircleLaw::Stop, Timing::Discrete};
    write(solution, writePreset(preset));
    QVERIFY(first().laws == preset.laws);
    QVERIFY(first().preset.laws != preset.laws);
    write(solution, "{}");
    QVERIFY(!first().laws);
    QCOMPARE(readLab(folder.path())->findings.size(), std::size_t{1});
}

void TestLabReader::hashChangesWithAnyFile_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("instructions") << QStringLiteral("S1/instructions.md");
    QTest::newRow("preset") << QStringLiteral("S2/preset.json");
    QTest::newRow("a new file") << QStringLiteral("S1/picture.svg");
}

void TestLabReader::hashChangesWithAnyFile()
{
    QFETCH(QString, file);
    const QTemporaryDir folder;
    copyLab(folder.path());
    const QString before = readLab(folder.path())->hash;
    QCOMPARE(readLab(folder.path())->hash, before);
    QFile changed(folder.filePath(file));
    QVERIFY(changed.open(QIODevice::Append));
    changed.write("\n");
    changed.close();
    QVERIFY(readLab(folder.path())->hash != before);
}

/// Wherever a lab lies, it is the same lab.
void TestLabReader::hashIsThatOfNamesAndContents()
{
    const QTemporaryDir one;
    const QTemporaryDir two;
    copyLab(one.path());
    copyLab(two.path());
    const QString hash = readLab(one.path())->hash;
    QCOMPARE(hash.size(), 64);
    QCOMPARE(readLab(two.path())->hash, hash);
    QCOMPARE(readLab(two.path() + QLatin1Char('/'))->hash, hash);
    QVERIFY(QFile::rename(two.filePath(QStringLiteral("S2/instructions.md")),
                          two.filePath(QStringLiteral("S2/other.md"))));
    QVERIFY(readLab(two.path())->hash != hash);
}

/// All that judging looks at; what a step starts from is of no interest there.
void TestLabReader::stepReadAloneIsTheSame()
{
    const QString folder = QLatin1String(shippedLab);
    const auto whole = readLabWithFiles(folder, QStringLiteral("de"));
    QVERIFY(whole.ok());
    for (const Task &task : whole->lab.tasks) {
        const auto alone = readLabWithFiles(folder, QStringLiteral("de"), task.id);
        QVERIFY(alone.ok());
        QCOMPARE(alone->lab.hash, whole->lab.hash);
        QCOMPARE(alone->lab.id, whole->lab.id);
        QCOMPARE(alone->lab.tasks.size(), std::size_t{1});
        QVERIFY(alone->files.contents.size() < whole->files.contents.size() / 4);
        const Task &same = alone->lab.tasks.front();
        QCOMPARE(same.title, task.title);
        QCOMPARE(same.solution, task.solution);
        QCOMPARE(writePreset(same.preset), writePreset(task.preset));
        QVERIFY(same.checks == task.checks);
        QCOMPARE(same.mistakes.size(), task.mistakes.size());
        for (std::size_t i = 0; i < task.mistakes.size(); ++i) {
            QCOMPARE(same.mistakes[i].source, task.mistakes[i].source);
            QCOMPARE(same.mistakes[i].message, task.mistakes[i].message);
        }
        QCOMPARE(same.remarks.size(), task.remarks.size());
    }
}

void TestLabReader::stepThatCannotBeFoundReadsAll()
{
    for (const char *step : {"S3", "", "S", "lab.json"}) {
        const auto read = readLabWithFiles(fixture(QStringLiteral("good")), QStringLiteral("en"),
                                           QLatin1String(step));
        QVERIFY(read.ok());
        QCOMPARE(read->lab.tasks.size(), std::size_t{2});
    }
}

QTEST_GUILESS_MAIN(TestLabReader)
#include "test_lab_reader.moc"
