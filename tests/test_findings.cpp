// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/task_laws.h"
#include "tasks/reading/lab_list.h"
#include "tests/other_forms.h"

using namespace cradle;
using namespace cradle::programs;

/// What a failed submission is told: every fault, in the order in which to mend them, and nothing
/// that is right.
class TestFindings : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void faultsOfTwoAspectsAreBothNamed_data();
    void faultsOfTwoAspectsAreBothNamed();
    void oneFaultIsToldOnce_data();
    void oneFaultIsToldOnce();
    void aspectThatCannotBeMeasuredIsNotJudged_data();
    void aspectThatCannotBeMeasuredIsNotJudged();
    void mistakeOfOneAspectDoesNotExplainAnother();
    void programThatStoppedHasNoWrongStart();
    void wrongStartNamesTheLineThatSetsIt();
    void labOfAnotherKindGetsFindings_data();
    void labOfAnotherKindGetsFindings();
    void crowdHasRoomWhereItIsMeasured();
    void measuredLawsAreThoseOfTheStepAsItIs();
    void measuringBeforehandChangesNoFinding();

private:
    [[nodiscard]] CheckReport told(const QString &step, const OtherForm &form) const
    {
        return *judgeTask(m_lab, task(step), Submission(task(step).preset, form.source()), 1);
    }
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

QStringList headlinesOf(const CheckReport &report)
{
    QStringList lines;
    for (const Finding &finding : report.findings)
        lines.append(finding.message.section(QLatin1Char('\n'), 0, 0));
    return lines;
}

/// A lab with one step: air that brakes a circle by 0.5 v.
Lab airLab(const Preset &preset)
{
    const auto program = [](const char *change) {
        return QStringLiteral("function on_update(h)\n"
                              "  circle1.velocity = circle1.velocity %1\n"
                              "  circle1.position = circle1.position + circle1.velocity * h\n"
                              "end\n")
            .arg(QLatin1String(change));
    };
    Task task;
    task.id = QStringLiteral("AIR1");
    task.title = QStringLiteral("Air");
    task.preset = preset;
    task.checks.push_back(
        {.id = QStringLiteral("brakes"),
         .title = QStringLiteral("Air brakes by 0.5 v"),
         .kind = QStringLiteral("script"),
         .circles = {0},
         .parameters = {},
         .scene = {{QStringLiteral("kind"), QStringLiteral("flight")},
                   {QStringLiteral("count"), 4},
                   {QStringLiteral("duration"), 0.5},
                   {QStringLiteral("timesteps"), QJsonArray{1.0 / 60.0, 1.0 / 120.0}}},
         .source = text(R"lua(
function check(run)
  for k = 1, run.step_count do
    local before, after = run:step(k - 1).circles[1].velocity, run:step(k).circles[1].velocity
    local way = run:step(k).circles[1].position - run:step(k - 1).circles[1].position
    if (after - (1 - 0.5 * run.timestep) * before):length() > 1e-9
      or (way - run.timestep * after):length() > 1e-9 then
      return false, "the velocity does not change by -0.5 v dt"
    end
  end
  return true
end
)lua")});
    task.moves = Mover::Program;
    task.solution = program("- 0.5 * circle1.velocity * h");
    task.mistakes.push_back({.name = QStringLiteral("drives"),
                             .source = program("+ 0.5 * circle1.velocity * h"),
                             .message = text("Your air drives the circle\n\nLook at the sign.")});
    Lab lab;
    lab.id = QStringLiteral("air");
    lab.title = QStringLiteral("Air");
    lab.tasks.push_back(task);
    return lab;
}

} // namespace

void TestFindings::faultsOfTwoAspectsAreBothNamed_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    QTest::addColumn<QStringList>("said");
    using namespace parts;
    const auto row = [](const char *step, const char *name, const QStringList &said,
                        const Change &change) {
        OtherForm form = otherForm(lab(step));
        change(form);
        QTest::addRow("%s %s", step, name) << lab(step) << form << said;
    };
    row("L42T4", "start and motion",
        {text("The position of circle 2 is (-2, -2) m at the start; (-2, 2) m is asked for"),
         text("The motion of both circles is symplectic Euler, not Euler")},
        [](OtherForm &f) {
            f.start += lab("circle2.position = vec(-2, -2) ");
            f.integrate = symplectic;
        });
    row("L42T7", "motion and walls",
        {text("Gravity acts on both circles twice as strongly"),
         text("At the walls the centre of both circles is asked for, not the rim")},
        [](OtherForm &f) {
            f.integrate = lab("c.velocity = c.velocity + 2 * gravity * h "
                              "c.position = c.position + c.velocity * h");
            edit(f.walls, "half_width - c.radius", "half_width");
        });
    row("L42T12", "walls and answer",
        {text("The walls turn both circles round too early"),
         text("Of two equal circles the whole velocities change hands, not only the parts along "
              "the normal")},
        [](OtherForm &f) {
            edit(f.walls, "- c.radius", "- 2 * c.radius");
            f.answer = lab("p.velocity, q.velocity = q.velocity, p.velocity");
        });
    row("L42T14", "contact and masses",
        {text("Contact is tested at 2 r₁, not at r₁ + r₂"),
         text("The mass grows with r to the power of 4, not 3")},
        [](OtherForm &f) {
            f.reach = lab("2 * p.radius");
            f.mass = lab("c.density * c.radius ^ 4");
        });
    row("L42T16", "masses and e",
        {text("The mass grows with r to the power of 2, not 3"),
         text("e is squared in the hit of two circles")},
        [](OtherForm &f) {
            f.mass = lab("c.density * c.radius ^ 2");
            f.answer.replace(lab("1 + restitution"), lab("1 + restitution ^ 2"));
        });
}

void TestFindings::oneFaultIsToldOnce_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    QTest::addColumn<QString>("said");
    using namespace parts;
    const auto row = [](const char *step, const char *name, const char *said,
                        const Change &change) {
        OtherForm form = otherForm(lab(step));
        change(form);
        QTest::addRow("%s %s", step, name) << lab(step) << form << text(said);
    };
    row("L42T7", "velocity of the other circle", "The velocity of circle 2 is taken from circle 1",
        [](OtherForm &f) {
            f.integrate = lab("c.velocity = circle1.velocity + gravity * h "
                              "c.position = c.position + c.velocity * h");
        });
    row("L42T7", "slow ones are stopped",
        "Away from every wall a low speed of both circles is taken away", [](OtherForm &f) {
            f.integrate =
                lab("c.velocity = c.velocity + gravity * h "
                    "c.position = c.position + c.velocity * h "
                    "if math.abs(c.velocity.y) < 2 then c.velocity = vec(c.velocity.x, 0) end");
        });
    row("L42T9", "distance beside a square, near one radius", "The circles answer too late",
        [](OtherForm &f) { f.reach = lab("(p.radius + q.radius) ^ 2"); });
    row("L42T7", "gravity sideways, too", "Gravity pulls both circles in a wrong direction",
        [](OtherForm &f) {
            f.integrate = lab("c.velocity = c.velocity + vec(gravity.y, gravity.y) * h "
                              "c.position = c.position + c.velocity * h");
        });
}

void TestFindings::oneFaultIsToldOnce()
{
    QFETCH(QString, step);
    QFETCH(OtherForm, form);
    QFETCH(QString, said);
    const CheckReport report = told(step, form);
    QVERIFY(!report.passed);
    QCOMPARE(headlinesOf(report), QStringList{said});
}

void TestFindings::faultsOfTwoAspectsAreBothNamed()
{
    QFETCH(QString, step);
    QFETCH(OtherForm, form);
    QFETCH(QStringList, said);
    const CheckReport report = told(step, form);
    QVERIFY(!report.passed);
    QStringList lines = headlinesOf(report);
    // A mistake of the lab may say the same in words of its own.
    for (qsizetype i = 0; i < lines.size() && i < said.size(); ++i) {
        if (!report.findings[static_cast<std::size_t>(i)].mistake.isEmpty())
            lines[i] = said[i];
    }
    QCOMPARE(lines, said);
    for (std::size_t i = 1; i < report.findings.size(); ++i)
        QVERIFY(report.findings[i - 1].aspect <= report.findings[i].aspect);
}

void TestFindings::aspectThatCannotBeMeasuredIsNotJudged_data()
{
    QTest::addColumn<QString>("integrate");
    for (const char *way :
         {"vec(c.velocity.x * h, 0)", "-c.velocity * h", "circle1.velocity * h", "vec(0, 0)"})
        QTest::newRow(way) << QStringLiteral("c.position = c.position + ") + text(way)
                                  + QStringLiteral(" c.velocity = c.velocity + gravity * h");
    QTest::newRow("velocity set anew")
        << QStringLiteral("c.velocity = vec(1, 0) c.position = c.position + c.velocity * h");
}

void TestFindings::aspectThatCannotBeMeasuredIsNotJudged()
{
    QFETCH(QString, integrate);
    OtherForm form = otherForm(QStringLiteral("L42T12"));
    form.integrate = integrate;
    const CheckReport report = told(QStringLiteral("L42T12"), form);
    QVERIFY(!report.findings.empty());
    for (const Finding &finding : report.findings) {
        const bool isMotion = finding.aspect == Aspect::Motion;
        QVERIFY2(isMotion || finding.message.contains(text("circle 1")),
                 qPrintable(finding.message));
    }
}

void TestFindings::mistakeOfOneAspectDoesNotExplainAnother()
{
    OtherForm form = otherForm(QStringLiteral("L42T12"));
    edit(form.walls, "half_width - c.radius", "half_width - c.radius + 0.03");
    const CheckReport report = told(QStringLiteral("L42T12"), form);
    QCOMPARE(headlinesOf(report), QStringList(text("The walls turn both circles round too late")));
}

void TestFindings::programThatStoppedHasNoWrongStart()
{
    OtherForm form = otherForm(QStringLiteral("L42T12"));
    form.integrate = QStringLiteral("c.position = c.position + c.velocity * h "
                                    "steps = (steps or 0) + 1 "
                                    "if steps > 20 then error('enough') end");
    form.start += QStringLiteral("steps = 0 ");
    const CheckReport report = told(QStringLiteral("L42T12"), form);
    QVERIFY(report.error);
    for (const Finding &finding : report.findings)
        QVERIFY2(finding.aspect != Aspect::Start, qPrintable(finding.message));
}

void TestFindings::wrongStartNamesTheLineThatSetsIt()
{
    const auto line = [&](const char *step, QString program, const char *from, const char *to) {
        const auto at = program.indexOf(QLatin1String(from));
        if (at < 0)
            return -1;
        program.replace(at, qsizetype(qstrlen(from)), QLatin1String(to));
        const Task &of = task(QLatin1String(step));
        const CheckReport report = *judgeTask(m_lab, of, Submission(of.preset, program), 1);
        const int wanted = int(program.left(at).count(QLatin1Char('\n'))) + 1;
        return report.findings.empty() ? 0 : report.findings.front().line - wanted;
    };
    const auto solution = [&](const char *step) { return task(QLatin1String(step)).solution; };
    QCOMPARE(line("L42T3", solution("L42T3"), "vec(0, -9.81)", "vec(0, -9)"), 0);
    QCOMPARE(
        line("L42T4", solution("L42T4"), "circle2.position = vec(-2", "circle2.position = vec(-1"),
        0);
    // Another variable of that name is set instead.
    QCOMPARE(line("L42T3", solution("L42T3"), "gravity = vec(", "local gravity = vec("), 0);
    QCOMPARE(line("L42T16", solution("L42T16"), "restitution = 0.5", "local restitution = 0.5"), 0);
}

void TestFindings::labOfAnotherKindGetsFindings_data()
{
    QTest::addColumn<QString>("change");
    QTest::addColumn<QString>("way");
    QTest::addColumn<QStringList>("said");
    const auto row = [](const char *change, const char *way, const QStringList &said) {
        QTest::addRow("%s, %s", change, way) << text(change) << text(way) << said;
    };
    const char *brakes = "- 0.5 * v * h";
    row(brakes, "v * h", {});
    row("+ 0.5 * v * h", "v * h", {text("Your air drives the circle")});
    row("- 1 * v * h", "v * h",
        {text("What acts on the velocity of circle 1 is 2 times as strong as it should be")});
    row("", "v * h", {text("Nothing slows circle 1 down on the way")});
    row(brakes, "v", {text("The way of circle 1 is not multiplied by the timestep")});
    row("- 1 * v * h", "2 * v * h",
        {text("The way of circle 1 in a step is not v Δt"),
         text("What acts on the velocity of circle 1 is 2 times as strong as it should be")});
}

void TestFindings::labOfAnotherKindGetsFindings()
{
    QFETCH(QString, change);
    QFETCH(QString, way);
    QFETCH(QStringList, said);
    const Lab lab = airLab(task(QStringLiteral("L42T2")).preset);
    const QString program = QStringLiteral("function on_update(h)\n"
                                           "  local v = circle1.velocity\n"
                                           "  v = v %1\n"
                                           "  circle1.velocity = v\n"
                                           "  circle1.position = circle1.position + %2\n"
                                           "end\n")
                                .arg(change, way);
    const CheckReport report =
        *judgeTask(lab, lab.tasks.front(), Submission(lab.tasks.front().preset, program), 1);
    QVERIFY2(!report.error, report.error ? qPrintable(report.error->message) : "");
    QCOMPARE(report.passed, said.isEmpty());
    QCOMPARE(headlinesOf(report), said);
}

/// Checks may look at many circles; none may lie on another when flights are measured.
void TestFindings::crowdHasRoomWhereItIsMeasured()
{
    Task crowd = task(QStringLiteral("L42T14"));
    for (CheckSpec &check : crowd.checks) {
        check.circles.clear();
        for (int circle = 0; circle < 36; ++circle)
            check.circles.push_back(circle);
    }
    const std::vector<PresetCircle> circles = Ground(crowd, crowd.preset).stage().circles;
    QCOMPARE(circles.size(), std::size_t(36));
    for (std::size_t i = 0; i < circles.size(); ++i) {
        const Circle &a = circles[i].body;
        QVERIFY(std::max(std::abs(a.position.x), std::abs(a.position.y)) + a.radius < 4.0);
        for (std::size_t j = 0; j < i; ++j) {
            const Circle &b = circles[j].body;
            const double gap = length(a.position - b.position) - a.radius - b.radius;
            QVERIFY2(gap > 0.1, qPrintable(QStringLiteral("%1 and %2").arg(i).arg(j)));
        }
    }
}

void TestFindings::measuredLawsAreThoseOfTheStepAsItIs()
{
    const Task &step = task(text("L42T3"));
    QCOMPARE(lawsOf(step), lawsOf(step));
    Task changed = step;
    changed.solution += QLatin1Char('\n');
    QVERIFY(lawsOf(changed) != lawsOf(step));
    changed = step;
    changed.mistakes.pop_back();
    QVERIFY(lawsOf(changed) != lawsOf(step));
    changed = step;
    changed.checks.pop_back();
    QVERIFY(lawsOf(changed) != lawsOf(step));
    changed = step;
    changed.preset.gravity.y -= 1.0;
    QVERIFY(lawsOf(changed) != lawsOf(step));
}

void TestFindings::measuringBeforehandChangesNoFinding()
{
    const Task &step = task(text("L42T4"));
    const auto told = [&](const KnownScript &mistake) {
        return judgeTask(m_lab, step, Submission(step.preset, mistake.source), 1,
                         {.provesLines = false})
            ->findings;
    };
    std::vector<std::vector<Finding>> alone;
    for (const KnownScript &mistake : step.mistakes) {
        forgetLaws();
        alone.push_back(told(mistake));
    }
    forgetLaws();
    lawsOf(step)->measureAll();
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const std::vector<Finding> prepared = told(step.mistakes[i]);
        QCOMPARE(prepared.size(), alone[i].size());
        QCOMPARE(prepared.front().mistake, step.mistakes[i].name);
        QCOMPARE(prepared.front().message, alone[i].front().message);
        QCOMPARE(prepared.front().line, alone[i].front().line);
    }
}

QTEST_GUILESS_MAIN(TestFindings)
#include "test_findings.moc"
