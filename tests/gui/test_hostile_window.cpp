// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_window.h"

#include "app/code_session.h"

#include "../hostile_programs.h"
#include "tests/patience.h"

#include <QTimer>

using namespace cradle;
using namespace cradle::programs;
using cradle::windows::OpenWindow;

/// Programs that hang or overflow, run in the window: it says so and lives on.
class TestHostileWindow final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void windowLivesOn_data();
    void windowLivesOn();

private:
    QTemporaryDir m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestHostileWindow::initTestCase()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.setMode(Mode::Code);
}

void TestHostileWindow::windowLivesOn_data()
{
    QTest::addColumn<HostileProgram>("program");
    for (const auto &programs : {endlessPrograms(), overflowingPrograms()}) {
        // Half of them: all run without a window in test_hostile_scripts.
        for (std::size_t i = 0; i < programs.size(); i += 2)
            QTest::newRow(programs[i].name) << programs[i];
    }
}

void TestHostileWindow::windowLivesOn()
{
    QFETCH(HostileProgram, program);
    Simulation &simulation = m_open->simulation();
    m_open->bench.code().replace(program.source);
    simulation.start();
    const bool ends = program.kind != QByteArray(noKind);
    QTRY_VERIFY(simulation.programError() || m_open->bench.code().run().fault()
                || (!ends && simulation.recording().last() > 3));
    QVERIFY(!ends || !simulation.isRunning() || m_open->bench.code().run().fault());
    // It answers, and a sound program runs at once.
    bool answered = false;
    QTimer::singleShot(0, &m_open->window, [&answered] { answered = true; });
    QTRY_VERIFY(answered);
    m_open->bench.code().replace(QStringLiteral("circle1.velocity = vec(1, 0)"));
    QVERIFY(!simulation.programError());
    simulation.restart();
    simulation.goTo(60);
    QCOMPARE(simulation.recording().last(), 60);
}

QTEST_MAIN(TestHostileWindow)
#include "test_hostile_window.moc"
