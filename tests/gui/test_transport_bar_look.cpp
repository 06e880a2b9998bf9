// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/transport_scene.h"
#include "views/action_button.h"
#include "views/theme.h"
#include "views/transport_bar.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QVBoxLayout>

using namespace cradle;

/// What the transport bar shows, and how it fits.
class TestTransportBarLook final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void readoutDoesNotJump();
    void checkBecomesStop();
    void modesAppearFromTwoOn();
    void fitsNarrowWindows();
    void focusedControlsKeepTheirKeys();
};

void TestTransportBarLook::readoutDoesNotJump()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.resize(1280, 48);
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar));
    const auto places = [&] {
        QList<QRect> all;
        for (const QLabel *label : bar.findChildren<QLabel *>())
            all.append(label->geometry());
        return all;
    };
    const QList<QRect> before = places();
    for (int i = 0; i < 1000; ++i)
        simulation.stepForward();
    bar.slowerAction()->trigger();
    QCoreApplication::processEvents();
    QCOMPARE(places(), before);
}

void TestTransportBarLook::checkBecomesStop()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.show();
    QSignalSpy requested(&bar, &TransportBar::checkRequested);
    QSignalSpy cancelled(&bar, &TransportBar::checkCancelled);
    auto *progress = bar.findChild<QProgressBar *>();
    QVERIFY(!progress->isVisible());
    bar.checkAction()->trigger();
    QCOMPARE(requested.size(), 1);
    bar.setChecking(true);
    bar.setCheckProgress(0.25);
    QCOMPARE(bar.checkAction()->text(), QStringLiteral("Stop"));
    QVERIFY(progress->isVisible());
    QCOMPARE(progress->value(), progress->maximum() / 4);
    QTest::mouseClick(buttonOf(bar, QStringLiteral("Stop")), Qt::LeftButton);
    QCOMPARE(cancelled.size(), 1);
    QCOMPARE(requested.size(), 1);
    bar.setChecking(false);
    QCOMPARE(bar.checkAction()->text(), QStringLiteral("Check"));
    QVERIFY(!progress->isVisible());
}

void TestTransportBarLook::modesAppearFromTwoOn()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.show();
    const auto segment = [&](const QString &name) -> QPushButton * {
        for (QPushButton *button : bar.findChildren<QPushButton *>()) {
            if (button->accessibleName() == name && button->isVisible())
                return button;
        }
        return nullptr;
    };
    bar.setModes({QStringLiteral("Explore")}, 0);
    QVERIFY(!segment(QStringLiteral("Explore")));
    bar.setModes({QStringLiteral("Explore"), QStringLiteral("Code")}, 0);
    QVERIFY(segment(QStringLiteral("Explore"))->isChecked());
    QSignalSpy chosen(&bar, &TransportBar::modeChosen);
    QTest::mouseClick(segment(QStringLiteral("Code")), Qt::LeftButton);
    QCOMPARE(chosen.size(), 1);
    QCOMPARE(chosen.front().front().toInt(), 1);
}

void TestTransportBarLook::fitsNarrowWindows()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    for (const int width : {1280, 900, bar.minimumSizeHint().width()}) {
        bar.resize(width, 48);
        bar.show();
        QCoreApplication::processEvents();
        QCOMPARE(bar.width(), width);
        int right = 0;
        for (ActionButton *button : bar.findChildren<ActionButton *>()) {
            QVERIFY(button->geometry().left() >= right);
            right = button->geometry().right();
            QVERIFY(button->width() >= button->minimumSizeHint().width());
            QVERIFY(!button->accessibleName().isEmpty());
        }
        QVERIFY(right < width);
    }
}

void TestTransportBarLook::focusedControlsKeepTheirKeys()
{
    Simulation simulation(rolling());
    QWidget window;
    auto *column = new QVBoxLayout(&window);
    auto *bar = new TransportBar(simulation);
    auto *line = new QLineEdit;
    auto *table = new QTableWidget(1, 3);
    column->addWidget(bar);
    column->addWidget(line);
    column->addWidget(table);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));

    line->setFocus();
    QTest::keyClicks(line, QStringLiteral("r n"));
    QCOMPARE(line->text(), QStringLiteral("r n"));
    QVERIFY(!simulation.isRunning());

    table->setCurrentCell(0, 0);
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Right);
    QCOMPARE(table->currentColumn(), 1);
    QCOMPARE(simulation.current(), 0);

    auto *slider = bar->findChild<QSlider *>();
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QCOMPARE(simulation.speed(), 2.0);
    QCOMPARE(simulation.current(), 0);

    ActionButton *step = buttonOf(*bar, QStringLiteral("Next hit"));
    step->setFocus();
    QTest::keyClick(step, Qt::Key_Space);
    QVERIFY(!simulation.isRunning());
    QVERIFY(simulation.current() > 0);
}

QTEST_MAIN(TestTransportBarLook)
#include "test_transport_bar_look.moc"
