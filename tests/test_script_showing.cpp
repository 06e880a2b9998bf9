// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

using namespace cradle;
using namespace cradle::programs;

/// What a program plots, draws and prints.
class TestScriptShowing : public QObject
{
    Q_OBJECT
private slots:
    void plotAndDrawAreKept();
    void wrongShowingIsExplained_data();
    void wrongShowingIsExplained();
    void quietProgramShowsNothing();
    void outputOfAStepIsLimited_data();
    void outputOfAStepIsLimited();
};

void TestScriptShowing::plotAndDrawAreKept()
{
    const ScriptRun run = runScript(lua(R"lua(
function on_update()
  plot("energy", 2.5)
  plot("height", circle1.position.y)
  draw.arrow(vec(1, 2), vec(3, 4), "red", "v")
  draw.line(vec(0, 0), vec(1, 1))
  draw.point(circle1.position, "#00ff00")
  draw.text(vec(5, 6), "here")
end)lua"),
                                    1);
    VERIFY_RUNS(run);
    QCOMPARE(run.output.points,
             (std::vector<PlottedPoint>{{lua("energy"), 2.5}, {lua("height"), 2.0}}));
    using Kind = Drawing::Kind;
    const std::vector<Drawing> drawings{{Kind::Arrow, {1.0, 2.0}, {4.0, 6.0}, lua("red"), lua("v")},
                                        {Kind::Line, {0.0, 0.0}, {1.0, 1.0}, {}, {}},
                                        {Kind::Point, {-2.0, 2.0}, {}, lua("#00ff00"), {}},
                                        {Kind::Text, {5.0, 6.0}, {}, {}, lua("here")}};
    QCOMPARE(run.output.drawings, drawings);
}

void TestScriptShowing::wrongShowingIsExplained_data()
{
    QTest::addColumn<QString>("words");
    const auto row = [](const char *statement, const char *words) {
        QTest::newRow(statement) << lua(words);
    };
    row("plot(1)", "takes a number, not nothing");
    row("plot('e', vec(1, 2))", "takes a number, not the vector (1, 2)");
    row("plot('e', 0 / 0)", "a finite number is right");
    row("plot('', 1)", "must have 1 to 100 letters");
    row("plot({}, 1)", "the name in plot(name, number) must be a text, not a table");
    row("draw.arrow(vec(0, 0), 3)", "draw.arrow(from, vector, colour, label) needs a vector");
    row("draw.arrow(vec(1e308, 0), vec(1e308, 0))", "beyond all numbers");
    row("draw.point(vec(0, 1 / 0))", "finite numbers are right");
    row("draw.line(vec(0, 0), vec(1, 1), {})", "a colour must be a text");
    row("draw.text(vec(0, 0))", "must be a text, not nothing");
    row("draw.circle(vec(0, 0))", "draw has no `circle`");
    row("draw.arow(vec(0, 0))", "did you mean `arrow`?");
}

void TestScriptShowing::wrongShowingIsExplained()
{
    QFETCH(QString, words);
    const QString statement = QString::fromUtf8(QTest::currentDataTag());
    for (const bool quiet : {false, true})
        VERIFY_STOPS(runScript(lua("\n") + statement, 0, {.quiet = quiet}), 2, words);
}

void TestScriptShowing::quietProgramShowsNothing()
{
    const ScriptRun run =
        runScript(lua("function on_update() print(1) plot('a', 1) draw.point(vec(0, 0)) end"), 3,
                  {.quiet = true});
    VERIFY_RUNS(run);
    QVERIFY(run.output.isEmpty());
}

void TestScriptShowing::outputOfAStepIsLimited_data()
{
    QTest::addColumn<QString>("statement");
    QTest::addColumn<int>("fits"); // times in a step
    // 64 KiB: 63 letters and the end of the line; points and drawings count 64 bytes and names.
    QTest::newRow("print") << lua("print(('%062d'):format(i) .. 'x')") << 1024;
    QTest::newRow("plot") << lua("plot('12345678', i)") << 910;
    QTest::newRow("draw") << lua("draw.point(vec(i, 0))") << 1024;
}

void TestScriptShowing::outputOfAStepIsLimited()
{
    QFETCH(QString, statement);
    QFETCH(int, fits);
    const QString loop = lua("function on_update()\nfor i = 1, %1 do\n%2\nend\nend");
    for (const bool quiet : {false, true}) {
        // The allowance is new in every step.
        VERIFY_RUNS(runScript(loop.arg(fits).arg(statement), 3, {.quiet = quiet}));
        VERIFY_STOPS(runScript(loop.arg(fits + 1).arg(statement), 3, {.quiet = quiet}), 3,
                     lua("more than 64 KiB in one step"));
    }
}

QTEST_GUILESS_MAIN(TestScriptShowing)
#include "test_script_showing.moc"
