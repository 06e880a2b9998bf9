// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/named_controls.h"
#include "tests/gui/room_states.h"
#include "tests/patience.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QSet>

using namespace cradle;
using namespace cradle::windows;

/// Every control in every state of the window: a screen reader can name it, and Tab passes it.
class TestReachedControls final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_room = std::make_unique<StatefulRoom>(m_folder);
        QVERIFY(QTest::qWaitForWindowActive(&m_room->window(), patience));
    }
    void cleanupTestCase() { m_room.reset(); }
    void everyControlIsNamedAndPassed_data() { addStates(roomStates()); }
    void everyControlIsNamedAndPassed();

private:
    void findUnnamed(QStringList &found);
    void goRound(bool backwards);

    QTemporaryDir m_folder;
    std::unique_ptr<StatefulRoom> m_room;
};

void TestReachedControls::findUnnamed(QStringList &found)
{
    int met = 0;
    findNameless(QAccessible::queryAccessibleInterface(&m_room->window()), found, met);
    QVERIFY2(met > 120, qPrintable(QString::number(met)));
}

/// By Tab from the scene to the scene; but in programs, where Tab indents, F6 goes on.
void TestReachedControls::goRound(bool backwards)
{
    MainWindow &window = m_room->window();
    window.scene().setFocus();
    QSet<const QWidget *> met;
    bool back = false;
    for (int i = 0; i < 150 && !back; ++i) {
        QWidget *focused = QApplication::focusWidget();
        QVERIFY(focused);
        const QString name =
            QStringLiteral("%1 “%2” after %3")
                .arg(QLatin1String(focused->metaObject()->className()), focused->accessibleName())
                .arg(met.size());
        QVERIFY2(isInSight(*focused), qPrintable(name));
        met.insert(focused);
        if (window.codePane().editor().isAncestorOf(focused))
            window.focusRounds().focusNextPane(backwards ? -1 : 1);
        else
            QTest::keyClick(focused, backwards ? Qt::Key_Backtab : Qt::Key_Tab,
                            backwards ? Qt::ShiftModifier : Qt::NoModifier);
        // In the scene, Tab goes from circle to circle first.
        QVERIFY2(QApplication::focusWidget() != focused || focused == &window.scene(),
                 qPrintable(name));
        back = met.size() > 1 && QApplication::focusWidget() == &window.scene();
    }
    QVERIFY2(back, qPrintable(QString::number(met.size())));
    QVERIFY2(met.size() >= 12, qPrintable(QString::number(met.size())));
}

void TestReachedControls::everyControlIsNamedAndPassed()
{
    QFETCH(RoomState, state);
    m_room->take(state);
    QStringList found;
    for (int turn = 0; turn < StatefulRoom::turns; ++turn) {
        m_room->showBehind(turn);
        findUnnamed(found);
        goRound(false);
        goRound(true);
        if (QTest::currentTestFailed())
            return;
    }
    found.removeDuplicates();
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestReachedControls)

#include "test_reached_controls.moc"
