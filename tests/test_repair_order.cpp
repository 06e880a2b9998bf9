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
    void numbersWithNamesComeFirst();
    void whatIsChangedInSeveralLinesComesBehind();
    void whatIsAlikeStaysInItsOrder();
    void aSignWhereNoneStoodComesBehindOtherWords();
    void whatTheNextLineOverwritesComesLast();
};

namespace {

std::vector<QString> inOrder(const QString &source, const QStringList &changed,
                             const std::set<int> &sound = {})
{
    std::vector<Repair> repairs;
    for (const QString &each : changed)
        repairs.push_back({each, 1, true, false});
    putInOrder(repairs, source, sound, false);
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
        putInOrder(repairs, wrong + QLatin1Char('\n') + wrong, {}, false);
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
    putInOrder(repairs, QStringLiteral("x = 1"), {1}, false);
    QCOMPARE(repairs.front().source, QStringLiteral("x = 3"));
    // But not against the names.
    repairs = {{QStringLiteral("m1 = f(c2)"), 1, true, true},
               {QStringLiteral("m1 = g(c1)"), 1, true, false}};
    putInOrder(repairs, QStringLiteral("m1 = f(c1)"), {}, false);
    QCOMPARE(repairs.front().source, QStringLiteral("m1 = g(c1)"));
}

void TestRepairOrder::soundLinesComeLast()
{
    const QString source = QStringLiteral("x = u\ny = w");
    std::vector<Repair> repairs{{QStringLiteral("x = -u\ny = w"), 1, true, false},
                                {QStringLiteral("x = u\ny = -w"), 2, true, false}};
    putInOrder(repairs, source, {1}, false);
    QCOMPARE(repairs.front().line, 2);
    putInOrder(repairs, source, {2}, false);
    QCOMPARE(repairs.front().line, 1);
}

void TestRepairOrder::numbersWithNamesComeFirst()
{
    const QString source = QStringLiteral("x = u + margin\nlocal margin = 0.1");
    const std::vector<Repair> all{{QStringLiteral("x = u\nlocal margin = 0.1"), 1},
                                  {QStringLiteral("x = u + margin\nlocal margin = 0"), 2}};
    std::vector<Repair> repairs = all;
    putInOrder(repairs, source, {}, true);
    QCOMPARE(repairs.front().line, 2);
    repairs = all;
    putInOrder(repairs, source, {}, false);
    QCOMPARE(repairs.front().line, 1);
}

void TestRepairOrder::whatIsChangedInSeveralLinesComesBehind()
{
    const QString source = QStringLiteral("a = u\nb = w\nc = p\nd.velocity = v");
    std::vector<Repair> repairs{
        {QStringLiteral("a = u\nb = w\nc = p\n"), 4},                       // a value not written
        {QStringLiteral("a = u + k + k\nb = w\nc = p\nd.velocity = v"), 1}, // the same twice
        {QStringLiteral("a = -u\nb = -w\nc = p\nd.velocity = v"), 1, false},
        {QStringLiteral("a = u\nb = w\nc = -p\nd.velocity = v"), 3}};
    putInOrder(repairs, source, {}, false);
    QCOMPARE(repairs[0].line, 3);
    QVERIFY(!repairs[1].alone);
    QVERIFY(!repairs[1].isDoubtful);
    QVERIFY(repairs[2].isDoubtful);
    QVERIFY(repairs[3].isDoubtful);
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

void TestRepairOrder::aSignWhereNoneStoodComesBehindOtherWords()
{
    const QString source = QStringLiteral("local out = f(p)\nif out > 0 and q then");
    std::vector<Repair> repairs = repairsOf(source, {}, {1, 2}, 1000);
    putInOrder(repairs, source, {}, false);
    const auto placeOf = [&](const char *row) {
        const auto at = std::find_if(repairs.begin(), repairs.end(), [&](const Repair &each) {
            return each.source.simplified().contains(QLatin1String(row));
        });
        return at == repairs.end() ? -1 : int(at - repairs.begin());
    };
    const int compared = placeOf("if out < 0 and q then");
    QVERIFY(compared >= 0);
    QVERIFY(placeOf("local out = - f(p)") > compared);
    QVERIFY(placeOf("if out > 0 then") > compared);
    QVERIFY(placeOf("if q then") > compared);
    QVERIFY(placeOf("local out = f( -p)") > compared);
    const QString guard = QStringLiteral("if u >= 0 then\n  return\nend\nhit(square.left)");
    repairs = repairsOf(guard, {}, {1, 2, 4}, 1000);
    putInOrder(repairs, guard, {}, false);
    QVERIFY(placeOf("hit(square.right)") >= 0);
    QVERIFY(placeOf("if u >= 0 then end") > placeOf("hit(square.right)"));
}

void TestRepairOrder::whatTheNextLineOverwritesComesLast()
{
    const QString source = QStringLiteral("a.position = olda\nb.position = oldb\n");
    const QString lost = QStringLiteral("b.position = olda\nb.position = oldb\n");
    const QString other = QStringLiteral("a.position = oldb\nb.position = oldb\n");
    QCOMPARE(inOrder(source, {lost, other}), std::vector({other, lost}));
}

QTEST_GUILESS_MAIN(TestRepairOrder)
#include "test_repair_order.moc"
