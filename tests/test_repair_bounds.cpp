// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repairs.h"

#include "tests/tried_repairs.h"

#include <QTest>

using namespace cradle;
using namespace cradle::changes;

/// Where changes are tried and where not, which of them together, and how many at most.
class TestRepairBounds : public QObject
{
    Q_OBJECT
private slots:
    void likeLinesAreChangedAlike();
    void restitutionIsPutInOnlyWhereItIsKnown();
    void onlyTheseLinesAreChanged();
    void noMoreThanAreWantedAreMade();
    void whatNobodyWritesIsNotTried_data();
    void whatNobodyWritesIsNotTried();
    void allThatIsTriedForALine_data();
    void allThatIsTriedForALine();
};

/// Each wall is asked for in a line of its own.
void TestRepairBounds::likeLinesAreChangedAlike()
{
    const QString wrong = QStringLiteral("if px > east - r then px = east end\n"
                                         "if py > north - r then py = north end\n"
                                         "if pz > 4 + r then pz = 5 end\n");
    const auto changed = [&](const char *from, const char *to) {
        return QString(wrong).replace(QLatin1String(from), QLatin1String(to));
    };
    const auto all = tried(wrong, {1});
    QVERIFY(isTried(all, changed("> east - r", "> east + r")));
    const auto both = std::find_if(all.begin(), all.end(), [&](const Repair &each) {
        return each.source == changed(" - r", " + r");
    });
    QVERIFY(both != all.end());
    QVERIFY(!both->alone);
    QCOMPARE(both->line, 1);
    QVERIFY(
        isTried(all, changed(" > ", " < ").replace(QLatin1String("pz <"), QLatin1String("pz >"))));
    // Alone comes before together.
    QVERIFY(std::is_sorted(all.begin(), all.end(),
                           [](const Repair &a, const Repair &b) { return a.alone && !b.alone; }));
}

void TestRepairBounds::restitutionIsPutInOnlyWhereItIsKnown()
{
    const auto names = [](const QString &source, const QString &reference) {
        const auto all = repairsOf(source, reference, {1}, 1000);
        return std::any_of(all.begin(), all.end(), [](const Repair &each) {
            return each.source.contains(QLatin1String("restitution"));
        });
    };
    const QString plain = QStringLiteral("x = 2 * u");
    const QString known = QStringLiteral("x = 2 * restitution");
    QVERIFY(!names(plain, plain));
    QVERIFY(names(plain, known));
    QVERIFY(names(known, plain));
}

void TestRepairBounds::onlyTheseLinesAreChanged()
{
    const QString program = QStringLiteral("x = u\nq = w\nz = v");
    for (const Repair &each : tried(program, {3, 2})) {
        QVERIFY(each.source.startsWith(QLatin1String("x = u\n")));
        QVERIFY(each.line == 2 || each.line == 3);
    }
    QCOMPARE(tried(program, {3, 2}).front().line, 3);
    QVERIFY(tried(program, {}).empty());
}

void TestRepairBounds::noMoreThanAreWantedAreMade()
{
    const QString program = around(QStringLiteral("x = u * w + 2 * z"));
    const auto all = tried(program);
    QVERIFY(all.size() > 20);
    for (const std::size_t most : {std::size_t{0}, std::size_t{1}, std::size_t{7}}) {
        const auto some = tried(program, {theLine}, most);
        QCOMPARE(some.size(), most);
        for (std::size_t i = 0; i < most; ++i)
            QCOMPARE(some[i].source, all[i].source);
    }
}

void TestRepairBounds::whatNobodyWritesIsNotTried_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("other");
    const auto row = [](const char *line, const char *other) {
        QTest::addRow("%s -> %s", line, other)
            << QString::fromUtf8(line) << QString::fromUtf8(other);
    };
    // A factor for what is handed over with others, called, or given a value.
    row("x = g(a.radius, 2)", "x = g(a.radius ^ 2, 2)");
    row("x = g(v.x, 2)", "x = g(v.x * h, 2)");
    row("move(v)", "move(v * h)");
    row("v = 1", "v * h = 1");
    row("x = c.velocity", "x = c * h.velocity");
    row("x = u", "x = u * h"); // no rate
    row("x = u", "x = u ^ 2");
    // A sign where there is no sum, and none for a whole circle.
    row("x = {-u}", "x = {+u}");
    row("f(circles)", "f( -circles)");
    row("f(a)", "f( -a)");
    // A name that the program has not.
    row("x = m3", "x = m4");
    row("x = left", "x = top");
    // Conditions and calls without two parts.
    row("if u == w then", "if u ~= w then");
    row("x = g(u)", "x = g(u, u)");
    row("x = math.pi", "x = (pi)");
}

void TestRepairBounds::whatNobodyWritesIsNotTried()
{
    QFETCH(QString, line);
    QFETCH(QString, other);
    QVERIFY(!isTried(tried(around(line)), around(other)));
}

void TestRepairBounds::allThatIsTriedForALine_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("all"); // in alphabetical order
    const auto row = [](const char *line, const char *all) {
        QTest::newRow(line) << QString::fromUtf8(line) << QString::fromUtf8(all);
    };
    row("x = u", "|x = (u):normalized()|x = - u|x = -(u)");
    row("x = u.radius", "|x = - u.radius|x = -(u.radius)|x = u.density * u.radius|"
                        "x = u.radius * u.density|x = u.radius * u.radius|x = u.radius ^ 2");
    row("if u then", "if false then|if true then");
    row("f(u)", "|f( -u)");
    row("until u == w", "");
    row("local z", "");
    row("end", "");
    row("x = 'text' .. u", "|x = ('text' .. u):normalized()|x = -('text' .. u)");
}

/// Where nothing else is named: not a change more.
void TestRepairBounds::allThatIsTriedForALine()
{
    QFETCH(QString, line);
    QFETCH(QString, all);
    QStringList is;
    for (const Repair &each : repairsOf(line, {}, {1}, 1000))
        is.append(each.source);
    is.sort();
    if (all.startsWith(QLatin1Char('|')))
        QVERIFY(is.contains(QString())); // the line is dropped
    QCOMPARE(is.join(QLatin1Char('|')), all);
}

QTEST_GUILESS_MAIN(TestRepairBounds)
#include "test_repair_bounds.moc"
