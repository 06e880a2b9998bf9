// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/ran_lines.h"
#include "tasks/judging/suspect_lines.h"
#include "tests/lab_test.h"

#include "tasks/reading/lab_reader.h"

#include <algorithm>

using namespace cradle;

/// Which line of a program a failed check names: one that moved the circle of which it speaks.
class TestSuspectLine : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void lineMovesTheCircleThatIsWrong_data();
    void lineMovesTheCircleThatIsWrong();
    void linesOfMassesComeFirst();
    void theLastLineIsOneOfThem_data();
    void theLastLineIsOneOfThem();
    void linesOfTheStartAreThoseThatChoose_data();
    void linesOfTheStartAreThoseThatChoose();
};

namespace {

/// Both circles of step 5; the lines that move them are put in.
QString program(const char *circle1, const char *circle2)
{
    return QStringLiteral(R"lua(function on_load()
  circle2.position = circle1.position
  circle2.velocity = circle1.velocity
end
function on_update(h)
  local old1, old2 = circle1.position, circle2.position
  %1
  %2
  for i, old in ipairs({old1, old2}) do
    local c = circles[i]
    local p, v = c.position, c.velocity
    if math.abs(p.x) > 3.8 and p.x * v.x > 0 then
      c.position, c.velocity = old, vec(-v.x, v.y)
    end
    if math.abs(p.y) > 3.8 and p.y * v.y > 0 then
      c.position, c.velocity = old, vec(c.velocity.x, -v.y)
    end
  end
end)lua")
        .arg(QString::fromLatin1(circle1), QString::fromLatin1(circle2));
}

constexpr char euler[] = "circle1.position, circle1.velocity = circle1.position + "
                         "circle1.velocity * h, circle1.velocity + gravity * h";
constexpr char twiceEuler[] = "circle1.position, circle1.velocity = circle1.position + "
                              "circle1.velocity * h, circle1.velocity + 2 * gravity * h";
constexpr char symplectic[] = "circle2.velocity = circle2.velocity + gravity * h "
                              "circle2.position = circle2.position + circle2.velocity * h";
constexpr char upward[] = "circle2.velocity = circle2.velocity - gravity * h "
                          "circle2.position = circle2.position + circle2.velocity * h";

} // namespace

void TestSuspectLine::lineMovesTheCircleThatIsWrong_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("check");
    QTest::addColumn<int>("line");
    const auto row = [](const char *name, const QString &source, const char *check, int line) {
        QTest::newRow(name) << source << QString::fromLatin1(check) << line;
    };
    row("circle 1, before circle 2", program(twiceEuler, symplectic), "circle1-euler", 7);
    row("circle 2, after circle 1", program(euler, upward), "circle2-symplectic", 8);
    row("circle 2, before circle 1", program(upward, euler), "circle2-symplectic", 7);
    row("circle 1, after circle 2", program(symplectic, twiceEuler), "circle1-euler", 8);
    row("circle 1 not moved", program("", symplectic), "circle1-euler", 0);
    row("circle 2 not moved", program(euler, ""), "circle2-symplectic", 0);
}

void TestSuspectLine::lineMovesTheCircleThatIsWrong()
{
    QFETCH(QString, source);
    QFETCH(QString, check);
    QFETCH(int, line);
    const Task &step = task(QStringLiteral("L42T5"));
    const CheckReport report = *judgeTask(m_lab, step, Submission(step.preset, source), 1);
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [&](const CheckOutcome &each) { return each.id == check; });
    QVERIFY(found != report.checks.end());
    QVERIFY2(!found->passed && !report.error, qPrintable(failedChecks(report)));
    QCOMPARE(found->line, line);
}

/// Before those that run at the moment, but for a question and for what never runs.
void TestSuspectLine::linesOfMassesComeFirst()
{
    const QString program = QStringLiteral("function on_update(h)\n"
                                           "  local m1 = circle1.radius ^ 2\n"
                                           "  if circle1.radius > 0.1 then\n"
                                           "    circle1.velocity = circle1.velocity * m1\n"
                                           "  end\n"
                                           "  local m2 = circle2.radius ^ 2\n"
                                           "  circle2.velocity = circle2.velocity * m2\n"
                                           "end\n");
    const Moment moment;
    const RanLines ran{.now = {3, 4, 7}, .before = {3, 7}};
    const std::vector<int> lines = suspectLines({.program = program,
                                                 .reference = program,
                                                 .moment = moment,
                                                 .ran = ran,
                                                 .suspect = Suspect::Masses,
                                                 .last = 7,
                                                 .aspect = Aspect::Response,
                                                 .mending = {}});
    QCOMPARE(lines, (std::vector<int>{2, 6, 4, 3, 7}));
}

/// Whatever it is that makes a line suspect; the first one runs.
void TestSuspectLine::theLastLineIsOneOfThem_data()
{
    QTest::addColumn<QString>("last");
    QTest::addColumn<Suspect>("suspect");
    QTest::addColumn<Aspect>("aspect");
    QTest::addColumn<std::vector<int>>("lines");
    QTest::newRow("a mass") << "local m = circle1.radius ^ 2" << Suspect::Masses << Aspect::Response
                            << std::vector{2, 1};
    QTest::newRow("a quantity") << "local m = circle1.radius ^ 2" << Suspect::Formula
                                << Aspect::Response << std::vector{1, 2};
    QTest::newRow("a number") << "local n = 3" << Suspect::Formula << Aspect::Response
                              << std::vector{2, 1};
    QTest::newRow("a choice") << "local way = true" << Suspect::Formula << Aspect::Motion
                              << std::vector{1, 2};
}

void TestSuspectLine::theLastLineIsOneOfThem()
{
    QFETCH(QString, last);
    QFETCH(Suspect, suspect);
    QFETCH(Aspect, aspect);
    QFETCH(std::vector<int>, lines);
    const QString program =
        QStringLiteral("function on_update(h) circle1.position = circle1.position * h end\n%1")
            .arg(last);
    const Moment moment;
    const RanLines ran{.now = {1}, .before = {}};
    QCOMPARE(suspectLines({.program = program,
                           .reference = program,
                           .moment = moment,
                           .ran = ran,
                           .suspect = suspect,
                           .last = 1,
                           .aspect = aspect,
                           .mending = {}}),
             lines);
}

/// A method or a circle, which decides how something moves.
void TestSuspectLine::linesOfTheStartAreThoseThatChoose_data()
{
    QTest::addColumn<QString>("row");
    QTest::addColumn<bool>("chooses");
    const auto row = [](const char *text, bool chooses) {
        QTest::newRow(text) << QString::fromLatin1(text) << chooses;
    };
    row("local move = verlet", true);
    row("local ways = {verlet, 2}", true);
    row("local made = verlet (2)", false);
    row("local way = verletOf", false);
    row("local way = 'verlet'", true);
    row("local way = \"verlet\"", true);
    row("local exact = true", true);
    row("local exact = false", true);
    row("local first = circle1", true);
    row("local second = circle2", true);
    row("local third = circle3", false);
    row("local count = 3", false);
    row("local make = other", false);
}

void TestSuspectLine::linesOfTheStartAreThoseThatChoose()
{
    QFETCH(QString, row);
    QFETCH(bool, chooses);
    const QString program = QStringLiteral("local function verlet(c) return c end\n"
                                           "local list = each(function(c) return c end)\n"
                                           "%1\n"
                                           "function on_update(h)\n"
                                           "  %1\n"
                                           "  circle1.position = circle1.position + h * way\n"
                                           "end\n")
                                .arg(row);
    const Moment moment;
    const RanLines ran{.now = {6}, .before = {}};
    const auto lines = [&](Aspect aspect) {
        return suspectLines({.program = program,
                             .reference = program,
                             .moment = moment,
                             .ran = ran,
                             .suspect = Suspect::Formula,
                             .last = 6,
                             .aspect = aspect,
                             .mending = {}});
    };
    // So may one that is handed on there, or stands in a list.
    const bool isGiven = row.contains(QLatin1String("2}")) || row.contains(QLatin1String("(2)"));
    QCOMPARE(lines(Aspect::Motion),
             chooses || isGiven ? std::vector<int>({6, 3}) : std::vector<int>({6}));
    // A number may be wrong in a hit, a choice not.
    const bool isNumber = row.endsWith(QLatin1String("= 3"));
    QCOMPARE(lines(Aspect::Contact), isNumber  ? std::vector<int>({3, 5, 6})
                                     : isGiven ? std::vector<int>({6, 3})
                                               : std::vector<int>({6}));
}

QTEST_GUILESS_MAIN(TestSuspectLine)
#include "test_suspect_line.moc"
