// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/chart_reading.h"
#include "tests/gui/chart_scenes.h"
#include "tests/gui/settled.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/note_place.h"

#include <QSignalSpy>
#include <QTest>

using namespace cradle;

class TestChartZoom final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void wheelZoomsAboutThePointer();
    void zoomIsShared();
    void controlWheelZoomsTheValues();
    void shiftDragZoomsToABox();
    void lowBoxIsAStretchOfTime();
    void middleButtonPans();
    void doubleClickEndsTheZoom();
    void keysZoomAboutTheMoment();
    void zoomedWindowFollowsTheRun();
    void clickOnAHitGoesThere();
    void noteTellsBeforeAndAfter();
    void noteOnAWallHasOneCircle();
    void noteIsMissingWhereManyHit();
    void noteInALowChartIsShort();
    void noteLiesBetweenCurves();
    void menuEndsTheZoom();

private:
    [[nodiscard]] QRectF area() const { return m_momentum->plot().plotArea(); }
    [[nodiscard]] TimeWindow::Span span() const { return m_momentum->plot().timeSpan(); }

    std::unique_ptr<Simulation> m_simulation;
    std::unique_ptr<RunCurves> m_curves;
    std::unique_ptr<TimeWindow> m_window;
    std::unique_ptr<PinnedRuns> m_pins;
    std::unique_ptr<MomentumChart> m_momentum;
    std::unique_ptr<EnergyChart> m_energy;
};

void TestChartZoom::init()
{
    m_simulation = std::make_unique<Simulation>(glancing());
    m_curves = std::make_unique<RunCurves>(*m_simulation);
    m_window = std::make_unique<TimeWindow>();
    m_pins = std::make_unique<PinnedRuns>();
    m_momentum = std::make_unique<MomentumChart>(*m_simulation, *m_curves);
    m_energy = std::make_unique<EnergyChart>(*m_simulation, *m_curves);
    for (ChartPane *chart :
         {static_cast<ChartPane *>(m_momentum.get()), static_cast<ChartPane *>(m_energy.get())}) {
        chart->share(*m_window, *m_pins);
        connect(chart, &ChartPane::seekRequested, m_simulation.get(), [this](double time) {
            m_simulation->seek(m_simulation->recording().indexAt(time));
        });
        chart->resize(420, 260);
        chart->show();
    }
    run(*m_simulation, 240); // 4 s
    settle();
}

void TestChartZoom::cleanup()
{
    m_momentum.reset();
    m_energy.reset();
}

void TestChartZoom::wheelZoomsAboutThePointer()
{
    const TimeWindow::Span before = span();
    const QPointF place(area().left() + 0.25 * area().width(), area().center().y());
    const double about = m_momentum->plot().valuesAt(place).x();
    turnWheel(*m_momentum, place, 120);
    settle();
    QVERIFY(span().length() < 0.85 * before.length());
    QVERIFY(std::abs(m_momentum->plot().valuesAt(place).x() - about) < 1e-9);
    turnWheel(*m_momentum, place, -120);
    turnWheel(*m_momentum, place, -120);
    settle();
    QCOMPARE(span(), before);
    QCOMPARE(m_window->kind(), TimeWindow::Kind::All);
}

void TestChartZoom::zoomIsShared()
{
    turnWheel(*m_momentum, area().center(), 360);
    settle();
    QCOMPARE(m_energy->plot().timeSpan(), span());
    QVERIFY(span().length() < 3.0);
}

void TestChartZoom::controlWheelZoomsTheValues()
{
    const ValueSpan before = m_momentum->plot().upSpan();
    const TimeWindow::Span times = span();
    const ValueSpan others = m_energy->plot().upSpan();
    const double about = m_momentum->plot().valuesAt(area().center()).y();
    turnWheel(*m_momentum, area().center(), 240, Qt::ControlModifier);
    settle();
    const ValueSpan after = m_momentum->plot().upSpan();
    QVERIFY(after.high - after.low < 0.75 * (before.high - before.low));
    QVERIFY(std::abs(m_momentum->plot().valuesAt(area().center()).y() - about) < 1e-6);
    QCOMPARE(span(), times);
    QCOMPARE(m_energy->plot().upSpan(), others);
}

void TestChartZoom::shiftDragZoomsToABox()
{
    const QPoint from = (area().topLeft() + QPointF(50.0, 20.0)).toPoint();
    const QPoint to = from + QPoint(120, 60);
    const ChartPlot &plot = m_momentum->plot();
    const TimeWindow::Span times{plot.valuesAt(from).x(), plot.valuesAt(to).x()};
    const ValueSpan values{plot.valuesAt(to).y(), plot.valuesAt(from).y()};
    const qint64 shown = m_simulation->current();
    drag(*m_momentum, from, to, Qt::LeftButton, Qt::ShiftModifier);
    settle();
    QVERIFY(std::abs(span().from - times.from) < 1e-9 && std::abs(span().to - times.to) < 1e-9);
    QCOMPARE(plot.upSpan(), values);
    QCOMPARE(m_simulation->current(), shown); // a box is no click
}

void TestChartZoom::lowBoxIsAStretchOfTime()
{
    const ValueSpan values = m_momentum->plot().upSpan();
    const QPoint from = area().center().toPoint();
    drag(*m_momentum, from, from + QPoint(60, 2), Qt::LeftButton, Qt::ShiftModifier);
    settle();
    QCOMPARE(m_window->kind(), TimeWindow::Kind::Zoomed);
    QCOMPARE(m_momentum->plot().upSpan(), values);
}

void TestChartZoom::middleButtonPans()
{
    turnWheel(*m_momentum, area().center(), 480);
    settle();
    const TimeWindow::Span before = span();
    const QPoint from = area().center().toPoint();
    drag(*m_momentum, from, from + QPoint(40, 0), Qt::MiddleButton);
    settle();
    const double moved = 40.0 / area().width() * before.length();
    QVERIFY(std::abs(span().from - (before.from - moved)) < 1e-9);
    QVERIFY(std::abs(span().length() - before.length()) < 1e-9);
    drag(*m_momentum, from, from + QPoint(4000, 0), Qt::MiddleButton);
    settle();
    QCOMPARE(span().from, 0.0); // no further than the run
}

void TestChartZoom::doubleClickEndsTheZoom()
{
    const qint64 shown = m_simulation->current();
    turnWheel(*m_momentum, area().center(), 240);
    turnWheel(*m_momentum, area().center(), 240, Qt::ControlModifier);
    settle();
    QTest::mouseClick(m_momentum->plot().viewport(), Qt::LeftButton, {}, area().center().toPoint());
    QVERIFY(m_simulation->current() != shown);
    QTest::mouseDClick(m_momentum->plot().viewport(), Qt::LeftButton, {},
                       area().center().toPoint());
    settle();
    QCOMPARE(m_window->kind(), TimeWindow::Kind::All);
    QVERIFY(m_momentum->plot().upSpan().high > 500.0);
    QCOMPARE(m_simulation->current(), shown); // and does nothing else
}

void TestChartZoom::keysZoomAboutTheMoment()
{
    m_simulation->seek(120);
    settle();
    const double place = m_momentum->plot().xOf(2.0);
    m_momentum->zoomIn();
    settle();
    QVERIFY(span().length() < 3.0);
    QVERIFY(std::abs(m_momentum->plot().xOf(2.0) - place) < 1e-6);
    m_energy->zoomOut();
    settle();
    QCOMPARE(m_window->kind(), TimeWindow::Kind::All);
}

void TestChartZoom::zoomedWindowFollowsTheRun()
{
    m_window->zoomTo({1.0, 2.0}, {0.0, 4.0});
    m_simulation->seek(90);
    settle();
    QCOMPARE(span(), (TimeWindow::Span{1.0, 2.0}));
    m_simulation->seek(150); // leaves it to the right
    settle();
    QVERIFY(span().from < 2.5 && span().to > 2.5);
    QVERIFY(std::abs(span().length() - 1.0) < 1e-9);
    // What was outside when the student zoomed elsewhere is not followed.
    m_window->zoomTo({0.0, 1.0}, {0.0, 4.0});
    settle();
    m_simulation->seek(160);
    settle();
    QCOMPARE(span(), (TimeWindow::Span{0.0, 1.0}));
}

void TestChartZoom::clickOnAHitGoesThere()
{
    const Hit hit = m_simulation->recording().hits().front();
    QVERIFY(m_simulation->recording().step(m_simulation->current()) != hit.step);
    const double x = m_momentum->plot().xOf(hit.time);
    QTest::mouseClick(m_momentum->plot().viewport(), Qt::LeftButton, {},
                      {qRound(x) + 2, qRound(area().center().y())});
    QCOMPARE(m_simulation->recording().step(m_simulation->current()), hit.step);
    settle();
    QVERIFY(m_momentum->plot().note());
    QVERIFY(m_energy->plot().note());
}

void TestChartZoom::noteTellsBeforeAndAfter()
{
    QVERIFY(!m_momentum->plot().note()); // the last moment is no hit
    const Hit hit = m_simulation->recording().hits().front();
    m_simulation->seek(hit.step);
    settle();
    const HitNote &note = *m_momentum->plot().note();
    QCOMPARE(note.rows.size(), std::size_t{3});
    const double m = 7800.0 * 4.0 / 3.0 * 3.14159265358979323846 * 0.008;
    QCOMPARE(note.rows[0].before, m * 2.0);
    QCOMPARE(note.rows[1].before, 0.0);
    QCOMPARE(note.rows[0].after, m * hit.afterA.x);
    QCOMPARE(note.rows[1].after, m * hit.afterB.x);
    QCOMPARE(note.rows[2].before, m * 2.0);
    QVERIFY(std::abs(note.rows[2].after - note.rows[2].before) < 1e-9);
    QVERIFY2(note.sentence().contains(QStringLiteral("both before 522.8, after 522.8, change 0")),
             qPrintable(note.sentence()));
    QVERIFY(m_momentum->plot().accessibleDescription().contains(note.sentence()));
    const HitNote &energy = *m_energy->plot().note();
    QCOMPARE(energy.rows[0].before, 0.5 * m * 4.0);
    m_momentum->setPart(MomentumPart::Y);
    settle();
    QCOMPARE(m_momentum->plot().note()->rows[0].before, 0.0);
    QCOMPARE(m_momentum->plot().note()->rows[0].after, m * hit.afterA.y);
    m_simulation->seek(hit.step + 1);
    settle();
    QVERIFY(!m_momentum->plot().note());
}

void TestChartZoom::noteOnAWallHasOneCircle()
{
    m_simulation->goTo(400);
    const auto &hits = m_simulation->recording().hits();
    const auto wall = std::find_if(hits.begin(), hits.end(),
                                   [](const Hit &hit) { return hit.kind == Hit::Kind::Wall; });
    QVERIFY(wall != hits.end());
    m_simulation->seek(wall->step);
    settle();
    QVERIFY(m_momentum->plot().note());
    QCOMPARE(m_momentum->plot().note()->rows.size(), std::size_t{1});
}

/// Of a crowd, one hit says nothing about the sums that are shown.
void TestChartZoom::noteIsMissingWhereManyHit()
{
    const HitMeasure speed = [](auto bodies) { return length(bodies.front().second); };
    for (const int count : {6, 7}) {
        Preset preset;
        preset.laws.walls = WallLaw::Reflect;
        for (int i = 0; i < count; ++i) {
            PresetCircle circle;
            circle.body = {.position = {3.5, 0.5 * i}, .velocity = {1.0, 0.0}};
            preset.circles.push_back(circle);
        }
        Simulation simulation(preset);
        simulation.seekNextHit();
        const auto shown = hitsShownAt(simulation.recording(), simulation.current());
        QVERIFY(shown && static_cast<int>(shown->count) == count);
        QCOMPARE(noteOn(simulation.recording(), simulation.current(), speed).has_value(),
                 count == 6);
    }
}

void TestChartZoom::noteInALowChartIsShort()
{
    const qint64 step = m_simulation->recording().hits().front().step;
    m_simulation->seek(step);
    settle();
    const QRectF whole = m_momentum->plot().noteRect();
    for (ChartPane *chart :
         {static_cast<ChartPane *>(m_momentum.get()), static_cast<ChartPane *>(m_energy.get())}) {
        chart->resize(356, 172); // at 1280 x 720
        settle();
        const ChartPlot &plot = chart->plot();
        const QRectF note = plot.noteRect();
        QVERIFY(plot.plotArea().contains(note));
        QVERIFY(note.width() < 0.75 * whole.width() && note.height() < whole.height());
        const double cursor = plot.xOf(m_simulation->time());
        QVERIFY(cursor < note.left() || cursor > note.right());
        for (const auto &[text, rect] : plot.labels())
            QVERIFY2(!rect.intersects(note), qPrintable(text));
    }
}

void TestChartZoom::noteLiesBetweenCurves()
{
    const QRectF plot(40.0, 4.0, 300.0, 100.0);
    const auto level = [&plot](double y) {
        return CurveProfile({{plot.left(), y}, {plot.right(), y}}, plot);
    };
    const std::vector<CurveProfile> curves{level(20.0), level(90.0)};
    const NotePlace between = quietestPlace(plot, curves, {100.0, 50.0}, 320.0);
    QCOMPARE(between.hidden, 0.0);
    QVERIFY(between.rect.top() > 20.0 && between.rect.bottom() < 90.0);
    QVERIFY(between.rect.right() < 320.0 && between.rect.right() > 300.0);
    // Of two that cannot be missed together it hides one.
    QCOMPARE(quietestPlace(plot, curves, {100.0, 70.0}, 320.0).hidden, 101.0);
}

void TestChartZoom::menuEndsTheZoom()
{
    m_window->zoomTo({1.0, 2.0}, {0.0, 4.0});
    settle();
    QMenu menu;
    m_momentum->fillMenu(menu);
    QAction *reset = actionNamed(menu, QStringLiteral("Reset zoom"));
    QVERIFY(reset && reset->isEnabled());
    reset->trigger();
    QCOMPARE(m_window->kind(), TimeWindow::Kind::All);
}

QTEST_MAIN(TestChartZoom)

#include "test_chart_zoom.moc"
