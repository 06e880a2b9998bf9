// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_plot.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace cradle;

namespace {

constexpr double near = 24.0; ///< px that a label may be from what it tells of

/// +500 up to \p turn s, then −500.
MinMaxPyramid turning(double turn)
{
    MinMaxPyramid samples;
    for (int i = 0; i <= 600; ++i) {
        const double time = i / 60.0;
        if (time >= turn && samples.lastValue() > 0.0) {
            samples.append(turn, 500.0);
            samples.append(turn, -500.0);
        }
        samples.append(time, time < turn ? 500.0 : -500.0);
    }
    return samples;
}

} // namespace

/// A label that tells a number stands where the curve has it.
class TestChartLabels final : public QObject
{
    Q_OBJECT
private slots:
    void aValueStandsWhereTheCurveHasIt_data();
    void aValueStandsWhereTheCurveHasIt();
    void aSteepCurveTellsItsValueAtTheCursor();
    void withoutRoomThereTheNameStandsAlone();
    void closeCurvesStrikeNoLabelOut_data();
    void closeCurvesStrikeNoLabelOut();

private:
    void show(const MinMaxPyramid &samples, double shown);

    ChartPlot m_plot;
};

void TestChartLabels::show(const MinMaxPyramid &samples, double shown)
{
    m_plot.resize(400, 240);
    m_plot.show();
    ChartMoment moment{.to = 10.0, .shown = shown, .scale = 500.0};
    moment.range.fit(-500.0, 500.0, 500.0);
    const ChartCurve curve{.label = QStringLiteral("circle 1"),
                           .showsValue = true,
                           .colour = Qt::blue,
                           .samples = &samples};
    m_plot.showMoment(moment, {curve}, Recording());
}

void TestChartLabels::aValueStandsWhereTheCurveHasIt_data()
{
    QTest::addColumn<double>("turn");
    QTest::addColumn<double>("shown");
    for (const double turn : {2.0, 5.0, 8.0, 9.7}) {
        for (const double shown : {0.0, 1.0, 4.9, 5.1, 8.1, 10.0})
            QTest::addRow("turns at %g s, shown at %g s", turn, shown) << turn << shown;
    }
}

void TestChartLabels::aValueStandsWhereTheCurveHasIt()
{
    QFETCH(double, turn);
    QFETCH(double, shown);
    const MinMaxPyramid samples = turning(turn);
    show(samples, shown);
    const auto labels = m_plot.labels();
    QCOMPARE(labels.size(), std::size_t{1});
    const auto &[text, rect] = labels.front();
    const double value = samples.valueAt(shown);
    QCOMPARE(text,
             value > 0.0 ? QStringLiteral("circle 1: 500.0") : QStringLiteral("circle 1: −500.0"));
    const double y = m_plot.yOf(value);
    QVERIFY(rect.top() - y < near && y - rect.bottom() < near);
}

void TestChartLabels::aSteepCurveTellsItsValueAtTheCursor()
{
    MinMaxPyramid ramp;
    for (int i = 0; i <= 600; ++i)
        ramp.append(i / 60.0, 1000.0 * i / 600.0 - 500.0);
    for (const double shown : {3.0, 5.0, 7.0}) {
        show(ramp, shown);
        const auto labels = m_plot.labels();
        const auto &[text, rect] = labels.front();
        QVERIFY(text.contains(QLatin1Char(':')));
        const QPointF place(m_plot.xOf(shown), m_plot.yOf(ramp.valueAt(shown)));
        QVERIFY(rect.adjusted(-near, -near, near, near).contains(place));
    }
}

void TestChartLabels::withoutRoomThereTheNameStandsAlone()
{
    MinMaxPyramid spike; // at 0 but for one moment
    for (int i = 0; i <= 600; ++i)
        spike.append(i / 60.0, i == 300 ? 5000.0 : 0.0);
    show(spike, 5.0); // beyond what is shown
    QCOMPARE(m_plot.labels().front().first, QStringLiteral("circle 1"));
}

void TestChartLabels::closeCurvesStrikeNoLabelOut_data()
{
    QTest::addColumn<double>("low");
    for (const double low : {455.0, 440.0, 425.0, 400.0})
        QTest::addRow("500 and %g", low) << low;
}

/// Levels that are nearer to each other, and to the edge, than a label is high, though not than
/// half.
void TestChartLabels::closeCurvesStrikeNoLabelOut()
{
    QFETCH(double, low);
    const std::array levels{500.0, low, 0.0};
    std::array<MinMaxPyramid, 3> samples;
    std::vector<ChartCurve> curves;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        for (int k = 0; k <= 600; ++k)
            samples[i].append(k / 60.0, levels[i]);
        curves.push_back({.label = QStringLiteral("level %1").arg(levels[i]),
                          .colour = Qt::blue,
                          .samples = &samples[i]});
    }
    ChartPlot plot;
    plot.resize(400, 130);
    plot.show();
    ChartMoment moment{.to = 10.0, .shown = 5.0, .scale = 500.0};
    moment.range.fit(0.0, 500.0, 500.0);
    plot.showMoment(moment, curves, Recording());
    const auto labels = plot.labels();
    QCOMPARE(labels.size(), levels.size());
    for (const auto &[text, rect] : labels) {
        for (const double level : levels) {
            const double y = plot.yOf(level);
            const bool isOther = text != QStringLiteral("level %1").arg(level);
            QVERIFY2(!isOther || y < rect.top() || y > rect.bottom(),
                     qPrintable(QStringLiteral("%1 is met by %2").arg(text).arg(level)));
        }
    }
}

QTEST_MAIN(TestChartLabels)

#include "test_chart_labels.moc"
