// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/checker.h"

#include "tests/form_test.h"

using namespace cradle;
using namespace cradle::programs;

/// Mistakes that no lab lists are measured in other forms than its own files, and remarks made on
/// what is right.
class TestMeasuredMistakes : public FormTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void unknownMistakeIsMeasured_data();
    void unknownMistakeIsMeasured();
    void remarkIsMadeOnAnotherForm_data();
    void remarkIsMadeOnAnotherForm();
};

void TestMeasuredMistakes::unknownMistakeIsMeasured_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    QTest::addColumn<QString>("headline");
    using namespace parts;
    const auto row = [](const char *step, const char *name, const char *headline,
                        const FormChange &change) {
        OtherForm form = otherForm(lab(step));
        change(form);
        QTest::addRow("%s %s", step, name) << lab(step) << form << lab(headline);
    };
    row("L42T2", "through the wall to the other side",
        "Hits at the walls put circle 1 somewhere else", [](OtherForm &f) {
            f.walls = lab("local function wrapped(x) return math.abs(x) > 3.8 and -x or x end "
                          "c.position = vec(wrapped(c.position.x), wrapped(c.position.y))");
        });
    row("L42T2", "turned by a right angle",
        "At the walls the parts of the velocity of circle 1 are mixed up", [](OtherForm &f) {
            f.walls =
                lab("local room = square.half_width - c.radius if math.abs(c.position.x) > room "
                    "or math.abs(c.position.y) > room then "
                    "c.velocity = c.velocity:perpendicular() end");
        });
    row("L42T2", "the left-hand wall holds it", "At the left wall and floor circle 1 went out",
        [](OtherForm &f) {
            f.walls =
                lab("local room = square.half_width - c.radius if math.abs(c.position.x) > room "
                    "then c.velocity = vec(-math.abs(c.velocity.x), c.velocity.y) end "
                    "if math.abs(c.position.y) > room then "
                    "c.velocity = vec(c.velocity.x, -math.abs(c.velocity.y)) end");
        });
    row("L42T2", "no ceiling", "At the ceiling circle 1 went out", [](OtherForm &f) {
        f.walls = clamp;
        edit(f.walls, "y > room", "false");
    });
    row("L42T3", "gravity of the Moon",
        "The velocity of circle 1 gets 0.167 times what gravity gives",
        [](OtherForm &f) { edit(f.integrate, "gravity * h", "gravity * (h / 6)"); });
    row("L42T3", "heavy ones fall faster", "The fall of circle 1 depends on radius or density",
        [](OtherForm &f) { edit(f.integrate, "gravity * h", "gravity * (c.density / 7.8) * h"); });
    row("L42T3", "air", "Something slows circle 1 down on the way",
        [](OtherForm &f) { f.integrate += lab(" c.velocity = 0.99 * c.velocity"); });
    row("L42T4", "circle 2 put where circle 1 is", "Every step puts circle 2 where circle 1 is",
        [](OtherForm &f) {
            f.integrate = lab("if c.index == 1 then ") + euler
                          + lab(" else c.position = circle1.position end");
        });
    row("L42T12", "turned by an angle", "Only circle 2 leaves a hit as it should",
        [](OtherForm &f) {
            f.answer += lab(" if closing > 0 then p.velocity = p.velocity:perpendicular() end");
        });
    row("L42T14", "a third of the impulse", "Equal circles get 0.35 times the right push",
        [](OtherForm &f) { edit(f.answer, "(1 + restitution)", "0.7"); });
    row("L42T16", "e by its root", "The root of e is used in the hit of two circles",
        [](OtherForm &f) { edit(f.answer, "1 + restitution", "1 + restitution ^ 0.5"); });
}

void TestMeasuredMistakes::unknownMistakeIsMeasured()
{
    QFETCH(QString, step);
    QFETCH(OtherForm, form);
    const CheckReport report = judgedForm(step, form);
    QVERIFY2(!report.passed && !report.error, say(report).constData());
    QFETCH(QString, headline);
    QVERIFY2(report.diagnosis() && headlineOf(*report.diagnosis()) == headline,
             say(report).constData());
}

void TestMeasuredMistakes::remarkIsMadeOnAnotherForm_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<OtherForm>("form");
    QTest::addColumn<QString>("remark");
    using namespace parts;
    const auto row = [](const char *step, const char *remark, const FormChange &change) {
        OtherForm form = otherForm(lab(step));
        change(form);
        QTest::newRow(remark) << lab(step) << form << lab(remark);
    };
    row("L42T14", "integer-four-thirds", [](OtherForm &f) {
        f.start += lab("for i = 1, 2 do local c = circles[i] "
                       "c.mass = c.density * 1000 * (4 // 3) * math.pi * c.radius ^ 3 end");
        f.mass = lab("c.mass");
    });
    row("L42T9", "small-margin", [](OtherForm &f) { f.reach = lab("p.radius + q.radius + 1e-5"); });
    row("L42T17", "frozen-on-floor", [](OtherForm &f) {
        f.integrate = lab("c.old = c.position ") + symplectic;
        edit(f.walls, "c.position, c.velocity = vec(x, y), vec(vx, vy)",
             "if vx ~= c.velocity.x or vy ~= c.velocity.y then "
             "c.position, c.velocity = c.old, vec(vx, vy) end");
    });
}

void TestMeasuredMistakes::remarkIsMadeOnAnotherForm()
{
    QFETCH(QString, step);
    QFETCH(OtherForm, form);
    QFETCH(QString, remark);
    const CheckReport report = judgedForm(step, form);
    QVERIFY2(report.passed, say(report).constData());
    QCOMPARE(report.remarks.size(), std::size_t{1});
    QCOMPARE(report.remarks.front().id, remark);
}

QTEST_GUILESS_MAIN(TestMeasuredMistakes)
#include "test_measured_mistakes.moc"
