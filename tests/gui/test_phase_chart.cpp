// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/chart_reading.h"
#include "tests/gui/chart_scenes.h"
#include "tests/gui/open_window.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/phase_chart.h"
#include "views/charts/phase_plot.h"

#include <QSignalSpy>
#include <QTabWidget>

using namespace cradle;
using namespace cradle::windows;

namespace {

double lengthOf(const ValueSpan &span)
{
    return span.high - span.low;
}

} // namespace

class TestPhaseChart final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void showsPinnedRunsToo();
    void clickNearTheCurveGoesThere();
    void wheelZoomsBothAxesAboutThePointer();
    void controlWheelZoomsTheVerticalAxis();
    void shiftDragZoomsToABox();
    void middleButtonPans();
    void doubleClickEndsTheZoom();
    void menuZoomsAndResets();
    void menuKeepsTheRun();
    void otherAxesEndTheZoom();
    void timeIsZoomedInAllCharts();
    void keysTellTheMomentAndLetItBeHeard();

private:
    [[nodiscard]] Simulation &simulation() { return m_open->simulation(); }
    [[nodiscard]] const PhasePlot &plot() const { return m_phase->plot(); }
    [[nodiscard]] PhasePlot *widget() { return m_phase->findChild<PhasePlot *>(); }
    [[nodiscard]] QPoint middle() const { return plot().plotArea().center().toPoint(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
    PhaseChart *m_phase = nullptr;
};

void TestPhaseChart::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    m_open->bench.setMode(Mode::Explore);
    m_open->bench.document().open(glancing());
    simulation().goTo(180);
    m_phase = &m_open->window.phaseChart();
    auto *tabs = qobject_cast<QTabWidget *>(m_phase->parentWidget()->parentWidget());
    QVERIFY(tabs);
    tabs->setCurrentWidget(m_phase);
    m_open->window.findChild<QDockWidget *>(QStringLiteral("values"))->raise();
    m_phase->setAxes({Quantity::VelocityY, 1}, {Quantity::X, 1});
    settle();
}

void TestPhaseChart::cleanup()
{
    m_open.reset();
    m_folder.reset();
}

void TestPhaseChart::keysTellTheMomentAndLetItBeHeard()
{
    m_open->window.activateWindow();
    widget()->setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(widget()->hasFocus());
    const World now = simulation().recording().world(180);
    const QString told = widget()->accessibleDescription();
    QCOMPARE(told, plot().picture().told);
    QVERIFY2(told.startsWith(QStringLiteral("Velocity upwards, circle 2: "))
                 && told.contains(QStringLiteral("Position x, circle 2: ")),
             qPrintable(told));
    // What is written is what the run has, to the digits that are written.
    const auto numbers = told.split(QStringLiteral(": "));
    const auto numberIn = [](QString text) {
        return text.section(QLatin1Char(' '), 0, 0)
            .replace(QChar(0x2212), QLatin1Char('-'))
            .toDouble();
    };
    QVERIFY(std::abs(numberIn(numbers[1]) - now.circles[1].velocity.y) < 1e-3);
    QVERIFY(std::abs(numberIn(numbers[2]) - now.circles[1].position.x) < 1e-3);
    QTest::keyClick(widget(), Qt::Key_Left); // the window's key: a step back
    QCOMPARE(simulation().current(), qint64{179});
    QTRY_VERIFY(widget()->accessibleDescription() != told);
    QSignalSpy played(m_phase, &PhaseChart::curvePlayed);
    QTest::keyClick(widget(), Qt::Key_Return);
    QCOMPARE(played.size(), 1);
    const auto values = played[0][0].value<std::vector<double>>();
    QCOMPARE(values.front(), simulation().recording().world(0).circles[1].velocity.y);
    QCOMPARE(values.back(), now.circles[1].velocity.y);
}

void TestPhaseChart::showsPinnedRunsToo()
{
    m_phase->setAxes({Quantity::Y, 1}, {Quantity::X, 1});
    settle();
    QCOMPARE(plot().picture().curves.size(), std::size_t{1});
    QVERIFY(plot().picture().isEqual);
    const World last = simulation().recording().world(180);
    QCOMPARE(plot().picture().curves[0].points.last(),
             QPointF(last.circles[1].position.x, last.circles[1].position.y));
    QCOMPARE(*plot().picture().moment, plot().picture().curves[0].points.last());
    m_open->window.runDesk().pinRun();
    simulation().restart();
    simulation().goTo(10);
    settle();
    QCOMPARE(plot().picture().curves.size(), std::size_t{2});
}

void TestPhaseChart::clickNearTheCurveGoesThere()
{
    const World then = simulation().recording().world(150);
    const QPointF place = plot().placeOf({then.circles[1].position.x, then.circles[1].velocity.y});
    QTest::mouseClick(widget()->viewport(), Qt::LeftButton, {}, place.toPoint());
    QVERIFY2(std::abs(simulation().current() - 150) <= 1,
             qPrintable(QString::number(simulation().current())));
}

void TestPhaseChart::wheelZoomsBothAxesAboutThePointer()
{
    const ValueSpan across = plot().acrossSpan();
    const ValueSpan up = plot().upSpan();
    const TimeWindow::Span times = m_open->window.findChild<MomentumChart *>()->plot().timeSpan();
    const QPointF place = plot().plotArea().topLeft() + QPointF(40.0, 30.0);
    const QPointF about = plot().valuesAt(place);
    turnWheel(widget()->viewport(), place, 360);
    settle();
    // A notch of 120 is a factor of e^−0.2.
    QVERIFY(std::abs(lengthOf(plot().acrossSpan()) / lengthOf(across) - std::exp(-0.6)) < 1e-9);
    QVERIFY(std::abs(lengthOf(plot().upSpan()) / lengthOf(up) - std::exp(-0.6)) < 1e-9);
    QVERIFY((plot().placeOf(about) - place).manhattanLength() < 1.0);
    // Places are no times: the other charts rest.
    QCOMPARE(m_open->window.findChild<MomentumChart *>()->plot().timeSpan(), times);
}

void TestPhaseChart::controlWheelZoomsTheVerticalAxis()
{
    const ValueSpan across = plot().acrossSpan();
    const ValueSpan up = plot().upSpan();
    turnWheel(widget()->viewport(), middle(), 120, Qt::ControlModifier);
    settle();
    QCOMPARE(plot().acrossSpan(), across);
    QVERIFY(lengthOf(plot().upSpan()) < 0.9 * lengthOf(up));
}

void TestPhaseChart::shiftDragZoomsToABox()
{
    const QPoint from = plot().plotArea().topLeft().toPoint() + QPoint(30, 10);
    const QPoint to = from + QPoint(80, 40);
    const QPointF first = plot().valuesAt(from);
    const QPointF last = plot().valuesAt(to);
    const qint64 shown = simulation().current();
    drag(widget()->viewport(), from, to, Qt::LeftButton, Qt::ShiftModifier);
    settle();
    QCOMPARE(plot().acrossSpan(), (ValueSpan{first.x(), last.x()}));
    QCOMPARE(plot().upSpan(), (ValueSpan{last.y(), first.y()}));
    QCOMPARE(simulation().current(), shown); // a box is no click
    drag(widget()->viewport(), from, from + QPoint(3, 40), Qt::LeftButton, Qt::ShiftModifier);
    settle();
    QCOMPARE(plot().acrossSpan(), (ValueSpan{first.x(), last.x()})); // a slip of the hand
}

void TestPhaseChart::middleButtonPans()
{
    const QPointF held = plot().valuesAt(middle());
    drag(widget()->viewport(), middle(), middle() + QPoint(-30, 20), Qt::MiddleButton);
    settle();
    const QPointF now = plot().placeOf(held);
    QVERIFY((now - middle() - QPointF(-30.0, 20.0)).manhattanLength() < 1e-6);
}

void TestPhaseChart::doubleClickEndsTheZoom()
{
    const ValueSpan across = plot().acrossSpan();
    const ValueSpan up = plot().upSpan();
    turnWheel(widget()->viewport(), middle(), 480);
    settle();
    QVERIFY(plot().acrossSpan() != across);
    QTest::mouseDClick(widget()->viewport(), Qt::LeftButton, {}, middle());
    settle();
    QCOMPARE(plot().acrossSpan(), across);
    QCOMPARE(plot().upSpan(), up);
}

void TestPhaseChart::menuKeepsTheRun()
{
    const auto trigger = [this](const char *name) {
        QMenu menu;
        m_phase->fillMenu(menu);
        QAction *action = actionNamed(menu, QLatin1String(name));
        return action && action->isEnabled() && (action->trigger(), true);
    };
    QVERIFY(trigger("Pin this run"));
    QCOMPARE(m_open->window.runDesk().pins().runs().size(), std::size_t{1});
    QVERIFY(trigger("Remove"));
    QVERIFY(m_open->window.runDesk().pins().runs().empty());
}

void TestPhaseChart::menuZoomsAndResets()
{
    const ValueSpan across = plot().acrossSpan();
    const auto trigger = [this](const char *name) {
        QMenu menu;
        m_phase->fillMenu(menu);
        QAction *action = actionNamed(menu, QLatin1String(name));
        return action && action->isEnabled() && (action->trigger(), true);
    };
    QVERIFY(!trigger("Reset zoom"));
    QVERIFY(trigger("Zoom in"));
    settle();
    QVERIFY(std::abs(lengthOf(plot().acrossSpan()) - lengthOf(across) / 1.5) < 1e-9);
    QVERIFY(trigger("Zoom out"));
    settle();
    QVERIFY(std::abs(lengthOf(plot().acrossSpan()) - lengthOf(across)) < 1e-9);
    QVERIFY(trigger("Zoom in"));
    QVERIFY(trigger("Reset zoom"));
    settle();
    QCOMPARE(plot().acrossSpan(), across);
}

void TestPhaseChart::otherAxesEndTheZoom()
{
    turnWheel(widget()->viewport(), middle(), 480);
    settle();
    QVERIFY(plot().picture().across && plot().picture().up);
    m_phase->setAxes({Quantity::Y, 0}, {Quantity::X, 0});
    settle();
    QVERIFY(!plot().picture().across && !plot().picture().up);
}

void TestPhaseChart::timeIsZoomedInAllCharts()
{
    m_phase->setAxes({Quantity::X, 1}, {Quantity::Time, PhaseVariable::together});
    settle();
    const ValueSpan up = plot().upSpan();
    const double seconds = lengthOf(plot().acrossSpan());
    turnWheel(widget()->viewport(), middle(), 240);
    settle();
    const ChartPlot &others = m_open->window.findChild<MomentumChart *>()->plot();
    QVERIFY(lengthOf(plot().acrossSpan()) < 0.75 * seconds);
    QCOMPARE(plot().acrossSpan(), (ValueSpan{others.timeSpan().from, others.timeSpan().to}));
    QCOMPARE(plot().upSpan(), up); // the values are zoomed with Control
    m_phase->resetZoom();
    settle();
    QCOMPARE(lengthOf(plot().acrossSpan()), seconds);
    QCOMPARE(others.timeSpan().length(), seconds);
}

QTEST_MAIN(TestPhaseChart)

#include "test_phase_chart.moc"
