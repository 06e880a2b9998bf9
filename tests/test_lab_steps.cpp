// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_problems.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::authoring;

/// New labs, and edits of whole steps and their programs.
class TestLabSteps : public QObject
{
    Q_OBJECT
private slots:
    void newLabPassesVerify_data();
    void newLabPassesVerify();
    void addedStepPassesVerify();
    void stepsMove_data();
    void stepsMove();
    void movedThereAndBackKeepsEveryByte();
    void renamedStepKeepsItsFiles();
    void duplicateIsALikeStepBesideIt();
    void removedStepLeavesNothing();
    void wrongStepsAreRefused_data();
    void wrongStepsAreRefused();
    void freeNameIsFree();
    void labIsNamed();
};

namespace {

LabFiles threeSteps()
{
    LabFiles lab = small();
    for (const char *name : {"S2", "S3"}) {
        const Result<LabFiles> more = withStepAdded(lab, text(name), text("More"));
        lab = more ? *more : LabFiles{};
    }
    return lab;
}

} // namespace

void TestLabSteps::newLabPassesVerify_data()
{
    QTest::addColumn<QString>("language");
    for (const char *language : {"en", "de", "fr"})
        QTest::newRow(language) << text(language);
}

void TestLabSteps::newLabPassesVerify()
{
    QFETCH(QString, language);
    const LabFiles files = newLab(text("my.lab-1"), text("Größe \"zwei\""), language);
    const Lab lab = *readLab(files, text("lab"), language);
    QCOMPARE(lab.id, text("my.lab-1"));
    QCOMPARE(lab.title, text("Größe \"zwei\""));
    QCOMPARE(lab.language, language);
    QCOMPARE(lab.tasks.size(), std::size_t{1});
    QCOMPARE(lab.tasks[0].checks.size(), std::size_t{1});
    QCOMPARE(lab.tasks[0].mistakes.size(), std::size_t{1});
    QVERIFY(!lab.tasks[0].starter.isEmpty() && !lab.tasks[0].solution.isEmpty());
    QVERIFY(lab.tasks[0].instructions.startsWith(QLatin1Char('#')));
    QVERIFY(*presetOf(files, text("S1"), StepPreset::Solution) != *presetOf(files, text("S1")));
    QCOMPARE(problemsOf(files, language), QStringList());
}

void TestLabSteps::addedStepPassesVerify()
{
    LabFiles lab;
    TAKE(lab, withStepAdded(small(), text("begin"), text("Begin"), 0));
    QCOMPARE(stepsOf(lab), words("begin S1"));
    QCOMPARE(taskForm(lab, text("begin"))->id, text("begin"));
    QCOMPARE(taskForm(lab, text("begin"))->title, text("Begin"));
    QCOMPARE(problemsOf(lab, text("en")), QStringList());
}

void TestLabSteps::stepsMove_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<int>("to");
    QTest::addColumn<QStringList>("order");
    QTest::newRow("to the front") << text("S3") << 0 << words("S3 S1 S2");
    QTest::newRow("to the end") << text("S1") << 2 << words("S2 S3 S1");
    QTest::newRow("beyond the end") << text("S1") << 9 << words("S2 S3 S1");
    QTest::newRow("before the front") << text("S2") << -1 << words("S2 S1 S3");
    QTest::newRow("nowhere") << text("S2") << 1 << words("S1 S2 S3");
}

void TestLabSteps::stepsMove()
{
    QFETCH(QString, step);
    QFETCH(int, to);
    QFETCH(QStringList, order);
    LabFiles lab;
    TAKE(lab, withStepMoved(threeSteps(), step, to));
    QCOMPARE(stepsOf(lab), order);
    const Lab read = *readLab(lab, text("lab"));
    for (qsizetype i = 0; i < order.size(); ++i)
        QCOMPARE(read.tasks[static_cast<std::size_t>(i)].id, order[i]);
}

void TestLabSteps::movedThereAndBackKeepsEveryByte()
{
    LabFiles shipped;
    TAKE(shipped, readLabFiles(shippedFolder));
    LabFiles lab;
    TAKE(lab, withStepMoved(shipped, text("L42T9"), 2));
    QCOMPARE(differences(shipped, lab), words("lab.json"));
    TAKE(lab, withStepMoved(lab, text("L42T9"), 8));
    QCOMPARE(differences(shipped, lab), QStringList());
}

void TestLabSteps::renamedStepKeepsItsFiles()
{
    LabFiles shipped;
    TAKE(shipped, readLabFiles(shippedFolder));
    LabFiles lab;
    TAKE(lab, withStepRenamed(shipped, text("L42T14"), text("masses")));
    QCOMPARE(stepsOf(lab).indexOf(text("masses")), stepsOf(shipped).indexOf(text("L42T14")));
    QCOMPARE(taskForm(lab, text("masses"))->id, text("masses"));
    QCOMPARE(lab.contents.size(), shipped.contents.size());
    QCOMPARE(lab.contents[text("masses/remarks/integer-four-thirds.lua")],
             shipped.contents[text("L42T14/remarks/integer-four-thirds.lua")]);
    TAKE(lab, withStepRenamed(lab, text("masses"), text("L42T14")));
    QCOMPARE(differences(shipped, lab), QStringList());
    // Capital letters alone.
    TAKE(lab, withStepRenamed(small(), text("S1"), text("s1")));
    QCOMPARE(stepsOf(lab), words("s1"));
    // An id that is not the folder's name is the author's.
    TaskForm form = *taskForm(lab, text("s1"));
    form.id = text("own-id");
    TAKE(lab, withTask(lab, text("s1"), form));
    TAKE(lab, withStepRenamed(lab, text("s1"), text("other")));
    QCOMPARE(taskForm(lab, text("other"))->id, text("own-id"));
}

void TestLabSteps::duplicateIsALikeStepBesideIt()
{
    LabFiles lab;
    TAKE(lab, withStepDuplicated(threeSteps(), text("S2"), text("S2b")));
    QCOMPARE(stepsOf(lab), words("S1 S2 S2b S3"));
    const Lab read = *readLab(lab, text("lab"));
    QVERIFY(read.findings.empty());
    QCOMPARE(read.tasks[2].id, text("S2b"));
    QCOMPARE(read.tasks[2].title, read.tasks[1].title);
    QCOMPARE(read.tasks[2].mistakes.size(), read.tasks[1].mistakes.size());
}

void TestLabSteps::removedStepLeavesNothing()
{
    LabFiles lab;
    TAKE(lab, withStepRemoved(threeSteps(), text("S2")));
    QCOMPARE(stepsOf(lab), words("S1 S3"));
    for (const QString &path : lab.contents.keys())
        QVERIFY2(!path.startsWith(text("S2/")), qPrintable(path));
    TAKE(lab, withStepRemoved(lab, text("S1")));
    TAKE(lab, withStepRemoved(lab, text("S3")));
    QCOMPARE(lab.contents.keys(), words("lab.json"));
    QVERIFY(readLab(lab, text("lab"))->tasks.empty());
}

void TestLabSteps::wrongStepsAreRefused_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"", "S2", "s2", "../x", "a b", "a/b", "ä", "con", "."})
        QTest::newRow(name) << text(name);
}

void TestLabSteps::wrongStepsAreRefused()
{
    QFETCH(QString, name);
    const LabFiles lab = threeSteps();
    QVERIFY(!withStepAdded(lab, name, text("Title")));
    QVERIFY(!withStepDuplicated(lab, text("S1"), name));
    QVERIFY(!withStepRenamed(lab, text("S1"), name));
    const Result<LabFiles> missing = withStepRemoved(lab, text("S9"));
    QVERIFY(!missing);
    QVERIFY(missing.error().message.contains(text("S9")));
    QVERIFY(!withStepMoved(lab, text("S9"), 0));
    QVERIFY(!withStepRenamed(lab, text("S9"), text("S10")));
}

void TestLabSteps::freeNameIsFree()
{
    LabFiles lab = threeSteps();
    QCOMPARE(freeStepName(lab, text("S4")), text("S4"));
    QCOMPARE(freeStepName(lab, text("S1")), text("S1-2"));
    TAKE(lab, withStepAdded(lab, text("S1-2"), text("More")));
    QCOMPARE(freeStepName(lab, text("S1")), text("S1-3"));
}

void TestLabSteps::labIsNamed()
{
    LabFiles lab = small();
    LabForm form = *labForm(lab);
    form.title = text("Another");
    form.version = text("2.0");
    TAKE(lab, withLab(lab, form));
    QVERIFY(*labForm(lab) == form);
    form.title = text("Ein anderes");
    TAKE(lab, withLab(lab, form, text("de")));
    QCOMPARE(labForm(lab)->title, text("Another"));
    QCOMPARE(labForm(lab, text("de"))->title, text("Ein anderes"));
    QCOMPARE(readLab(lab, text("lab"), text("de"))->title, text("Ein anderes"));
    // What is not said has no member.
    form.version.clear();
    form.language.clear();
    TAKE(lab, withLab(lab, form));
    const QByteArray written = lab.contents.value(text("lab.json"));
    QVERIFY2(!written.contains("version") && !written.contains("language"), written);
    form.id = text("no id");
    QVERIFY(!withLab(lab, form));
}

QTEST_GUILESS_MAIN(TestLabSteps)
#include "test_lab_steps.moc"
