// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/examples.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/charts/speed_histogram.h"
#include "views/charts/speed_plot.h"
#include "views/task_pane/instructions_pane.h"
#include "views/values/values_table.h"

#include <QMenuBar>
#include <QTabWidget>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// The entry of Lab → Example scenes.
QAction *entryOf(MainWindow &window, const QString &title)
{
    for (const QMenu *menu : window.menuBar()->findChildren<QMenu *>()) {
        for (QAction *action : menu->actions()) {
            if (action->text() == title)
                return action;
        }
    }
    return nullptr;
}

} // namespace

class TestExamples final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void cleanup() { setLanguage(QStringLiteral("en")); }
    void filesAreScenesWithoutFault_data();
    void filesAreScenesWithoutFault();
    void gasStartsFarFromEquilibrium();
    void gasComesToEquilibrium();
    void pistonLosesItsEnergyAtTwoBlows();
    void menuOpensThem_data();
    void menuOpensThem();
    void stepIsOneClickAway();
    void textsFollowTheLanguage();
    void idsAreTheirOwn();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestExamples::filesAreScenesWithoutFault_data()
{
    QTest::addColumn<Example>("example");
    QTest::addColumn<int>("circles");
    QTest::addColumn<double>("restitution");
    QTest::newRow("gas") << Example::Gas << 1000 << 1.0;
    QTest::newRow("piston drop") << Example::PistonDrop << 125 << 0.9;
}

void TestExamples::filesAreScenesWithoutFault()
{
    QFETCH(Example, example);
    QFile file(fileOf(example));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const Result<Preset> preset = parsePreset(file.readAll());
    QVERIFY2(preset, qPrintable(preset ? QString() : preset.error().toString()));
    QVERIFY(!findFault(*preset));
    QTEST(static_cast<int>(preset->circles.size()), "circles");
    QTEST(preset->restitution, "restitution");
    QCOMPARE(preset->laws, (Laws{WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact}));
    QCOMPARE(preset->name, titleOf(example));
}

void TestExamples::gasStartsFarFromEquilibrium()
{
    const Result<Preset> preset = readPreset(fileOf(Example::Gas));
    QVERIFY(preset);
    const World start = initialWorld(*preset);
    for (const Circle &circle : start.circles)
        QVERIFY(std::abs(length(circle.velocity) - 2.0) < 2e-4);
    QVERIFY(distanceFromMaxwell(start.circles) > 0.6);
    const double share = 1000.0 * std::numbers::pi * 0.04 / (4.0 * 12.53 * 12.53);
    QVERIFY(std::abs(share - 0.2) < 1e-3);
}

void TestExamples::gasComesToEquilibrium()
{
    const Result<Preset> preset = readPreset(fileOf(Example::Gas));
    QVERIFY(preset);
    Simulation simulation(*preset);
    simulation.goTo(120);
    const auto distanceAt = [&](qint64 step) {
        return distanceFromMaxwell(simulation.recording().circles(step));
    };
    QVERIFY(distanceAt(30) < 0.5 * distanceAt(0));
    QVERIFY2(distanceAt(120) < distanceByChance(1000),
             qPrintable(QString::number(distanceAt(120))));
}

/// What its text tells.
void TestExamples::pistonLosesItsEnergyAtTwoBlows()
{
    Result<Preset> preset = readPreset(fileOf(Example::PistonDrop));
    QVERIFY(preset);
    preset->timestep = 0.01;
    Simulation simulation(*preset);
    simulation.goTo(100);
    const auto energyAt = [&](qint64 step) {
        return measure(simulation.recording().circles(step), preset->gravity, preset->halfWidth)
            .total();
    };
    const double lost = (energyAt(91) - energyAt(99)) / energyAt(0);
    QVERIFY2(lost > 0.18 && lost < 0.22, qPrintable(QString::number(lost)));
    const double blows = (energyAt(93) - energyAt(94) + energyAt(98) - energyAt(99)) / energyAt(0);
    QVERIFY2(blows > 0.5 * lost, qPrintable(QString::number(blows)));
    const auto &hits = simulation.recording().hits();
    const auto inTheBlow = std::count_if(
        hits.begin(), hits.end(), [](const Hit &h) { return h.time > 0.93 && h.time < 0.94; });
    QVERIFY2(inTheBlow > 300, qPrintable(QString::number(inTheBlow)));
}

void TestExamples::menuOpensThem_data()
{
    QTest::addColumn<Example>("example");
    QTest::newRow("gas") << Example::Gas;
    QTest::newRow("piston drop") << Example::PistonDrop;
}

void TestExamples::menuOpensThem()
{
    QFETCH(Example, example);
    OpenWindow open(*m_folder);
    QAction *entry = entryOf(open.window, titleOf(example));
    QVERIFY(entry);
    entry->trigger();
    QCOMPARE(open.preset(), *readPreset(fileOf(example)));
    QVERIFY(!open.bench.task());
    QCOMPARE(open.window.windowTitle(), titleOf(example));
    auto *histogram = open.window.findChild<SpeedHistogram *>();
    auto &tabs = open.window.findChild<ValuesPane *>()->tabs();
    QCOMPARE(tabs.currentWidget() == histogram, showsSpeeds(example));
    if (!showsSpeeds(example))
        return;
    QTRY_VERIFY(histogram->plot().showsRun());
    // Every circle is as fast as every other: one bar holds them all.
    QCOMPARE(*std::max_element(histogram->plot().picture().shares.begin(),
                               histogram->plot().picture().shares.end()),
             1.0);
}

void TestExamples::stepIsOneClickAway()
{
    OpenWindow open(*m_folder);
    open.bench.openTask(QStringLiteral("L42T5"));
    Preset edited = open.preset();
    edited.restitution = 0.25;
    open.bench.document().edit(QStringLiteral("mine"), edited);
    open.window.opening().openExample(Example::PistonDrop);
    QVERIFY(open.preset() != edited);
    // An edit of the example is undone like any other.
    Preset bouncier = open.preset();
    bouncier.restitution = 1.0;
    QVERIFY(open.bench.document().edit(QStringLiteral("e"), bouncier));
    open.bench.document().undoStack().undo();
    QCOMPARE(open.preset(), *readPreset(fileOf(Example::PistonDrop)));
    open.bench.openTask(QStringLiteral("L42T5"));
    QCOMPARE(open.preset(), edited);
    QVERIFY(!open.bench.example());
    // The speeds that the gas brought to the front go back with it.
    auto &tabs = open.window.findChild<ValuesPane *>()->tabs();
    open.window.opening().openExample(Example::Gas);
    open.bench.openTask(QStringLiteral("L42T5"));
    QCOMPARE(tabs.currentIndex(), 0);
}

void TestExamples::textsFollowTheLanguage()
{
    OpenWindow open(*m_folder);
    open.window.opening().openExample(Example::PistonDrop);
    QCOMPARE(open.window.windowTitle(), QStringLiteral("Piston drop"));
    open.window.choices().chooseLanguage(QStringLiteral("de"));
    QCOMPARE(open.window.windowTitle(), QStringLiteral("Fallender Kolben"));
    QTRY_VERIFY(entryOf(open.window, QStringLiteral("Fallender Kolben")));
}

void TestExamples::idsAreTheirOwn()
{
    for (const Example example : allExamples)
        QCOMPARE(exampleFromId(idOf(example)), std::optional(example));
    QVERIFY(!exampleFromId(QStringLiteral("steam")));
}

QTEST_MAIN(TestExamples)

#include "test_examples.moc"
