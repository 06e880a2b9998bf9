// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_plot.h"

#include <QLineSeries>
#include <QTest>

using namespace cradle;

namespace {

constexpr QRgb curveColour = qRgb(200, 0, 200);

/// How many pixels of a column of the plot are about as \p colour.
int inkIn(const QImage &image, const QRectF &area, int x, QRgb colour)
{
    int count = 0;
    for (int y = static_cast<int>(area.top()); y <= static_cast<int>(area.bottom()); ++y) {
        const QRgb pixel = image.pixel(x, y);
        const int off = std::abs(qRed(pixel) - qRed(colour))
                        + std::abs(qGreen(pixel) - qGreen(colour))
                        + std::abs(qBlue(pixel) - qBlue(colour));
        count += off < 60 ? 1 : 0;
    }
    return count;
}

/// Up and down between 1 and 2, \p each samples to a second, for 100 s.
MinMaxPyramid zigzag(int each)
{
    MinMaxPyramid samples;
    for (int i = 0; i <= 100 * each; ++i)
        samples.append(static_cast<double>(i) / each, i % 2 == 0 ? 1.0 : 2.0);
    return samples;
}

} // namespace

/// The plot by itself, with curves made for it.
class TestChartPlot final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void denseCurvesFillTheirColumns();
    void denseCurvesStayWithinAZoom();
    void sparseCurvesAreSeries();
    void pointsOnAStraightLineAreLeftOut();

private:
    void show(const MinMaxPyramid &samples);
    [[nodiscard]] const QLineSeries *series() const
    {
        return qobject_cast<QLineSeries *>(m_plot->chart()->series().constFirst());
    }

    std::unique_ptr<ChartPlot> m_plot;
    ChartMoment m_moment;
};

void TestChartPlot::init()
{
    m_plot = std::make_unique<ChartPlot>();
    m_plot->resize(400, 240);
    m_plot->show();
    m_moment = {.to = 100.0};
    m_moment.range.fit(0.0, 3.0, 3.0);
}

void TestChartPlot::show(const MinMaxPyramid &samples)
{
    const ChartCurve curve{.label = QStringLiteral("c"),
                           .isLabelled = false,
                           .colour = QColor(curveColour),
                           .samples = &samples};
    m_plot->showMoment(m_moment, {curve}, Recording());
}

void TestChartPlot::denseCurvesFillTheirColumns()
{
    const MinMaxPyramid samples = zigzag(60);
    show(samples);
    QCOMPARE(series()->count(), 0); // QtCharts would stroke each of its corners
    const QRectF area = m_plot->plotArea();
    const double height = m_plot->yOf(1.0) - m_plot->yOf(2.0);
    QImage drawn(m_plot->size(), QImage::Format_RGB32);
    drawn.fill(Qt::white);
    QPainter painter(&drawn);
    m_plot->paint(painter); // for files
    painter.end();
    for (const QImage &image : {m_plot->grab().toImage(), drawn}) {
        for (int x = static_cast<int>(area.left()) + 4; x < area.right() - 4; x += 10) {
            const int ink = inkIn(image, area, x, curveColour);
            QVERIFY2(std::abs(ink - height) <= 3.0,
                     qPrintable(QStringLiteral("%1 of %2").arg(ink).arg(height)));
        }
    }
}

void TestChartPlot::denseCurvesStayWithinAZoom()
{
    const MinMaxPyramid samples = zigzag(60);
    m_moment.zoom = ValueSpan{1.5, 4.0}; // the lower half of the curve lies below
    show(samples);
    QCOMPARE(series()->count(), 0);
    const QRectF area = m_plot->plotArea();
    const QImage image = m_plot->grab().toImage();
    const int x = static_cast<int>(area.center().x());
    QVERIFY(std::abs(inkIn(image, area, x, curveColour) - (area.bottom() - m_plot->yOf(2.0)))
            <= 3.0);
    const QRectF below(area.left(), area.bottom() + 2.0, area.width(), 16.0);
    QCOMPARE(inkIn(image, below, x, curveColour), 0);
}

void TestChartPlot::sparseCurvesAreSeries()
{
    const MinMaxPyramid samples = zigzag(1);
    m_moment.to = 20.0;
    show(samples);
    QVERIFY(series()->count() >= 20);
}

void TestChartPlot::pointsOnAStraightLineAreLeftOut()
{
    MinMaxPyramid ramps; // up in 10 s, down in 10 s
    for (int i = 0; i <= 6000; ++i) {
        const double time = i / 60.0;
        ramps.append(time, 1.0 + std::abs(std::fmod(time, 20.0) - 10.0) / 10.0);
    }
    show(ramps);
    // Of 600 points, two to a column, few more than the eleven corners are needed.
    QVERIFY2(series()->count() >= 11 && series()->count() <= 40,
             qPrintable(QString::number(series()->count())));
    const QImage image = m_plot->grab().toImage();
    for (const double time : {5.0, 33.0, 77.0}) {
        const int y = static_cast<int>(m_plot->yOf(ramps.valueAt(time)));
        const QRectF place(m_plot->xOf(time) - 1.0, y - 3.0, 2.0, 6.0);
        QVERIFY(inkIn(image, place, static_cast<int>(m_plot->xOf(time)), curveColour) > 0);
    }
}

QTEST_MAIN(TestChartPlot)

#include "test_chart_plot.moc"
