// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "tests/showing_program.h"
#include "views/values/deviation_text.h"
#include "views/values/values_model.h"
#include "views/values/values_table.h"

#include <QLabel>
#include <QMenuBar>

using namespace cradle;
using namespace cradle::windows;

namespace {

constexpr double g = 9.81;        ///< m/s²
constexpr double dt = 1.0 / 60.0; ///< s

/// Two circles under gravity that meet nothing for a second: Euler and symplectic Euler.
Preset falling()
{
    Preset preset;
    preset.gravity = {0.0, -g};
    preset.laws = {WallLaw::Reflect, CircleLaw::None, Timing::Discrete};
    preset.circles = {{.name = QStringLiteral("circle 1"), .body = {.position = {-2.0, 3.0}}},
                      {.name = QStringLiteral("circle 2"), .body = {.position = {2.0, 3.0}}}};
    preset.circles[1].integrator = Integrator::SymplecticEuler;
    return preset;
}

QAction *exactAction(OpenWindow &open)
{
    for (const QAction *menu : open.window.menuBar()->actions()) {
        for (QAction *action : menu->menu()->actions()) {
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_E))
                return action;
        }
    }
    return nullptr;
}

QStringList chips(OpenWindow &open)
{
    QStringList texts;
    for (const Chip &chip : open.window.scene().picture().chips)
        texts << chip.text;
    return texts;
}

QStringList labels(OpenWindow &open)
{
    QStringList texts;
    for (const DrawList::Label &label : open.window.scene().picture().list.labels)
        texts << label.text;
    return texts;
}

/// Lines without a head: dashes of outlines, and links.
int dashes(OpenWindow &open)
{
    int count = 0;
    for (const DrawList::Arrow &arrow : open.window.scene().picture().list.arrows)
        count += arrow.head == 0.0 ? 1 : 0;
    return count;
}

} // namespace

class TestExactMotion : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void isOffAtTheFirstStart();
    void shortcutTogglesIt();
    void choiceIsKept();
    void chipTellsTheDistance();
    void ghostsAreToldApart();
    void valuesTellTheDeviation();
    void sentenceTellsTheDeviation();
    void programsAreMeasuredByTheStep();
    void crowdIsToldThatThereIsNone();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestExactMotion::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_open = std::make_unique<OpenWindow>(*m_folder);
}

void TestExactMotion::cleanup()
{
    m_open.reset();
    m_folder.reset();
}

void TestExactMotion::isOffAtTheFirstStart()
{
    QVERIFY(exactAction(*m_open) && !exactAction(*m_open)->isChecked());
    QVERIFY(!m_open->simulation().shadow());
    QVERIFY(chips(*m_open).isEmpty());
}

void TestExactMotion::shortcutTogglesIt()
{
    m_open->press(Qt::Key_E, Qt::ControlModifier);
    QVERIFY(m_open->simulation().shadow());
    QVERIFY(exactAction(*m_open)->isChecked());
    QCOMPARE(chips(*m_open), QStringList{QStringLiteral("Exact motion; the run is 0.000 m off")});
    m_open->press(Qt::Key_E, Qt::ControlModifier);
    QVERIFY(!m_open->simulation().shadow());
    QVERIFY(!exactAction(*m_open)->isChecked());
    QVERIFY(chips(*m_open).isEmpty());
}

void TestExactMotion::choiceIsKept()
{
    exactAction(*m_open)->trigger();
    m_open.reset();
    m_open = std::make_unique<OpenWindow>(*m_folder);
    QVERIFY(m_open->simulation().shadow());
    QVERIFY(exactAction(*m_open)->isChecked());
    // Also in another step, whose scene has a motion of its own.
    m_open->bench.openTask(QStringLiteral("L42T5"));
    m_open->simulation().goTo(30);
    QVERIFY(!m_open->simulation().shadow()->circles(30).empty());
}

void TestExactMotion::chipTellsTheDistance()
{
    m_open->bench.document().open(falling());
    exactAction(*m_open)->trigger();
    m_open->simulation().goTo(60);
    // ½ g h t = 0.08175 m for both, above and below the parabola.
    QCOMPARE(chips(*m_open), QStringList{QStringLiteral("Exact motion; the run is 0.082 m off")});
    QVERIFY(m_open->window.scene().accessibleDescription().contains(
        QStringLiteral("the run is 0.082 m off")));
    QVERIFY(dashes(*m_open) >= 2 * 8); // two broken outlines
    m_open->simulation().seek(12);
    QCOMPARE(chips(*m_open), QStringList{QStringLiteral("Exact motion; the run is 0.016 m off")});
    m_open->simulation().restart();
    QCOMPARE(dashes(*m_open), 0);
}

void TestExactMotion::ghostsAreToldApart()
{
    m_open->bench.document().open(falling());
    m_open->simulation().goTo(60);
    auto ghost = std::make_shared<Recording>();
    World world = m_open->simulation().recording().world(60);
    for (Circle &circle : world.circles)
        circle.position.x += 1.0;
    ghost->append(world);
    m_open->window.scene().setGhost(ghost, QStringLiteral("reference"));
    const int dashed = dashes(*m_open);
    QVERIFY(labels(*m_open).contains(QStringLiteral("reference")));
    // A program that leaves gravity out is far from the exact motion.
    ShowingProgram program;
    m_open->simulation().setProgram(&program);
    exactAction(*m_open)->trigger();
    m_open->simulation().goTo(60);
    QVERIFY(labels(*m_open).contains(QStringLiteral("reference")));
    QVERIFY(labels(*m_open).contains(QStringLiteral("exact")));
    QVERIFY(dashes(*m_open) >= dashed + 2 * 8);
    const QStringList texts = chips(*m_open);
    QCOMPARE(texts.size(), 2);
    QVERIFY(texts[0].startsWith(QStringLiteral("Exact motion; the run is 4.905 m")));
    QVERIFY(texts[1].startsWith(QStringLiteral("ghost: reference")));
    m_open->simulation().setProgram(nullptr);
}

void TestExactMotion::valuesTellTheDeviation()
{
    Simulation simulation(falling());
    ValuesModel model(simulation);
    QCOMPARE(model.columnCount(), int(ValuesModel::Offset));
    simulation.setShadowed(true);
    QCOMPARE(model.columnCount(), int(ValuesModel::Count));
    simulation.goTo(60);
    model.refresh(0, 2);
    QVERIFY(std::abs(*model.number(0, ValuesModel::Offset) - 0.5 * g * dt) < 1e-12);
    QVERIFY(std::abs(*model.number(1, ValuesModel::Offset) - 0.5 * g * dt) < 1e-12);
    QVERIFY(!model.number(2, ValuesModel::Offset)); // distances have no sum
    const double m = mass(falling().circles[0].body);
    const double gained = 60 * 0.5 * m * g * g * dt * dt;
    QVERIFY(std::abs(*model.number(0, ValuesModel::EnergyOffset) - gained) < 1e-8);
    QVERIFY(std::abs(*model.number(1, ValuesModel::EnergyOffset) + gained) < 1e-8);
    QVERIFY(std::abs(*model.number(2, ValuesModel::EnergyOffset)) < 1e-8);
    const auto header = [&](int column, int role) {
        return model.headerData(column, Qt::Horizontal, role).toString();
    };
    QCOMPARE(header(ValuesModel::Offset, Qt::DisplayRole), QStringLiteral("Δr"));
    QCOMPARE(header(ValuesModel::Offset, ValuesModel::unitRole), QStringLiteral("m"));
    QCOMPARE(header(ValuesModel::EnergyOffset, Qt::AccessibleTextRole),
             QStringLiteral("Total energy more than in the exact motion, J"));
    simulation.setShadowed(false);
    QCOMPARE(model.columnCount(), int(ValuesModel::Offset));
}

void TestExactMotion::sentenceTellsTheDeviation()
{
    Simulation simulation(falling());
    QCOMPARE(describeDeviation(simulation), QString());
    ValuesPane pane(simulation);
    pane.resize(420, 400);
    pane.show();
    simulation.setShadowed(true);
    simulation.goTo(60);
    QCOMPARE(describeDeviation(simulation),
             QStringLiteral("Off the exact motion: 0 J, up to 0.082 m (rms 0.082 m)."));
    const auto isSeen = [&] {
        for (const auto *label : pane.findChildren<QLabel *>()) {
            if (label->isVisible() && label->text() == describeDeviation(simulation))
                return label->accessibleName() == QStringLiteral("Distance from the exact motion");
        }
        return false;
    };
    QTRY_VERIFY(isSeen());
    Preset one = falling();
    one.circles.pop_back();
    simulation.setPreset(one);
    simulation.goTo(60);
    QCOMPARE(describeDeviation(simulation),
             QStringLiteral("Off the exact motion: +209.6 J, 0.082 m."));
    QTRY_VERIFY(isSeen());
    simulation.setShadowed(false);
    QTRY_VERIFY(!isSeen());
}

void TestExactMotion::programsAreMeasuredByTheStep()
{
    // The scene of step 2 in Code mode has no walls yet; the step asks for them.
    m_open->bench.openTask(QStringLiteral("L42T2"));
    m_open->bench.setMode(Mode::Code);
    exactAction(*m_open)->trigger();
    QVERIFY(m_open->simulation().isProgrammed());
    m_open->simulation().goTo(300);
    const double x = m_open->simulation().shadow()->circles(300)[0].position.x;
    QVERIFY2(std::abs(x) <= 4.0, qPrintable(QString::number(x)));
    QVERIFY(m_open->bench.task()->laws->walls == WallLaw::Reflect);
}

void TestExactMotion::crowdIsToldThatThereIsNone()
{
    Preset crowd;
    crowd.fill = CircleFill{.count = 201, .radius = 0.05, .rmsSpeed = 1.0};
    crowd.circles = *makeCircles(*crowd.fill, crowd.halfWidth);
    m_open->bench.document().open(crowd);
    exactAction(*m_open)->trigger();
    QCOMPARE(chips(*m_open),
             QStringList{QStringLiteral("No exact motion beside more than 50 circles")});
    QCOMPARE(dashes(*m_open), 0);
    m_open->simulation().goTo(5);
    QVERIFY(m_open->simulation().shadow()->circles(5).empty());
}

QTEST_MAIN(TestExactMotion)
#include "test_exact_motion.moc"
