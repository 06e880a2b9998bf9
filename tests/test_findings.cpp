// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"
#include "tests/other_forms.h"
#include "tests/text.h"

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
    void mistakeOfTheStartIsNotSaidOfARightOne();
    void programThatStoppedHasNoWrongStart();
    void wrongStartNamesTheLineThatSetsIt();
    void restitutionOfTheOwnSceneIsNamedBesideOtherFaults();
    void circleThatLeavesRightlyIsNamedOfUnequalOnes();
    void massesOfNoPowerAreToldSo();
    void crowdHasRoomWhereItIsMeasured();
    void withoutASolutionStudentsAloneAreTold();
    void wallsThatAreSoughtFarAheadAreNoFaultOfTheMotion();

private:
    [[nodiscard]] CheckReport told(const QString &step, const OtherForm &form) const
    {
        return *judgeTask(m_lab, task(step), Submission(task(step).preset, form.source()), 1);
    }
};

namespace {

QStringList headlinesOf(const CheckReport &report)
{
    QStringList lines;
    for (const Finding &finding : report.findings)
        lines.append(finding.message.section(QLatin1Char('\n'), 0, 0));
    return lines;
}

} // namespace

void TestFindings::faultsOfTwoAspectsAreBothNamed_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    QTest::addColumn<QStringList>("said");
    using namespace parts;
    const auto row = [](const char *step, const char *name, const QStringList &said,
                        const FormChange &change) {
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
        {text("Hits at the walls turn both circles round too early"),
         text("Two equal circles exchange their whole velocities")},
        [](OtherForm &f) {
            edit(f.walls, "- c.radius", "- 2 * c.radius");
            f.answer = lab("p.velocity, q.velocity = q.velocity, p.velocity");
        });
    // The own scene shows no wall but the open one.
    row("L42T14", "one wall and all hits",
        {text("At the right wall both circles went out"),
         text("The circles run through each other")},
        [](OtherForm &f) {
            edit(f.walls, "if x > room", "if x > 9");
            f.touch = lab("false");
        });
    row("L42T14", "contact and masses",
        {text("Contact is tested at 2 r₁, not at r₁ + r₂"),
         text("The mass grows with r to the power of 4, not 3")},
        [](OtherForm &f) {
            f.reach = lab("2 * p.radius");
            f.mass = lab("c.density * c.radius ^ 4");
        });
    // In its own scene nothing changes the velocity of circle 1; a hit that is thrown does.
    row("L42T12", "walls of circle 1 and meetings",
        {text("At every wall circle 1 went out"),
         text("Some hits of the two circles are not answered")},
        [](OtherForm &f) {
            f.walls = lab("if c.index == 2 then ") + f.walls + lab(" end");
            f.answer.replace(lab("closing > 0"), lab("closing > 0 and q.velocity:dot(n) > 0"));
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
                        const FormChange &change) {
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
    row("L42T12", "velocity never written back", "Nothing changes the velocity of circle 2",
        [](OtherForm &f) {
            f.integrate = lab("if c.index == 2 then kept = c.velocity end "
                              "c.position = c.position + c.velocity * h");
            f.walls += lab(" if c.index == 2 then c.velocity = kept end");
            f.answer += lab(" circle2.velocity = kept");
        });
    row("L42T12", "velocity kept in an own variable", "Circle 1 does not move as its velocity says",
        [](OtherForm &f) {
            f.start += lab(" own = {}");
            f.integrate = lab("own[c.index] = own[c.index] or c.velocity "
                              "c.position = c.position + own[c.index] * h");
            f.walls = lab("local room = square.half_width - c.radius local v = own[c.index] "
                          "if math.abs(c.position.x) > room and v.x * c.position.x > 0 then "
                          "own[c.index] = vec(-v.x, v.y) end "
                          "if math.abs(c.position.y) > room and v.y * c.position.y > 0 then "
                          "own[c.index] = vec(v.x, -v.y) end");
            f.answer = QString();
        });
    // What a hit makes of it there is no fault of the walls.
    row("L42T10", "place of the other circle",
        "Every step moves circle 1 on from where circle 2 is", [](OtherForm &f) {
            f.integrate = lab("if c.index == 1 then c.position = circle2.position end "
                              "c.position = c.position + c.velocity * h");
        });
    row("L42T9", "distance beside a square, near one radius", "The circles answer too late",
        [](OtherForm &f) { f.reach = lab("(p.radius + q.radius) ^ 2"); });
    row("L42T7", "gravity sideways, too", "Gravity pulls both circles in a wrong direction",
        [](OtherForm &f) {
            f.integrate = lab("c.velocity = c.velocity + vec(gravity.y, gravity.y) * h "
                              "c.position = c.position + c.velocity * h");
        });
    // The start is right, and what is known of a wrong one does not fit.
    for (const char *step : {"L42T8", "L42T17"})
        row(step, "gravity of before the start",
            "The fall of both circles is not that of the gravity in the scene", [](OtherForm &f) {
                f.start = lab("pull = gravity ") + f.start;
                f.integrate.replace(lab("gravity"), lab("pull"));
            });
    row("L42T15", "mass of before the start",
        "In your own scene the circles answer as if they had other masses", [](OtherForm &f) {
            f.start = lab("cube = circle2.radius ^ 3 ") + f.start;
            f.mass = lab("c.density * (c.index == 2 and cube or c.radius ^ 3)");
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
    QCOMPARE(headlinesOf(report),
             QStringList(text("Hits at the walls turn both circles round too late")));
}

void TestFindings::mistakeOfTheStartIsNotSaidOfARightOne()
{
    // The normal of a scene that was there before on_load, as after a start for a head-on hit.
    OtherForm form = otherForm(QStringLiteral("L42T11"));
    const CheckReport right = told(QStringLiteral("L42T11"), form);
    QVERIFY(right.passed);
    form.answer.prepend(QStringLiteral("local n = vec(1, 0) "
                                       "local closing = (p.velocity - q.velocity):dot(n) "));
    const CheckReport report = told(QStringLiteral("L42T11"), form);
    QVERIFY(!report.passed);
    QVERIFY(!report.findings.empty());
    QCOMPARE(report.findings.front().mistake, QString());
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

/// Also where the check that asks for it passes by the other fault.
void TestFindings::restitutionOfTheOwnSceneIsNamedBesideOtherFaults()
{
    const auto said = [&](const char *from, const char *to) {
        OtherForm form = otherForm(QStringLiteral("L42T16"));
        edit(form.start, "restitution = 0.5", "local other = 0.6");
        if (from)
            edit(form.answer, from, to);
        return headlinesOf(told(QStringLiteral("L42T16"), form));
    };
    const QString start = text("e = 1 is not the value that is asked for");
    QCOMPARE(said(nullptr, nullptr), QStringList(start));
    QCOMPARE(said("1 + restitution", "1 + restitution ^ 2"),
             (QStringList{start, text("e is squared in the hit of two circles")}));
    QCOMPARE(said("1 + restitution", "1 + 0.7").first(), start);
    // Any e below 1 loses energy, and another one than asked for is named as well.
    OtherForm form = otherForm(QStringLiteral("L42T16"));
    edit(form.start, "restitution = 0.5", "restitution = 0.4");
    edit(form.answer, "1 + restitution", "1 + restitution ^ 2");
    QCOMPARE(headlinesOf(told(QStringLiteral("L42T16"), form)),
             (QStringList{text("e = 0.4 is not the value that is asked for"),
                          text("e is squared in the hit of two circles")}));
}

/// Where circle 2 is at rest, or both are equal, (m₁ − m₂) in place of (m₂ − m₁) does not show.
void TestFindings::circleThatLeavesRightlyIsNamedOfUnequalOnes()
{
    OtherForm form = otherForm(QStringLiteral("L42T14"));
    form.answer = QStringLiteral(
        "if closing > 0 then local u, v, m = p.velocity:dot(n), q.velocity:dot(n), m1 + m2 "
        "p.velocity = p.velocity + (((m1 - m2) * u + 2 * m2 * v) / m - u) * n "
        "q.velocity = q.velocity + (((m1 - m2) * v + 2 * m1 * u) / m - v) * n end");
    const CheckReport report = told(QStringLiteral("L42T14"), form);
    QCOMPARE(headlinesOf(report),
             QStringList(text("Where the masses differ, only circle 1 leaves as it should")));
    QVERIFY(report.findings.front().message.contains(text("hits tried, 3 came out right.")));
}

/// Two sizes fit a power that others do not.
void TestFindings::massesOfNoPowerAreToldSo()
{
    OtherForm form = otherForm(QStringLiteral("L42T14"));
    form.answer =
        QStringLiteral("local function w(c) return c.radius ^ 2 * math.max(c.radius, 0.3) "
                       "end m1, m2 = w(p), w(q) ")
        + form.answer;
    QCOMPARE(headlinesOf(told(QStringLiteral("L42T14"), form)),
             QStringList(text("The masses do not follow the radii as those of balls do")));
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

/// Their edition asks the checks for the laws; a lab whose author has yet to write one does not.
void TestFindings::withoutASolutionStudentsAloneAreTold()
{
    using namespace parts;
    Task step = task(lab("L42T4"));
    OtherForm form = otherForm(lab("L42T4"));
    form.integrate = symplectic;
    const auto saidOf = [&] {
        return headlinesOf(*judgeTask(m_lab, step, Submission(step.preset, form.source()), 1));
    };
    const QStringList said{text("The motion of both circles is symplectic Euler, not Euler")};
    QCOMPARE(saidOf(), said);
    step.solution.clear();
    QCOMPARE(saidOf(), QStringList());
    step.forStudents = true;
    QCOMPARE(saidOf(), said);
}

/// Only what is fast is turned where no wall is near.
void TestFindings::wallsThatAreSoughtFarAheadAreNoFaultOfTheMotion()
{
    const QString step = QStringLiteral("L42T2");
    const QString program = text("function on_update(h)\n"
                                 "  local c, far = circle1, AHEAD * circle1.velocity\n"
                                 "  local q, v, room = c.position + far, c.velocity, 4 - c.radius\n"
                                 "  if math.abs(q.x) > room and q.x * v.x > 0 then\n"
                                 "    v = vec(-v.x, v.y)\n"
                                 "  end\n"
                                 "  if math.abs(q.y) > room and q.y * v.y > 0 then\n"
                                 "    v = vec(v.x, -v.y)\n"
                                 "  end\n"
                                 "  c.position, c.velocity = c.position + v * h, v\n"
                                 "end\n");
    for (const auto &[ahead, headline] :
         {std::pair("0.5", "Hits at the walls turn circle 1 round too early"),
          std::pair("0.7", "Hits at the walls turn circle 1 round too early"),
          std::pair("1", "Hits at the walls turn circle 1 round a whole second too early")}) {
        QString source = program;
        source.replace(QLatin1String("AHEAD"), QLatin1String(ahead));
        const CheckReport report =
            *judgeTask(m_lab, task(step), Submission(task(step).preset, source), 1);
        QCOMPARE(headlinesOf(report), QStringList(text(headline)));
    }
}

QTEST_GUILESS_MAIN(TestFindings)
#include "test_findings.moc"
