// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/chart_scenes.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/number_text.h"

#include "model/world/measurements.h"

#include <QAction>
#include <QLineSeries>
#include <QSignalSpy>
#include <QTest>
#include <QValueAxis>

using namespace cradle;

namespace {

bool overlapping(const std::vector<std::pair<QString, QRectF>> &labels)
{
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = i + 1; j < labels.size(); ++j) {
            if (labels[i].second.intersects(labels[j].second))
                return true;
        }
    }
    return false;
}

} // namespace

class TestCharts final : public QObject
{
    Q_OBJECT
private slots:
    void eachCircleHasItsTotal();
    void integratorsMakeOrKeepEnergy();
    void integratorsAreComparedWhereTheyDiffer();
    void choiceOfTheStudentWins();
    void labelsNeverOverlap_data();
    void labelsNeverOverlap();
    void labelsNameTheCurvesAndTheValueOfTheSum();
    void noiseIsNotBlownUp();
    void seriesHaveAtMostTwoPointsPerColumn();
    void clickAsksForThatTime();
    void hiddenChartDrawsNothing();
    void pastIsShownBeforeTheMoment();
};

void TestCharts::eachCircleHasItsTotal()
{
    Simulation simulation(euleredFall());
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    chart.resize(420, 300);
    chart.show();
    run(simulation, 300);
    const auto circles = simulation.recording().circles(simulation.current());
    for (std::size_t i = 0; i < 2; ++i) {
        const double total = measure(circles[i], {0.0, -9.81}, 4.0).total();
        QCOMPARE(curves.circle(i).total.lastValue(), total);
        const QString label =
            QStringLiteral("total %1: %2").arg(i + 1).arg(QString::number(total, 'f', 1));
        const auto isShown = [&] {
            const auto labels = chart.plot().labels();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const auto &shown) { return shown.first == label; });
        };
        QTRY_VERIFY2(isShown(), qPrintable(label));
    }
    const MinMaxPyramid &euler = curves.circle(0).total;
    QVERIFY(euler.lastValue() > 1.05 * euler.valueAt(0.0));
}

void TestCharts::integratorsMakeOrKeepEnergy()
{
    Preset lossy = euleredFall();
    lossy.restitution = 0.8;
    Simulation simulation(lossy);
    RunCurves curves(simulation);
    run(simulation, 300);
    QVERIFY(curves.dissipated().lastValue() > 0.0);
    for (const double time : {0.5, 1.5, 4.9}) {
        const double start = curves.total().valueAt(time) + curves.dissipated().valueAt(time)
                             - curves.made().valueAt(time);
        QVERIFY(std::abs(start - curves.total().valueAt(0.0)) < 1e-9 * start);
    }
    QVERIFY(curves.made().valueAt(0.9) > 0.0);

    simulation.setPreset(falling(2)); // by Verlet
    run(simulation, 300);
    QVERIFY(std::abs(curves.made().lastValue()) < 1e-6 * curves.total().valueAt(0.0));
}

void TestCharts::integratorsAreComparedWhereTheyDiffer()
{
    Simulation simulation(falling(2));
    RunCurves curves(simulation);
    const EnergyChart chart(simulation, curves);
    const auto compares = [&](const Preset &preset) {
        simulation.setPreset(preset);
        const bool shown = chart.isShown(EnergyChart::TotalOfEach);
        return shown == chart.isShown(EnergyChart::ByIntegrator)
               && shown != chart.isShown(EnergyChart::KineticOfEach) && shown;
    };
    QVERIFY(!chart.isShown(EnergyChart::TotalOfEach));
    QVERIFY(chart.isShown(EnergyChart::KineticOfEach));
    QVERIFY(compares(euleredFall()));
    Preset weightless = euleredFall();
    weightless.gravity = {};
    QVERIFY(!compares(weightless));
    Preset many = falling(5);
    many.circles.front().integrator = Integrator::Euler;
    QVERIFY(!compares(many));
    many.circles.pop_back();
    QVERIFY(compares(many));
}

void TestCharts::choiceOfTheStudentWins()
{
    Simulation simulation(falling(2));
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    chart.setShown(EnergyChart::KineticOfEach, true);
    QAction *made = nullptr;
    for (QAction *action : chart.findChildren<QAction *>()) {
        if (action->toolTip().contains(QStringLiteral("start = total + dissipated")))
            made = action;
    }
    QVERIFY(made);
    made->trigger(); // on
    made->trigger(); // off
    simulation.setPreset(euleredFall());
    QVERIFY(chart.isShown(EnergyChart::TotalOfEach));
    QVERIFY(chart.isShown(EnergyChart::KineticOfEach));
    QVERIFY(!chart.isShown(EnergyChart::ByIntegrator));
}

void TestCharts::labelsNeverOverlap_data()
{
    QTest::addColumn<int>("circles");
    QTest::addColumn<QSize>("size");
    for (const int circles : {1, 2, 5, 8}) {
        for (const QSize size : {QSize(300, 220), QSize(420, 260), QSize(900, 500)})
            QTest::addRow("%d circles, %d px", circles, size.width()) << circles << size;
    }
}

void TestCharts::labelsNeverOverlap()
{
    QFETCH(int, circles);
    QFETCH(QSize, size);
    Simulation simulation(falling(circles));
    RunCurves curves(simulation);
    EnergyChart energy(simulation, curves);
    MomentumChart momentum(simulation, curves);
    for (ChartPane *pane :
         {static_cast<ChartPane *>(&energy), static_cast<ChartPane *>(&momentum)}) {
        pane->resize(size);
        pane->show();
    }
    for (int i = 0; i < 12; ++i) {
        run(simulation, 20);
        settle();
        for (const ChartPane *pane :
             {static_cast<ChartPane *>(&energy), static_cast<ChartPane *>(&momentum)}) {
            const auto labels = pane->plot().labels();
            QVERIFY(!labels.empty());
            QVERIFY(!overlapping(labels));
            for (const auto &[text, rect] : labels)
                QVERIFY(pane->plot().plotArea().contains(rect));
        }
    }
}

void TestCharts::labelsNameTheCurvesAndTheValueOfTheSum()
{
    Simulation simulation(glancing());
    RunCurves curves(simulation);
    MomentumChart chart(simulation, curves);
    chart.resize(420, 260);
    chart.show();
    run(simulation, 130);
    simulation.seek(10);
    settle();
    QStringList texts;
    for (const auto &[text, rect] : chart.plot().labels())
        texts.append(text);
    // m = 7800 · 4/3 π 0.2³ = 261.4 kg at 2 m/s
    QVERIFY2(texts.contains(QStringLiteral("circle 1")), qPrintable(texts.join(u'|')));
    QVERIFY2(texts.contains(QStringLiteral("circle 2")), qPrintable(texts.join(u'|')));
    QVERIFY2(texts.contains(QStringLiteral("sum p_x: 522.8")), qPrintable(texts.join(u'|')));
}

void TestCharts::noiseIsNotBlownUp()
{
    SteadyRange range;
    range.fit(-1e-12, 2e-12, 500.0);
    QVERIFY(range.scale(5, 0.0).high >= 100.0);
    range.reset();
    range.fit(522.7, 522.7, 522.7);
    const AxisScale level = range.scale(5, 0.0);
    QCOMPARE(level.low, 0.0);
    QCOMPARE(level.high, 600.0);
    range.reset();
    range.fit(0.0, 0.0, 0.0);
    QVERIFY(range.scale(5, 0.0).low < range.scale(5, 0.0).high);
}

void TestCharts::seriesHaveAtMostTwoPointsPerColumn()
{
    Simulation simulation(falling(3));
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    chart.resize(420, 260);
    chart.show();
    run(simulation, 3000);
    settle();
    const auto columns = static_cast<qsizetype>(chart.plot().plotArea().width());
    QVERIFY(!chart.plot().chart()->series().isEmpty());
    for (const QAbstractSeries *series : chart.plot().chart()->series()) {
        const qsizetype count = qobject_cast<const QLineSeries *>(series)->count();
        QVERIFY(count > 1 && count <= 2 * (columns + 2));
    }
}

void TestCharts::clickAsksForThatTime()
{
    Simulation simulation(glancing());
    RunCurves curves(simulation);
    MomentumChart chart(simulation, curves);
    chart.resize(420, 260);
    chart.show();
    QSignalSpy asked(&chart, &ChartPane::seekRequested);
    const auto viewport = chart.plot().viewport();
    QTest::mouseClick(viewport, Qt::LeftButton, {}, {200, 60});
    QCOMPARE(asked.count(), 0); // nothing is recorded yet
    run(simulation, 120);
    settle();
    const QRectF area = chart.plot().plotArea();
    const QPoint middle = area.center().toPoint();
    QTest::mouseClick(viewport, Qt::LeftButton, {}, middle);
    QCOMPARE(asked.count(), 1);
    const double end = chart.plot().valuesAt(area.topRight()).x();
    QVERIFY(end >= 2.0 && end < 2.5);
    QVERIFY(std::abs(asked.takeFirst().at(0).toDouble() - 0.5 * end) < 0.02);
}

void TestCharts::hiddenChartDrawsNothing()
{
    Simulation simulation(glancing());
    RunCurves curves(simulation);
    MomentumChart chart(simulation, curves);
    run(simulation, 20);
    QVERIFY(chart.plot().labels().empty());
    chart.show();
    QTRY_VERIFY(!chart.plot().labels().empty());
}

void TestCharts::pastIsShownBeforeTheMoment()
{
    Simulation simulation(falling(2));
    RunCurves curves(simulation);
    EnergyChart chart(simulation, curves);
    chart.timeWindow().show(TimeWindow::Kind::LastSeconds);
    chart.resize(420, 260);
    chart.show();
    run(simulation, 1800);
    settle();
    for (const qint64 index : {900, 1100, 1500, 600}) {
        simulation.seek(index);
        settle();
        const QRectF area = chart.plot().plotArea();
        const double from = chart.plot().valuesAt(area.topLeft()).x();
        const double part = (simulation.time() - from) / TimeWindow::lastSeconds;
        QVERIFY2(part > 0.3 && part < 0.81, qPrintable(QString::number(part)));
    }
}

QTEST_MAIN(TestCharts)

#include "test_charts.moc"
