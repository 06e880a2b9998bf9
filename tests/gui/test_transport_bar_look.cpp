// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/transport_scene.h"
#include "tests/patience.h"
#include "views/action_button.h"
#include "views/theme.h"
#include "views/transport_bar.h"

#include <QAction>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace cradle;

/// What the transport bar shows, and how it fits.
class TestTransportBarLook final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void cleanup() { QGuiApplication::setLayoutDirection(Qt::LeftToRight); }
    void readoutDoesNotJump();
    void checkBecomesStop();
    void modesAppearFromTwoOn();
    void fitsNarrowWindows();
    void focusedControlsKeepTheirKeys();
    void iconStandsBesideTheText_data();
    void iconStandsBesideTheText();
};

void TestTransportBarLook::readoutDoesNotJump()
{
    Simulation simulation(rolling());
    TransportBar bar(simulation);
    bar.resize(1280, 48);
    bar.show();
    QVERIFY(QTest::qWaitForWindowExposed(&bar, patience));
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
    QVERIFY(QTest::qWaitForWindowActive(&window, patience));

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

void TestTransportBarLook::iconStandsBesideTheText_data()
{
    QTest::addColumn<Qt::LayoutDirection>("direction");
    QTest::newRow("left to right") << Qt::LeftToRight;
    QTest::newRow("right to left") << Qt::RightToLeft;
}

/// Also where the button is wide enough for another text than the one it shows.
void TestTransportBarLook::iconStandsBesideTheText()
{
    QFETCH(Qt::LayoutDirection, direction);
    QGuiApplication::setLayoutDirection(direction);
    QAction action(QStringLiteral("Run"));
    ActionButton button(&action);
    button.setIconName(QStringLiteral("run"));
    button.setTexts({QStringLiteral("Go on for a while")});
    button.resize(button.sizeHint());
    const QImage drawn = button.grab().toImage();
    const int middle = drawn.height() / 2;
    const auto isBlank = [&](int x) {
        for (int y = middle - 6; y <= middle + 6; ++y) {
            if (drawn.pixel(x, y) != drawn.pixel(x, middle - 8))
                return false;
        }
        return true;
    };
    constexpr int edge = 8; // px, with the border
    QList<int> inked;
    for (int x = edge; x < drawn.width() - edge; ++x) {
        if (!isBlank(x))
            inked << x;
    }
    QVERIFY(inked.size() > 10);
    int widest = 0;
    for (qsizetype i = 1; i < inked.size(); ++i)
        widest = std::max(widest, inked[i] - inked[i - 1]);
    QVERIFY2(widest < 16, qPrintable(QStringLiteral("%1 px apart").arg(widest)));
    // And both in the middle.
    const int aside = inked.front() - (drawn.width() - 1 - inked.back());
    QVERIFY2(std::abs(aside) < 10, qPrintable(QStringLiteral("%1 px aside").arg(aside)));
}

QTEST_MAIN(TestTransportBarLook)
#include "test_transport_bar_look.moc"
