// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/chart_scenes.h"
#include "tests/patience.h"
#include "tests/showing_program.h"
#include "views/charts/energy_chart.h"
#include "views/charts/plots_chart.h"
#include "views/theme.h"

#include <QSignalSpy>
#include <QTest>

#include <set>

using namespace cradle;

namespace {

void plotThings(World &world, ProgramOutput &output)
{
    output.points.push_back({QStringLiteral("x"), world.circles[0].position.x});
    if (world.step >= 10)
        output.points.push_back({QStringLiteral("a much too long name of a curve"), 7.0});
}

/// A chart beside a run of a program.
struct Plots {
    ShowingProgram program;
    Simulation simulation{glancing()};
    RunCurves curves{simulation};
    PlotsChart chart{simulation, curves};

    explicit Plots(ShowingProgram::Show show = plotThings)
        : program(std::move(show))
    {
        simulation.setProgram(&program);
        chart.resize(344, 240);
        chart.show();
        (void)QTest::qWaitForWindowExposed(&chart, patience);
    }

    [[nodiscard]] QStringList labels() const
    {
        QStringList texts;
        for (const auto &[text, place] : chart.plot().labels())
            texts << text;
        return texts;
    }
};

ProgramOutput onePoint(double value)
{
    ProgramOutput output;
    output.points = {{QStringLiteral("c"), value}};
    return output;
}

} // namespace

class TestPlotsChart final : public QObject
{
    Q_OBJECT
private slots:
    void curvesHaveTheirNamesAndValues();
    void valuesAreThoseOfTheMoment();
    void clickSeeks();
    void newRunBeginsAnew();
    void thinnedCurveIsReadAnew();
    void plotsCanBeToldApart_data();
    void plotsCanBeToldApart();
    void energyOfEachIsShownForAProgram_data();
    void energyOfEachIsShownForAProgram();
};

void TestPlotsChart::curvesHaveTheirNamesAndValues()
{
    Plots plots;
    QTRY_VERIFY(plots.labels().isEmpty());
    run(plots.simulation, 30);
    QTRY_COMPARE(plots.labels(), (QStringList{QStringLiteral("x: −1.033"),
                                              QStringLiteral("a much too long nam…: 7.000")}));
    QCOMPARE(plots.chart.windowTitle(), QStringLiteral("Plots"));
}

void TestPlotsChart::valuesAreThoseOfTheMoment()
{
    Plots plots;
    run(plots.simulation, 30);
    plots.simulation.seek(15); // plotted before the move of step 15: −2 + 14/30
    QTRY_VERIFY2(plots.labels().contains(QStringLiteral("x: −1.533")),
                 qPrintable(plots.labels().join(u',')));
}

void TestPlotsChart::clickSeeks()
{
    Plots plots;
    run(plots.simulation, 60);
    QTRY_VERIFY(!plots.labels().isEmpty());
    QSignalSpy asked(&plots.chart, &ChartPane::seekRequested);
    const ChartPlot &plot = plots.chart.plot();
    const auto shownUntil = [&plot] { return plot.valuesAt(plot.plotArea().topRight()).x(); };
    QTRY_VERIFY2(std::abs(shownUntil() - 1.0) < 0.05, qPrintable(QString::number(shownUntil())));
    QTest::mouseClick(plot.viewport(), Qt::LeftButton, {}, plot.plotArea().center().toPoint());
    QCOMPARE(asked.count(), 1);
    const double time = asked.takeFirst().at(0).toDouble();
    QVERIFY2(std::abs(time - 0.5) < 0.05, qPrintable(QString::number(time)));
}

void TestPlotsChart::newRunBeginsAnew()
{
    Plots plots;
    run(plots.simulation, 30);
    QTRY_COMPARE(plots.labels().size(), 2);
    plots.chart.hide();
    plots.simulation.restart();
    plots.chart.resize(300, 200); // lays out what is no longer there
    plots.chart.show();
    QTRY_VERIFY(plots.labels().isEmpty());
    run(plots.simulation, 5);
    QTRY_COMPARE(plots.labels().size(), 1);
}

void TestPlotsChart::thinnedCurveIsReadAnew()
{
    ProgramNotes notes;
    PlotCurves curves;
    const auto add = [&](qint64 from, qint64 to) {
        for (qint64 i = from; i < to; ++i)
            notes.add(i, static_cast<double>(i), onePoint(static_cast<double>(i % 1000)));
    };
    add(0, 150'000);
    curves.update(notes);
    // Thinned out, and then again longer than what was read.
    add(150'000, 270'000);
    QVERIFY(notes.curves()[0].times.size() > 150'000);
    curves.update(notes);
    const MinMaxPyramid &samples = curves.curves()[0].samples;
    QCOMPARE(samples.lastTime(), 269'999.0);
    QCOMPARE(samples.valueAt(200'500.0), 500.0);
    QCOMPARE(samples.valueAt(1'500.0), 500.0);
    QCOMPARE(samples.maximum(), 999.0);
}

void TestPlotsChart::plotsCanBeToldApart_data()
{
    QTest::addColumn<ThemeChoice>("choice");
    QTest::newRow("light") << ThemeChoice::Light;
    QTest::newRow("dark") << ThemeChoice::Dark;
}

void TestPlotsChart::plotsCanBeToldApart()
{
    QFETCH(ThemeChoice, choice);
    applyTheme(choice);
    std::set<std::pair<QRgb, int>> looks;
    for (int i = 0; i < static_cast<int>(ProgramNotes::mostCurves); ++i) {
        QVERIFY(contrast(plotColour(i), theme().panel) >= 4.5);
        QVERIFY(looks.insert({plotColour(i).rgb(), static_cast<int>(circleDash(i))}).second);
    }
    applyTheme(ThemeChoice::Light);
}

void TestPlotsChart::energyOfEachIsShownForAProgram_data()
{
    QTest::addColumn<int>("circles");
    QTest::addColumn<bool>("program");
    QTest::addColumn<bool>("shown");
    QTest::newRow("two, by a program") << 2 << true << true;
    QTest::newRow("three, by a program") << 3 << true << true;
    QTest::newRow("four, by a program") << 4 << true << false;
    QTest::newRow("one, by a program") << 1 << true << false;
    QTest::newRow("two, by one law") << 2 << false << false;
}

void TestPlotsChart::energyOfEachIsShownForAProgram()
{
    QFETCH(int, circles);
    QFETCH(bool, program);
    ShowingProgram straight;
    Simulation simulation(falling(circles));
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    simulation.setProgram(program ? &straight : nullptr);
    QTEST(chart.isShown(EnergyChart::TotalOfEach), "shown");
    QCOMPARE(chart.isShown(EnergyChart::KineticOfEach), !chart.isShown(EnergyChart::TotalOfEach));
    chart.setShown(EnergyChart::ByIntegrator, true);
    chart.resize(500, 400);
    chart.show();
    run(simulation, 20);
    QStringList labels;
    QTRY_VERIFY(!chart.plot().labels().empty());
    for (const auto &[text, place] : chart.plot().labels())
        labels << text.section(u':', 0, 0);
    QCOMPARE(labels.contains(QStringLiteral("by the program")), program);
    QCOMPARE(labels.contains(QStringLiteral("by the integrator")), !program);
}

QTEST_MAIN(TestPlotsChart)

#include "test_plots_chart.moc"
