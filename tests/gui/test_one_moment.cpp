// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "model/world/measurements.h"
#include "tests/gui/chart_reading.h"
#include "tests/gui/chart_scenes.h"
#include "tests/gui/open_window.h"
#include "tests/gui/settled.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/phase_chart.h"
#include "views/charts/phase_plot.h"
#include "views/theme.h"
#include "views/timeline.h"
#include "views/values/values_model.h"
#include "views/values/values_table.h"

#include <QTabWidget>

using namespace cradle;
using namespace cradle::windows;

/// One cursor through scene, charts, values and timeline, wherever it is moved.
class TestOneMoment final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void scrubbingTheTimelineMovesAll();
    void clickInAChartMovesAll();
    void clickInThePhaseChartMovesAll();
    void runningOnMovesAll();

private:
    void verifyAllShow(qint64 index);
    [[nodiscard]] bool hasCursor(const ChartPane &chart, double time);
    [[nodiscard]] Timeline *timeline() { return m_open->window.findChild<Timeline *>(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
    QTabWidget *m_tabs = nullptr;
};

void TestOneMoment::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    m_open->bench.setMode(Mode::Explore);
    m_open->window.resize(1440, 900); // both charts are seen
    m_open->window.findChild<QDockWidget *>(QStringLiteral("values"))->raise();
    m_open->bench.document().open(euleredFall());
    m_open->simulation().goTo(150);
    m_tabs = &m_open->window.findChild<ValuesPane *>()->tabs();
    settle();
}

void TestOneMoment::cleanup()
{
    m_open.reset();
    m_folder.reset();
}

/// Whether the line of the cursor is drawn in the plot at \p time (s), and nowhere near.
bool TestOneMoment::hasCursor(const ChartPane &chart, double time)
{
    const QImage image = chart.plot().viewport()->grab().toImage();
    const double scale = image.devicePixelRatio();
    const auto inkAt = [&](double x) {
        int ink = 0;
        for (int y = 0; y < image.height(); ++y)
            ink += image.pixelColor(static_cast<int>(x * scale), y) == theme().accent ? 1 : 0;
        return ink;
    };
    const double x = std::floor(chart.plot().xOf(time)) + 0.5;
    const double height = 0.25 * chart.plot().plotArea().height() * scale; // labels lie on it
    return inkAt(x) > height && inkAt(x - 4.0) < height && inkAt(x + 4.0) < height;
}

void TestOneMoment::verifyAllShow(qint64 index)
{
    settle();
    const Recording &recording = m_open->simulation().recording();
    const double time = recording.time(index);
    QCOMPARE(m_open->simulation().current(), index);
    QCOMPARE(timeline()->value(), static_cast<int>(index));
    QVERIFY(m_open->says(QStringLiteral("t = %1 s").arg(time, 0, 'f', 3)));
    QVERIFY(m_open->says(QStringLiteral("step %1").arg(index)));
    QVERIFY(hasCursor(*m_open->window.findChild<MomentumChart *>(), time));
    QVERIFY(hasCursor(*m_open->window.findChild<EnergyChart *>(), time));
    const Circle &circle = recording.circles(index)[1];
    const DrawList list = m_open->window.scene().picture().list;
    QVERIFY(std::any_of(list.discs.begin(), list.discs.end(),
                        [&](const auto &disc) { return disc.centre == circle.position; }));
    QCOMPARE(m_open->window.findChild<ValuesModel *>()->number(1, ValuesModel::Y),
             std::optional(circle.position.y));
    if (m_tabs->currentWidget() == &m_open->window.phaseChart()) {
        const auto dot = m_open->window.phaseChart().plot().picture().moment;
        QCOMPARE(*dot, QPointF(circle.position.y, circle.velocity.y));
    }
}

void TestOneMoment::scrubbingTheTimelineMovesAll()
{
    const double y = 0.5 * timeline()->height();
    const auto at = [&](double time) { return QPoint(int(timeline()->xOf(time)), int(y)); };
    QTest::mousePress(timeline(), Qt::LeftButton, {}, at(0.4));
    verifyAllShow(m_open->simulation().current());
    QVERIFY(std::abs(m_open->simulation().time() - 0.4) < 0.02);
    QMouseEvent move(QEvent::MouseMove, at(1.7), timeline()->mapToGlobal(QPointF(at(1.7))),
                     Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(timeline(), &move);
    verifyAllShow(m_open->simulation().current());
    QVERIFY(std::abs(m_open->simulation().time() - 1.7) < 0.02);
    QTest::mouseRelease(timeline(), Qt::LeftButton, {}, at(1.7));
}

void TestOneMoment::clickInAChartMovesAll()
{
    const auto *chart = m_open->window.findChild<EnergyChart *>();
    const QPointF place(chart->plot().xOf(0.75), chart->plot().plotArea().top() + 12.0);
    QTest::mouseClick(chart->plot().viewport(), Qt::LeftButton, {}, place.toPoint());
    QVERIFY(std::abs(m_open->simulation().time() - 0.75) < 0.03);
    verifyAllShow(m_open->simulation().current());
}

void TestOneMoment::clickInThePhaseChartMovesAll()
{
    PhaseChart &phase = m_open->window.phaseChart();
    m_tabs->setCurrentWidget(&phase);
    phase.setAxes({Quantity::VelocityY, 1}, {Quantity::Y, 1});
    settle();
    const Circle then = m_open->simulation().recording().circles(40)[1];
    const QPointF place = phase.plot().placeOf({then.position.y, then.velocity.y});
    QTest::mouseClick(phase.plot().viewport(), Qt::LeftButton, {}, place.toPoint());
    QVERIFY(std::abs(m_open->simulation().current() - 40) <= 1);
    verifyAllShow(m_open->simulation().current());
}

void TestOneMoment::runningOnMovesAll()
{
    m_open->simulation().seek(30);
    m_open->simulation().stepForward();
    verifyAllShow(31);
    m_open->simulation().seekNextHit();
    verifyAllShow(m_open->simulation().current());
}

QTEST_MAIN(TestOneMoment)

#include "test_one_moment.moc"
