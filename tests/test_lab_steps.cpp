// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/authoring_labs.h"

#include "tasks/proof/lab_verifier.h"
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
    void mistakesAreAddedRenamedAndRemoved();
    void remarksAreListedInTheTask();
    void textOfAMistakeIsTranslated();
    void wrongProgramsAreRefused();
    void labIsNamed();
};

namespace {

LabFiles small()
{
    return newLab(text("small"), text("Small"), text("en"));
}

LabFiles threeSteps()
{
    LabFiles lab = small();
    for (const char *name : {"S2", "S3"}) {
        const Result<LabFiles> more = withStepAdded(lab, text(name), text("More"));
        lab = more ? *more : LabFiles{};
    }
    return lab;
}

QStringList words(const char *list)
{
    return text(list).split(QLatin1Char(' '));
}

/// What the reader and the verifier say of a lab.
QStringList problemsOf(const LabFiles &files, const QString &language)
{
    const Result<Lab> lab = readLab(files, text("lab"), language);
    if (!lab)
        return {lab.error().toString()};
    QStringList problems;
    for (const Error &finding : lab->findings)
        problems.append(finding.toString());
    for (const VerifiedTask &task : verifyLab(*lab)) {
        for (const LabFinding &finding : task.findings)
            problems.append(finding.message);
    }
    return problems;
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

void TestLabSteps::mistakesAreAddedRenamedAndRemoved()
{
    const LabFiles lab = small();
    const QString source = text("-- It stands still\n\nfunction on_update(dt)\nend\n");
    LabFiles more;
    TAKE(more, withKnownAdded(lab, text("S1"), KnownKind::Mistake, text("still"), source));
    QCOMPARE(knownNames(more, text("S1"), KnownKind::Mistake), words("still upward"));
    QCOMPARE(problemsOf(more, text("en")), QStringList());
    TAKE(more,
         withKnownRenamed(more, text("S1"), KnownKind::Mistake, text("still"), text("asleep")));
    QCOMPARE(knownNames(more, text("S1"), KnownKind::Mistake), words("asleep upward"));
    QCOMPARE(textOf(more, text("S1/mistakes/asleep.lua")), source);
    TAKE(more, withKnownRemoved(more, text("S1"), KnownKind::Mistake, text("asleep")));
    QCOMPARE(differences(lab, more), QStringList());
}

void TestLabSteps::remarksAreListedInTheTask()
{
    const LabFiles lab = small();
    const QString source = text("-- A word\n\nfunction on_update(dt)\nend\n");
    LabFiles more;
    TAKE(more, withKnownAdded(lab, text("S1"), KnownKind::Remark, text("word"), source));
    QCOMPARE(knownNames(more, text("S1"), KnownKind::Remark), words("word"));
    const Lab read = *readLab(more, text("lab"));
    QVERIFY(read.findings.empty());
    QCOMPARE(read.tasks[0].remarks.at(0).script.message, text("A word"));
    TAKE(more, withKnownRenamed(more, text("S1"), KnownKind::Remark, text("word"), text("words")));
    QCOMPARE(taskForm(more, text("S1"))->remarks.at(0).id, text("words"));
    TAKE(more, withKnownRemoved(more, text("S1"), KnownKind::Remark, text("words")));
    QCOMPARE(differences(lab, more), QStringList());
}

void TestLabSteps::textOfAMistakeIsTranslated()
{
    LabFiles lab;
    TAKE(lab, withKnownText(small(), text("S1"), KnownKind::Mistake, text("upward"), text("de"),
                            text("Nach oben\n\nVorzeichen.")));
    QCOMPARE(knownText(lab, text("S1"), KnownKind::Mistake, text("upward"), text("de")),
             text("Nach oben\n\nVorzeichen."));
    QCOMPARE(readLab(lab, text("lab"), text("de"))->tasks[0].mistakes[0].message,
             text("Nach oben\n\nVorzeichen."));
    TAKE(lab, withKnownRenamed(lab, text("S1"), KnownKind::Mistake, text("upward"), text("up")));
    QCOMPARE(knownText(lab, text("S1"), KnownKind::Mistake, text("up"), text("de")),
             text("Nach oben\n\nVorzeichen."));
    QVERIFY(knownText(lab, text("S1"), KnownKind::Mistake, text("upward"), text("de")).isEmpty());
    TAKE(lab,
         withKnownText(lab, text("S1"), KnownKind::Mistake, text("up"), text("de"), QString()));
    QCOMPARE(lab.contents[text("S1/task.de.json")], QByteArray("{}\n"));
}

void TestLabSteps::wrongProgramsAreRefused()
{
    const LabFiles lab = small();
    const auto added = [&](const char *name) {
        return withKnownAdded(lab, text("S1"), KnownKind::Mistake, text(name), text("-- A\n"));
    };
    for (const char *name : {"upward", "UPWARD", "", "../x", "a/b", "a b", ".x"})
        QVERIFY2(!added(name), name);
    QVERIFY(!withKnownRemoved(lab, text("S1"), KnownKind::Mistake, text("none")));
    QVERIFY(!withKnownRenamed(lab, text("S1"), KnownKind::Mistake, text("none"), text("some")));
    QVERIFY(withKnownRenamed(lab, text("S1"), KnownKind::Mistake, text("upward"), text("Upward")));
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
    form.id = text("no id");
    QVERIFY(!withLab(lab, form));
}

QTEST_GUILESS_MAIN(TestLabSteps)
#include "test_lab_steps.moc"
