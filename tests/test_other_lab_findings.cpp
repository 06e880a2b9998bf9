// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab_test.h"

#include "tasks/reading/lab_list.h"
#include "tests/text.h"

#include <QJsonArray>

using namespace cradle;

/// Findings are made for labs of any kind: here one with another law, which its own check in Lua
/// judges.
class TestOtherLabFindings : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void labOfAnotherKindGetsFindings_data();
    void labOfAnotherKindGetsFindings();
};

namespace {

QStringList headlinesOf(const CheckReport &report)
{
    QStringList lines;
    for (const Finding &finding : report.findings)
        lines.append(finding.message.section(QLatin1Char('\n'), 0, 0));
    return lines;
}

/// A lab with one step: air that brakes a circle by 0.5 v.
Lab airLab(const Preset &preset)
{
    const auto program = [](const char *change) {
        return QStringLiteral("function on_update(h)\n"
                              "  circle1.velocity = circle1.velocity %1\n"
                              "  circle1.position = circle1.position + circle1.velocity * h\n"
                              "end\n")
            .arg(QLatin1String(change));
    };
    Task task;
    task.id = QStringLiteral("AIR1");
    task.title = QStringLiteral("Air");
    task.preset = preset;
    task.checks.push_back(
        {.id = QStringLiteral("brakes"),
         .title = QStringLiteral("Air brakes by 0.5 v"),
         .kind = QStringLiteral("script"),
         .circles = {0},
         .parameters = {},
         .scene = {{QStringLiteral("kind"), QStringLiteral("flight")},
                   {QStringLiteral("count"), 4},
                   {QStringLiteral("duration"), 0.5},
                   {QStringLiteral("timesteps"), QJsonArray{1.0 / 60.0, 1.0 / 120.0}}},
         .source = text(R"lua(
function check(run)
  for k = 1, run.step_count do
    local before, after = run:step(k - 1).circles[1].velocity, run:step(k).circles[1].velocity
    local way = run:step(k).circles[1].position - run:step(k - 1).circles[1].position
    if (after - (1 - 0.5 * run.timestep) * before):length() > 1e-9
      or (way - run.timestep * after):length() > 1e-9 then
      return false, "the velocity does not change by -0.5 v dt"
    end
  end
  return true
end
)lua")});
    task.moves = Mover::Program;
    task.solution = program("- 0.5 * circle1.velocity * h");
    task.mistakes.push_back({.name = QStringLiteral("drives"),
                             .source = program("+ 0.5 * circle1.velocity * h"),
                             .message = text("Your air drives the circle\n\nLook at the sign.")});
    Lab lab;
    lab.id = QStringLiteral("air");
    lab.title = QStringLiteral("Air");
    lab.tasks.push_back(task);
    return lab;
}

} // namespace

void TestOtherLabFindings::labOfAnotherKindGetsFindings_data()
{
    QTest::addColumn<QString>("change");
    QTest::addColumn<QString>("way");
    QTest::addColumn<QStringList>("said");
    const auto row = [](const char *change, const char *way, const QStringList &said) {
        QTest::addRow("%s, %s", change, way) << text(change) << text(way) << said;
    };
    const char *brakes = "- 0.5 * v * h";
    row(brakes, "v * h", {});
    row("+ 0.5 * v * h", "v * h", {text("Your air drives the circle")});
    row("- 1 * v * h", "v * h",
        {text("What acts on the velocity of circle 1 is 2 times as strong as it should be")});
    row("", "v * h", {text("Nothing slows circle 1 down on the way")});
    row(brakes, "v", {text("The way of circle 1 is not multiplied by the timestep")});
    row("- 1 * v * h", "2 * v * h",
        {text("The way of circle 1 in a step is not v Δt"),
         text("What acts on the velocity of circle 1 is 2 times as strong as it should be")});
}

void TestOtherLabFindings::labOfAnotherKindGetsFindings()
{
    QFETCH(QString, change);
    QFETCH(QString, way);
    QFETCH(QStringList, said);
    const Lab lab = airLab(task(QStringLiteral("L42T2")).preset);
    const QString program = QStringLiteral("function on_update(h)\n"
                                           "  local v = circle1.velocity\n"
                                           "  v = v %1\n"
                                           "  circle1.velocity = v\n"
                                           "  circle1.position = circle1.position + %2\n"
                                           "end\n")
                                .arg(change, way);
    const CheckReport report =
        *judgeTask(lab, lab.tasks.front(), Submission(lab.tasks.front().preset, program), 1);
    QVERIFY2(!report.error, report.error ? qPrintable(report.error->message) : "");
    QCOMPARE(report.passed, said.isEmpty());
    QCOMPARE(headlinesOf(report), said);
}

QTEST_GUILESS_MAIN(TestOtherLabFindings)
#include "test_other_lab_findings.moc"
