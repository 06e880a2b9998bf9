// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/phase_plot.h"

#include <QLineSeries>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace cradle;

namespace {

const QColor curveColour(200, 0, 200);

/// So many times around the origin, with \p each points to a turn.
PlotLine spiral(int turns, int each)
{
    PlotLine line{.pen = QPen(curveColour, 1.5), .isOverTime = false};
    for (int i = 0; i <= turns * each; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / each;
        const double radius = 1.0 + static_cast<double>(i) / (turns * each);
        line.points.append({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return line;
}

/// Whether something of the curve's colour is at \p place, or a few px from it.
bool hasInk(const QImage &image, QPointF place)
{
    for (int dx = -3; dx <= 3; ++dx) {
        for (int dy = -3; dy <= 3; ++dy) {
            if (image.pixelColor(place.toPoint() + QPoint(dx, dy)) == curveColour)
                return true;
        }
    }
    return false;
}

/// Whether anything of the curve's colour is outside of \p area.
bool spills(const QImage &image, const QRectF &area)
{
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const bool isOutside = !area.adjusted(-2.0, -2.0, 2.0, 2.0).contains(x, y);
            if (isOutside && image.pixelColor(x, y) == curveColour)
                return true;
        }
    }
    return false;
}

} // namespace

/// The plot by itself, with curves made for it.
class TestPhasePlot final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void curvesAreSeries();
    void pathsOfManyPointsAreNoSeries();
    void denseCurvesOverTimeAreNoSeries();
    void zoomedCurvesStayWithinTheAxes();

private:
    [[nodiscard]] int seriesPoints() const
    {
        return qobject_cast<QLineSeries *>(m_plot->chart()->series().constFirst())->count();
    }

    std::unique_ptr<PhasePlot> m_plot;
    PhasePicture m_picture;
};

void TestPhasePlot::init()
{
    m_plot = std::make_unique<PhasePlot>();
    m_plot->resize(400, 240);
    m_plot->show();
    m_picture = {.acrossText = QStringLiteral("x in m"), .upText = QStringLiteral("y in m")};
}

void TestPhasePlot::curvesAreSeries()
{
    m_picture.curves = {spiral(3, 60)};
    m_plot->showPicture(m_picture);
    QVERIFY(seriesPoints() > 150);
}

/// QtCharts makes the outline of every series, at a cost of all its corners.
void TestPhasePlot::pathsOfManyPointsAreNoSeries()
{
    m_picture.curves = {spiral(90, 60)};
    m_plot->showPicture(m_picture);
    QCOMPARE(seriesPoints(), 0);
    QVERIFY(hasInk(m_plot->grab().toImage(), m_plot->placeOf({0.0, 1.5})));
}

/// A smooth line up and down in every column took 74 ms a frame.
void TestPhasePlot::denseCurvesOverTimeAreNoSeries()
{
    PlotLine line{.pen = QPen(curveColour, 1.5)};
    for (int i = 0; i <= 700; ++i)
        line.points.append({0.1 * i, i % 2 == 0 ? -1.0 : 1.0});
    m_picture.curves = {line};
    m_plot->showPicture(m_picture);
    QCOMPARE(seriesPoints(), 0);
    const QImage image = m_plot->grab().toImage();
    for (const double time : {10.0, 33.0, 60.0}) {
        for (const double value : {-0.9, 0.0, 0.9})
            QCOMPARE(image.pixelColor(m_plot->placeOf({time, value}).toPoint()), curveColour);
    }
}

/// On the screen, and where nothing clips: in a picture.
void TestPhasePlot::zoomedCurvesStayWithinTheAxes()
{
    m_picture.across = ValueSpan{-1.2, 1.2};
    m_picture.up = ValueSpan{-1.2, 1.2};
    for (const int turns : {4, 90}) {
        m_picture.curves = {spiral(turns, 60)};
        m_plot->showPicture(m_picture);
        QImage drawn(m_plot->size(), QImage::Format_RGB32);
        drawn.fill(Qt::white);
        QPainter painter(&drawn);
        m_plot->paint(painter);
        painter.end();
        for (const QImage &image : {m_plot->grab().toImage(), drawn})
            QVERIFY(!spills(image, m_plot->plotArea()));
    }
}

QTEST_MAIN(TestPhasePlot)

#include "test_phase_plot.moc"
