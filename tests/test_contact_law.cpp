// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/contact_comparison.h"
#include "tasks/reading/lab_list.h"

#include <functional>

using namespace cradle;
using namespace cradle::programs;

/// What is measured of the contacts of a program is when it answers.
class TestContactLaw : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void distanceIsMeasured_data();
    void distanceIsMeasured();
    void rightContactsHaveNoFault_data();
    void rightContactsHaveNoFault();
    void faultIsNamed_data();
    void faultIsNamed();
    void wrongMotionIsNoFaultOfTheHits_data();
    void wrongMotionIsNoFaultOfTheHits();
    void returnFromTheWallTellsMemoryFromDirection();
    void pauseAfterAHitIsNamed_data();
    void pauseAfterAHitIsNamed();
    void leapAfterAHitIsNamed();
    void partingCirclesAreToldOfThoseWhoDoNotAsk();
    void ownHitIsThatOfTheTwo();
    void placesOfTwoMomentsAreNamed_data();
    void placesOfTwoMomentsAreNamed();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

/// At which circles of two radii answer, m.
using Distance = std::function<double(double, double)>;

} // namespace

void TestContactLaw::distanceIsMeasured_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<Distance>("distance");
    const auto rows = [](const char *reach, const Distance &distance) {
        for (std::size_t i = 0; i < std::size(hitWays); ++i)
            QTest::addRow("%s, %s, %s", reach, hitWays[i].name, structures[i].name) << written(
                withHit(hitOf(hitWays[i], {.reach = QLatin1String(reach)})), structures[i])
                                                                                    << distance;
    };
    rows("p.radius + q.radius", [](double a, double b) { return a + b; });
    rows("p.radius", [](double a, double) { return a; });
    rows("2 * q.radius", [](double, double b) { return 2.0 * b; });
    rows("math.max(p.radius, q.radius)", [](double a, double b) { return std::max(a, b); });
    rows("(p.radius + q.radius) / 2", [](double a, double b) { return 0.5 * (a + b); });
}

void TestContactLaw::distanceIsMeasured()
{
    QFETCH(QString, program);
    QFETCH(Distance, distance);
    const LawBench step(task(QStringLiteral("L42T14")));
    const MeasuredLaws own(&program, step.ground);
    QVERIFY(own.pair().isJudged);
    QVERIFY(own.pair().contacts.size() >= 9);
    for (const PairHit &hit : own.pair().contacts) {
        QVERIFY(hit.isMet());
        const double reach = distance(hit.meeting.radius1, hit.meeting.radius2);
        QVERIFY(hit.reached < reach && reach <= hit.before);
    }
}

void TestContactLaw::rightContactsHaveNoFault_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("program");
    for (const char *step : {"L42T12", "L42T13", "L42T14", "L42T16"}) {
        const int number = QString::fromLatin1(step).mid(4).toInt();
        HitLaw law;
        if (number < 14)
            law.mass = QStringLiteral("1");
        if (number == 16)
            law.e = QStringLiteral("restitution");
        for (const HitWay &way : hitWays) {
            for (const Structure &structure : structures)
                QTest::addRow("%s, %s, %s", step, way.name, structure.name)
                    << QString::fromLatin1(step) << written(withHit(hitOf(way, law)), structure);
        }
    }
}

void TestContactLaw::rightContactsHaveNoFault()
{
    QFETCH(QString, step);
    QFETCH(QString, program);
    const LawBench judged(task(step));
    QCOMPARE(judged.contact(program) + judged.response(program), QStringList());
}

void TestContactLaw::faultIsNamed_data()
{
    QTest::addColumn<QString>("hit");
    QTest::addColumn<QString>("said");
    const auto rows = [](const char *name, const HitLaw &law, const char *said) {
        for (const HitWay &way : hitWays)
            QTest::addRow("%s, %s", name, way.name) << hitOf(way, law) << text(said);
    };
    rows("radius 1", {.reach = text("p.radius")}, "Contact is tested at r₁, not at r₁ + r₂");
    rows("twice radius 1", {.reach = text("2 * p.radius")},
         "Contact is tested at 2 r₁, not at r₁ + r₂");
    rows("larger", {.reach = text("math.max(p.radius, q.radius)")},
         "Contact is tested at the larger radius, not at r₁ + r₂");
    rows("a number", {.reach = text("0.4")},
         "The test of contact acts as if a number stood for r₁ + r₂");
    rows("difference", {.reach = text("math.abs(p.radius - q.radius)")},
         "Contact is tested at the difference of the radii, not at r₁ + r₂");
    rows("margin", {.reach = text("p.radius + q.radius + 0.05")},
         "The circles answer before they touch");
    rows("boxes", {.touch = text("math.abs(d.x) < reach and math.abs(d.y) < reach")},
         "Boxes are compared, not circles");
    rows("sum of the parts", {.touch = text("math.abs(d.x) + math.abs(d.y) < reach")},
         "|Δx| + |Δy| is not the distance");
    rows("square", {.touch = text("d.x ^ 2 + d.y ^ 2 < reach")},
         "A squared distance is compared with a length");
    rows("never", {.touch = text("false")}, "The circles run through each other");
    rows("when they part", {.approach = text("closing < 0")},
         "The circles answer when they part, not when they meet");
    rows("circle 1 only", {.approach = text("p.velocity:dot(n) > 0")},
         "Some hits of the two circles are not answered");
    rows("circle 2 only", {.approach = text("q.velocity:dot(n) < 0")},
         "Some hits of the two circles are not answered");
}

void TestContactLaw::faultIsNamed()
{
    QFETCH(QString, hit);
    QFETCH(QString, said);
    const LawBench step(task(QStringLiteral("L42T14")));
    for (const std::size_t structure : {std::size_t{1}, std::size_t{3}}) {
        const QString program = written(withHit(hit), structures[structure]);
        // One word, and nothing of the answer, which is right.
        QCOMPARE(step.contact(program) + step.response(program), QStringList(said));
    }
}

void TestContactLaw::wrongMotionIsNoFaultOfTheHits_data()
{
    QTest::addColumn<QString>("way");
    for (const char *way : {"c.velocity", "c.velocity / 60", "c.velocity * h * h",
                            "2 * c.velocity * h", "c.velocity * h / 2", "-c.velocity * h",
                            "(c.index == 1 and c.velocity or c.velocity * h)"})
        QTest::newRow(way) << QString::fromLatin1(way);
}

void TestContactLaw::wrongMotionIsNoFaultOfTheHits()
{
    QFETCH(QString, way);
    const LawBench step(task(QStringLiteral("L42T16")));
    for (const HitWay &hit : hitWays) {
        LawProgram program = withHit(hitOf(hit, {.e = QStringLiteral("restitution")}));
        program.move = QStringLiteral("c.position = c.position + ") + way;
        const QString source = written(program, structures[3]);
        QCOMPARE(step.contact(source) + step.response(source), QStringList());
    }
}

/// Who drives parting circles apart is done with them at once, as who remembers a hit is.
void TestContactLaw::partingCirclesAreToldOfThoseWhoDoNotAsk()
{
    const LawBench step(task(QStringLiteral("L42T12")));
    const QString answer = text("local u = math.abs(closing) "
                                "p.velocity, q.velocity = p.velocity - u * n, q.velocity + u * n");
    const auto contact = [&](const char *approach, const char *after) {
        LawProgram program = withHit(hitOf(hitWays[1], {.approach = QString::fromLatin1(approach),
                                                        .mass = text("1"),
                                                        .answer = answer + text(after)}));
        program.start = text("touching = false");
        program.hit = text("local d = q.position - p.position "
                           "if d:length() >= p.radius + q.radius then touching = false end ")
                      + program.hit;
        return step.contact(written(program, structures[3]));
    };
    QCOMPARE(contact("true", ""), QStringList(text("Circles that already part are hit again")));
    QCOMPARE(contact("not touching", " touching = true"), QStringList());
    QCOMPARE(contact("closing > 0", ""), QStringList());
}

void TestContactLaw::returnFromTheWallTellsMemoryFromDirection()
{
    const LawBench step(task(QStringLiteral("L42T10")));
    HitLaw law{.approach = QStringLiteral("closing > 0 and not done"), .mass = QStringLiteral("1")};
    law.answer += QStringLiteral(" done = true");
    LawProgram once = withHit(hitOf(hitWays[0], law));
    once.start = QStringLiteral("done = false");
    QCOMPARE(step.contact(written(once, structures[0])),
             QStringList(text("A later hit is not answered")));
    const QString source = written(once, structures[0]);
    const MeasuredLaws own(&source, step.ground);
    QVERIFY(own.pair().ranThrough);
    QVERIFY(own.pair().returning && own.pair().returning->answered);
    // Without a wall nothing comes back, and nothing is said of it.
    LawProgram open = withHit(hitOf(hitWays[0], {.mass = QStringLiteral("1")}));
    open.walls.clear();
    QCOMPARE(step.contact(written(open, structures[0])), QStringList());
}

void TestContactLaw::pauseAfterAHitIsNamed_data()
{
    QTest::addColumn<QString>("approach");
    QTest::addColumn<QString>("after");
    QTest::newRow("some tenths of a second") << "closing > 0 and time - last > 0.2"
                                             << " if closing > 0 then last = time end";
    QTest::newRow("nine steps") << "closing > 0 and step - last > 9"
                                << " if closing > 0 then last = step end";
}

void TestContactLaw::pauseAfterAHitIsNamed()
{
    QFETCH(QString, approach);
    QFETCH(QString, after);
    const LawBench bench(task(QStringLiteral("L42T12")));
    HitLaw law{.approach = approach, .mass = QStringLiteral("1")};
    law.answer += after;
    LawProgram pauses = withHit(hitOf(hitWays[0], law));
    pauses.start = QStringLiteral("last = -100");
    QCOMPARE(bench.contact(written(pauses, structures[0])),
             QStringList(text("A hit soon after another is not answered")));
}

/// The one that a hit puts far from its path is named.
void TestContactLaw::leapAfterAHitIsNamed()
{
    const LawBench step(task(QStringLiteral("L42T14")));
    for (const int circle : {1, 2}) {
        const QString hit =
            hitOf({"leap", "", circle == 1 ? "p.position = vec(0, 3)" : "q.position = vec(0, 3)"});
        const QStringList said = step.contact(written(withHit(hit), structures[1]));
        QCOMPARE(said.value(0), QStringLiteral("A hit puts circle %1 somewhere else").arg(circle));
    }
}

/// In the own scene circle 1 comes from the wall, which is no hit of the two.
void TestContactLaw::ownHitIsThatOfTheTwo()
{
    Task scene = task(QStringLiteral("L42T12"));
    LawProgram program = withHit(hitOf(hitWays[0], {.mass = QStringLiteral("1")}));
    program.start =
        QStringLiteral("gravity = vec(0, 0) "
                       "circle1.position, circle1.velocity = vec(-3.5, 2), vec(-1.7, 0) "
                       "circle2.position, circle2.velocity = vec(0, 2), vec(0, 0)");
    const QString source = written(program, structures[0]);
    const LawBench step(scene);
    const MeasuredLaws own(&source, step.ground);
    QVERIFY(own.pair().own);
    const PairHit &hit = *own.pair().own;
    QVERIFY(hit.answered);
    QVERIFY(hit.reached < 0.4 && 0.4 <= hit.before && hit.before < 0.5);
    QVERIFY(std::abs(hit.came1.x - 1.7) < 1e-9);
    QCOMPARE(own.pair().ownContacts, 2);
    QVERIFY(!own.pair().ranThrough && !own.pair().returning);
}

void TestContactLaw::placesOfTwoMomentsAreNamed_data()
{
    QTest::addColumn<QString>("between");
    QTest::addColumn<bool>("isNamed");
    QTest::newRow("now") << "q.position - p.position" << false;
    QTest::newRow("1 before") << "q.position - oldp" << true;
    QTest::newRow("2 before") << "oldq - p.position" << true;
    QTest::newRow("1 ahead") << "q.position - p.position - h * p.velocity" << true;
    QTest::newRow("both before") << "oldq - oldp" << false;
}

/// Circles that come slowly are answered in time even so.
void TestContactLaw::placesOfTwoMomentsAreNamed()
{
    QFETCH(QString, between);
    QFETCH(bool, isNamed);
    const LawBench step(task(QStringLiteral("L42T12")));
    for (const Structure &structure : structures) {
        for (const HitWay &way : {hitWays[0], hitWays[1]}) {
            QString hit = hitOf(way);
            hit.replace(QLatin1String("q.position - p.position"), between);
            const QString program = written(withHit(hit), structure);
            const MeasuredLaws own(&program, step.ground);
            const auto said = momentsDeviation(own.pairChases());
            QCOMPARE(said.has_value(), isNamed);
            if (said)
                QVERIFY(said->message.startsWith(
                    QLatin1String("The distance is taken between places of two moments\n")));
        }
    }
}

QTEST_GUILESS_MAIN(TestContactLaw)
#include "test_contact_law.moc"
