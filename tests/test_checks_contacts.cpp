// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"
#include "tasks/checks/contacts.h"

#include "tests/contact_programs.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::contacts;
using scenes::dt;

/// The checks of circle against circle against programs that are not the engine.
class TestChecksContacts : public QObject
{
    Q_OBJECT
private slots:
    void rightProgramIsAccepted_data();
    void rightProgramIsAccepted();
    void wrongProgramIsRefused_data();
    void wrongProgramIsRefused();
    void wrongProgramLosesMomentumOrEnergy_data();
    void wrongProgramLosesMomentumOrEnergy();
    void eachLawIsAskedAsItIs();
    void whoStandsStillBehindAHitIsSeen();
    void whoCrawlsBehindAHitIsSeen();
    void rightHitBeforeAWrongOneIsTold();
    void missingHitsAreCounted();
    void hitAtAWallIsNotACollision();
    void onlyWhoStaysInsidePartsInside_data();
    void onlyWhoStaysInsidePartsInside();
    void passingThroughIsSeen();
    void handWorkedVelocitiesAreAsked();
    void energyLossIsSeen();

private:
    static Observation meeting(const std::function<void(Circles &, double)> &program,
                               double restitution, double degrees, double sine, double radius);
};

/// Circle 1 comes from \p degrees and meets circle 2 off centre by \p sine; both move.
Observation TestChecksContacts::meeting(const std::function<void(Circles &, double)> &program,
                                        double e, double degrees, double sine, double radius)
{
    const double a = degrees * scenes::pi / 180.0;
    const Vec2 n{std::cos(a), std::sin(a)};
    const Vec2 common{0.4, -0.7};
    Circle one{.velocity = 2.0 * (std::sqrt(1.0 - sine * sine) * n + sine * perpendicular(n))};
    Circle two{.velocity = common, .radius = radius};
    // Contact after 0.5 s, and a third of a step.
    one.position = -(0.5 + dt / 3.0) * one.velocity;
    two.position = (one.radius + two.radius) * n;
    one.velocity += common;
    one.position -= (0.5 + dt / 3.0) * common;
    two.position -= (0.5 + dt / 3.0) * common;
    return observed(scene({one, two}, {}, e), 1.0, program);
}

void TestChecksContacts::rightProgramIsAccepted_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<double>("e");
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("sine");
    QTest::addColumn<double>("radius");
    for (int way = 0; way < static_cast<int>(std::size(rightWays)); ++way) {
        for (const double e : {1.0, 0.5, 0.0}) {
            for (const double degrees : {0.0, 45.0, 117.0, 290.0}) {
                for (const double sine : {0.0, 0.6, -0.9}) {
                    for (const double radius : {0.2, 0.35})
                        QTest::addRow("%s, e %g, %g degrees, sine %g, r %g", rightWays[way].name, e,
                                      degrees, sine, radius)
                            << way << e << degrees << sine << radius;
                }
            }
        }
    }
}

void TestChecksContacts::rightProgramIsAccepted()
{
    QFETCH(int, way);
    QFETCH(double, e);
    QFETCH(double, degrees);
    QFETCH(double, sine);
    QFETCH(double, radius);
    const Observation o = meeting([&](Circles &c, double h) { rightWays[way].step(c, e, h); }, e,
                                  degrees, sine, radius);
    VERIFY_ACCEPTED(judge(check("collides", {0, 1}), o));
    const QJsonObject energy{{QStringLiteral("energy"), e == 1.0}};
    VERIFY_ACCEPTED(judge(check("conserves", {0, 1}, energy), o));
}

void TestChecksContacts::wrongProgramIsRefused_data()
{
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Mistake &mistake : mistakes)
        QTest::newRow(mistake.name) << index++;
}

void TestChecksContacts::wrongProgramIsRefused()
{
    QFETCH(int, index);
    const Mistake &mistake = mistakes[index];
    const Observation o =
        meeting([&](Circles &c, double h) { mistake.step(c, mistakenRestitution, h); },
                mistakenRestitution, mistake.degrees, 0.4, 0.2);
    VERIFY_REFUSED(judge(check("collides", {0, 1}), o), QLatin1String(mistake.word));
}

void TestChecksContacts::wrongProgramLosesMomentumOrEnergy_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<QString>("word");
    QTest::newRow("whole velocity reversed") << 0 << QStringLiteral("momentum");
    QTest::newRow("second from the changed first") << 4 << QStringLiteral("momentum");
    QTest::newRow("e twice") << 5 << QStringLiteral("kinetic energy");
    QTest::newRow("e on one circle only") << 6 << QStringLiteral("momentum");
}

void TestChecksContacts::wrongProgramLosesMomentumOrEnergy()
{
    QFETCH(int, index);
    QFETCH(QString, word);
    const Observation o =
        meeting([&](Circles &c, double h) { mistakes[index].step(c, mistakenRestitution, h); },
                mistakenRestitution, 30.0, 0.4, 0.2);
    const QJsonObject energy{{QStringLiteral("energy"), true}};
    VERIFY_REFUSED(judge(check("conserves", {0, 1}, energy), o), word);
}

void TestChecksContacts::whoStandsStillBehindAHitIsSeen()
{
    for (int pause = 0; pause <= 4; ++pause) {
        int left = 0;
        const Observation o = meeting(
            [&](Circles &c, double h) {
                if (left-- > 0)
                    return;
                const Vec2 before = c[0].velocity;
                rightWays[0].step(c, 1.0, h);
                left = c[0].velocity == before ? 0 : pause;
            },
            1.0, 30.0, 0.4, 0.2);
        const auto fault = judge(check("collides", {0, 1}), o);
        if (pause < 3)
            VERIFY_ACCEPTED(fault);
        else
            VERIFY_REFUSED(fault, QStringLiteral("After a hit"));
        // Where no hit is asked for, they may be held where they were set.
        const QJsonObject none{{QStringLiteral("contacts"), 0}};
        VERIFY_ACCEPTED(judge(check("collides", {0, 1}, none), o));
    }
}

void TestChecksContacts::whoCrawlsBehindAHitIsSeen()
{
    for (const double share : {0.5, 0.7}) {
        int left = 0;
        const Observation o = meeting(
            [&](Circles &c, double h) {
                if (left-- > 0)
                    return move(c, share * h);
                const Vec2 before = c[0].velocity;
                rightWays[0].step(c, 1.0, h);
                left = c[0].velocity == before ? 0 : 5;
            },
            1.0, 30.0, 0.4, 0.2);
        const auto fault = judge(check("collides", {0, 1}), o);
        QCOMPARE(fault.has_value(), share < 0.6);
    }
}

/// The larger circle meets the other again when a wall has sent it back.
void TestChecksContacts::rightHitBeforeAWrongOneIsTold()
{
    const Circle one{.position = {2.5, 0.0}, .velocity = {1.0, 0.0}, .radius = 0.3};
    const Circle two{.position = {3.2, 0.0}};
    for (const double second : {1.0, 0.5, -1.0}) {
        double e = 1.0;
        const Observation o = observed(scene({one, two}, {}, 1.0), 1.2, [&](Circles &c, double h) {
            const Vec2 before = c[0].velocity;
            move(c, h);
            if (c[1].position.x > 4.0 - c[1].radius)
                c[1].velocity.x = -std::abs(c[1].velocity.x);
            if (touches(c))
                push(c, normalized(between(c)), e);
            e = c[0].velocity == before ? e : second;
        });
        const auto fault = judge(check("collides", {0, 1}), o);
        if (second == 1.0)
            VERIFY_ACCEPTED(fault);
        else
            VERIFY_REFUSED(fault, QStringLiteral("Their hit before, at step 13, came out right"));
    }
}

void TestChecksContacts::missingHitsAreCounted()
{
    const Observation o =
        meeting([](Circles &c, double h) { rightWays[0].step(c, 1.0, h); }, 1.0, 0.0, 0.0, 0.2);
    const QJsonObject two{{QStringLiteral("contacts"), 2}};
    VERIFY_REFUSED(judge(check("collides", {0, 1}, two), o), QStringLiteral("answered: 1"));
    const Observation apart = observed(scene({{}, {.position = {2.0, 0.0}}}), 1.0, move);
    for (const char *kind :
         {"collides", "conserves", "after_contact", "loses_energy", "passes_through"})
        QVERIFY2(judge(check(kind, {0, 1}), apart), kind);
}

void TestChecksContacts::hitAtAWallIsNotACollision()
{
    // One turns round at the right wall; the other rests on the other side.
    const Circle moving{.position = {3.0, 0.0}, .velocity = {3.0, 0.0}};
    const Circle resting{.position = {-3.0, 0.0}};
    const auto turn = [](Circles &c, double h) {
        move(c, h);
        for (Circle &each : c) {
            if (each.position.x > 3.8)
                each.velocity.x = -3.0;
        }
    };
    const QJsonObject none{{QStringLiteral("contacts"), 0}};
    for (const Preset &preset : {scene({moving, resting}), scene({resting, moving})})
        VERIFY_ACCEPTED(judge(check("collides", {0, 1}, none), observed(preset, 1.0, turn)));
}

/// Who goes back, or is put rim to rim, no longer overlaps when they part.
void TestChecksContacts::onlyWhoStaysInsidePartsInside_data()
{
    QTest::addColumn<int>("way");
    for (int way = 0; way < static_cast<int>(std::size(rightWays)); ++way)
        QTest::newRow(rightWays[way].name) << way;
}

void TestChecksContacts::onlyWhoStaysInsidePartsInside()
{
    QFETCH(int, way);
    const Observation o =
        meeting([&](Circles &c, double h) { rightWays[way].step(c, 1.0, h); }, 1.0, 0.0, 0.0, 0.2);
    QCOMPARE(motion::leavesInside(o, 0, 1, {}), way == 2);
}

void TestChecksContacts::passingThroughIsSeen()
{
    VERIFY_ACCEPTED(judge(check("passes_through", {0, 1}), meeting(move, 1.0, 0.0, 0.2, 0.2)));
    const auto hit = [](Circles &c, double h) { rightWays[0].step(c, 1.0, h); };
    VERIFY_REFUSED(judge(check("passes_through", {0, 1}), meeting(hit, 1.0, 0.0, 0.2, 0.2)),
                   QStringLiteral("pass"));
}

void TestChecksContacts::handWorkedVelocitiesAreAsked()
{
    // r 0.2 and 0.252 of one density, 1 m/s against −1 m/s: masses 1 : 2.000376.
    const Circle one{.position = {-1.0, 0.0}, .velocity = {1.0, 0.0}};
    const Circle two{.position = {1.0, 0.0}, .velocity = {-1.0, 0.0}, .radius = 0.252};
    const Observation o = observed(scene({one, two}), 2.0,
                                   [](Circles &c, double h) { rightWays[3].step(c, 1.0, h); });
    const QJsonArray right{json({-1.66683, 0.0}), json({0.333166, 0.0})};
    const QJsonArray wrong{json({-1.66683, 0.0}), json({0.34, 0.0})};
    const auto asked = [](const QJsonArray &velocities) {
        return check(
            "after_contact", {0, 1},
            {{QStringLiteral("velocities"), velocities}, {QStringLiteral("tolerance"), 1e-5}});
    };
    VERIFY_ACCEPTED(judge(asked(right), o));
    const auto fault = judge(asked(wrong), o);
    VERIFY_REFUSED(fault, QStringLiteral("circle 2"));
    QCOMPARE(*fault->expected, 0.34);
    COMPARE_NEAR(*fault->observed, 0.333166, 1e-5);
    QCOMPARE(fault->unit, QStringLiteral("m/s"));
}

void TestChecksContacts::energyLossIsSeen()
{
    const auto run = [](double e) {
        return meeting([e](Circles &c, double h) { rightWays[0].step(c, e, h); }, e, 0.0, 0.0, 0.2);
    };
    VERIFY_ACCEPTED(judge(check("loses_energy", {0, 1}), run(0.9)));
    VERIFY_REFUSED(judge(check("loses_energy", {0, 1}), run(1.0)), QStringLiteral("less"));
}

/// Of equal circles: normal parts or whole velocities change hands, or both stop. Only the first
/// has a normal, which may be that of the step before.
void TestChecksContacts::eachLawIsAskedAsItIs()
{
    const auto asked = [](const char *law) {
        return check("collides", {0, 1},
                     {{QStringLiteral("laws"), QJsonArray{QLatin1String(law)}}});
    };
    const auto whole = [](Circles &c, double h, bool stops) {
        move(c, h);
        if (!touches(c) || dot(c[0].velocity - c[1].velocity, between(c)) <= 0.0)
            return;
        std::swap(c[0].velocity, c[1].velocity);
        if (stops)
            c[0].velocity = c[1].velocity = {};
    };
    for (const double degrees : {20.0, 117.0}) {
        const auto meet = [&](const std::function<void(Circles &, double)> &program) {
            return meeting(program, 1.0, degrees, 0.6, 0.2);
        };
        for (const Way &way : rightWays) {
            const Observation parts = meet([&](Circles &c, double h) { way.step(c, 1.0, h); });
            VERIFY_ACCEPTED(judge(asked("swap_normal"), parts));
            QVERIFY(judge(asked("swap_velocities"), parts));
            QVERIFY(judge(asked("stop"), parts));
        }
        const Observation swap = meet([&](Circles &c, double h) { whole(c, h, false); });
        VERIFY_ACCEPTED(judge(asked("swap_velocities"), swap));
        QVERIFY(judge(asked("swap_normal"), swap));
        const Observation stop = meet([&](Circles &c, double h) { whole(c, h, true); });
        VERIFY_ACCEPTED(judge(asked("stop"), stop));
        QVERIFY(judge(asked("swap_normal"), stop));
    }
}

QTEST_APPLESS_MAIN(TestChecksContacts)
#include "test_checks_contacts.moc"
