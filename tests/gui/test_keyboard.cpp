// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/timeline.h"

#include <QTextBrowser>

#include <algorithm>

using namespace cradle;
using namespace cradle::windows;

/// The whole window by keys alone: nothing keeps the focus, and nothing has it that is not seen.
class TestKeyboard final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void init();
    void f6GoesRoundThePanes_data();
    void f6GoesRoundThePanes();
    void controlLGoesIntoTheProgram();
    void hiddenInspectorChangesNothing();
    void f11IsFullScreen();
    void everyKeyIsListedOnce();
    void wholeStepByKeysAlone();

private:
    /// A key, wherever the keyboard is.
    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    [[nodiscard]] static bool isSeen(const QWidget *widget)
    {
        if (!widget || !widget->isEnabled() || !widget->isVisible())
            return false;
        QRect rect = widget->rect();
        for (const QWidget *w = widget; !w->isWindow(); w = w->parentWidget())
            rect = rect.translated(w->pos()).intersected(w->parentWidget()->rect());
        return !rect.isEmpty();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestKeyboard::init()
{
    m_open.reset();
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.openTask(QStringLiteral("L42T11"));
    m_open->window.resize(1440, 900);
}

void TestKeyboard::f6GoesRoundThePanes_data()
{
    QTest::addColumn<Mode>("mode");
    QTest::newRow("explore") << Mode::Explore;
    QTest::newRow("code") << Mode::Code;
}

void TestKeyboard::f6GoesRoundThePanes()
{
    QFETCH(Mode, mode);
    m_open->bench.setMode(mode);
    calm(m_open->window);
    m_open->window.scene().setFocus();
    QList<const QWidget *> met;
    do {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
        met.append(QApplication::focusWidget());
        QVERIFY(isSeen(met.last()));
    } while (met.last() != &m_open->window.scene() && met.size() < 20);
    QVERIFY(met.size() >= 6 && met.size() < 20);
    QVERIFY(met.contains(m_open->window.findChild<Timeline *>()));
    const CodeEditor &editor = m_open->window.codePane().editor();
    const bool hasCode = std::any_of(met.begin(), met.end(), [&](const QWidget *each) {
        return each == &editor || editor.isAncestorOf(each);
    });
    QCOMPARE(hasCode, mode == Mode::Code);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget(), met.at(met.size() - 2));
}

void TestKeyboard::controlLGoesIntoTheProgram()
{
    m_open->bench.setMode(Mode::Explore);
    QTest::keyClick(&m_open->window.scene(), Qt::Key_L, Qt::ControlModifier);
    QVERIFY(m_open->bench.mode() == Mode::Code);
    const CodeEditor &editor = m_open->window.codePane().editor();
    QVERIFY(&editor == QApplication::focusWidget()
            || editor.isAncestorOf(QApplication::focusWidget()));
}

void TestKeyboard::hiddenInspectorChangesNothing()
{
    m_open->bench.setMode(Mode::Code);
    calm(m_open->window);
    const Preset before = m_open->preset();
    auto *table = m_open->window.inspector().findChild<QTableView *>();
    QVERIFY(!isSeen(table));
    table->setFocus();
    QVERIFY(!table->hasFocus());
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("9"));
    QVERIFY(m_open->preset() == before);
}

void TestKeyboard::f11IsFullScreen()
{
    QTest::keyClick(&m_open->window.scene(), Qt::Key_F11);
    QVERIFY(m_open->window.isFullScreen());
    QTest::keyClick(&m_open->window.scene(), Qt::Key_F11);
    QVERIFY(!m_open->window.isFullScreen());
}

/// With words that say what it does: the scene and the charts both zoom in.
void TestKeyboard::everyKeyIsListedOnce()
{
    QStringList lines;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&] {
        QWidget *dialog = QApplication::activeModalWidget();
        if (!dialog)
            return;
        timer.stop();
        lines = dialog->findChild<QTextBrowser *>()->toPlainText().split(u'\n');
        dialog->close();
    });
    timer.start(20);
    m_open->window.help().showShortcuts();
    for (const char *line :
         {"Zoom in", "Charts · Zoom in", "Larger text", "Words that fit here",
          "Comment lines, or not", "Out of the program", "Remove what is selected"})
        QVERIFY2(std::any_of(lines.begin(), lines.end(),
                             [&](const QString &each) {
                                 return each.trimmed() == QString::fromUtf8(line);
                             }),
                 line);
    for (const QString &line : lines) {
        QVERIFY2(!line.trimmed().startsWith(u'·'), qPrintable(line));
        const bool isKey = line.contains(u'+') || line.trimmed().size() < 3;
        QVERIFY2(isKey || lines.count(line) == 1 || line.trimmed().isEmpty(), qPrintable(line));
    }
}

/// From the window as it opens to the next step: nothing is clicked, and nothing is given the
/// focus.
void TestKeyboard::wholeStepByKeysAlone()
{
    m_open.reset();
    const QTemporaryDir fresh;
    m_open = std::make_unique<OpenWindow>(fresh);
    QVERIFY(isSeen(QApplication::focusWidget()));
    QCOMPARE(m_open->bench.current(), 0);
    press(Qt::Key_L, Qt::ControlModifier); // into the program
    press(Qt::Key_A, Qt::ControlModifier);
    QStringList lines = m_open->bench.task()->solution.split(u'\n');
    lines.removeIf([](const QString &line) { return line.trimmed().startsWith(u"--"); });
    for (const QString &line : lines) { // the editor indents
        for (const QChar letter : line.trimmed())
            QTest::keyClick(QApplication::focusWidget(), letter.toLatin1());
        press(Qt::Key_Return);
    }
    const CodeEditor &editor = m_open->window.codePane().editor();
    QTRY_COMPARE(m_open->bench.code().text(), editor.text());
    press(Qt::Key_Escape);
    press(Qt::Key_Tab); // out of the program
    for (int panes = 0; !m_open->window.scene().hasFocus() && panes < 20; ++panes)
        press(Qt::Key_F6);
    QVERIFY(m_open->window.scene().hasFocus());
    press(Qt::Key_Space);
    QTRY_VERIFY(m_open->simulation().time() > 0.1);
    press(Qt::Key_Return, Qt::ControlModifier);
    QTRY_VERIFY(m_open->bench.check().report() && !m_open->bench.check().awaitsRun());
    QVERIFY(m_open->bench.check().report()->passed);
    press(Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(m_open->bench.current(), 1);
    QVERIFY(m_open->isTicked(0));
    QVERIFY(isSeen(QApplication::focusWidget()));
}

QTEST_MAIN(TestKeyboard)

#include "test_keyboard.moc"
