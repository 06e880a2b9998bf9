// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model/contacts/collision_response.h"
#include "model/contacts/contact_solver.h"
#include "model/world/measurements.h"
#include "tests/generators.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

namespace {

Vec2 unitVector()
{
    const double angle = numberIn(0.0, 2.0 * pi);
    return {std::cos(angle), std::sin(angle)};
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

} // namespace

/// Laws that the answer to any hit obeys.
class TestResponseLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void impulseKeepsMomentum();
    void impulseScalesTheRelativeNormalSpeed();
    void impulseLosesOnlyTheEnergyOfTheRelativeNormalMotion();
    void responseDoesNotDependOnWhoIsFirst();
    void responseMirrors();
    void equalMassesExchangeTheirNormalParts();
    void aSecondResponseChangesNothing();
    void wallKeepsTheTangentialPart();
    void contactsTogetherFulfilTheirConditions();
};

void TestResponseLaws::initTestCase()
{
    useFixedCases();
}

void TestResponseLaws::impulseKeepsMomentum()
{
    QVERIFY(rc::check("m_a v_a + m_b v_b stays", [] {
        auto [a, b, n] = contacting();
        const Vec2 before = mass(a) * a.velocity + mass(b) * b.velocity;
        const double size = mass(a) * length(a.velocity) + mass(b) * length(b.velocity);
        respond(CircleLaw::Impulse, a, b, n, numberIn(0.0, 1.0));
        RC_ASSERT(close(mass(a) * a.velocity + mass(b) * b.velocity, before, 1e-12 * size));
    }));
}

void TestResponseLaws::impulseScalesTheRelativeNormalSpeed()
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

void TestResponseLaws::impulseLosesOnlyTheEnergyOfTheRelativeNormalMotion()
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

void TestResponseLaws::responseDoesNotDependOnWhoIsFirst()
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

void TestResponseLaws::responseMirrors()
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

void TestResponseLaws::equalMassesExchangeTheirNormalParts()
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

void TestResponseLaws::aSecondResponseChangesNothing()
{
    QVERIFY(rc::check("they part after the first", [] {
        auto [a, b, n] = contacting();
        const double e = numberIn(0.01, 1.0);
        RC_PRE(dot(a.velocity - b.velocity, n) > 1e-6);
        respond(CircleLaw::Impulse, a, b, n, e);
        RC_ASSERT(!respond(CircleLaw::Impulse, a, b, n, e));
    }));
}

void TestResponseLaws::wallKeepsTheTangentialPart()
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

void TestResponseLaws::contactsTogetherFulfilTheirConditions()
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

QTEST_GUILESS_MAIN(TestResponseLaws)
#include "test_response_laws.moc"
