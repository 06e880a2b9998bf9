// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include "git_home.h"
#include "tasks/reading/lab_reader.h"
#include "tests/patience.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

#include <algorithm>

using namespace cradle;

namespace {

/// A check that went wrong in the third step of \p scene.
CheckOutcome momentIn(const Preset &scene)
{
    CheckOutcome outcome;
    outcome.step = 3;
    outcome.variant = QStringLiteral("preset");
    outcome.scene = scene;
    return outcome;
}

} // namespace

/// What runs when a step is opened, and when a check has gone wrong in it.
class TestOpenedSteps final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_bench.reset(); }
    void openedStepStartsOneRun_data();
    void openedStepStartsOneRun();
    void lawsOfTheStepAreThoseOfItsShadow();
    void brokenProgramIsToldAfterItsText();
    void referenceComesWhenItHasRun();
    void referenceOfALeftMomentDoesNotCome();

private:
    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Workbench> m_bench;
};

void TestOpenedSteps::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_bench = std::make_unique<Workbench>(m_folder->filePath(QStringLiteral("progress.json")));
    const auto error = m_bench->openLab(QLatin1String(shippedLab), QStringLiteral("en"));
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
}

void TestOpenedSteps::openedStepStartsOneRun_data()
{
    QTest::addColumn<bool>("programs");
    QTest::addColumn<bool>("visits");
    QTest::newRow("Explore") << false << false;
    QTest::newRow("Code") << true << false;
    QTest::newRow("Code, from a scene of the check") << true << true;
}

void TestOpenedSteps::openedStepStartsOneRun()
{
    QFETCH(bool, programs);
    QFETCH(bool, visits);
    m_bench->openTaskAt(1);
    m_bench->setMode(Mode::Code);
    m_bench->code().replace(m_bench->task()->solution);
    m_bench->openTaskAt(0);
    m_bench->setMode(programs ? Mode::Code : Mode::Explore);
    if (visits)
        m_bench->document().visit(m_bench->lab().tasks[3].preset);
    Simulation &simulation = m_bench->simulation();
    QSignalSpy restarted(&simulation, &Simulation::restarted);
    m_bench->openTaskAt(1);
    QCOMPARE(restarted.size(), 1);
    QVERIFY(simulation.basePreset() == m_bench->task()->preset);
    QCOMPARE(simulation.isProgrammed(), programs);
    QVERIFY(!m_bench->document().isVisiting());
    // That run is of the program that the step has, and goes on.
    simulation.goTo(10);
    QCOMPARE(simulation.recording().last(), qint64{10});
    QCOMPARE(m_bench->code().run().text(), programs ? m_bench->task()->solution : QString());
    QCOMPARE(restarted.size(), 1);
}

/// They hold from the start, and there is one.
void TestOpenedSteps::lawsOfTheStepAreThoseOfItsShadow()
{
    Simulation &simulation = m_bench->simulation();
    simulation.setShadowed(true);
    m_bench->setMode(Mode::Code);
    for (const Task &task : m_bench->lab().tasks) {
        QVERIFY(m_bench->openTask(task.id));
        m_bench->code().replace(task.solution);
        m_bench->openTaskAt(0);
        QVERIFY(m_bench->openTask(task.id));
        const Laws laws = simulation.isProgrammed() ? task.laws.value_or(simulation.preset().laws)
                                                    : simulation.preset().laws;
        ShadowRun expected(simulation.preset(), laws);
        simulation.goTo(120);
        expected.follow(simulation.recording());
        QVERIFY(std::ranges::equal(simulation.shadow()->circles(120), expected.circles(120)));
    }
}

void TestOpenedSteps::brokenProgramIsToldAfterItsText()
{
    m_bench->setMode(Mode::Code);
    m_bench->openTaskAt(1);
    m_bench->code().replace(QStringLiteral("function on_load() error('no') end\n"));
    m_bench->openTaskAt(0);
    QStringList told;
    connect(&m_bench->code(), &CodeSession::opened, this, [&] { told += QStringLiteral("text"); });
    connect(&m_bench->simulation(), &Simulation::programFailed, this,
            [&] { told += QStringLiteral("error"); });
    m_bench->openTaskAt(1);
    QCOMPARE(told, (QStringList{QStringLiteral("text"), QStringLiteral("error")}));
}

void TestOpenedSteps::referenceComesWhenItHasRun()
{
    m_bench->setMode(Mode::Code);
    m_bench->openTaskAt(0);
    m_bench->moment().show(momentIn(m_bench->task()->preset));
    QCOMPARE(m_bench->simulation().current(), qint64{3});
    QVERIFY(!m_bench->moment().ghost()); // events go on meanwhile
    QTRY_VERIFY(m_bench->moment().ghost());
    QCOMPARE(m_bench->moment().ghost()->circleCount(), m_bench->task()->preset.circles.size());
    QVERIFY(m_bench->moment().ghost()->last() > 600);
    // One moment's reference is not shown at another.
    m_bench->moment().show(momentIn(m_bench->lab().tasks[1].preset));
    QVERIFY(!m_bench->moment().ghost());
    QTRY_VERIFY(m_bench->moment().ghost());
}

void TestOpenedSteps::referenceOfALeftMomentDoesNotCome()
{
    m_bench->setMode(Mode::Code);
    m_bench->openTaskAt(0);
    m_bench->moment().show(momentIn(m_bench->lab().tasks[1].preset));
    QVERIFY(m_bench->document().isVisiting());
    m_bench->document().leave();
    QVERIFY(QThreadPool::globalInstance()->waitForDone(patience));
    QCoreApplication::processEvents();
    QVERIFY(!m_bench->moment().ghost());
}

QTEST_GUILESS_MAIN(TestOpenedSteps)
#include "test_opened_steps.moc"
