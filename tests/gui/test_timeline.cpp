// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/student_script.h"
#include "tests/cpu_timer.h"
#include "tests/gui/chart_scenes.h"
#include "tests/patience.h"
#include "views/timeline.h"

#include <QAccessible>
#include <QTest>

using namespace cradle;

namespace {

/// A circle that bounces between two walls: a hit every 0.9 s or so.
Preset bouncing(double speed = 8.0)
{
    Preset preset;
    preset.laws.walls = WallLaw::Reflect;
    preset.laws.timing = Timing::Continuous;
    preset.circles = {{QStringLiteral("ball"), {{0.0, 0.0}, {speed, 0.0}}}};
    return preset;
}

bool overlapping(const std::vector<Timeline::Label> &labels)
{
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = i + 1; j < labels.size(); ++j) {
            if (labels[i].rect.intersects(labels[j].rect))
                return true;
        }
    }
    return false;
}

} // namespace

class TestTimeline final : public QObject
{
    Q_OBJECT
private slots:
    void followsTheSimulation();
    void clickAndDragSeek();
    void keysStepAndJump();
    void pageKeysGoFromHitToHit();
    void labelsNeverOverlap_data();
    void labelsNeverOverlap();
    void labelsTellEndsAndHits();
    void hitAtTheEndIsNamed();
    void marksComeFirst();
    void stoppedProgramIsMarked();
    void runsOnFromThePast();
    void isAccessibleAsSlider();
    void paintsManyHitsFast();
};

void TestTimeline::followsTheSimulation()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    run(simulation, 30);
    QCOMPARE(timeline.maximum(), 30);
    QCOMPARE(timeline.value(), 30);
    simulation.seek(7);
    QCOMPARE(timeline.value(), 7);
    simulation.restart();
    QCOMPARE(timeline.maximum(), 0);
}

void TestTimeline::clickAndDragSeek()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    timeline.resize(644, 56);
    timeline.show();
    run(simulation, 100);
    const auto at = [&](qint64 frame) {
        return QPoint(qRound(timeline.xOf(simulation.recording().time(frame))), 22);
    };
    QTest::mousePress(&timeline, Qt::LeftButton, {}, at(40));
    QCOMPARE(simulation.current(), 40);
    QTest::mouseMove(&timeline, at(75));
    QTRY_COMPARE(simulation.current(), 75);
    QTest::mouseRelease(&timeline, Qt::LeftButton, {}, at(75));
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, {643, 22});
    QCOMPARE(simulation.current(), 100);
    QTest::mouseClick(&timeline, Qt::LeftButton, {}, {0, 22});
    QCOMPARE(simulation.current(), 0);
}

void TestTimeline::keysStepAndJump()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    run(simulation, 50);
    QTest::keyClick(&timeline, Qt::Key_Left);
    QCOMPARE(simulation.current(), 49);
    QTest::keyClick(&timeline, Qt::Key_Home);
    QCOMPARE(simulation.current(), 0);
    QTest::keyClick(&timeline, Qt::Key_Right);
    QCOMPARE(simulation.current(), 1);
    QTest::keyClick(&timeline, Qt::Key_End);
    QCOMPARE(simulation.current(), 50);
    QTest::keyClick(&timeline, Qt::Key_Right);
    QCOMPARE(simulation.current(), 50); // no new step
}

void TestTimeline::pageKeysGoFromHitToHit()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    run(simulation, 200);
    const auto &hits = simulation.recording().hits();
    QVERIFY(hits.size() >= 3);
    simulation.seek(0);
    for (std::size_t i = 0; i < 3; ++i) {
        QTest::keyClick(&timeline, Qt::Key_PageDown);
        QCOMPARE(simulation.recording().step(simulation.current()), hits[i].step);
    }
    QTest::keyClick(&timeline, Qt::Key_PageUp);
    QCOMPARE(simulation.recording().step(simulation.current()), hits[1].step);
    QTest::keyClick(&timeline, Qt::Key_PageUp);
    QTest::keyClick(&timeline, Qt::Key_PageUp);
    QCOMPARE(simulation.current(), 0);
}

void TestTimeline::labelsNeverOverlap_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("width");
    for (const double speed : {2.0, 8.0, 50.0}) {
        for (const int width : {160, 640, 1920})
            QTest::addRow("%g m/s, %d px", speed, width) << speed << width;
    }
}

void TestTimeline::labelsNeverOverlap()
{
    QFETCH(double, speed);
    QFETCH(int, width);
    Simulation simulation(bouncing(speed));
    Timeline timeline(simulation);
    timeline.resize(width, 56);
    timeline.setMarks({{1.0, Timeline::Mark::Kind::Failure, QStringLiteral("wall")},
                       {1.1, Timeline::Mark::Kind::Failure, QStringLiteral("energy")}});
    for (int i = 0; i < 40; ++i) {
        run(simulation, 13);
        const auto labels = timeline.labels();
        QVERIFY(!overlapping(labels));
        for (const Timeline::Label &label : labels)
            QVERIFY(QRectF(timeline.rect()).contains(label.rect));
    }
}

void TestTimeline::labelsTellEndsAndHits()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    timeline.resize(1000, 56);
    run(simulation, 120);
    QStringList texts;
    for (const Timeline::Label &label : timeline.labels())
        texts.append(label.text);
    for (const auto &wanted : {QStringLiteral("0 s"), QStringLiteral("2.0 s"),
                               QStringLiteral("hit 1"), QStringLiteral("hit 2")})
        QVERIFY2(texts.contains(wanted), qPrintable(texts.join(u'|')));
}

void TestTimeline::hitAtTheEndIsNamed()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    timeline.resize(1000, 56);
    simulation.seekNextHit();
    QCOMPARE(simulation.current(), simulation.recording().last());
    const auto has = [&timeline](const QString &text) {
        const auto labels = timeline.labels();
        return std::any_of(labels.begin(), labels.end(),
                           [&text](const Timeline::Label &label) { return label.text == text; });
    };
    QVERIFY(has(QStringLiteral("hit 1")));
    const QString end = QStringLiteral("%1 s").arg(simulation.time(), 0, 'f', 1);
    QVERIFY(!has(end)); // there is room for one of them
    run(simulation, 120);
    QVERIFY(has(QStringLiteral("hit 1")));
    QVERIFY(has(QStringLiteral("%1 s").arg(simulation.time(), 0, 'f', 1)));
}

void TestTimeline::marksComeFirst()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    timeline.resize(300, 56);
    run(simulation, 400);
    timeline.setMarks({{2.0, Timeline::Mark::Kind::Failure, QStringLiteral("energy grows")}});
    const auto labels = timeline.labels();
    QCOMPARE(labels.front().text, QStringLiteral("energy grows"));
    QVERIFY(!timeline.grab().isNull());
}

void TestTimeline::stoppedProgramIsMarked()
{
    Simulation simulation(bouncing());
    StudentScript program(QStringLiteral("function on_update(timestep)\n"
                                         "  circle1.position = circle1.position + vec(0.01, 0)\n"
                                         "  if step > 30 then error('no more') end\n"
                                         "end"));
    simulation.setProgram(&program);
    Timeline timeline(simulation);
    timeline.resize(900, 56);
    QVERIFY(timeline.recordedMarks().empty());
    simulation.goTo(60);
    QVERIFY(simulation.programError());
    const auto marks = timeline.recordedMarks();
    QCOMPARE(marks.size(), std::size_t{1});
    QCOMPARE(marks[0].kind, Timeline::Mark::Kind::Error);
    QCOMPARE(marks[0].time, simulation.recording().time(simulation.recording().last()));
    QCOMPARE(timeline.labels().front().text, QStringLiteral("program stopped in line 3"));
    simulation.restart();
    QVERIFY(timeline.recordedMarks().empty());
    simulation.setProgram(nullptr);
}

void TestTimeline::runsOnFromThePast()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    run(simulation, 60);
    const World then = simulation.recording().world(40);
    timeline.setValue(20);
    QCOMPARE(simulation.current(), 20);
    simulation.start();
    QTRY_VERIFY(simulation.current() > 25);
    simulation.pause();
    QCOMPARE(simulation.recording().world(40), then); // what has happened happens again
    QCOMPARE(timeline.value(), static_cast<int>(simulation.current()));
    QCOMPARE(simulation.recording().last(), std::max<qint64>(60, simulation.current()));
}

void TestTimeline::isAccessibleAsSlider()
{
    Simulation simulation(bouncing());
    Timeline timeline(simulation);
    run(simulation, 20);
    QAccessibleInterface *interface = QAccessible::queryAccessibleInterface(&timeline);
    QVERIFY(interface);
    QCOMPARE(interface->role(), QAccessible::Slider);
    QVERIFY(!interface->text(QAccessible::Name).isEmpty());
    QVERIFY(interface->valueInterface());
    QCOMPARE(interface->valueInterface()->currentValue().toInt(), 20);
    interface->valueInterface()->setCurrentValue(5);
    QCOMPARE(simulation.current(), 5);
}

void TestTimeline::paintsManyHitsFast()
{
    Preset preset = bouncing(2000.0);
    preset.halfWidth = 0.3;
    Simulation simulation(preset);
    while (simulation.recording().hits().size() < 100'000)
        run(simulation, 10);
    Timeline timeline(simulation);
    timeline.resize(1400, 56);
    (void)timeline.grab();
    const CpuTimer timer;
    for (int i = 0; i < 10; ++i)
        (void)timeline.grab();
    QVERIFY2(timer.elapsed() < 500.0, qPrintable(QString::number(timer.elapsed())));
}

QTEST_MAIN(TestTimeline)

#include "test_timeline.moc"
