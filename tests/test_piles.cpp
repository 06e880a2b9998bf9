// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/contact_solver.h"
#include "model/continuous/pile_contacts.h"
#include "model/world/random.h"
#include "tests/scenes.h"

#include <numeric>

using namespace cradle;
using namespace cradle::scenes;

/// The pushes in a large pile, solved.
class TestPiles : public QObject
{
    Q_OBJECT
private slots:
    void pushesAreThoseOfOtherSolvers();
    void aColumnWeighsOnTheFloor();
    void aGuessIsOnlyABegin();
    void unfinishedPushesGiveNoEnergy();
};

namespace {

/// Contacts of random bodies that close at random speeds.
std::vector<PileContact> randomContacts(Random &random, std::size_t count, PileBodies &bodies)
{
    const std::size_t bodyCount = count + 2;
    bodies.velocities.assign(bodyCount, Vec2{});
    bodies.inverseMasses.assign(bodyCount, 0.0);
    for (std::size_t i = 1; i < bodyCount; ++i) {
        bodies.velocities[i] = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
        bodies.inverseMasses[i] = random.between(0.5, 2.0);
    }
    std::vector<PileContact> contacts;
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = static_cast<std::uint32_t>(1 + i % (bodyCount - 1));
        auto b = static_cast<std::uint32_t>(random.below(bodyCount));
        if (a == b)
            b = 0;
        const double angle = random.between(-pi, pi);
        contacts.push_back({a, b, {std::cos(angle), std::sin(angle)}});
    }
    return contacts;
}

double kineticEnergyOf(const PileBodies &bodies)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < bodies.velocities.size(); ++i) {
        if (bodies.inverseMasses[i] > 0.0)
            sum += 0.5 * lengthSquared(bodies.velocities[i]) / bodies.inverseMasses[i];
    }
    return sum;
}

} // namespace

/// The velocities that fulfil the conditions are unique, so another solver must find the same.
void TestPiles::pushesAreThoseOfOtherSolvers()
{
    Random random(1);
    for (int run = 0; run < 20; ++run) {
        PileBodies bodies;
        std::vector<PileContact> contacts = randomContacts(random, 30, bodies);
        std::vector<Vec2> expected = bodies.velocities;
        std::vector<Contact> others;
        for (const PileContact &c : contacts) {
            // Body 0 is a wall.
            const bool wall = c.b == 0;
            const double closing = dot(expected[c.a] - expected[c.b], c.normal);
            others.push_back({.a = static_cast<int>(c.a),
                              .b = wall ? -1 : static_cast<int>(c.b),
                              .normal = c.normal,
                              .change = closing});
        }
        solveContacts(others, bodies.inverseMasses);
        for (const Contact &c : others) {
            const auto a = static_cast<std::size_t>(c.a);
            expected[a] -= (c.impulse * bodies.inverseMasses[a]) * c.normal;
            if (c.b >= 0) {
                const auto b = static_cast<std::size_t>(c.b);
                expected[b] += (c.impulse * bodies.inverseMasses[b]) * c.normal;
            }
        }
        solvePile(contacts, bodies, 1e-13, 100'000);
        for (std::size_t i = 0; i < expected.size(); ++i)
            COMPARE_NEAR(length(bodies.velocities[i] - expected[i]), 0.0, 1e-9);
        for (const PileContact &c : contacts) {
            const double closing = dot(bodies.velocities[c.a] - bodies.velocities[c.b], c.normal);
            QVERIFY(c.push >= 0.0);
            QVERIFY(closing <= 1e-9);
            COMPARE_NEAR(c.push * closing, 0.0, 1e-9);
        }
    }
}

void TestPiles::aColumnWeighsOnTheFloor()
{
    // Twenty of 1 kg, 2 kg, … upon each other: the k-th contact carries all above it.
    constexpr std::uint32_t count = 20;
    PileBodies bodies;
    std::vector<PileContact> contacts;
    for (std::uint32_t i = 0; i < count; ++i) {
        bodies.velocities.push_back({0, -g * dt});
        bodies.inverseMasses.push_back(1.0 / (i + 1.0));
        contacts.push_back({i, i == 0 ? count : i - 1, {0, -1}});
    }
    bodies.velocities.push_back({});
    bodies.inverseMasses.push_back(0.0);
    const int sweeps = solvePile(contacts, bodies, 1e-12, 10'000);
    for (std::uint32_t i = 0; i < count; ++i) {
        double above = 0.0;
        for (std::uint32_t k = i; k < count; ++k)
            above += (k + 1.0) * g * dt;
        COMPARE_NEAR(contacts[i].push, above, 1e-9 * above);
    }
    // Sweeps by height, and conjugate: far fewer than 20² it would take one by one.
    QVERIFY2(sweeps <= 80, QByteArray::number(sweeps).constData());
}

void TestPiles::aGuessIsOnlyABegin()
{
    Random random(2);
    PileBodies bodies;
    std::vector<PileContact> contacts = randomContacts(random, 200, bodies);
    PileBodies again = bodies;
    solvePile(contacts, bodies, 1e-12, 100'000);
    std::vector<PileContact> guessed = contacts;
    const int sweeps = solvePile(guessed, again, 1e-9, 100'000);
    QVERIFY2(sweeps <= 4, QByteArray::number(sweeps).constData());
    for (PileContact &c : guessed)
        c.push = 10.0 * random.between(0.0, 1.0);
    Random same(2);
    PileBodies third;
    (void)randomContacts(same, 200, third);
    solvePile(guessed, third, 1e-12, 100'000);
    for (std::size_t i = 0; i < bodies.velocities.size(); ++i)
        COMPARE_NEAR(length(third.velocities[i] - bodies.velocities[i]), 0.0, 1e-8);
}

/// Where nothing may close, contacts take energy, whenever they are left off.
void TestPiles::unfinishedPushesGiveNoEnergy()
{
    Random random(3);
    for (int sweeps = 2; sweeps <= 12; sweeps += 2) {
        PileBodies bodies;
        std::vector<PileContact> contacts = randomContacts(random, 300, bodies);
        const std::vector<Vec2> before = bodies.velocities;
        const double energy = kineticEnergyOf(bodies);
        solvePile(contacts, bodies, 0.0, sweeps);
        // Exactly what the change of the velocities takes.
        double change = 0.0;
        for (std::size_t i = 1; i < before.size(); ++i)
            change +=
                0.5 * lengthSquared(bodies.velocities[i] - before[i]) / bodies.inverseMasses[i];
        COMPARE_NEAR(kineticEnergyOf(bodies) - energy, -change, 1e-12 * energy);
    }
}

QTEST_APPLESS_MAIN(TestPiles)
#include "test_piles.moc"
