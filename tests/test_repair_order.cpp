// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repair_order.h"

#include <QTest>

using namespace cradle;

/// Which changes are tried before others.
class TestRepairOrder : public QObject
{
    Q_OBJECT
private slots:
    void namesTellWhatIsTriedFirst_data();
    void namesTellWhatIsTriedFirst();
    void ofTwoEqualLinesTheLaterIsMeantForTheSecond();
    void whatIsToldComesFirst();
    void soundLinesComeLast();
    void whatIsAlikeStaysInItsOrder();
};

namespace {

std::vector<QString> inOrder(const QString &source, const QStringList &changed,
                             const std::set<int> &sound = {})
{
    std::vector<Repair> repairs;
    for (const QString &each : changed)
        repairs.push_back({each, 1, true, false});
    putInOrder(repairs, source, sound);
    std::vector<QString> sources;
    for (const Repair &each : repairs)
        sources.push_back(each.source);
    return sources;
}

} // namespace

void TestRepairOrder::namesTellWhatIsTriedFirst_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("sooner");
    QTest::addColumn<QString>("later");
    QTest::newRow("numbers") << "local m2 = mass(circle1)"
                             << "local m2 = mass(circle2)"
                             << "local m2 = -mass(circle1)";
    QTest::newRow("letters") << "ub = dot(a.velocity, n)"
                             << "ub = dot(b.velocity, n)"
                             << "ub = -dot(a.velocity, n)";
    QTest::newRow("coordinates") << "local dy = p.x - q.x"
                                 << "local dy = p.y - q.y"
                                 << "local dy = p.x + q.x";
    QTest::newRow("one of several") << "local m1, m2 = mass(c1), mass(c1)"
                                    << "local m1, m2 = mass(c1), mass(c2)"
                                    << "local m1, m2 = mass(c1), 2 * mass(c1)";
    QTest::newRow("several of one call") << "local x2, y2 = parts(p1)"
                                         << "local x2, y2 = parts(p2)"
                                         << "local x2, y2 = -parts(p1)";
    QTest::newRow("not against the names") << "local m1 = mass(circle1)"
                                           << "local m1 = -mass(circle1)"
                                           << "local m1 = mass(circle2)";
    QTest::newRow("what is of both tells nothing") << "w1 = u1 - u2"
                                                   << "w1 = u2 - u1"
                                                   << "w1 = u2 - u2";
    QTest::newRow("nothing is asked any more") << "if u < w then"
                                               << "if u > w then"
                                               << "if true then";
}

void TestRepairOrder::namesTellWhatIsTriedFirst()
{
    QFETCH(QString, source);
    QFETCH(QString, sooner);
    QFETCH(QString, later);
    const std::vector<QString> order{sooner, later};
    QCOMPARE(inOrder(source, {sooner, later}), order);
    QCOMPARE(inOrder(source, {later, sooner}), order);
}

void TestRepairOrder::ofTwoEqualLinesTheLaterIsMeantForTheSecond()
{
    const auto first = [](const QString &wrong, const QString &right) {
        std::vector<Repair> repairs{
            {right + QLatin1Char('\n') + wrong, 1, true, false},
            {wrong + QLatin1Char('\n') + right, 2, true, false},
        };
        putInOrder(repairs, wrong + QLatin1Char('\n') + wrong, {});
        return repairs.front().line;
    };
    QCOMPARE(first(QStringLiteral("walls(circle1)"), QStringLiteral("walls(circle2)")), 2);
    QCOMPARE(first(QStringLiteral("walls(circle2)"), QStringLiteral("walls(circle1)")), 1);
    QCOMPARE(first(QStringLiteral("walls(circle1)"), QStringLiteral("move(circle1)")), 1);
    QCOMPARE(first(QStringLiteral("move(circle1)"), {}), 2); // that is one too many
}

void TestRepairOrder::whatIsToldComesFirst()
{
    std::vector<Repair> repairs{{QStringLiteral("x = 2"), 1, true, false},
                                {QStringLiteral("x = 3"), 1, true, true}};
    putInOrder(repairs, QStringLiteral("x = 1"), {1});
    QCOMPARE(repairs.front().source, QStringLiteral("x = 3"));
    // But not against the names.
    repairs = {{QStringLiteral("m1 = f(c2)"), 1, true, true},
               {QStringLiteral("m1 = g(c1)"), 1, true, false}};
    putInOrder(repairs, QStringLiteral("m1 = f(c1)"), {});
    QCOMPARE(repairs.front().source, QStringLiteral("m1 = g(c1)"));
}

void TestRepairOrder::soundLinesComeLast()
{
    const QString source = QStringLiteral("x = u\ny = w");
    std::vector<Repair> repairs{{QStringLiteral("x = -u\ny = w"), 1, true, false},
                                {QStringLiteral("x = u\ny = -w"), 2, true, false}};
    putInOrder(repairs, source, {1});
    QCOMPARE(repairs.front().line, 2);
    putInOrder(repairs, source, {2});
    QCOMPARE(repairs.front().line, 1);
}

void TestRepairOrder::whatIsAlikeStaysInItsOrder()
{
    const QStringList changed{QStringLiteral("x = 3"), QStringLiteral("x = 2"),
                              QStringLiteral("x = 5")};
    const std::vector<QString> order(changed.begin(), changed.end());
    QCOMPARE(inOrder(QStringLiteral("x = 1"), changed), order);
    // Words that end in the same letters by chance tell nothing.
    QCOMPARE(inOrder(QStringLiteral("alpha = lamb"), changed), order);
}

QTEST_GUILESS_MAIN(TestRepairOrder)
#include "test_repair_order.moc"
