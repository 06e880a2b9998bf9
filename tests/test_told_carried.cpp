// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_words.h"
#include "tasks/judging/judgement.h"

#include "tests/scenes.h"
#include "tests/told_numbers.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What findings tell of motion that does not go on from the circle's own place and velocity.
class TestToldCarried : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void velocityThatIsSetIsTold_data();
    void velocityThatIsSetIsTold();
    void startThatIsNotTakenOverIsTold_data();
    void startThatIsNotTakenOverIsTold();
    void startOfOneThatWaitsIsTold_data();
    void startOfOneThatWaitsIsTold();
    void velocitiesThatAreExchangedAreTold();
    void velocityOfAnotherIsTold();
    void slowOnesThatStopAreTold();
    void speedThatIsLimitedIsTold_data();
    void speedThatIsLimitedIsTold();
    void placeThatIsMultipliedIsTold_data();
    void placeThatIsMultipliedIsTold();
    void anotherThatMovesItIsTold();
    void momentOfTheRunIsTold_data();
    void momentOfTheRunIsTold();
    void faultIsOfPlaceOrOfVelocity_data();
    void faultIsOfPlaceOrOfVelocity();

private:
    [[nodiscard]] QString body(const QString &program, const char *headline) const
    {
        const LawBench bench(task(QStringLiteral("L42T4")));
        const MeasuredLaws own(&program, bench.ground);
        return bodyOf(flightDeviations(own.flight(), bench.right.flight(), bench.ground),
                      QString::fromUtf8(headline));
    }
    /// Of a program that does so to every circle.
    [[nodiscard]] QString bodyOfMove(const char *move, const char *headline) const
    {
        return body(written({.move = QString::fromUtf8(move)}, structures[0]), headline);
    }
};

void TestToldCarried::velocityThatIsSetIsTold_data()
{
    QTest::addColumn<QString>("velocity");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<Vec2>("made"); // NaN: as it was, or by gravity
    const double kept = scenes::notANumber;
    QTest::newRow("both parts") << "vec(1.5, -2)"
                                << "The velocity of both circles is set anew in every step"
                                << Vec2{1.5, -2.0};
    QTest::newRow("to rest") << "vec(0, 0)"
                             << "In free flight a step took the velocity of both circles away"
                             << Vec2{kept, kept};
    QTest::newRow("to rest under gravity")
        << "gravity:length() > 0 and vec(0, 0) or c.velocity"
        << "Under gravity a step took the velocity of both circles away" << Vec2{kept, kept};
    QTest::newRow("x") << "vec(2, c.velocity.y + gravity.y * h)"
                       << "The x of the velocity of both circles is set anew in every step"
                       << Vec2{2.0, kept};
    QTest::newRow("x to 0") << "vec(0, c.velocity.y + gravity.y * h)"
                            << "The x of the velocity of both circles is 0 after every step"
                            << Vec2{0.0, kept};
    QTest::newRow("y to 0") << "vec(c.velocity.x, 0)"
                            << "The y of the velocity of both circles is 0 after every step"
                            << Vec2{kept, 0.0};
    QTest::newRow("y") << "vec(c.velocity.x, -3)"
                       << "The y of the velocity of both circles is set anew in every step"
                       << Vec2{kept, -3.0};
}

void TestToldCarried::velocityThatIsSetIsTold()
{
    QFETCH(QString, velocity);
    QFETCH(QString, headline);
    QFETCH(Vec2, made);
    const QString said = bodyOfMove(
        (QStringLiteral("c.position = c.position + c.velocity * h c.velocity = ") + velocity)
            .toUtf8()
            .constData(),
        headline.toUtf8().constData());
    auto n = numbersIn(said, "Started with (#, #) m/s, it has (#, #) m/s one step later");
    if (std::isnan(made.x) && std::isnan(made.y)) {
        const bool isOfGravity = headline.startsWith(QLatin1String("Under"));
        n = numbersIn(
            said,
            isOfGravity
                ? "Started with (#, #) m/s under gravity (0, -9.81) m/s², away from every wall and "
                  "every other circle, its velocity is 0 one step later; without gravity it keeps "
                  "it."
                : "Started with (#, #) m/s, away from every wall and every other "
                  "circle, its velocity is 0 one step later.");
        QVERIFY2(n.size() == 2, qPrintable(said));
        return;
    }
    QVERIFY2(n.size() == 4, qPrintable(said));
    QVERIFY(std::isnan(made.x) ? isNear(n[2], n[0]) : isNear(n[2], made.x));
    QVERIFY(std::isnan(made.y) ? isNear(n[3], n[1] - 9.81 / 60.0) : isNear(n[3], made.y));
    QVERIFY(!isNear(Vec2{n[0], n[1]}, Vec2{n[2], n[3]}));
}

/// Of a program with a place and a velocity of its own, in a step with gravity and in one without.
void TestToldCarried::startThatIsNotTakenOverIsTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("begins");   ///< its place and velocity
    QTest::addColumn<QString>("velocity"); ///< of the next step, which goes by the one before
    QTest::addColumn<QString>("headline");
    QTest::addColumn<int>("line");
    const auto row = [](const char *step, const char *begins, const char *velocity,
                        const char *headline, int line) {
        QTest::addRow("%s, %s, %s", step, begins, velocity)
            << QString::fromLatin1(step) << QString::fromLatin1(begins)
            << QString::fromLatin1(velocity) << QString::fromLatin1(headline) << line;
    };
    const char *place = "s.p = circle1.position\ns.v = ";
    const char *velocity = "The velocity of circle 1 at the start is not taken over";
    const char *goesOn = "s.v + gravity * h";
    const auto with = [&](const char *v) { return QByteArray(place) + v; };
    row("L42T3", with("vec(0, 0)"), goesOn, velocity, 4);
    row("L42T3", with("vec(2, 0)"), goesOn, velocity, 4);
    row("L42T3", with("vec(circle1.velocity.x, 0)"), goesOn,
        "The velocity of circle 1 at the start is not taken over whole", 0);
    row("L42T2", with("vec(2, 0)"), goesOn, velocity, 4);
    row("L42T3", "s.p = vec(0, 0)\ns.v = circle1.velocity", goesOn,
        "The place of circle 1 at the start is not taken over", 3);
    const char *anew = "The velocity of circle 1 is set anew in every step";
    row("L42T3", with("circle1.velocity"), "vec(2, -1)", anew, 0);
    row("L42T3", with("circle1.velocity"), "vec(2, 0) + gravity * h", anew, 0);
    row("L42T2", with("circle1.velocity"), "vec(2, -1)", anew, 0);
}

void TestToldCarried::startThatIsNotTakenOverIsTold()
{
    QFETCH(QString, step);
    QFETCH(QString, begins);
    QFETCH(QString, velocity);
    QFETCH(QString, headline);
    QFETCH(int, line);
    const QString program = QStringLiteral(R"lua(local s = {}
function on_load()
%1
end
function on_update(h)
local was, limit = s.p, square.half_width - circle1.radius
s.p = s.p + s.v * h
s.v = %2
if math.abs(s.p.x) > limit and s.p.x * s.v.x > 0 then
s.p, s.v = was, vec(-s.v.x, s.v.y)
end
if math.abs(s.p.y) > limit and s.p.y * s.v.y > 0 then
s.p, s.v = was, vec(s.v.x, -s.v.y)
end
circle1.position, circle1.velocity = s.p, s.v
end
)lua")
                                .arg(begins, velocity);
    const Task &of = task(step);
    const CheckReport report = *judgeTask(m_lab, of, Submission(of.preset, program), 1);
    const auto told =
        std::find_if(report.findings.begin(), report.findings.end(), [&](const Finding &each) {
            return each.message.startsWith(headline + QLatin1Char('\n'));
        });
    QVERIFY2(told != report.findings.end(),
             report.findings.empty() ? "nothing" : qPrintable(report.findings[0].message));
    if (line > 0)
        QCOMPARE(told->line, line);
}

/// A circle with a place of its own that rests until it is hit is put nowhere in every step, and
/// none of these takes its velocity away.
void TestToldCarried::startOfOneThatWaitsIsTold_data()
{
    QTest::addColumn<QString>("places"); ///< before a step
    QTest::newRow("its own") << "b.p";
    QTest::newRow("the circle's") << "circles[i].position";
}

void TestToldCarried::startOfOneThatWaitsIsTold()
{
    QFETCH(QString, places);
    const QString program = QStringLiteral(R"lua(local s = {}
function on_load()
s[1] = { p = vec(-2, 2), v = vec(2, 0) }
s[2] = { p = vec(2, 2), v = vec(0, 0) }
end
function on_update(h)
local reach = circle1.radius + circle2.radius
for i, b in ipairs(s) do
b.p = %1 + b.v * h
if math.abs(b.p.x) > 3.8 and b.p.x * b.v.x > 0 then b.v = vec(-b.v.x, b.v.y) end
end
local d = s[2].p - s[1].p
if d:length() < reach and dot(s[2].v - s[1].v, d) < 0 then s[1].v, s[2].v = s[2].v, s[1].v end
for i, b in ipairs(s) do circles[i].position, circles[i].velocity = b.p, b.v end
end
)lua")
                                .arg(places);
    const Task &of = task(QStringLiteral("L42T10"));
    const CheckReport report = *judgeTask(m_lab, of, Submission(of.preset, program), 1);
    QCOMPARE(report.findings.size(), std::size_t(1));
    QCOMPARE(report.findings[0].message.section(QLatin1Char('\n'), 0, 0),
             QStringLiteral("The velocity of both circles at the start is not taken over"));
    QCOMPARE(report.findings[0].line, 3);
}

/// Each has what the other had, with gravity added.
void TestToldCarried::velocitiesThatAreExchangedAreTold()
{
    const QString said =
        body(QStringLiteral("function on_update(h) "
                            "circle1.position = circle1.position + circle1.velocity * h "
                            "circle2.position = circle2.position + circle2.velocity * h "
                            "circle1.velocity, circle2.velocity = circle2.velocity + gravity * h, "
                            "circle1.velocity + gravity * h end"),
             "Each circle goes on with the velocity of the other");
    const auto n = numbersIn(said, "started with (#, #) m/s, circle # has (#, #) m/s.");
    QVERIFY2(n.size() == 5, qPrintable(said));
    QCOMPARE(n[2], 1.0);
    QVERIFY(!isNear(Vec2{n[0], n[1] - 9.81 / 60.0}, Vec2{n[3], n[4]}));
}

/// Circle 2 has what circle 1 had, with gravity added.
void TestToldCarried::velocityOfAnotherIsTold()
{
    const QString said =
        body(QStringLiteral("function on_update(h) local v = circle1.velocity "
                            "circle1.position = circle1.position + v * h "
                            "circle2.position = circle2.position + circle2.velocity * h "
                            "circle1.velocity = v + gravity * h "
                            "circle2.velocity = v + gravity * h end"),
             "The velocity of circle 2 is taken from circle 1");
    const auto n = numbersIn(said, "what it has one step later comes from the velocity of circle "
                                   "#: started with (#, #) m/s, it has (#, #) m/s.");
    QVERIFY2(n.size() == 5, qPrintable(said));
    QCOMPARE(n[0], 1.0);
    QVERIFY(!isNear(Vec2{n[1], n[2] - 9.81 / 60.0}, Vec2{n[3], n[4]}));
}

void TestToldCarried::slowOnesThatStopAreTold()
{
    const QString said = bodyOfMove("c.position = c.position + c.velocity * h "
                                    "if c.velocity:length() < 4 then c.velocity = vec(0, 0) end "
                                    "c.velocity = c.velocity + gravity * h",
                                    "Away from every wall a low speed of both circles is taken");
    const auto n = numbersIn(said, "Started with (#, #) m/s, it has (#, #) m/s one step later");
    QVERIFY2(n.size() == 4, qPrintable(said));
    QVERIFY(std::hypot(n[0], n[1]) < 4.0);
    QVERIFY(isNear(Vec2{n[2], n[3]}, Vec2{0.0, -9.81 / 60.0}));
}

void TestToldCarried::speedThatIsLimitedIsTold_data()
{
    QTest::addColumn<QString>("faster");
    QTest::addColumn<double>("share"); // of the speed, or 0: 8 m/s
    QTest::newRow("held") << "c.velocity:normalized() * 8" << 0.0;
    QTest::newRow("less") << "c.velocity * 0.9" << 0.9;
    QTest::newRow("half") << "c.velocity / 2" << 0.5;
}

/// What falls from high comes so fast.
void TestToldCarried::speedThatIsLimitedIsTold()
{
    QFETCH(QString, faster);
    QFETCH(double, share);
    const QString said =
        bodyOfMove(QStringLiteral("c.position = c.position + c.velocity * h c.velocity = "
                                  "c.velocity + gravity * h "
                                  "if c.velocity:length() > 8 then c.velocity = %1 end")
                       .arg(faster)
                       .toUtf8()
                       .constData(),
                   "The velocity of both circles changes far from everything");
    const auto n = numbersIn(said, "Thrown with (#, #) m/s, it has (#, #) m/s one step of 1/60 s");
    QVERIFY2(n.size() == 4, qPrintable(said));
    const double was = std::hypot(n[0], n[1] - 9.81 / 60.0);
    QVERIFY(was > 8.0);
    QVERIFY(isNear(std::hypot(n[2], n[3]), share == 0.0 ? 8.0 : share * was));
}

void TestToldCarried::placeThatIsMultipliedIsTold_data()
{
    QTest::addColumn<QString>("factor");
    QTest::addColumn<double>("share");
    QTest::newRow("half") << "0.5" << 0.5;
    QTest::newRow("three times") << "3" << 3.0;
    QTest::newRow("the timestep") << "h" << 1.0 / 60.0;
}

void TestToldCarried::placeThatIsMultipliedIsTold()
{
    QFETCH(QString, factor);
    QFETCH(double, share);
    const QString said = bodyOfMove(QStringLiteral("c.position = c.position * %1 + c.velocity * h "
                                                   "c.velocity = c.velocity + gravity * h")
                                        .arg(factor)
                                        .toUtf8()
                                        .constData(),
                                    "The old place of both circles is multiplied, too");
    const auto n = numbersIn(said, "Two that start 1 m apart, at rest, are # m apart one step of "
                                   "1/# s later.");
    QVERIFY2(n.size() == 2, qPrintable(said));
    QVERIFY(isNear(n[0], share));
    QCOMPARE(n[1], 60.0);
}

void TestToldCarried::anotherThatMovesItIsTold()
{
    const QString said =
        body(QStringLiteral("function on_update(h) "
                            "circle2.position = circle2.position + circle1.velocity * h "
                            "circle1.position = circle1.position + circle1.velocity * h "
                            "circle1.velocity = circle1.velocity + gravity * h "
                            "circle2.velocity = circle2.velocity + gravity * h end"),
             "The velocity of circle 1 moves circle 2");
    QVERIFY2(said.startsWith(QString::fromUtf8("In a scene in which circle 1 alone has a velocity, "
                                               "circle 2 goes on by that times Δt.")),
             qPrintable(said));
    const QString follows =
        body(QStringLiteral("function on_update(h) for _, c in ipairs(circles) do "
                            "c.position = c.position + c.velocity * h "
                            "c.velocity = c.velocity + gravity * h end "
                            "circle2.position = circle1.position end"),
             "Every step puts circle 2 where circle 1 is");
    QVERIFY(!follows.isEmpty());
}

void TestToldCarried::momentOfTheRunIsTold_data()
{
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("velocity");
    QTest::addColumn<QString>("pattern");
    QTest::newRow("way") << "c.velocity * time"
                         << "gravity * h"
                         << "Started with (#, #) m/s, it goes (#, #) m in the second step of a run "
                            "and (#, #) m where it starts alike # s later, with the same Δt.";
    QTest::newRow("turn") << "c.velocity * h"
                          << "gravity * time"
                          << "Started with (#, #) m/s, it has (#, #) m/s after the first step of a "
                             "run and (#, #) m/s where it starts alike # s later.";
}

void TestToldCarried::momentOfTheRunIsTold()
{
    QFETCH(QString, place);
    QFETCH(QString, velocity);
    QFETCH(QString, pattern);
    const QString said =
        bodyOfMove(QStringLiteral("c.position = c.position + %1 c.velocity = c.velocity + %2")
                       .arg(place, velocity)
                       .toUtf8()
                       .constData(),
                   "The step of both circles depends on how long the run has lasted");
    const auto n = numbersIn(said, pattern.toUtf8().constData());
    QVERIFY2(n.size() == 7, qPrintable(said));
    QVERIFY(n[6] > 0.0);
    const Vec2 start{n[0], n[1]};
    const Vec2 first{n[2], n[3]};
    const Vec2 late{n[4], n[5]};
    if (place.endsWith(QLatin1String("time"))) {
        // As many times as far as the time is longer.
        QVERIFY(length(late) > 2.0 * length(first));
        QVERIFY(std::abs(cross(normalized(first), normalized(late))) < 0.02);
    } else {
        QVERIFY(isNear(first.x, start.x) && isNear(late.x, start.x));
        QVERIFY(late.y - start.y < 2.0 * (first.y - start.y) - 0.01);
    }
}

/// By it the line that is pointed at assigns the one or the other.
void TestToldCarried::faultIsOfPlaceOrOfVelocity_data()
{
    QTest::addColumn<QString>("move"); // of a first circle a and a second b
    QTest::addColumn<QString>("headline");
    QTest::addColumn<bool>("isPosition");
    const auto row = [](const char *headline, bool isPosition, const char *move) {
        QTest::newRow(headline) << QString::fromUtf8(move) << QString::fromUtf8(headline)
                                << isPosition;
    };
    row("Each circle goes on with the velocity of the other", false,
        "a.position = a.position + va * h b.position = b.position + vb * h "
        "a.velocity, b.velocity = vb + gravity * h, va + gravity * h");
    row("The velocity of circle 2 is taken from circle 1", false,
        "a.position = a.position + va * h b.position = b.position + vb * h "
        "a.velocity, b.velocity = va + gravity * h, va + gravity * h");
    row("Away from every wall a low speed of circle 1 is taken away", false,
        "a.position = a.position + va * h b.position = b.position + vb * h "
        "if va:length() < 4 then va = vec(0, 0) end "
        "a.velocity, b.velocity = va + gravity * h, vb + gravity * h");
    row("The velocity of circle 1 is set anew in every step", false,
        "a.position = a.position + va * h b.position = b.position + vb * h "
        "a.velocity, b.velocity = vec(1.5, -2), vb + gravity * h");
    row("The x of the velocity of circle 1 is set anew in every step", false,
        "a.position = a.position + va * h b.position = b.position + vb * h "
        "a.velocity, b.velocity = vec(2, va.y + gravity.y * h), vb + gravity * h");
    row("Every step puts circle 2 where circle 1 is", true,
        "a.position = a.position + va * h b.position = a.position "
        "a.velocity, b.velocity = va + gravity * h, vb + gravity * h");
    row("The velocity of circle 1 moves circle 2", true,
        "a.position = a.position + va * h b.position = b.position + va * h "
        "a.velocity, b.velocity = va + gravity * h, vb + gravity * h");
    row("The old place of circle 1 is multiplied, too", true,
        "a.position = a.position * 3 + va * h b.position = b.position + vb * h "
        "a.velocity, b.velocity = va + gravity * h, vb + gravity * h");
}

void TestToldCarried::faultIsOfPlaceOrOfVelocity()
{
    QFETCH(QString, move);
    QFETCH(QString, headline);
    QFETCH(bool, isPosition);
    const QString program = QStringLiteral("function on_update(h) local a, b = circle1, circle2 "
                                           "local va, vb = a.velocity, b.velocity %1 end")
                                .arg(move);
    const LawBench bench(task(QStringLiteral("L42T4")));
    const MeasuredLaws own(&program, bench.ground);
    const auto found = flightDeviations(own.flight(), bench.right.flight(), bench.ground);
    const auto told = std::find_if(found.begin(), found.end(), [&](const LawDeviation &each) {
        return each.message.startsWith(headline);
    });
    QVERIFY2(told != found.end(), found.empty() ? "nothing" : qPrintable(found[0].message));
    QCOMPARE(told->moment.isPosition, isPosition);
}

QTEST_GUILESS_MAIN(TestToldCarried)
#include "test_told_carried.moc"
