// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_reader.h"

#include "model/files/preset_json.h"
#include "tests/test_paths.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace cradle;

class TestLabReader : public QObject
{
    Q_OBJECT
private slots:
    void readsALab();
    void readsTheStudentsLanguage();
    void takesItsOwnLanguageWhereThereIsNoOther();
    void lawsAreThoseOfTheSceneThatPasses();
    void refusesALabWithoutAUsableIndex_data();
    void refusesALabWithoutAUsableIndex();
    void leavesABrokenStepOutAndSaysWhy_data();
    void leavesABrokenStepOutAndSaysWhy();
    void keepsAStepWithATextThatCannotBeRead_data();
    void keepsAStepWithATextThatCannotBeRead();
    void refusesHugeTexts_data();
    void refusesHugeTexts();
    void hashChangesWithAnyFile_data();
    void hashChangesWithAnyFile();
    void hashIsThatOfNamesAndContents();
    void stepReadAloneIsTheSame();
    void stepThatCannotBeFoundReadsAll();
};

namespace {

QString fixture(const QString &name)
{
    return fixturePath("labs/") + name;
}

void write(const QString &path, const QByteArray &text)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

/// A copy of the good lab, to be broken.
void copyLab(const QString &to)
{
    const QString from = fixture(QStringLiteral("good"));
    for (const char *name : {"lab.json", "S1/task.json", "S1/preset.json", "S1/instructions.md",
                             "S2/task.json", "S2/preset.json", "S2/instructions.md"}) {
        const QString path = QLatin1Char('/') + QLatin1String(name);
        QVERIFY(QDir().mkpath(QFileInfo(to + path).path()));
        QVERIFY(QFile::copy(from + path, to + path));
    }
}

QByteArray said(const Lab &lab)
{
    QStringList lines;
    for (const Error &finding : lab.findings)
        lines.append(finding.toString());
    return lines.join(QLatin1Char('\n')).toUtf8();
}

} // namespace

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

void TestLabReader::refusesALabWithoutAUsableIndex_data()
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

void TestLabReader::refusesALabWithoutAUsableIndex()
{
    QFETCH(QString, place);
    const QString folder = fixture(QString::fromLatin1(QTest::currentDataTag()));
    const Result<Lab> lab = readLab(folder);
    QVERIFY(!lab.ok());
    const QString text = lab.error().toString();
    QVERIFY2(text.startsWith(folder + QStringLiteral("/lab.json") + place), qPrintable(text));
}

void TestLabReader::leavesABrokenStepOutAndSaysWhy_data()
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

void TestLabReader::leavesABrokenStepOutAndSaysWhy()
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

void TestLabReader::keepsAStepWithATextThatCannotBeRead_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("file");
    const QString text = QStringLiteral("/S2/instructions.md: ");
    QTest::newRow("instructions_missing") << QStringLiteral("en") << text;
    QTest::newRow("instructions_latin1") << QStringLiteral("en") << text;
    QTest::newRow("translation_broken")
        << QStringLiteral("de") << QStringLiteral("/S2/task.de.json: /title: 5");
}

void TestLabReader::keepsAStepWithATextThatCannotBeRead()
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

void TestLabReader::refusesHugeTexts_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("tasks");
    QTest::newRow("index") << QStringLiteral("lab.json") << 0;
    QTest::newRow("task") << QStringLiteral("S2/task.json") << 1;
    QTest::newRow("instructions") << QStringLiteral("S2/instructions.md") << 2;
}

void TestLabReader::refusesHugeTexts()
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
