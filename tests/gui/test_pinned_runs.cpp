// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/chart_reading.h"
#include "tests/gui/chart_scenes.h"
#include "tests/gui/open_window.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/charts/energy_chart.h"
#include "views/charts/momentum_chart.h"
#include "views/charts/pin_legend.h"
#include "views/theme.h"

#include "model/world/measurements.h"

#include <QMenuBar>
#include <QRegularExpression>

using namespace cradle;
using namespace cradle::windows;

class TestPinnedRuns final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void pinnedCurvesKeepTheRecordedNumbers();
    void legendTellsWhatDiffers_data();
    void legendTellsWhatDiffers();
    void legendHasRoomForLargeTexts();
    void programsDiffer();
    void noMoreThanThree();
    void pinsAreRemovedFromTheMenu();
    void pinsGoWithTheirStep();
    void memoryIsBounded();
    void newRunStartsFromTheMoment();
    void oldRunIsComparedFromTheBranchOn();
    void newRunFromTheEndPinsNothing();
    void branchIsUndone();
    void impossibleBranchIsRefused();
    void sceneOffersTheBranch();

private:
    [[nodiscard]] Simulation &simulation() { return m_open->simulation(); }
    [[nodiscard]] PinnedRuns &pins() { return m_open->window.runDesk().pins(); }
    void edit(const Preset &preset)
    {
        QVERIFY(m_open->bench.document().edit(QStringLiteral("edit"), preset));
    }
    /// The curve whose label begins with \p label.
    [[nodiscard]] const ChartCurve *curve(const QString &label)
    {
        for (const ChartCurve &each : m_momentum->plot().curves()) {
            if (each.label.startsWith(label))
                return &each;
        }
        return nullptr;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
    MomentumChart *m_momentum = nullptr;
};

void TestPinnedRuns::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    m_open->bench.setMode(Mode::Explore);
    m_open->bench.document().open(glancing());
    m_momentum = m_open->window.findChild<MomentumChart *>();
    simulation().goTo(180);
}

void TestPinnedRuns::cleanup()
{
    m_open.reset();
    m_folder.reset();
}

void TestPinnedRuns::pinnedCurvesKeepTheRecordedNumbers()
{
    const World at150 = simulation().recording().world(150);
    m_open->window.runDesk().pinRun();
    Preset slower = glancing();
    slower.circles[0].body.velocity = {1.0, 0.0};
    edit(slower);
    simulation().goTo(20);
    settle();
    const ChartCurve *old = curve(QStringLiteral("pinned 1: circle 1"));
    QVERIFY(old);
    QCOMPARE(old->samples->valueAt(2.5), mass(at150.circles[0]) * at150.circles[0].velocity.x);
    const ChartCurve *now = curve(QStringLiteral("circle 1"));
    QVERIFY(now);
    QCOMPARE(now->samples->valueAt(0.2), mass(slower.circles[0].body));
    QVERIFY(old->colour != now->colour && old->dash != now->dash);
    // Beneath: drawn before the run that goes on.
    QCOMPARE(m_momentum->plot().curves().front().label.left(8), QStringLiteral("pinned 1"));
    QVERIFY(m_momentum->plot().timeSpan().to >= 3.0); // all of it is in sight
}

void TestPinnedRuns::legendTellsWhatDiffers_data()
{
    QTest::addColumn<Preset>("changed");
    QTest::addColumn<QString>("told");
    const auto add = [](const char *name, const QString &told, auto change) {
        Preset preset = glancing();
        change(preset);
        QTest::newRow(name) << preset << told;
    };
    add("nothing", QStringLiteral("pinned 1: the same scene and program"),
        [](Preset &p) { p.name = QStringLiteral("another name"); });
    add("restitution", QStringLiteral("pinned 1: e 1 → 0.8"),
        [](Preset &p) { p.restitution = 0.8; });
    add("gravity", QStringLiteral("pinned 1: g (0, 0) → (0, −9.81)"), [](Preset &p) {
        p.gravity = {0.0, -9.81};
    });
    add("velocity", QStringLiteral("pinned 1: circle 1 v (2, 0) → (3, 0)"), [](Preset &p) {
        p.circles[0].body.velocity = {3.0, 0.0};
    });
    add("integrator", QStringLiteral("pinned 1: circle 2 Euler → Runge-Kutta 4"),
        [](Preset &p) { p.circles[1].integrator = Integrator::RungeKutta4; });
    add("laws", QStringLiteral("pinned 1: timing Continuous → Discrete, circles Impulse → Stop"),
        [](Preset &p) {
            p.laws = {WallLaw::Reflect, CircleLaw::Stop, Timing::Discrete};
        });
    add("many", QStringLiteral("pinned 1: e 1 → 0.5, Δt 0.01667 → 0.01 and 2 more"), [](Preset &p) {
        p.restitution = 0.5;
        p.timestep = 0.01;
        p.circles[0].body.radius = 0.1;
        p.circles[1].body.density = 1.0;
    });
    add("circles", QStringLiteral("pinned 1: 2 → 1 circles"),
        [](Preset &p) { p.circles.pop_back(); });
}

void TestPinnedRuns::legendTellsWhatDiffers()
{
    QFETCH(Preset, changed);
    QFETCH(QString, told);
    m_open->window.runDesk().pinRun();
    edit(changed);
    QCOMPARE(m_momentum->legend().lines().size(), std::size_t{1});
    QCOMPARE(m_momentum->legend().lines().front().text, told);
    QVERIFY(m_momentum->legend().isVisible());
    QCOMPARE(m_momentum->legend().accessibleName(), told);
}

void TestPinnedRuns::legendHasRoomForLargeTexts()
{
    m_open->window.runDesk().pinRun();
    QVERIFY(m_momentum->legend().isVisibleTo(m_momentum));
    setTextScale(2.0);
    applyTheme(ThemeChoice::Light);
    QFont small = m_momentum->legend().font();
    small.setPixelSize(scaledByText(11));
    const int line = QFontMetrics(small).height();
    const auto enlarged = [&] { return m_momentum->legend().height() >= line; };
    const bool isEnlarged = QTest::qWaitFor(enlarged, patience);
    setTextScale(1.0);
    applyTheme(ThemeChoice::Light);
    QVERIFY(isEnlarged);
}

void TestPinnedRuns::programsDiffer()
{
    const RunSource laws{glancing(), {}};
    const RunSource program{glancing(), QStringLiteral("x = 1")};
    const RunSource other{glancing(), QStringLiteral("x = 2")};
    QCOMPARE(differences(laws, program), QStringList{QStringLiteral("laws → program")});
    QCOMPARE(differences(program, other), QStringList{QStringLiteral("program changed")});
    QCOMPARE(differences(program, program), QStringList{});
    // As the window has it: the text that runs.
    m_open->bench.openTask(QStringLiteral("L42T2"));
    m_open->bench.setMode(Mode::Code);
    QCOMPARE(pins().now().program, m_open->bench.code().text());
    QVERIFY(!pins().now().program.isEmpty());
    m_open->bench.setMode(Mode::Explore);
    QCOMPARE(pins().now().program, QString());
}

void TestPinnedRuns::noMoreThanThree()
{
    for (int i = 0; i < 4; ++i)
        m_open->window.runDesk().pinRun();
    QCOMPARE(pins().runs().size(), PinnedRuns::most);
    QVERIFY(m_open->says(QStringLiteral("3 runs are pinned")));
    pins().remove(2);
    m_open->window.runDesk().pinRun();
    QCOMPARE(pins().runs().back().number, 2); // the number that was free
}

void TestPinnedRuns::pinsAreRemovedFromTheMenu()
{
    QMenu menu;
    m_momentum->fillMenu(menu);
    actionNamed(menu, QStringLiteral("Pin this run"))->trigger();
    QCOMPARE(pins().runs().size(), std::size_t{1});
    menu.clear();
    m_momentum->fillMenu(menu);
    actionNamed(menu, QStringLiteral("Remove pinned 1"))->trigger();
    QVERIFY(pins().runs().empty());
    settle();
    QVERIFY(!curve(QStringLiteral("pinned")));
    QVERIFY(!m_momentum->legend().isVisible());
}

void TestPinnedRuns::pinsGoWithTheirStep()
{
    m_open->window.runDesk().pinRun();
    m_open->bench.openTask(QStringLiteral("L42T5"));
    QVERIFY(pins().runs().empty());
}

void TestPinnedRuns::memoryIsBounded()
{
    Simulation one(falling(2));
    RunCurves curves(one);
    run(one, 3000);
    const CurveSet part = curves.set().within(30'000);
    QVERIFY2(part.bytes() <= 30'000, qPrintable(QString::number(part.bytes())));
    QVERIFY(curves.bytes() > 60'000 && part.total().firstTime() > 0.0);
    QCOMPARE(part.total().lastValue(), curves.total().lastValue());
    const Recording kept = newestPart(one.recording(), 100'000);
    QVERIFY(kept.bytes() <= 100'000);
    QCOMPARE(kept.world(kept.last()).circles,
             one.recording().world(one.recording().last()).circles);
}

void TestPinnedRuns::newRunStartsFromTheMoment()
{
    simulation().seek(130); // after the hit
    const World then = simulation().recording().world(130);
    m_open->window.runDesk().startNewRunHere();
    QVERIFY(simulation().atStart());
    QCOMPARE(simulation().recording().world(0).circles, then.circles);
    QCOMPARE(pins().runs().size(), std::size_t{1});
    QCOMPARE(pins().runs().front().branch, then.time);
    // It goes on as the old one did.
    const World old = pins().runs().front().recording.world(180);
    simulation().goTo(50);
    const auto circles = simulation().recording().circles(50);
    for (std::size_t i = 0; i < circles.size(); ++i)
        QVERIFY(length(circles[i].position - old.circles[i].position) < 1e-9);
}

void TestPinnedRuns::oldRunIsComparedFromTheBranchOn()
{
    simulation().seek(60); // 1 s, before the hit at 1.8 s
    m_open->window.runDesk().startNewRunHere();
    settle();
    QVERIFY(m_momentum->legend().lines().front().text.contains(
        QStringLiteral("how it went on after 1.0")));
    simulation().goTo(10);
    settle();
    const ChartCurve *old = curve(QStringLiteral("pinned 1: circle 1"));
    QVERIFY(old);
    QCOMPARE(old->shift, 1.0);
    const auto rows = cellsOf(m_momentum->table());
    const qsizetype pinned =
        rows[0].indexOf(QRegularExpression(QStringLiteral("^pinned 1: sum.*")));
    const qsizetype now = rows[0].indexOf(QRegularExpression(QStringLiteral("^sum.*")));
    QVERIFY(pinned > 0 && now > 0);
    for (qsizetype i = 1; i < rows.size(); ++i)
        QCOMPARE(rows[i][pinned].toDouble(), rows[i][now].toDouble());
}

void TestPinnedRuns::newRunFromTheEndPinsNothing()
{
    simulation().seek(simulation().recording().last());
    m_open->window.runDesk().startNewRunHere();
    QVERIFY(simulation().atStart());
    QVERIFY(pins().runs().empty()); // nothing came after it
}

void TestPinnedRuns::branchIsUndone()
{
    simulation().seek(60);
    m_open->window.runDesk().startNewRunHere();
    QVERIFY(m_open->preset() != glancing());
    m_open->bench.document().undoStack().undo();
    QCOMPARE(m_open->preset(), glancing());
}

void TestPinnedRuns::impossibleBranchIsRefused()
{
    // Without walls the circle leaves the square; with them it may not start there.
    Preset fast = glancing();
    fast.laws.walls = WallLaw::None;
    fast.circles[0].body.velocity = {9.0, 1.0};
    edit(fast);
    simulation().goTo(120);
    m_open->window.runDesk().startNewRunHere();
    QVERIFY(simulation().atStart()); // outside is allowed where there are no walls
    pins().clear();
    simulation().goTo(5);
    m_open->bench.document().visit(glancing());
    simulation().goTo(5);
    m_open->window.runDesk().startNewRunHere();
    QVERIFY(!simulation().atStart()); // a scene of a check is not the student's
    QVERIFY(pins().runs().empty());
}

void TestPinnedRuns::sceneOffersTheBranch()
{
    simulation().seek(60);
    emit m_open->window.scene().newRunRequested();
    QVERIFY(simulation().atStart());
    QCOMPARE(pins().runs().size(), std::size_t{1});
}

QTEST_MAIN(TestPinnedRuns)

#include "test_pinned_runs.moc"
