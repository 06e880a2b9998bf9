// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab_problems.h"

#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::authoring;

/// Known programs are added to a step, renamed and removed.
class TestLabPrograms : public QObject
{
    Q_OBJECT
private slots:
    void mistakesAreAddedRenamedAndRemoved();
    void remarksAreListedInTheTask();
    void textOfAMistakeIsTranslated();
    void wrongProgramsAreRefused();
};

void TestLabPrograms::mistakesAreAddedRenamedAndRemoved()
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

void TestLabPrograms::remarksAreListedInTheTask()
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

void TestLabPrograms::textOfAMistakeIsTranslated()
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

void TestLabPrograms::wrongProgramsAreRefused()
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

QTEST_GUILESS_MAIN(TestLabPrograms)
#include "test_lab_programs.moc"
