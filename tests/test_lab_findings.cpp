// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/lab_findings.h"

#include <QTest>

using namespace cradle;

/// What is wrong with a step whose programs have been judged: verdicts made by hand.
class TestLabFindings : public QObject
{
    Q_OBJECT
private slots:
    void wrongVerdictIsFound_data();
    void wrongVerdictIsFound();
    void stepNeedsASolution();
    void checkThatNothingFailsIsFound();
    void checkThatRepeatsOthersIsTold_data();
    void checkThatRepeatsOthersIsTold();
    void sameCheckTwiceIsTold();
    void endlessNumbersAreTold_data();
    void endlessNumbersAreTold();
    void unfinishedTextsAreThoseOfTheStep();
};

namespace {

using Kind = LabFinding::Kind;
using Role = VerifiedProgram::Role;

/// A report that fails by some of the checks a, b and c.
CheckReport failing(const QString &failed)
{
    CheckReport report;
    report.seed = 7;
    report.passed = failed.isEmpty();
    for (const char id : {'a', 'b', 'c'}) {
        const bool fails = failed.contains(QLatin1Char(id));
        CheckOutcome &check = report.checks.emplace_back();
        check.id = QLatin1Char(id);
        check.passed = !fails;
        check.message = fails ? QStringLiteral("no") : QString();
    }
    return report;
}

/// A step with the checks a, b and c, which differ, and a solution.
struct Step {
    Step()
    {
        lab.folder = QStringLiteral("/lab");
        task.id = QStringLiteral("S1");
        task.folder = QStringLiteral("/lab/S1");
        task.solution = QStringLiteral("x = 1");
        for (const char id : {'a', 'b', 'c'}) {
            CheckSpec &check = task.checks.emplace_back();
            check.id = check.kind = QLatin1Char(id);
            verified.checks.append(check.id);
        }
        add(Role::Solution, {}, {});
    }
    void add(Role role, const QString &name, const QString &failed)
    {
        verified.programs.push_back({.role = role, .name = name, .reports = {failing(failed)}});
    }
    void find() { findProblems(lab, task, gaps, verified); }
    [[nodiscard]] static QStringList told(const std::vector<LabFinding> &all, Kind kind)
    {
        QStringList messages;
        for (const LabFinding &each : all) {
            if (each.kind == kind)
                messages.append(each.message);
        }
        return messages;
    }

    Lab lab;
    Task task;
    std::vector<Error> gaps;
    VerifiedTask verified;
};

} // namespace

void TestLabFindings::wrongVerdictIsFound_data()
{
    QTest::addColumn<int>("role");
    QTest::addColumn<QString>(
        "failed");                 // checks; ! stands for an error of the program, ? of a check
    QTest::addColumn<int>("kind"); // -1: none
    QTest::addColumn<QString>("said");
    const auto row = [](const char *name, Role role, const char *failed, int kind,
                        const char *said) {
        QTest::newRow(name) << int(role) << QString::fromLatin1(failed) << kind
                            << QString::fromUtf8(said);
    };
    row("starter passes", Role::Starter, "", int(Kind::StarterPasses),
        "passes; a starter should fail by a check");
    row("starter fails", Role::Starter, "b", -1, "");
    row("solution fails", Role::Solution, "bc", int(Kind::SolutionFails),
        "fails with seed 7 by b: no");
    row("solution passes", Role::Solution, "", -1, "");
    row("solution stops", Role::Solution, "!", int(Kind::ProgramErrs),
        "stops with an error at line 3: oh");
    row("mistake passes", Role::Mistake, "", int(Kind::MistakePasses),
        "passes; a mistake should fail by a check");
    row("mistake is not recognised", Role::Mistake, "a", int(Kind::MistakeNotRecognised),
        "is not recognised");
    row("remark fails", Role::Remark, "c", int(Kind::RemarkFails),
        "fails by c: no; work that gets a remark passes");
    row("remark is not recognised", Role::Remark, "", int(Kind::RemarkNotRecognised),
        "is not recognised");
    row("check stops", Role::Mistake, "a?", int(Kind::CheckStops),
        "is not judged by the check a: no");
}

void TestLabFindings::wrongVerdictIsFound()
{
    QFETCH(int, role);
    QFETCH(QString, failed);
    QFETCH(int, kind);
    QFETCH(QString, said);
    Step step;
    step.add(Role(role), QStringLiteral("name"), failed);
    CheckReport &report = step.verified.programs.back().reports.front();
    if (failed.contains(QLatin1Char('!')))
        report.error = ProgramError{.message = QStringLiteral("oh"), .line = 3};
    report.checks.front().checkStopped = failed.contains(QLatin1Char('?'));
    step.find();
    std::vector<LabFinding> found = step.verified.findings;
    std::erase_if(found, [](const LabFinding &each) { return each.kind == Kind::CheckNeverFails; });
    QCOMPARE(found.size(), std::size_t(kind < 0 ? 0 : 1));
    if (kind < 0)
        return;
    QCOMPARE(int(found[0].kind), kind);
    QCOMPARE(found[0].message,
             programPath(step.verified.programs.back()) + QLatin1Char(' ') + said);
    QCOMPARE(found[0].task, QStringLiteral("S1"));
    QCOMPARE(found[0].seed, qint64(7));
    QCOMPARE(found[0].program, programPath(step.verified.programs.back()));
}

void TestLabFindings::stepNeedsASolution()
{
    Step step;
    step.task.solution.clear();
    step.find();
    QCOMPARE(Step::told(step.verified.findings, Kind::NoSolution),
             QStringList{QStringLiteral("there is no solution.lua")});
}

void TestLabFindings::checkThatNothingFailsIsFound()
{
    Step step;
    step.add(Role::Mistake, QStringLiteral("one"), QStringLiteral("a"));
    step.add(Role::Starter, QStringLiteral("starter"), QStringLiteral("b")); // is no mistake
    step.find();
    QCOMPARE(Step::told(step.verified.findings, Kind::CheckNeverFails),
             (QStringList{QStringLiteral("no mistake fails the check b"),
                          QStringLiteral("no mistake fails the check c")}));
}

void TestLabFindings::checkThatRepeatsOthersIsTold_data()
{
    QTest::addColumn<QString>("mistakes"); // the checks that each fails by
    QTest::addColumn<QString>("told");
    QTest::newRow("each alone") << "a b c"
                                << "";
    QTest::newRow("never alone") << "ab a b c"
                                 << "";
    QTest::newRow("b with a") << "ab a c"
                              << "no mistake fails by the check b alone: it repeats a";
    QTest::newRow("b with a and c, mostly c")
        << "bc bc ab a c"
        << "no mistake fails by the check b alone: it repeats c, a";
    QTest::newRow("one that sees all") << "abc bc ab c a"
                                       << "no mistake fails by the check b alone: it repeats a, c";
}

void TestLabFindings::checkThatRepeatsOthersIsTold()
{
    QFETCH(QString, mistakes);
    QFETCH(QString, told);
    Step step;
    for (const QString &failed : mistakes.split(QLatin1Char(' ')))
        step.add(Role::Mistake, failed, failed);
    step.find();
    QCOMPARE(Step::told(step.verified.warnings, Kind::CheckNeverAlone).join(QLatin1Char('|')),
             told);
}

void TestLabFindings::sameCheckTwiceIsTold()
{
    Step step;
    step.task.checks[2].kind = step.task.checks[0].kind;
    step.find();
    QCOMPARE(Step::told(step.verified.warnings, Kind::CheckIsDuplicate),
             QStringList{QStringLiteral("the check c asks for the same as a")});
    for (const int what : {0, 1, 2, 3}) {
        Step other;
        CheckSpec &check = other.task.checks[2];
        check.kind = other.task.checks[0].kind;
        if (what == 0)
            check.circles = {2};
        else if (what == 1)
            check.parameters.insert(QStringLiteral("p"), 1);
        else if (what == 2)
            check.scene.insert(QStringLiteral("p"), 1);
        else
            check.source = QStringLiteral("return 1");
        other.find();
        QVERIFY(Step::told(other.verified.warnings, Kind::CheckIsDuplicate).isEmpty());
    }
}

void TestLabFindings::endlessNumbersAreTold_data()
{
    QTest::addColumn<double>("number");
    QTest::addColumn<double>("tolerance");
    QTest::addColumn<bool>("isNumber"); // what is asked for
    QTest::addColumn<bool>("told");
    QTest::newRow("a third") << 1.0 / 3.0 << 0.0 << true << true;
    QTest::newRow("with a tolerance") << 1.0 / 3.0 << 0.01 << true << false;
    QTest::newRow("six digits") << 1.23456 << 0.0 << true << false;
    QTest::newRow("seven digits") << 1.234567 << 0.0 << true << true;
    QTest::newRow("a choice") << 1.0 / 3.0 << 0.0 << false << false;
}

void TestLabFindings::endlessNumbersAreTold()
{
    QFETCH(double, number);
    QFETCH(double, tolerance);
    QFETCH(bool, isNumber);
    QFETCH(bool, told);
    Step step;
    Question question;
    question.id = QStringLiteral("q");
    question.kind = isNumber ? Question::Kind::Number : Question::Kind::One;
    question.number = number;
    question.tolerance = tolerance;
    step.task.questions = {question};
    step.find();
    const QStringList said = Step::told(step.verified.warnings, Kind::QuestionEndless);
    QCOMPARE(said.size(), told ? 1 : 0);
    if (told)
        QVERIFY(said[0].startsWith(QLatin1String("the question q asks for ")
                                   + QString::number(number, 'g', 9)));
}

void TestLabFindings::unfinishedTextsAreThoseOfTheStep()
{
    Step step;
    step.gaps = {{.message = QStringLiteral("gap"), .file = QStringLiteral("S1/text.de.md")},
                 {.message = QStringLiteral("other"), .file = QStringLiteral("S10/text.de.md")},
                 {.message = QStringLiteral("lab"), .file = QStringLiteral("lab.de.json")}};
    step.find();
    QCOMPARE(Step::told(step.verified.warnings, Kind::TextUnfinished),
             QStringList{QStringLiteral("text.de.md: gap")});
}

QTEST_GUILESS_MAIN(TestLabFindings)
#include "test_lab_findings.moc"
