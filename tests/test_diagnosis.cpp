// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/checker.h"

#include "tests/form_test.h"

using namespace cradle;
using namespace cradle::programs;

namespace {

const QString wholeSwapped =
    parts::lab("if closing > 0 then p.velocity, q.velocity = q.velocity, p.velocity end");

} // namespace

/// Mistakes that a lab lists are recognised in other forms than its own files.
class TestDiagnosis : public FormTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void mistakeOfAnotherFormIsRecognised_data();
    void mistakeOfAnotherFormIsRecognised();
    void mistakeOfMoreThanThatExplainsNothing_data();
    void mistakeOfMoreThanThatExplainsNothing();
};

void TestDiagnosis::mistakeOfAnotherFormIsRecognised_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    QTest::addColumn<QString>("mistake");
    using namespace parts;
    const auto row = [](const char *step, const char *name, const char *mistake,
                        const FormChange &change) {
        OtherForm form = otherForm(lab(step));
        change(form);
        QTest::addRow("%s %s", step, name) << lab(step) << form << lab(mistake);
    };
    row("L42T1", "twice the way", "moved-twice",
        [](OtherForm &f) { edit(f.integrate, "c.velocity * h ", "2 * h * c.velocity "); });
    row("L42T1", "no time, by components",
        "The way of circle 1 is not multiplied by the timestep (only in x)", [](OtherForm &f) {
            f.integrate = lab("c.position = vec(c.position.x + c.velocity.x, c.position.y)");
        });
    row("L42T2", "centre at the wall, mirrored", "centre-for-rim",
        [](OtherForm &f) { edit(f.walls, "half_width - c.radius", "half_width"); });
    row("L42T2", "centre at the wall, clamped", "centre-for-rim", [](OtherForm &f) {
        f.walls = clamp;
        edit(f.walls, "half_width - c.radius", "half_width");
    });
    row("L42T2", "diameter, mirrored", "diameter-for-radius",
        [](OtherForm &f) { edit(f.walls, "- c.radius", "- 2 * c.radius"); });
    row("L42T2", "all of it outside, clamped", "far-rim", [](OtherForm &f) {
        f.walls = clamp;
        edit(f.walls, "- c.radius", "+ c.radius");
    });
    row("L42T2", "whole velocity, clamped", "whole-velocity-reversed", [](OtherForm &f) {
        f.walls = clamp;
        f.walls += lab("if vx ~= c.old.x or vy ~= c.old.y then c.velocity = -c.old end");
        f.walls.prepend(lab("c.old = c.velocity\n"));
    });
    row("L42T2", "side walls, mirrored", "side-walls-only",
        [](OtherForm &f) { f.walls.replace(lab("if y"), lab("if false and y")); });
    row("L42T2", "speed kept away, mirrored", "bounce-takes-speed", [](OtherForm &f) {
        f.walls.replace(lab("-math.abs("), lab("-0.5 * math.abs("))
            .replace(lab(", math.abs("), lab(", 0.5 * math.abs("));
    });
    row("L42T3", "symplectic, mirrored", "symplectic-order",
        [](OtherForm &f) { f.integrate = symplectic; });
    row("L42T3", "symplectic, clamped", "symplectic-order", [](OtherForm &f) {
        f.integrate = symplectic;
        f.walls = clamp;
    });
    row("L42T3", "twice g", "gravity-twice",
        [](OtherForm &f) { edit(f.integrate, "gravity * h", "2 * gravity * h"); });
    row("L42T3", "no time", "time-forgotten",
        [](OtherForm &f) { edit(f.integrate, "+ gravity * h", "+ gravity"); });
    row("L42T3", "time squared", "time-squared",
        [](OtherForm &f) { edit(f.integrate, "gravity * h", "gravity * h ^ 2"); });
    row("L42T3", "minus a minus", "gravity-subtracted",
        [](OtherForm &f) { edit(f.integrate, "+ gravity * h", "- gravity * h"); });
    row("L42T3", "parabola, as Verlet", "exact-parabola",
        [](OtherForm &f) { f.integrate = verlet; });
    row("L42T5", "both symplectic", "both-symplectic",
        [](OtherForm &f) { f.integrate = symplectic; });
    row("L42T5", "both Euler, clamped", "still-both-euler", [](OtherForm &f) {
        f.integrate = euler;
        f.walls = clamp;
    });
    row("L42T5", "switched", "switched",
        [](OtherForm &f) { edit(f.integrate, "c.index == 1", "c.index == 2"); });
    row("L42T9", "a smaller margin", "The circles answer before they touch",
        [](OtherForm &f) { f.reach = lab("p.radius + q.radius + 0.06"); });
    row("L42T9", "a margin as a factor", "margin-added",
        [](OtherForm &f) { f.reach = lab("1.2 * (p.radius + q.radius)"); });
    row("L42T9", "boxes, as the larger of two", "box-test", [](OtherForm &f) {
        f.touch = lab("math.max(math.abs(q.position.x - p.position.x), "
                      "math.abs(q.position.y - p.position.y)) < reach");
    });
    row("L42T9", "the radius of circle 2", "only-one-radius",
        [](OtherForm &f) { f.reach = lab("q.radius"); });
    row("L42T9", "turned back", "velocities-reversed", [](OtherForm &f) {
        f.answer = lab("if closing > 0 then p.velocity, q.velocity = -p.velocity, -q.velocity end");
    });
    row("L42T10", "first overwritten", "temp-forgotten", [](OtherForm &f) {
        f.answer = lab("if closing > 0 then p.velocity = q.velocity q.velocity = p.velocity end");
    });
    row("L42T11", "whole velocity", "whole-velocity-swapped",
        [](OtherForm &f) { f.answer = wholeSwapped; });
    row("L42T12", "second part forgotten", "second-part-ignored", [](OtherForm &f) {
        f.answer = lab("local part = p.velocity:dot(n) * n if closing > 0 then "
                       "p.velocity, q.velocity = p.velocity - part, q.velocity + part end");
    });
    row("L42T12", "off a wall, circles first", "reflected-as-off-a-wall", [](OtherForm &f) {
        f.circlesFirst = true;
        f.answer = lab("if closing > 0 then for _, c in ipairs({p, q}) do "
                       "c.velocity = c.velocity - 2 * c.velocity:dot(n) * n end end");
    });
    row("L42T12", "whole velocity, Euler", "whole-velocity-swapped", [](OtherForm &f) {
        f.integrate = euler;
        f.answer = wholeSwapped;
    });
    row("L42T13", "radius of circle 1 twice", "twice-the-first-radius",
        [](OtherForm &f) { f.reach = lab("circle1.radius + circle1.radius"); });
    row("L42T13", "walls of circle 1, clamped", "walls-use-circle-1", [](OtherForm &f) {
        f.walls = clampWithE;
        edit(f.walls, "e = restitution", "e = 1");
        edit(f.walls, "- c.radius", "- circle1.radius");
    });
    row("L42T14", "area, impulse", "mass-from-area",
        [](OtherForm &f) { f.mass = lab("7 * c.density * c.radius ^ 2"); });
    row("L42T14", "radius, centre of mass", "mass-from-radius", [](OtherForm &f) {
        f.mass = lab("c.density * c.radius");
        f.answer = aboutCentre;
    });
    row("L42T14", "each other's mass, impulse", "masses-exchanged", [](OtherForm &f) {
        f.answer.replace(lab("j / m1"), lab("j / mx")).replace(lab("j / m2"), lab("j / m1"));
        f.answer.replace(lab("j / mx"), lab("j / m2"));
    });
    row("L42T14", "masses not used", "masses-not-used",
        [](OtherForm &f) { f.answer = parts::exchange; });
    row("L42T15", "density not asked for", "density-ignored",
        [](OtherForm &f) { f.mass = lab("c.radius ^ 3"); });
    row("L42T16", "own e, squared", "e-squared",
        [](OtherForm &f) { edit(f.answer, "1 + restitution", "1 + restitution ^ 2"); });
    row("L42T16", "no e, centre of mass", "e-forgotten", [](OtherForm &f) {
        f.answer = aboutCentre;
        f.answer.replace(lab("(1 + restitution)"), lab("2"));
    });
    row("L42T16", "no e for circle 2", "e-on-one-circle", [](OtherForm &f) {
        edit(f.answer, "q.velocity + j / m2 * n",
             "q.velocity + 2 * j / (1 + restitution) / m2 * n");
    });
    row("L42T16", "normal parts times e", "final-velocities-times-e", [](OtherForm &f) {
        f.answer.replace(lab("(1 + restitution)"), lab("2"));
        edit(f.answer, "* n end",
             "* n for _, c in ipairs({p, q}) do "
             "c.velocity = c.velocity - (1 - restitution) * c.velocity:dot(n) * n end end");
    });
    row("L42T17", "elastic walls, clamped",
        "Hits at the walls give both circles all of the speed back",
        [](OtherForm &f) { edit(f.walls, "local e = restitution", "local e = 1"); });
    row("L42T17", "elastic walls, Euler and mirrored",
        "Hits at the walls give both circles all of the speed back", [](OtherForm &f) {
            f.integrate = euler;
            f.walls = mirror;
        });
    row("L42T17", "e squared at the walls", "At the walls e acts on both circles twice",
        [](OtherForm &f) { edit(f.walls, "e = restitution", "e = restitution * restitution"); });
    row("L42T17", "no gravity set", "gravity-forgotten",
        [](OtherForm &f) { edit(f.start, "gravity = vec(0, -9.81)", ""); });
}

void TestDiagnosis::mistakeOfAnotherFormIsRecognised()
{
    QFETCH(QString, step);
    QFETCH(OtherForm, form);
    QFETCH(QString, mistake);
    const CheckReport report = judgedForm(step, form);
    QVERIFY2(!report.passed && !report.error, say(report).constData());
    // By the mistake's own words, or where its law is another at some hit, by those of the law.
    QVERIFY2(report.diagnosis()
                 && (report.diagnosis()->mistake == mistake
                     || headlineOf(*report.diagnosis()) == mistake),
             say(report).constData());
}

void TestDiagnosis::mistakeOfMoreThanThatExplainsNothing_data()
{
    QTest::addColumn<OtherForm>("mistake");
    QTest::addColumn<bool>("explains");
    using namespace parts;
    const auto row = [](const char *name, bool explains, const FormChange &change) {
        OtherForm form = otherForm(lab("L42T12"));
        form.answer = wholeSwapped;
        change(form);
        QTest::newRow(name) << form << explains;
    };
    row("no more", true, [](OtherForm &f) { f.walls = clamp; });
    row("the walls, too", false, [](OtherForm &f) { edit(f.walls, "y > room", "false"); });
    row("the contact, too", false, [](OtherForm &f) { f.reach += lab(" + 0.02"); });
}

/// What is said of it would be said of what the student has right.
void TestDiagnosis::mistakeOfMoreThanThatExplainsNothing()
{
    using parts::lab;
    QFETCH(OtherForm, mistake);
    Lab own = m_lab;
    Task &step = own.tasks.at(static_cast<std::size_t>(own.indexOf(lab("L42T12"))));
    step.mistakes = {{lab("mine"), mistake.source(), lab("Mine\n\nAll of it.")}};
    OtherForm form = otherForm(step.id);
    form.answer = wholeSwapped;
    const CheckReport report = *judgeTask(own, step, Submission(step.preset, form.source()), 1);
    QVERIFY2(!report.passed && report.diagnosis(), say(report).constData());
    QTEST(report.diagnosis()->mistake == lab("mine"), "explains");
}

QTEST_GUILESS_MAIN(TestDiagnosis)
#include "test_diagnosis.moc"
