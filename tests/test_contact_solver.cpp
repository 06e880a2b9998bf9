// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/contact_solver.h"

#include "model/world/random.h"
#include "tests/scenes.h"

#include <algorithm>
#include <array>

using namespace cradle;
using namespace cradle::scenes;

class TestContactSolver : public QObject
{
    Q_OBJECT
private slots:
    void noContactsNeedNothing();
    void aloneAContactIsSolvedByItsOwnEquation();
    void aWallContactCountsOnlyTheBody();
    void threeInARowShareTheImpulse();
    void aContactThatWouldPullGetsNone();
    void aBreakOfThreeIsSymmetric();
    void cornerWallsActEachForItself();
    void theOrderOfTheContactsDoesNotMatter();
    void aStackIsHeldByTheSumOfItsWeights_data();
    void aStackIsHeldByTheSumOfItsWeights();
    void aLongRowFulfilsItsConditions_data();
    void aLongRowFulfilsItsConditions();
    void aWedgedRowFulfilsItsConditions();
    void aPackFulfilsItsConditions();
};

namespace {

/// Circles of a row along x, each in touch with the next, that closes at random.
struct Row {
    std::vector<double> inverseMasses{};
    std::vector<double> velocities{}; ///< to the right, m/s
    std::vector<Contact> contacts{};
};

/// \param walls  at both ends, too
Row rowOf(int count, qint64 seed, bool walls)
{
    Random random(seed);
    Row row;
    for (int i = 0; i < count; ++i) {
        row.inverseMasses.push_back(random.between(0.2, 5.0));
        row.velocities.push_back(random.between(-1.0, 1.0));
    }
    const auto touch = [&](int a, int b, Vec2 n) {
        const double other = b < 0 ? 0.0 : row.velocities[static_cast<std::size_t>(b)];
        const double closing = (row.velocities[static_cast<std::size_t>(a)] - other) * n.x;
        row.contacts.push_back({.a = a, .b = b, .normal = n, .change = closing});
    };
    if (walls)
        touch(0, -1, {-1, 0});
    for (int i = 0; i + 1 < count; ++i)
        touch(i, i + 1, {1, 0});
    if (walls)
        touch(count - 1, -1, {1, 0});
    return row;
}

/// By how much the answers of \p row miss J ≥ 0, w ≥ 0 and J w = 0, from the velocities after
/// them: w is the speed at which a contact parts.
double faultOf(const Row &row)
{
    std::vector<double> v = row.velocities;
    for (const Contact &c : row.contacts) {
        const auto a = static_cast<std::size_t>(c.a);
        v[a] -= c.impulse * c.normal.x * row.inverseMasses[a];
        if (c.b >= 0)
            v[static_cast<std::size_t>(c.b)] +=
                c.impulse * c.normal.x * row.inverseMasses[static_cast<std::size_t>(c.b)];
    }
    double fault = 0.0;
    for (const Contact &c : row.contacts) {
        const double other = c.b < 0 ? 0.0 : v[static_cast<std::size_t>(c.b)];
        const double parting = (other - v[static_cast<std::size_t>(c.a)]) * c.normal.x;
        fault = std::max({fault, -c.impulse, -parting, std::abs(c.impulse * parting)});
    }
    return fault;
}

} // namespace

void TestContactSolver::noContactsNeedNothing()
{
    std::vector<Contact> contacts;
    solveContacts(contacts, {});
    QVERIFY(contacts.empty());
}

void TestContactSolver::aloneAContactIsSolvedByItsOwnEquation()
{
    // (1/m_a + 1/m_b) J = change: (½ + ¼) J = 3
    std::vector<Contact> contacts{{.a = 0, .b = 1, .normal = {1, 0}, .change = 3.0}};
    solveContacts(contacts, std::array{0.5, 0.25});
    COMPARE_NEAR(contacts[0].impulse, 4.0, 1e-15);
}

void TestContactSolver::aWallContactCountsOnlyTheBody()
{
    std::vector<Contact> contacts{{.a = 0, .b = -1, .normal = {0, -1}, .change = 3.0}};
    solveContacts(contacts, std::array{0.5});
    COMPARE_NEAR(contacts[0].impulse, 6.0, 1e-15);
}

void TestContactSolver::threeInARowShareTheImpulse()
{
    // The first of three 1 kg circles in touch runs into the others at 2 m/s, e = 1:
    //     2 J₁ − J₂ = 4,  −J₁ + 2 J₂ = 0   ⇒   J₁ = 8/3, J₂ = 4/3
    std::vector<Contact> contacts{{.a = 0, .b = 1, .normal = {1, 0}, .change = 4.0},
                                  {.a = 1, .b = 2, .normal = {1, 0}, .change = 0.0}};
    solveContacts(contacts, std::array{1.0, 1.0, 1.0});
    COMPARE_NEAR(contacts[0].impulse, 8.0 / 3.0, 1e-13);
    COMPARE_NEAR(contacts[1].impulse, 4.0 / 3.0, 1e-13);
}

void TestContactSolver::aContactThatWouldPullGetsNone()
{
    // The middle one is hit from the right: the contact on its left is pressed, the one of the
    // far pair that moves apart by itself is not pulled together.
    std::vector<Contact> contacts{{.a = 0, .b = 1, .normal = {1, 0}, .change = 2.0},
                                  {.a = 1, .b = 2, .normal = {1, 0}, .change = -6.0}};
    solveContacts(contacts, std::array{1.0, 1.0, 1.0});
    COMPARE_NEAR(contacts[0].impulse, 1.0, 1e-15);
    COMPARE_NEAR(contacts[1].impulse, 0.0, 0.0);
}

void TestContactSolver::aBreakOfThreeIsSymmetric()
{
    // 1 kg hits two 1 kg circles in touch along their axis at u = 1 m/s, e = 1. With
    // n = (cos 30°, ±sin 30°), A = [[2, ½], [½, 2]], change = 2 cos 30°:
    //     J = 2 cos 30° / 2.5 = (2/5)√3
    const double c = std::sqrt(0.75);
    std::vector<Contact> contacts{{.a = 0, .b = 1, .normal = {c, 0.5}, .change = 2.0 * c},
                                  {.a = 0, .b = 2, .normal = {c, -0.5}, .change = 2.0 * c}};
    solveContacts(contacts, std::array{1.0, 1.0, 1.0});
    COMPARE_NEAR(contacts[0].impulse, 0.4 * std::sqrt(3.0), 1e-14);
    QCOMPARE(contacts[1].impulse, contacts[0].impulse);
}

void TestContactSolver::cornerWallsActEachForItself()
{
    std::vector<Contact> contacts{{.a = 0, .b = -1, .normal = {0, -1}, .change = 3.0},
                                  {.a = 0, .b = -1, .normal = {1, 0}, .change = 5.0}};
    solveContacts(contacts, std::array{0.5});
    COMPARE_NEAR(contacts[0].impulse, 6.0, 1e-15);
    COMPARE_NEAR(contacts[1].impulse, 10.0, 1e-15);
}

void TestContactSolver::theOrderOfTheContactsDoesNotMatter()
{
    const double c = std::sqrt(0.75);
    const std::array masses{1.0, 0.5, 2.0, 1.0};
    std::vector<Contact> contacts{{.a = 0, .b = 1, .normal = {c, 0.5}, .change = 2.0},
                                  {.a = 0, .b = 2, .normal = {c, -0.5}, .change = 1.0},
                                  {.a = 1, .b = 2, .normal = {0, -1}, .change = 0.0},
                                  {.a = 2, .b = 3, .normal = {0, -1}, .change = 0.5}};
    std::vector<Contact> turned(contacts.rbegin(), contacts.rend());
    solveContacts(contacts, masses);
    solveContacts(turned, masses);
    for (std::size_t i = 0; i < contacts.size(); ++i)
        COMPARE_NEAR(turned[contacts.size() - 1 - i].impulse, contacts[i].impulse, 1e-13);
}

void TestContactSolver::aStackIsHeldByTheSumOfItsWeights_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("heavier"); // kg, each than the one below
    for (const int count : {1, 2, 5, 10, 100}) {
        QTest::addRow("%d alike", count) << count << 0.0;
        QTest::addRow("%d, each heavier than the one below", count) << count << 1.0;
    }
}

void TestContactSolver::aStackIsHeldByTheSumOfItsWeights()
{
    QFETCH(int, count);
    QFETCH(double, heavier);
    // Circle 0 lies on the floor, i + 1 on i. A contact carries all above it.
    std::vector<double> inverseMasses;
    std::vector<Contact> contacts;
    for (int i = 0; i < count; ++i) {
        inverseMasses.push_back(1.0 / (1.0 + heavier * i));
        if (i == 0)
            contacts.push_back({.a = 0, .b = -1, .normal = {0, -1}, .change = g});
        else
            contacts.push_back({.a = i - 1, .b = i, .normal = {0, 1}, .change = 0.0});
    }
    solveContacts(contacts, inverseMasses);
    double above = 0.0;
    for (int i = count - 1; i >= 0; --i) {
        above += 1.0 + heavier * i;
        COMPARE_NEAR(contacts[static_cast<std::size_t>(i)].impulse, above * g, 1e-9 * above * g);
    }
}

void TestContactSolver::aLongRowFulfilsItsConditions_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("walls");
    // Solved by iteration, by elimination, and, from 65 contacts on, as many. Between two walls a
    // push more through the whole row changes nothing: elimination finds no single answer.
    for (const int count : {3, 6, 8, 12, 30, 63, 65, 66, 300}) {
        QTest::addRow("%d", count) << count << false;
        QTest::addRow("%d between walls", count) << count << true;
    }
}

void TestContactSolver::aLongRowFulfilsItsConditions()
{
    QFETCH(int, count);
    QFETCH(bool, walls);
    for (qint64 seed = 1; seed <= 20; ++seed) {
        Row row = rowOf(count, seed, walls);
        solveContacts(row.contacts, row.inverseMasses);
        // Of many only the speeds are found to 1e-9.
        COMPARE_NEAR(faultOf(row), 0.0, count < 64 ? 1e-9 : 1e-6);
    }
}

/// A row on the floor, a little crooked and without room between two walls: more contacts than the
/// circles have ways to move, so what some do others could do, too.
void TestContactSolver::aWedgedRowFulfilsItsConditions()
{
    Random random(1);
    for (int run = 0; run < 200; ++run) {
        constexpr int count = 5;
        std::vector<double> inverseMasses;
        std::vector<Contact> contacts{{.a = 0, .normal = {-1, 0}},
                                      {.a = count - 1, .normal = {1, 0}}};
        for (int i = 0; i < count; ++i) {
            inverseMasses.push_back(random.between(0.02, 0.2));
            contacts.push_back(
                {.a = i, .normal = {0, -1}, .change = g * dt - random.between(0.0, 0.05)});
            if (i + 1 == count)
                continue;
            const double slope = random.between(-0.2, 0.2);
            contacts.push_back({.a = i,
                                .b = i + 1,
                                .normal = {std::cos(slope), std::sin(slope)},
                                .change = -1e-3 * random.between(0.0, 1.0)});
        }
        std::vector<double> changes;
        for (const Contact &c : contacts)
            changes.push_back(c.change);
        solveContacts(contacts, inverseMasses);
        std::vector<Vec2> velocities(count);
        for (const Contact &c : contacts) {
            const auto a = static_cast<std::size_t>(c.a);
            velocities[a] -= (c.impulse * inverseMasses[a]) * c.normal;
            if (c.b >= 0)
                velocities[a + 1] += (c.impulse * inverseMasses[a + 1]) * c.normal;
        }
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Contact &c = contacts[i];
            const auto a = static_cast<std::size_t>(c.a);
            const Vec2 other = c.b < 0 ? Vec2{} : velocities[a + 1];
            const double surplus = dot(other - velocities[a], c.normal) - changes[i];
            QVERIFY(c.impulse >= 0.0);
            COMPARE_NEAR(std::min(0.0, surplus), 0.0, 1e-9);
            COMPARE_NEAR(c.impulse * surplus, 0.0, 1e-8 * (1.0 + c.impulse));
        }
    }
}

/// Circles of unlike masses in a hexagonal pack that closes towards its middle: each push hangs on
/// those of up to ten others.
void TestContactSolver::aPackFulfilsItsConditions()
{
    constexpr int side = 20;
    for (qint64 seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        std::vector<double> inverseMasses;
        std::vector<Vec2> velocities;
        std::vector<Contact> contacts;
        for (int i = 0; i < side * side; ++i) {
            const int row = i / side;
            const Vec2 place{i % side + 0.5 * row, 0.866 * row};
            inverseMasses.push_back(random.between(0.2, 5.0));
            velocities.push_back(random.between(0.5, 1.0) * (Vec2{15.0, 8.0} - place));
        }
        const auto touch = [&](int a, int b, Vec2 n) {
            const Vec2 v =
                velocities[static_cast<std::size_t>(a)] - velocities[static_cast<std::size_t>(b)];
            contacts.push_back({.a = a, .b = b, .normal = n, .change = dot(v, n)});
        };
        const double high = std::sqrt(0.75);
        for (int i = 0; i < side * side; ++i) {
            if (i % side + 1 < side)
                touch(i, i + 1, {1.0, 0.0});
            if (i / side + 1 < side)
                touch(i, i + side, {0.5, high});
            if (i / side + 1 < side && i % side > 0)
                touch(i, i + side - 1, {-0.5, high});
        }
        solveContacts(contacts, inverseMasses);
        for (const Contact &c : contacts) {
            const auto a = static_cast<std::size_t>(c.a);
            const auto b = static_cast<std::size_t>(c.b);
            velocities[a] -= (c.impulse * inverseMasses[a]) * c.normal;
            velocities[b] += (c.impulse * inverseMasses[b]) * c.normal;
        }
        for (const Contact &c : contacts) {
            const double parting = dot(velocities[static_cast<std::size_t>(c.b)]
                                           - velocities[static_cast<std::size_t>(c.a)],
                                       c.normal);
            QVERIFY(c.impulse >= 0.0);
            QVERIFY2(parting >= -1e-6, QByteArray::number(parting));
            QVERIFY2(std::min(c.impulse, parting) < 1e-6, QByteArray::number(parting));
        }
    }
}

QTEST_APPLESS_MAIN(TestContactSolver)
#include "test_contact_solver.moc"
