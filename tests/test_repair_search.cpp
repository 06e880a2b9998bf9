// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/line_at_fault.h"

#include "tests/scenes.h"

#include <QTest>

#include <algorithm>

using namespace cradle;
using namespace cradle::scenes;

/// In which order changed programs are measured, and which of them is taken.
class TestRepairSearch : public QObject
{
    Q_OBJECT
private slots:
    void lastLineIsTriedFirst_data();
    void lastLineIsTriedFirst();
    void whatIsRightOnlyThereIsTriedAtLast();
    void fewOfALineAreMeasured();
    void wholeMendingEndsTheSearch();
    void partIsTakenWhereNothingMendsAll();
    void twinsAreTakenAfterOneLineAlone();
    void whatPassesTheChecksIsNotMeasured();
    void whatDoesNotRunIsNotChanged();
    void searchEndsWithItsWork();
};

namespace {

/// A search whose every measurement is noted.
struct Search {
    QString program;
    Suspect suspect = Suspect::Formula;
    int last = 0;
    std::set<int> lines{}; ///< that run at the moment, and before it
    Preset preset = scene({circle({-2.0, 1.0}, {2.0, 1.5}), circle({1.0, -1.0}, {-1.0, 0.7})}, {});
    std::vector<int> wrong{0};
    QString turn{}; ///< what the reference does besides moving
    std::function<bool(const QString &)> passes{};

    /// \param mending  what a measurement of the n-th program, from 0, tells
    std::optional<Repair> run(const std::function<Mending(std::size_t)> &mending)
    {
        measured.clear();
        preset.timestep = 0.01;
        const QString reference =
            QStringLiteral("function on_update(h) for _, c in ipairs(circles) do "
                           "c.position = c.position + c.velocity * h %1 end end")
                .arg(turn);
        const Moment moment{.stage = {preset, true}, .step = 1, .circles = wrong};
        const RanLines ran{.now = lines, .before = lines};
        return repairOf({.program = program,
                         .reference = reference,
                         .moment = moment,
                         .ran = ran,
                         .suspect = suspect,
                         .last = last,
                         .aspect = Aspect::Motion,
                         .passes = passes,
                         .mending = [&](const QString &source) {
                             measured.push_back(source);
                             return mending(measured.size() - 1);
                         }});
    }
    /// The line, from 1, in which the n-th measured program differs first.
    [[nodiscard]] int lineOf(std::size_t n) const
    {
        const QStringList before = program.split(QLatin1Char('\n'));
        const QStringList after = measured.at(n).split(QLatin1Char('\n'));
        for (int i = 0; i < std::min(before.size(), after.size()); ++i) {
            if (before[i] != after[i])
                return i + 1;
        }
        return 0;
    }

    std::vector<QString> measured{};
};

Mending none(std::size_t)
{
    return Mending::None;
}

/// The velocity turns round: the minus of line 2 is one too many, or one is missing in line 4.
const QString turned =
    QStringLiteral("function on_update(h)\n"
                   "  local v = -circle1.velocity\n"
                   "  circle1.position = circle1.position - v * h\n"
                   "  circle1.velocity = v\n"
                   "  circle2.position = circle2.position + circle2.velocity * h\n"
                   "end");

} // namespace

void TestRepairSearch::lastLineIsTriedFirst_data()
{
    QTest::addColumn<int>("last");
    QTest::addColumn<Suspect>("suspect");
    QTest::addColumn<int>("line");
    QTest::newRow("what it does: the line that changed it last") << 4 << Suspect::Answer << 4;
    QTest::newRow("the numbers it works out: in order") << 4 << Suspect::Formula << 2;
    QTest::newRow("the last one does not run then") << 5 << Suspect::Answer << 2;
}

void TestRepairSearch::lastLineIsTriedFirst()
{
    QFETCH(int, last);
    QFETCH(Suspect, suspect);
    QFETCH(int, line);
    Search search{.program = turned, .suspect = suspect, .last = last, .lines = {2, 3, 4}};
    QVERIFY(!search.run(none));
    QVERIFY(search.measured.size() >= 2);
    QCOMPARE(search.lineOf(0), line);
}

/// Where the reference exchanges the parts of a velocity, numbers are right in this scene only.
void TestRepairSearch::whatIsRightOnlyThereIsTriedAtLast()
{
    Search search{.program = QStringLiteral("function on_update(h)\n"
                                            "  circle1.position = circle1.position + "
                                            "circle1.velocity * h\n"
                                            "  circle1.velocity = vec(-1.5, 2)\n"
                                            "end"),
                  .lines = {2, 3},
                  .preset = scene({circle({-2.0, 1.0}, {2.0, 1.5})}, {}),
                  .turn = QStringLiteral("c.velocity = vec(c.velocity.y, c.velocity.x)")};
    const auto repair = search.run([](std::size_t) { return Mending::All; });
    QVERIFY(repair);
    QCOMPARE(repair->line, 3);
    QVERIFY2(repair->source.contains(QStringLiteral("vec(1.5, 2)")), qPrintable(repair->source));
    QCOMPARE(search.measured.size(), 1U);
    // No more than three of them.
    QVERIFY(!search.run(none));
    QVERIFY(search.measured.size() <= 3);
}

void TestRepairSearch::fewOfALineAreMeasured()
{
    Search search{.program = QStringLiteral("function on_update(h)\n"
                                            "  local v = circle1.velocity\n"
                                            "  circle1.position = circle1.position + v * h\n"
                                            "  circle1.velocity = -1 * v * (1 + 0) * 1\n"
                                            "end"),
                  .lines = {2, 3, 4},
                  .preset = scene({circle({-2.0, 1.0}, {2.0, 1.5})}, {})};
    QVERIFY(!search.run(none));
    int ofLine4 = 0;
    for (std::size_t n = 0; n < search.measured.size(); ++n)
        ofLine4 += search.lineOf(n) == 4;
    QCOMPARE(ofLine4, 3);
    QVERIFY(search.measured.size() <= 10);
}

void TestRepairSearch::wholeMendingEndsTheSearch()
{
    Search search{.program = turned, .lines = {2, 3, 4}};
    const auto repair = search.run([](std::size_t) { return Mending::All; });
    QVERIFY(repair);
    QCOMPARE(search.measured.size(), 1U);
    QCOMPARE(repair->source, search.measured[0]);
    QCOMPARE(repair->line, 2);
}

void TestRepairSearch::partIsTakenWhereNothingMendsAll()
{
    Search search{.program = turned, .lines = {2, 3, 4}};
    const auto part =
        search.run([](std::size_t n) { return n == 0 ? Mending::None : Mending::Part; });
    QVERIFY(part && search.measured.size() >= 2);
    QCOMPARE(part->source, search.measured[1]);
    const auto all =
        search.run([](std::size_t n) { return n == 1 ? Mending::All : Mending::Part; });
    QVERIFY(all);
    QCOMPARE(all->source, search.measured[1]);
    QCOMPARE(search.measured.size(), 2U);
}

/// Both circles turn round: each by a line of its own.
void TestRepairSearch::twinsAreTakenAfterOneLineAlone()
{
    Search search{.program = QStringLiteral("function on_update(h)\n"
                                            "  circle1.velocity = -circle1.velocity\n"
                                            "  circle2.velocity = -circle2.velocity\n"
                                            "  circle1.position = circle1.position + "
                                            "circle1.velocity * h\n"
                                            "  circle2.position = circle2.position + "
                                            "circle2.velocity * h\n"
                                            "end"),
                  .lines = {2, 3, 4, 5},
                  .wrong = {0, 1}};
    const auto twins = search.run([&](std::size_t n) {
        return search.measured[n].contains(QStringLiteral("= -")) ? Mending::None : Mending::All;
    });
    QVERIFY(twins && !twins->alone);
    QVERIFY(twins->source.contains(QStringLiteral("circle1.velocity = circle1.velocity")));
    QVERIFY(twins->source.contains(QStringLiteral("circle2.velocity = circle2.velocity")));
}

void TestRepairSearch::whatPassesTheChecksIsNotMeasured()
{
    Search search{.program = turned, .suspect = Suspect::Formula, .last = 4, .lines = {2, 3, 4}};
    const auto changes = [](int line) {
        return [line](const QString &source) {
            const auto row = [&](const QString &program) {
                return program.section(QLatin1Char('\n'), line - 1, line - 1);
            };
            return row(source) != row(turned);
        };
    };
    for (const int line : {2, 4}) {
        search.passes = changes(line);
        const auto repair = search.run(none);
        QVERIFY(repair);
        QCOMPARE(repair->line, line);
        QCOMPARE(std::count(search.measured.begin(), search.measured.end(), repair->source), 0);
    }
    // Where nothing passes, something else is wrong, too.
    search.passes = [](const QString &) { return false; };
    QVERIFY(search.run([](std::size_t) { return Mending::All; }));
    QCOMPARE(search.measured.size(), 1U);
}

void TestRepairSearch::whatDoesNotRunIsNotChanged()
{
    Search search{.program = turned, .lines = {}};
    QVERIFY(!search.run([](std::size_t) { return Mending::All; }));
    QVERIFY(search.measured.empty());
    search.lines = {5};
    QVERIFY(!search.run([](std::size_t) { return Mending::All; }));
    QVERIFY(search.measured.empty());
}

void TestRepairSearch::searchEndsWithItsWork()
{
    Search search{.program = turned, .lines = {2, 3, 4}};
    const auto works = [](std::size_t) {
        WorkLimit::count(2'000'000);
        return Mending::None;
    };
    QVERIFY(!search.run(works));
    const std::size_t all = search.measured.size();
    QVERIFY(all >= 2);
    {
        const WorkLimit limit(1'000'000);
        QVERIFY(!search.run(works));
        QCOMPARE(search.measured.size(), 1u);
    }
    QVERIFY(!search.run(works));
    QCOMPARE(search.measured.size(), all);
}

QTEST_APPLESS_MAIN(TestRepairSearch)
#include "test_repair_search.moc"
