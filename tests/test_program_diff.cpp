// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/authoring_labs.h"

#include "tasks/reading/lab_reader.h"
#include "tasks/text/program_diff.h"

using namespace cradle;
using namespace cradle::authoring;

/// Mistakes that are kept as differences from the solution of their step.
class TestProgramDiff : public QObject
{
    Q_OBJECT
private slots:
    void wholeProgramIsMadeOfTheDifference();
    void differenceIsMadeOfTheWholeProgram();
    void changeOfTheSolutionReachesTheMistake();
    void differenceThatNoLongerAppliesIsNamed();
    void mistakesAreEditedRenamedAndRemovedAsDifferences();
    void missingCommentOfTheSolutionIsNoDifference();
    void labIsTurned();
};

namespace {

const QString solution = text("-- A spring.\n\nlocal k = 2\n\nfunction on_update(dt)\n"
                              "  local x = circle1.position\n  circle1.velocity = -k * x\nend\n"
                              "\nfunction on_load()\n  circle1.position = vec(1, 0)\nend\n");
const QString program = text("-- The sign is wrong\n--\n-- It is *pushed* away.\n\n"
                             "-- A spring.\n\nlocal k = 2\n\nfunction on_update(dt)\n"
                             "  local x = circle1.position\n  circle1.velocity = k * x\nend\n"
                             "\nfunction on_load()\n  circle1.position = vec(1, 0)\nend\n");
const QString diff = text("The sign is wrong\n\nIt is *pushed* away.\n\n--- solution.lua\n"
                          "+++ mistakes/sign.lua\n@@ -4,7 +4,7 @@\n \n function on_update(dt)\n"
                          "   local x = circle1.position\n-  circle1.velocity = -k * x\n"
                          "+  circle1.velocity = k * x\n end\n \n function on_load()\n");
const QString sign = text("S1/mistakes/sign.lua");

/// A lab whose first step has that mistake, as a difference.
LabFiles springLab()
{
    LabFiles files = newLab(text("lab"), text("Lab"), text("en"));
    files = withText(files, text("S1/solution.lua"), solution);
    return *withKnownAdded(files, text("S1"), KnownKind::Mistake, text("sign"), program);
}

/// The mistake of that name as a student's is compared with it; empty if there is none.
QString sourceOf(const LabFiles &files, const char *name)
{
    const Result<Lab> lab = readLab(files, text("lab"));
    for (const KnownScript &mistake : lab->tasks.at(0).mistakes) {
        if (mistake.name == text(name))
            return mistake.source;
    }
    return {};
}

} // namespace

void TestProgramDiff::wholeProgramIsMadeOfTheDifference()
{
    QCOMPARE(*programFromDiff(diff, solution), program);
    QCOMPARE(*programFromDiff(QString(diff).replace(text("\n"), text("\r\n")), solution), program);
    const QString twice = text("--- solution.lua\nstands in the text, and again:\n\n");
    QVERIFY(programFromDiff(twice + diff, solution)->startsWith(text("-- --- solution.lua\n")));
    QCOMPARE(*programFromDiff(QString(diff).remove(0, diff.indexOf(text("---"))), solution),
             QString(program).remove(0, program.indexOf(text("-- A spring"))));
    // Without the lines of names all is what the student reads.
    QCOMPARE(*programFromDiff(text("One word\n"), solution), text("-- One word\n\n") + solution);
}

void TestProgramDiff::differenceIsMadeOfTheWholeProgram()
{
    QCOMPARE(diffOfProgram(program, solution, text("mistakes/sign.lua")), diff);
    QVERIFY(isWorthADiff(program, solution));
    QVERIFY(!isWorthADiff(text("-- Other\n\nx = 1\n"), solution));
    QVERIFY(!isWorthADiff(program, QString()));
}

void TestProgramDiff::changeOfTheSolutionReachesTheMistake()
{
    LabFiles lab = springLab();
    QVERIFY(isDiff(lab, sign));
    QVERIFY(!lab.contents.contains(sign));
    QCOMPARE(sourceOf(lab, "sign"), program);
    QString stiffer = solution;
    lab = withText(lab, text("S1/solution.lua"), stiffer.replace(text("k = 2"), text("k = 3")));
    QCOMPARE(sourceOf(lab, "sign"), QString(program).replace(text("k = 2"), text("k = 3")));
    QCOMPARE(*programText(lab, sign), sourceOf(lab, "sign"));
}

void TestProgramDiff::differenceThatNoLongerAppliesIsNamed()
{
    LabFiles lab = springLab();
    QString other = solution;
    lab = withText(lab, text("S1/solution.lua"), other.replace(text("-k * x"), text("-k * x * 1")));
    const Result<Lab> read = readLab(lab, text("lab"));
    QCOMPARE(read->findings.size(), std::size_t{1});
    QCOMPARE(read->findings[0].file, text("lab/S1/mistakes/sign.diff"));
    QCOMPARE(read->findings[0].line, 7); // the hunk
    QVERIFY(sourceOf(lab, "sign").isEmpty());
    QVERIFY(!sourceOf(lab, "upward").isEmpty()); // the others go on
    QCOMPARE(programText(lab, sign).error().file, text("S1/mistakes/sign.diff"));
}

void TestProgramDiff::mistakesAreEditedRenamedAndRemovedAsDifferences()
{
    const LabFiles lab = springLab();
    const QString edited = QString(program).replace(text("= k * x"), text("= 2 * k * x"));
    LabFiles more = withProgramText(lab, sign, edited);
    QCOMPARE(*programText(more, sign), edited);
    QVERIFY(!more.contents.contains(sign));
    TAKE(more, withKnownRenamed(more, text("S1"), KnownKind::Mistake, text("sign"), text("away")));
    QCOMPARE(knownNames(more, text("S1"), KnownKind::Mistake),
             text("away upward").split(QLatin1Char(' ')));
    QCOMPARE(*programText(more, text("S1/mistakes/away.lua")), edited);
    QVERIFY(textOf(more, text("S1/mistakes/away.diff")).contains(text("+++ mistakes/away.lua")));
    QVERIFY(!withKnownRenamed(more, text("S1"), KnownKind::Mistake, text("upward"), text("away")));
    TAKE(more, withKnownRemoved(more, text("S1"), KnownKind::Mistake, text("away")));
    QCOMPARE(knownNames(more, text("S1"), KnownKind::Mistake),
             text("upward").split(QLatin1Char(' ')));
    QVERIFY(!more.contents.contains(text("S1/mistakes/away.diff")));
}

void TestProgramDiff::missingCommentOfTheSolutionIsNoDifference()
{
    const QString without = QString(program).remove(text("-- A spring.\n\n"));
    QCOMPARE(withCommentOf(solution, without), program);
    QCOMPARE(withCommentOf(solution, program), program);
    const QString another = QString(program).replace(text("-- A spring."), text("-- A rope."));
    QCOMPARE(withCommentOf(solution, another), another);
}

void TestProgramDiff::labIsTurned()
{
    LabFiles lab = withoutFile(springLab(), text("S1/mistakes/sign.diff"));
    lab = withText(lab, sign, program);
    lab = withText(lab, text("S1/mistakes/other.lua"), text("-- Other\n\nx = 1\n"));
    const LabFiles turned = withDifferences(lab);
    QCOMPARE(textOf(turned, text("S1/mistakes/sign.diff")), diff);
    QVERIFY(!turned.contents.contains(sign));
    QVERIFY(turned.contents.contains(text("S1/mistakes/other.lua")));
    QCOMPARE(sourceOf(turned, "sign"), sourceOf(lab, "sign"));
    QCOMPARE(withDifferences(turned), turned);
    // The shipped labs are.
    const LabFiles shipped = *readLabFiles(shippedFolder);
    QCOMPARE(differences(shipped, withDifferences(shipped)), QStringList());
}

QTEST_MAIN(TestProgramDiff)
#include "test_program_diff.moc"
