// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/collision_detection.h"

#include "tests/generators.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// The paths of two circles that start apart by more than \p distance.
std::pair<Path, Path> twoPaths(double distance)
{
    const auto path = [] {
        return Path{vectorIn(3.0), vectorIn(5.0),
                    pathCurvature(anyIntegrator()) * Vec2{0.0, -9.81}};
    };
    const std::pair<Path, Path> paths(path(), path());
    RC_PRE(length(paths.first.position - paths.second.position) > distance);
    return paths;
}

double distanceAt(const Path &a, const Path &b, double s)
{
    return length(b.at(s) - a.at(s));
}

} // namespace

/// Laws that any path and any meeting of two paths obeys.
class TestPathLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void verletAndRungeKuttaRunBackwards();
    void integratorsKnowNoPlace();
    void contactIsWhereTheDistanceIs();
    void noContactMeansNoneInBetween();
    void lineIsMetWhereItIs();
};

void TestPathLaws::initTestCase()
{
    useFixedCases();
}

void TestPathLaws::verletAndRungeKuttaRunBackwards()
{
    QVERIFY(rc::check("h and then -h", [] {
        const Motion start{vectorIn(4.0), vectorIn(10.0)};
        const Vec2 a = vectorIn(20.0);
        const double h = numberIn(0.001, 0.1);
        for (const Integrator integrator : {Integrator::Verlet, Integrator::RungeKutta4}) {
            const Motion back = advance(integrator, advance(integrator, start, a, h), a, -h);
            RC_ASSERT(close(back.position, start.position, 1e-14));
            RC_ASSERT(close(back.velocity, start.velocity, 1e-14));
        }
    }));
}

void TestPathLaws::integratorsKnowNoPlace()
{
    QVERIFY(rc::check("shifted start, shifted end", [] {
        const Motion start{vectorIn(4.0), vectorIn(10.0)};
        const Vec2 shift = vectorIn(4.0);
        const Vec2 a = vectorIn(20.0);
        const Integrator integrator = anyIntegrator();
        const Motion here = advance(integrator, start, a, 0.05);
        const Motion there = advance(integrator, {start.position + shift, start.velocity}, a, 0.05);
        RC_ASSERT(close(there.position, here.position + shift, 1e-14));
        RC_ASSERT(there.velocity == here.velocity);
    }));
}

void TestPathLaws::contactIsWhereTheDistanceIs()
{
    QVERIFY(rc::check("|x_b - x_a| = distance there, and more before", [] {
        const double distance = numberIn(0.1, 2.0);
        const auto [a, b] = twoPaths(distance);
        const std::optional<double> s = timeToDistance(a, b, distance, 2.0);
        RC_PRE(s.has_value());
        RC_ASSERT(*s >= 0.0 && *s <= 2.0);
        RC_ASSERT(close(distanceAt(a, b, *s), distance, 1e-9));
        for (int i = 1; i < 100; ++i)
            RC_ASSERT(distanceAt(a, b, *s * i / 100.0) > distance - 1e-9);
    }));
}

void TestPathLaws::noContactMeansNoneInBetween()
{
    QVERIFY(rc::check("scan of the paths", [] {
        const double distance = numberIn(0.1, 2.0);
        const auto [a, b] = twoPaths(distance);
        RC_PRE(!timeToDistance(a, b, distance, 1.0).has_value());
        for (int i = 0; i <= 1000; ++i)
            RC_ASSERT(distanceAt(a, b, i / 1000.0) > distance - 1e-9);
    }));
}

void TestPathLaws::lineIsMetWhereItIs()
{
    QVERIFY(rc::check("gap = speed s + curve s^2", [] {
        const double gap = numberIn(0.0, 5.0);
        const double speed = numberIn(-10.0, 10.0);
        const double curve = numberIn(-10.0, 10.0);
        const auto left = [&](double s) { return gap - s * (speed + curve * s); };
        const std::optional<double> s = timeToLine(gap, speed, curve, 1.0);
        const int parts = 1000;
        const double until = s.value_or(1.0);
        for (int i = 1; i < parts; ++i)
            RC_ASSERT(left(until * i / parts) > -1e-12);
        if (s) {
            RC_ASSERT(*s >= 0.0 && *s <= 1.0);
            RC_ASSERT(close(left(*s), 0.0, 1e-12));
        }
    }));
}

QTEST_GUILESS_MAIN(TestPathLaws)
#include "test_path_laws.moc"
