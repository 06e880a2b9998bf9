// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_reader.h"

#include "tasks/proof/lab_verifier.h"
#include "tests/authoring_labs.h"
#include "tests/test_paths.h"

using namespace cradle;
using namespace cradle::authoring;

namespace {

const QString ballFolder = sourcePath("tasks/labs/bouncing-ball");

/// A change of one field, by the name of the row.
void change(TaskForm &form, const QByteArray &field)
{
    if (field == "title")
        form.title = text("Another title");
    else if (field == "commit")
        form.commit = text("Another \"commit\"");
    else if (field == "hint")
        form.hints[1] = text("Another hint");
    else if (field == "code hint")
        form.codeHints.last() = text("Another hint");
    else if (field == "title of a check")
        form.checks[0].title = text("Another check");
    else if (field == "parameter")
        form.checks[0].parameters.insert(text("tolerance"), 0.25);
    else if (field == "scene")
        form.checks.back().scene.insert(text("duration"), 7.5);
    else if (field == "moves")
        form.moves = QStringLiteral("laws");
    else if (field == "points")
        form.points = 2.5;
    else if (field == "extra")
        form.extra = !form.extra;
    else if (field == "remark")
        form.remarks[0].compare = text("positions");
    else if (field == "question")
        form.prediction->question = text("Another question?");
    else if (field == "answer")
        form.prediction->answers[1] = text("Another answer");
    else if (field == "right answer")
        form.prediction->right = form.prediction->right == 0 ? 1 : 0;
}

void addFields()
{
    QTest::addColumn<QByteArray>("field");
    for (const char *field :
         {"title", "commit", "hint", "code hint", "title of a check", "parameter", "scene", "moves",
          "points", "extra", "remark", "question", "answer", "right answer"})
        QTest::newRow(field) << QByteArray(field);
}

const QString masses = text("L42T14"); // it has remarks

} // namespace

/// Edits of a lab change what they say, and no byte besides.
class TestLabEdits : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void formReadAndWrittenKeepsEveryByte_data();
    void formReadAndWrittenKeepsEveryByte();
    void scenesReadAndWrittenKeepEveryByte_data();
    void scenesReadAndWrittenKeepEveryByte();
    void oneFieldChangesOneLine_data();
    void oneFieldChangesOneLine();
    void fieldSetBackKeepsEveryByte_data();
    void fieldSetBackKeepsEveryByte();
    void sceneChangesWhatDiffers();
    void sceneThatCannotBeIsRefused();
    void formThatDoesNotFitIsRefused();
    void unknownKeysAreKept();
    void textOfAnotherSystemKeepsItsLineEnds();

private:
    LabFiles m_lab;
};

void TestLabEdits::initTestCase()
{
    TAKE(m_lab, readLabFiles(shippedFolder));
    QVERIFY(m_lab.contents.size() > 200);
}

void TestLabEdits::formReadAndWrittenKeepsEveryByte_data()
{
    QTest::addColumn<LabFiles>("lab");
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("language");
    LabFiles ball;
    TAKE(ball, readLabFiles(ballFolder));
    for (const LabFiles &lab : {m_lab, ball}) {
        for (const QString &each : stepsOf(lab)) {
            for (const char *language : {"", "en", "de", "fr"})
                QTest::addRow("%s in %s", qPrintable(each), language)
                    << lab << each << text(language);
        }
    }
}

void TestLabEdits::formReadAndWrittenKeepsEveryByte()
{
    QFETCH(LabFiles, lab);
    QFETCH(QString, step);
    QFETCH(QString, language);
    const LabFiles before = lab;
    TaskForm form;
    TAKE(form, taskForm(lab, step, language));
    QVERIFY(!form.checks.empty() && form.hints.size() >= 3 && !form.title.isEmpty());
    TAKE(lab, withTask(lab, step, form, language));
    LabForm whole;
    TAKE(whole, labForm(lab, language));
    TAKE(lab, withLab(lab, whole, language));
    const QString instructions = instructionsPath(lab, step, language);
    if (lab.contents.contains(instructions))
        lab = withText(lab, instructions, textOf(lab, instructions));
    QCOMPARE(differences(before, lab), QStringList());
}

void TestLabEdits::scenesReadAndWrittenKeepEveryByte_data()
{
    QTest::addColumn<LabFiles>("lab");
    QTest::newRow("Lab 4.2") << m_lab;
    LabFiles ball;
    TAKE(ball, readLabFiles(ballFolder));
    QTest::newRow("bouncing ball") << ball;
}

void TestLabEdits::scenesReadAndWrittenKeepEveryByte()
{
    QFETCH(LabFiles, lab);
    const LabFiles before = lab;
    for (const QString &step : stepsOf(lab)) {
        for (const StepPreset which : {StepPreset::Start, StepPreset::Solution}) {
            Preset preset;
            TAKE(preset, presetOf(lab, step, which));
            TAKE(lab, withPreset(lab, step, preset, which));
        }
        for (const KnownKind kind : {KnownKind::Mistake, KnownKind::Remark}) {
            for (const QString &name : knownNames(lab, step, kind)) {
                const QString path = knownPath(step, kind, name);
                QString program;
                TAKE(program, programText(lab, path));
                QVERIFY(!program.isEmpty());
                lab = withProgramText(lab, path, program);
            }
        }
        // Another scene, and back again.
        Preset preset = *presetOf(lab, step);
        const Preset start = preset;
        preset.gravity.y += 1.5;
        preset.circles.front().body.velocity = {0.25, -3};
        TAKE(lab, withPreset(lab, step, preset));
        QVERIFY(*presetOf(lab, step) == preset);
        TAKE(lab, withPreset(lab, step, start));
        QVERIFY(*presetOf(lab, step) == start);
        // A number may have been written with more digits than it needs.
        lab.contents[step + text("/preset.json")] = before.contents[step + text("/preset.json")];
    }
    QCOMPARE(differences(before, lab), QStringList());
}

void TestLabEdits::oneFieldChangesOneLine_data()
{
    addFields();
}

void TestLabEdits::oneFieldChangesOneLine()
{
    QFETCH(QByteArray, field);
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses));
    change(form, field);
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form));
    const QString path = masses + text("/task.json");
    QCOMPARE(differences(m_lab, lab), QStringList{path});
    const QList<QByteArray> lines = newLines(m_lab.contents[path], lab.contents[path]);
    QVERIFY2(lines.size() == 1, lines.join('\n').constData());
    TaskForm again;
    TAKE(again, taskForm(lab, masses));
    QVERIFY(again == form);
    QVERIFY(readLab(lab, text("lab"))->findings.empty());
}

void TestLabEdits::fieldSetBackKeepsEveryByte_data()
{
    addFields();
}

void TestLabEdits::fieldSetBackKeepsEveryByte()
{
    QFETCH(QByteArray, field);
    TaskForm before;
    TAKE(before, taskForm(m_lab, masses));
    QVERIFY(!before.points); // worth its checks together
    TaskForm form = before;
    change(form, field);
    LabFiles lab;
    TAKE(lab, withTask(m_lab, masses, form));
    QVERIFY(lab != m_lab);
    TAKE(lab, withTask(lab, masses, before));
    QCOMPARE(differences(m_lab, lab), QStringList());
}

void TestLabEdits::sceneChangesWhatDiffers()
{
    Preset preset;
    TAKE(preset, presetOf(m_lab, masses));
    preset.gravity = {0, -1.5};
    preset.circles[1].body.radius = 0.3;
    LabFiles lab;
    TAKE(lab, withPreset(m_lab, masses, preset));
    const QString path = masses + text("/preset.json");
    QCOMPARE(differences(m_lab, lab), QStringList{path});
    QCOMPARE(newLines(m_lab.contents[path], lab.contents[path]),
             (QList<QByteArray>{"  \"gravity\": [0, -1.5],", "      \"radius\": 0.3,"}));
    Preset again;
    TAKE(again, presetOf(lab, masses));
    QVERIFY(again == preset);
    // Another number of circles, and a crowd.
    preset.circles.erase(preset.circles.begin());
    TAKE(lab, withPreset(lab, masses, preset));
    QVERIFY(*presetOf(lab, masses) == preset);
    preset.fill = CircleFill{.count = 20};
    preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
    TAKE(lab, withPreset(lab, masses, preset));
    QVERIFY(*presetOf(lab, masses) == preset);
}

void TestLabEdits::sceneThatCannotBeIsRefused()
{
    Preset preset;
    TAKE(preset, presetOf(m_lab, masses));
    preset.circles[0].body.radius = -1;
    const Result<LabFiles> lab = withPreset(m_lab, masses, preset);
    QVERIFY(!lab);
    QCOMPARE(lab.error().file, masses + text("/preset.json"));
    QCOMPARE(lab.error().pointer, text("/circles/0/radius"));
}

void TestLabEdits::formThatDoesNotFitIsRefused()
{
    TaskForm form;
    TAKE(form, taskForm(m_lab, masses));
    form.checks[2].title = QString(201, QLatin1Char('x'));
    const Result<LabFiles> lab = withTask(m_lab, masses, form);
    QVERIFY(!lab);
    QCOMPARE(lab.error().file, masses + text("/task.json"));
    QCOMPARE(lab.error().pointer, text("/checks/2/title"));
    TAKE(form, taskForm(m_lab, masses, text("de")));
    form.title = QString(201, QLatin1Char('x'));
    const Result<LabFiles> translated = withTask(m_lab, masses, form, text("de"));
    QVERIFY(!translated);
    QCOMPARE(translated.error().file, masses + text("/task.de.json"));
    QVERIFY(!taskForm(m_lab, text("nowhere")));
}

void TestLabEdits::unknownKeysAreKept()
{
    LabFiles lab = m_lab;
    const QString path = masses + text("/preset.json");
    // In the forms that people write: tabs, exponents, no space after a colon.
    lab.contents[path] = "{ \"format\":1,\n\t\"restitution\" : 1.0e0,\"circles\":[\n"
                         "\t\t{\"position\":[0,  1]},\t{\"position\":[2.50, 1]} ]\n}";
    Preset preset;
    TAKE(preset, presetOf(lab, masses));
    preset.circles[1].body.velocity = {1, 0};
    TAKE(lab, withPreset(lab, masses, preset));
    QCOMPARE(
        lab.contents[path],
        QByteArray("{ \"format\":1,\n\t\"restitution\" : 1.0e0,\"circles\":[\n"
                   "\t\t{\"position\":[0,  1]},\t{\"position\":[2.50, 1], \"velocity\": [1, 0]} "
                   "]\n}"));
}

void TestLabEdits::textOfAnotherSystemKeepsItsLineEnds()
{
    LabFiles lab = m_lab;
    const QString path = masses + text("/instructions.md");
    lab.contents[path] = "\xef\xbb\xbf# Title\r\nText\r\n";
    QCOMPARE(textOf(lab, path), text("# Title\nText\n"));
    QCOMPARE(withText(lab, path, text("# Title\nText\n")).contents[path], lab.contents[path]);
    QCOMPARE(withText(lab, path, text("# Other\n")).contents[path], QByteArray("# Other\n"));
}

QTEST_GUILESS_MAIN(TestLabEdits)
#include "test_lab_edits.moc"
