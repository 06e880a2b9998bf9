// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/collision_detection.h"
#include "model/collision_response.h"
#include "model/contact_solver.h"
#include "model/measurements.h"
#include "model/preset_json.h"
#include "tests/generators.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

/// More hits than a few circles have in 5 s, unless they hand the same push to and fro.
constexpr std::size_t manyHits = 2000;

Vec2 unitVector()
{
    const double angle = numberIn(0.0, 2.0 * pi);
    return {std::cos(angle), std::sin(angle)};
}

/// Any double of either sign and any size up to \p bound, zeros and tiny ones among them.
double wildNumber(double bound)
{
    const double mantissa = numberIn(-1.0, 1.0);
    return std::clamp(std::ldexp(mantissa, *rc::gen::inRange(-1080, 40)), -bound, bound);
}

double positiveNumber(double low, double high)
{
    return std::clamp(std::abs(wildNumber(high)), low, high);
}

Integrator anyIntegrator()
{
    return *rc::gen::element(Integrator::Euler, Integrator::SymplecticEuler, Integrator::Verlet,
                             Integrator::RungeKutta4);
}

QString anyName()
{
    std::u32string name;
    for (const std::uint32_t code : *rc::gen::container<std::vector<std::uint32_t>>(
             rc::gen::inRange<std::uint32_t>(1, 0x10ffff))) {
        if (name.size() < 100 && (code < 0xd800 || code > 0xdfff))
            name.push_back(static_cast<char32_t>(code));
    }
    return QString::fromStdU32String(name);
}

/// Two circles in touch, of any mass ratio up to about a million.
struct Contacting {
    Circle a{};
    Circle b{};
    Vec2 n{};
};

Contacting contacting()
{
    Contacting c;
    c.n = unitVector();
    c.a = {.position = vectorIn(4.0),
           .velocity = vectorIn(10.0),
           .radius = numberIn(0.1, 1.0),
           .density = numberIn(0.1, 100.0)};
    c.b = {
        .velocity = vectorIn(10.0), .radius = numberIn(0.1, 1.0), .density = numberIn(0.1, 100.0)};
    c.b.position = c.a.position + (c.a.radius + c.b.radius) * c.n;
    return c;
}

/// A few circles on a lattice in the lab's square, none in touch, all moving.
Preset fewCircles(Laws laws)
{
    Preset preset = scene({}, laws);
    const int count = *rc::gen::inRange(1, 9);
    for (int i = 0; i < count; ++i) {
        const Vec2 site{-2.0 + 2.0 * (i % 3), -2.0 + 2.0 * (i / 3)};
        preset.circles.push_back(circle(site + vectorIn(0.4), vectorIn(5.0), numberIn(0.1, 0.5),
                                        anyIntegrator(), numberIn(0.5, 10.0)));
    }
    return preset;
}

/// Σ m |v|, the size that an error of the momentum is measured by.
double sizeOfMomentum(const World &world)
{
    double sum = 0.0;
    for (const Circle &c : world.circles)
        sum += mass(c) * length(c.velocity);
    return sum;
}

} // namespace

class TestLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    // Response
    void impulseKeepsMomentum();
    void impulseScalesTheRelativeNormalSpeed();
    void impulseLosesOnlyTheEnergyOfTheRelativeNormalMotion();
    void responseDoesNotDependOnWhoIsFirst();
    void responseMirrors();
    void equalMassesExchangeTheirNormalParts();
    void aSecondResponseChangesNothing();
    void wallKeepsTheTangentialPart();
    // Integrators
    void verletAndRungeKuttaRunBackwards();
    void integratorsKnowNoPlace();
    // Detection
    void contactIsWhereTheDistanceIs();
    void noContactMeansNoneInBetween();
    void lineIsMetWhereItIs();
    // Contacts together
    void contactsTogetherFulfilTheirConditions();
    // Runs
    void continuousRunsKeepMomentumAndEnergy();
    void continuousRunsNeitherOverlapNorLeave();
    void continuousRunsGainNoEnergy();
    void continuousRunsGoBackTheWayTheyCame();
    void discreteRunsStayInside();
    void aMovingObserverSeesTheSameHits();
    // Files
    void presetsRoundTrip();
    void fillsRoundTrip();
    void anyBytesAreReadOrRefused();
};

void TestLaws::initTestCase()
{
    useFixedCases();
}

void TestLaws::impulseKeepsMomentum()
{
    QVERIFY(rc::check("m_a v_a + m_b v_b stays", [] {
        auto [a, b, n] = contacting();
        const Vec2 before = mass(a) * a.velocity + mass(b) * b.velocity;
        const double size = mass(a) * length(a.velocity) + mass(b) * length(b.velocity);
        respond(CircleLaw::Impulse, a, b, n, numberIn(0.0, 1.0));
        RC_ASSERT(close(mass(a) * a.velocity + mass(b) * b.velocity, before, 1e-12 * size));
    }));
}

void TestLaws::impulseScalesTheRelativeNormalSpeed()
{
    QVERIFY(rc::check("u' = -e u", [] {
        auto [a, b, n] = contacting();
        const double e = numberIn(0.0, 1.0);
        const double closing = dot(a.velocity - b.velocity, n);
        RC_PRE(closing > 0.0);
        const double acrossA = cross(n, a.velocity);
        const double acrossB = cross(n, b.velocity);
        RC_ASSERT(respond(CircleLaw::Impulse, a, b, n, e));
        RC_ASSERT(close(dot(b.velocity - a.velocity, n), e * closing, 1e-12 * 40.0));
        RC_ASSERT(close(cross(n, a.velocity), acrossA, 1e-12 * 40.0));
        RC_ASSERT(close(cross(n, b.velocity), acrossB, 1e-12 * 40.0));
    }));
}

void TestLaws::impulseLosesOnlyTheEnergyOfTheRelativeNormalMotion()
{
    QVERIFY(rc::check("loss = (1 - e^2) mu u^2 / 2", [] {
        auto [a, b, n] = contacting();
        const double e = numberIn(0.0, 1.0);
        const double closing = std::max(0.0, dot(a.velocity - b.velocity, n));
        const auto kinetic = [](const Circle &x, const Circle &y) {
            return 0.5 * mass(x) * lengthSquared(x.velocity)
                   + 0.5 * mass(y) * lengthSquared(y.velocity);
        };
        const double before = kinetic(a, b);
        const double reduced = 1.0 / (1.0 / mass(a) + 1.0 / mass(b));
        respond(CircleLaw::Impulse, a, b, n, e);
        const double loss = 0.5 * reduced * closing * closing * (1.0 - e * e);
        RC_ASSERT(close(before - kinetic(a, b), loss, 1e-11 * before));
    }));
}

void TestLaws::responseDoesNotDependOnWhoIsFirst()
{
    QVERIFY(rc::check("(a, b, n) as (b, a, -n)", [] {
        auto [a, b, n] = contacting();
        const CircleLaw law = *rc::gen::element(CircleLaw::Stop, CircleLaw::SwapVelocities,
                                                CircleLaw::SwapNormal, CircleLaw::Impulse);
        const double e = numberIn(0.0, 1.0);
        Circle c = a;
        Circle d = b;
        RC_ASSERT(respond(law, a, b, n, e) == respond(law, d, c, -n, e));
        RC_ASSERT(close(a.velocity, c.velocity, 1e-11));
        RC_ASSERT(close(b.velocity, d.velocity, 1e-11));
    }));
}

void TestLaws::responseMirrors()
{
    QVERIFY(rc::check("bit for bit", [] {
        auto [a, b, n] = contacting();
        const double e = numberIn(0.0, 1.0);
        Circle c = a;
        Circle d = b;
        const auto mirror = [](Vec2 v) { return Vec2{v.x, -v.y}; };
        c.velocity = mirror(c.velocity);
        d.velocity = mirror(d.velocity);
        RC_ASSERT(respond(CircleLaw::Impulse, a, b, n, e)
                  == respond(CircleLaw::Impulse, c, d, mirror(n), e));
        RC_ASSERT(c.velocity == mirror(a.velocity));
        RC_ASSERT(d.velocity == mirror(b.velocity));
    }));
}

void TestLaws::equalMassesExchangeTheirNormalParts()
{
    QVERIFY(rc::check("impulse with e = 1 is swap normal", [] {
        auto [a, b, n] = contacting();
        b.radius = a.radius;
        b.density = a.density;
        Circle c = a;
        Circle d = b;
        respond(CircleLaw::Impulse, a, b, n, 1.0);
        respond(CircleLaw::SwapNormal, c, d, n, 1.0);
        RC_ASSERT(close(a.velocity, c.velocity, 1e-13 * 40.0));
        RC_ASSERT(close(b.velocity, d.velocity, 1e-13 * 40.0));
    }));
}

void TestLaws::aSecondResponseChangesNothing()
{
    QVERIFY(rc::check("they part after the first", [] {
        auto [a, b, n] = contacting();
        const double e = numberIn(0.01, 1.0);
        RC_PRE(dot(a.velocity - b.velocity, n) > 1e-6);
        respond(CircleLaw::Impulse, a, b, n, e);
        RC_ASSERT(!respond(CircleLaw::Impulse, a, b, n, e));
    }));
}

void TestLaws::wallKeepsTheTangentialPart()
{
    QVERIFY(rc::check("v_n' = -e v_n", [] {
        const Vec2 before = vectorIn(10.0);
        const Vec2 n = unitVector();
        const double e = numberIn(0.0, 1.0);
        Vec2 v = before;
        const bool changed = reflect(v, n, e);
        RC_ASSERT(changed == (dot(before, n) > 0.0));
        if (changed) {
            RC_ASSERT(close(dot(v, n), -e * dot(before, n), 1e-13 * 20.0));
            RC_ASSERT(close(cross(v, n), cross(before, n), 1e-13 * 20.0));
        } else {
            RC_ASSERT(v == before);
        }
    }));
}

void TestLaws::verletAndRungeKuttaRunBackwards()
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

void TestLaws::integratorsKnowNoPlace()
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

void TestLaws::contactIsWhereTheDistanceIs()
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

void TestLaws::noContactMeansNoneInBetween()
{
    QVERIFY(rc::check("scan of the paths", [] {
        const double distance = numberIn(0.1, 2.0);
        const auto [a, b] = twoPaths(distance);
        RC_PRE(!timeToDistance(a, b, distance, 1.0).has_value());
        for (int i = 0; i <= 1000; ++i)
            RC_ASSERT(distanceAt(a, b, i / 1000.0) > distance - 1e-9);
    }));
}

void TestLaws::lineIsMetWhereItIs()
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

void TestLaws::contactsTogetherFulfilTheirConditions()
{
    QVERIFY(rc::check("J >= 0, A J - change >= 0, J (A J - change) = 0", [] {
        // A ring of circles round one in the middle, some of them in touch with it.
        std::vector<double> inverseMasses{1.0};
        std::vector<Contact> contacts;
        for (int i = 0; i < 6; ++i) {
            inverseMasses.push_back(numberIn(0.2, 5.0));
            if (*rc::gen::inRange(0, 3) == 0)
                continue;
            const double angle = i * pi / 3.0;
            contacts.push_back({.a = 0,
                                .b = i + 1,
                                .normal = {std::cos(angle), std::sin(angle)},
                                .change = numberIn(0.0, 10.0)});
        }
        const std::vector<Contact> asked = contacts;
        solveContacts(contacts, inverseMasses);
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            RC_ASSERT(contacts[i].impulse >= 0.0);
            // The fall of closing speed at i: each body moves by J/m along its normals.
            double fall = 0.0;
            for (std::size_t j = 0; j < contacts.size(); ++j) {
                double share = inverseMasses[0];
                if (i == j)
                    share += inverseMasses[static_cast<std::size_t>(asked[i].b)];
                fall += share * dot(asked[i].normal, asked[j].normal) * contacts[j].impulse;
            }
            const double more = fall - asked[i].change;
            RC_ASSERT(more >= -1e-9);
            RC_ASSERT(close(contacts[i].impulse * more, 0.0, 1e-8));
        }
    }));
}

void TestLaws::continuousRunsKeepMomentumAndEnergy()
{
    QVERIFY(rc::check("no walls, e = 1, 2 s", [] {
        Run run(fewCircles({WallLaw::None, CircleLaw::Impulse, Timing::Continuous}));
        const Totals before = measure(run.world.circles, {}, halfWidth);
        const double size = sizeOfMomentum(run.world);
        run.steps(120);
        const Totals after = measure(run.world.circles, {}, halfWidth);
        RC_ASSERT(close(after.momentum, before.momentum, 1e-12 * size));
        RC_ASSERT(close(after.kinetic, before.kinetic, 1e-12 * before.kinetic));
    }));
}

void TestLaws::continuousRunsNeitherOverlapNorLeave()
{
    QVERIFY(rc::check("walls, no gravity, any e, 5 s", [] {
        Preset preset = fewCircles({WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        preset.restitution = numberIn(0.0, 1.0);
        Run run(preset);
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            RC_ASSERT(run.hits.size() < manyHits);
            const auto &circles = run.world.circles;
            for (std::size_t i = 0; i < circles.size(); ++i) {
                const Circle &c = circles[i];
                const double room = halfWidth - c.radius + 1e-9;
                RC_ASSERT(std::abs(c.position.x) <= room && std::abs(c.position.y) <= room);
                for (std::size_t j = i + 1; j < circles.size(); ++j) {
                    const double sum = c.radius + circles[j].radius;
                    RC_ASSERT(length(circles[j].position - c.position) >= sum - 1e-9);
                }
            }
        }
    }));
}

void TestLaws::continuousRunsGainNoEnergy()
{
    QVERIFY(rc::check("walls, no gravity, any e: the loss is that of the hits", [] {
        Preset preset = fewCircles({WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        preset.restitution = numberIn(0.0, 1.0);
        Run run(preset);
        const double before = measure(run.world.circles, {}, halfWidth).kinetic;
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            RC_ASSERT(run.hits.size() < manyHits);
        }
        // Of hits at the same moment each reports the velocities before and after them all.
        for (std::size_t i = 1; i < run.hits.size(); ++i)
            RC_PRE(run.hits[i].time > run.hits[i - 1].time);
        double lost = 0.0;
        for (const Hit &hit : run.hits) {
            const double taken = hit.loss;
            RC_ASSERT(taken >= -1e-12 * before);
            lost += taken;
        }
        const double after = measure(run.world.circles, {}, halfWidth).kinetic;
        RC_ASSERT(close(before - after, lost, 1e-10 * before));
    }));
}

void TestLaws::continuousRunsGoBackTheWayTheyCame()
{
    QVERIFY(rc::check("two circles, walls, e = 1: 2 s forth and back", [] {
        Preset preset = scene({circle(Vec2{-2, 0} + vectorIn(1.0), vectorIn(3.0), 0.3),
                               circle(Vec2{2, 0} + vectorIn(1.0), vectorIn(3.0), 0.4)},
                              {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        Run run(preset);
        const World start = run.world;
        run.steps(120);
        for (Circle &c : run.world.circles)
            c.velocity = -c.velocity;
        run.steps(120);
        for (std::size_t i = 0; i < 2; ++i) {
            RC_ASSERT(close(run[i].position, start.circles[i].position, 1e-7));
            RC_ASSERT(close(-run[i].velocity, start.circles[i].velocity, 1e-7));
        }
    }));
}

void TestLaws::discreteRunsStayInside()
{
    QVERIFY(rc::check("within one step's travel", [] {
        Preset preset = fewCircles({WallLaw::Reflect, CircleLaw::None, Timing::Discrete});
        preset.gravity = {0, -g};
        preset.restitution = numberIn(0.0, 0.9);
        Run run(preset);
        for (int step = 0; step < 300; ++step) {
            run.steps(1);
            for (const Circle &c : run.world.circles) {
                const double travel = length(c.velocity) * dt + g * dt * dt;
                const double room = halfWidth - c.radius + travel;
                RC_ASSERT(std::abs(c.position.x) <= room && std::abs(c.position.y) <= room);
            }
        }
    }));
}

void TestLaws::aMovingObserverSeesTheSameHits()
{
    QVERIFY(rc::check("Galilei", [] {
        Preset preset = scene({circle(Vec2{-1, 0} + vectorIn(0.4), vectorIn(3.0), 0.3),
                               circle(Vec2{1, 0} + vectorIn(0.4), vectorIn(3.0), 0.4)},
                              {WallLaw::None, CircleLaw::Impulse, Timing::Continuous});
        preset.restitution = numberIn(0.1, 1.0);
        Preset moving = preset;
        const Vec2 drift = vectorIn(3.0);
        for (PresetCircle &c : moving.circles)
            c.body.velocity += drift;
        Run here(preset);
        Run there(moving);
        here.steps(60);
        there.steps(60);
        // A hit that grazes may be missed by the one and not by the other, but changes little.
        for (std::size_t i = 0; i < 2; ++i) {
            RC_ASSERT(close(there[i].velocity, here[i].velocity + drift, 1e-6));
            RC_ASSERT(close(there[i].position, here[i].position + drift, 1e-6));
        }
    }));
}

void TestLaws::presetsRoundTrip()
{
    QVERIFY(rc::check("read what was written, write it again", [] {
        Preset preset;
        preset.name = anyName();
        preset.halfWidth = positiveNumber(limits::minLength, limits::maxLength);
        preset.gravity = {wildNumber(limits::maxAcceleration), wildNumber(limits::maxAcceleration)};
        preset.restitution = positiveNumber(0.0, 1.0);
        preset.timestep = positiveNumber(limits::minTimestep, limits::maxTimestep);
        preset.laws.timing = *rc::gen::element(Timing::Discrete, Timing::Continuous, Timing::Exact);
        // With a law they must not overlap: then they stand in a row, far apart.
        preset.laws.circles =
            *rc::gen::element(CircleLaw::None, CircleLaw::Stop, CircleLaw::SwapVelocities,
                              CircleLaw::SwapNormal, CircleLaw::Impulse);
        const bool apart = preset.laws.circles != CircleLaw::None;
        const int count = *rc::gen::inRange(0, 6);
        for (int i = 0; i < count; ++i) {
            PresetCircle c;
            c.name = anyName();
            c.body.radius = positiveNumber(limits::minLength, apart ? 1.0 : limits::maxLength);
            c.body.density = positiveNumber(limits::minDensity, limits::maxDensity);
            c.body.velocity = {wildNumber(limits::maxSpeed), wildNumber(limits::maxSpeed)};
            c.body.position = {apart ? 4.0 * i + numberIn(-0.5, 0.5)
                                     : wildNumber(limits::maxLength),
                               wildNumber(limits::maxLength)};
            c.integrator = anyIntegrator();
            c.colour =
                QStringLiteral("#%1").arg(*rc::gen::inRange(0, 0x1000000), 6, 16, QLatin1Char('0'));
            preset.circles.push_back(c);
        }
        RC_ASSERT(!findFault(preset).has_value());
        const QByteArray written = writePreset(preset);
        const Result<Preset> read = parsePreset(written);
        if (!read)
            RC_FAIL(read.error().toString().toStdString());
        RC_ASSERT(*read == preset);
        RC_ASSERT(writePreset(*read) == written);
    }));
}

void TestLaws::fillsRoundTrip()
{
    QVERIFY(rc::check("the fill and its circles", [] {
        Preset preset;
        preset.halfWidth = numberIn(1.0, 10.0);
        preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
        preset.fill = CircleFill{.count = *rc::gen::inRange(1, 60),
                                 .radius = numberIn(0.001, 0.1),
                                 .rmsSpeed = numberIn(0.0, 10.0),
                                 .density = numberIn(0.1, 10.0),
                                 .seed = *rc::gen::inRange(0, 2147483647)};
        preset.circles = *makeCircles(*preset.fill, preset.halfWidth);
        RC_ASSERT(!findFault(preset).has_value());
        const QByteArray written = writePreset(preset);
        const Result<Preset> read = parsePreset(written);
        RC_ASSERT(read.ok());
        RC_ASSERT(*read == preset);
        RC_ASSERT(writePreset(*read) == written);
    }));
}

void TestLaws::anyBytesAreReadOrRefused()
{
    QVERIFY(rc::check("no crash, and a message", [] {
        QByteArray text = writePreset(scene({circle({0, 0}), circle({1, 0})}, {}));
        const int changes = *rc::gen::inRange(1, 6);
        for (int i = 0; i < changes; ++i)
            text[*rc::gen::inRange(0, static_cast<int>(text.size()))] =
                static_cast<char>(*rc::gen::inRange(-128, 128));
        const Result<Preset> preset = parsePreset(text);
        if (preset)
            RC_ASSERT(!findFault(*preset).has_value());
        else
            RC_ASSERT(!preset.error().message.isEmpty());
    }));
}

QTEST_GUILESS_MAIN(TestLaws)
#include "test_laws.moc"
