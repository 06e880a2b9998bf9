// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_code.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/code/code_pane.h"

#include <QAction>
#include <QSignalSpy>
#include <QTableWidget>

using namespace cradle;

class TestCodePane final : public CodeTest
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init() { openAnew(); }
    void cleanup() { m_open.reset(); }

    void findsAndCounts();
    void replacesOneAndAll();
    void headerSaysStateAndRuns();
    void steppingShowsLocals();
    void solutionIsReadOnlyBeside();
    void solutionWaitsForPassing();
    void staysReadableInEveryWidth_data();
    void staysReadableInEveryWidth();
    void tellsWhatIsSavedInLargeTexts_data();
    void tellsWhatIsSavedInLargeTexts();
};

void TestCodePane::findsAndCounts()
{
    m_open->editor().setText(s("vec Vec vector\nvec\n"));
    m_open->press(Qt::Key_F, Qt::ControlModifier);
    QCOMPARE(OpenCode::focused()->accessibleName(), s("Find"));
    m_open->type("vec");
    QVERIFY(m_open->says(s("1 of 4")));
    QCOMPARE(m_open->editor().selectedText(), s("vec"));
    m_open->press(Qt::Key_F3);
    QVERIFY(m_open->says(s("2 of 4")));
    m_open->press(Qt::Key_F3, Qt::ShiftModifier);
    m_open->press(Qt::Key_F3, Qt::ShiftModifier);
    QVERIFY(m_open->says(s("4 of 4")));
    QTest::mouseClick(m_open->shown<QAbstractButton>(s("Match case")), Qt::LeftButton);
    QTest::mouseClick(m_open->shown<QAbstractButton>(s("Whole words")), Qt::LeftButton);
    QVERIFY(m_open->says(s("2 of 2")));
    m_open->shown<QLineEdit>(s("Find"))->setFocus();
    m_open->type("q");
    QVERIFY(m_open->says(s("no match")));
    m_open->press(Qt::Key_Escape);
    QVERIFY(!m_open->shown<QLineEdit>(s("Find")));
    QVERIFY(m_open->editor().isAncestorOf(OpenCode::focused()));
}

void TestCodePane::replacesOneAndAll()
{
    m_open->editor().setText(s("a b a b a\nü a"));
    QSignalSpy edited(&m_open->pane, &CodePane::textEdited);
    m_open->press(Qt::Key_H, Qt::ControlModifier);
    m_open->type("a");
    m_open->shown<QLineEdit>(s("Replace by"))->setFocus();
    m_open->type("aa");
    m_open->press(Qt::Key_Return);
    QCOMPARE(m_open->editor().text(), s("aa b a b a\nü a"));
    for (auto *button : m_open->window.findChildren<QPushButton *>()) {
        if (button->text() == s("Replace all"))
            QTest::mouseClick(button, Qt::LeftButton);
    }
    QCOMPARE(m_open->editor().text(), s("aaaa b aa b aa\nü aa"));
    QVERIFY(m_open->says(s("5 replaced")));
    QTRY_VERIFY(!edited.isEmpty());
    m_open->editor().undo();
    QCOMPARE(m_open->editor().text(), s("aa b a b a\nü a"));
}

void TestCodePane::headerSaysStateAndRuns()
{
    QSignalSpy applied(&m_open->pane, &CodePane::applyRequested);
    QSignalSpy toggled(&m_open->pane, &CodePane::appliesAtOnceChanged);
    QTest::mouseClick(m_open->shown<QPushButton>(s("Run code")), Qt::LeftButton);
    QCOMPARE(applied.size(), 1);
    m_open->editor().setFocus();
    m_open->press(Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(applied.size(), 2);
    QVERIFY(m_open->pane.appliesAtOnce());
    m_open->shown<QPushButton>(s("Run as I type"))->click();
    QVERIFY(!m_open->pane.appliesAtOnce());
    QCOMPARE(toggled.size(), 1);
    m_open->pane.setAppliesAtOnce(true);
    QCOMPARE(toggled.size(), 1);
    m_open->pane.setState(CodeState::Broken);
    QVERIFY(m_open->says(s("cannot be read: the last good version runs")));
    m_open->pane.setState(CodeState::NeverRan);
    QVERIFY(m_open->says(s("cannot be read: nothing runs")));
    m_open->pane.setState(CodeState::Unsaved);
    QVERIFY(m_open->says(s("not saved")));
}

void TestCodePane::steppingShowsLocals()
{
    auto *step = m_open->shown<QPushButton>(s("Step into line"));
    auto *finish = m_open->shown<QPushButton>(s("Finish step"));
    QVERIFY(!step->isEnabled() && !finish->isEnabled());
    QSignalSpy stepped(&m_open->pane, &CodePane::lineStepRequested);
    QSignalSpy finished(&m_open->pane, &CodePane::finishStepRequested);
    m_open->pane.setStepping(true);
    step->click();
    finish->click();
    QCOMPARE(stepped.size(), 1);
    QCOMPARE(finished.size(), 1);
    m_open->editor().setText(s("local a = 1\nlocal b = 2\n"));
    QVERIFY(!m_open->shown<QTableWidget>());
    m_open->pane.setExecuting(2);
    m_open->pane.showLocals({{s("a"), s("1")}, {s("v"), s("(2, 0)")}});
    const auto *table = m_open->shown<QTableWidget>();
    QVERIFY(table);
    QCOMPARE(table->rowCount(), 2);
    QVERIFY(table->width() < m_open->editor().width() / 3); // no wider than such names need
    QCOMPARE(table->item(1, 1)->text(), s("(2, 0)"));
    QVERIFY(!m_open->says(s("None at this line")));
    m_open->pane.showLocals({});
    QVERIFY(m_open->says(s("None at this line")));
    m_open->pane.setStepping(false);
    QVERIFY(!m_open->says(s("None at this line")));
    QCOMPARE(m_open->editor().executingLine(), 0);
}

void TestCodePane::solutionIsReadOnlyBeside()
{
    m_open->pane.setSolutionAvailable(true);
    m_open->pane.showSolution(s("circle1.velocity = vec(2, 0)\n"));
    CodeEditor *solution = m_open->shown<CodeEditor>(s("Reference solution"));
    QVERIFY(solution);
    QVERIFY(solution->isReadOnly());
    solution->setFocus();
    m_open->type("x");
    m_open->press(Qt::Key_Return);
    m_open->press(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(m_open->offered().isEmpty());
    QCOMPARE(solution->text(), s("circle1.velocity = vec(2, 0)\n"));
    QSignalSpy asked(&m_open->pane, &CodePane::helpRequested);
    m_open->press(Qt::Key_F1);
    QCOMPARE(asked.front().front().toString(), s("circle1"));
    m_open->press(Qt::Key_Tab); // nothing to indent: it leaves
    QVERIFY(!solution->isAncestorOf(OpenCode::focused()));
    solution->setFocus();
    m_open->press(Qt::Key_Escape);
    QVERIFY(!m_open->pane.isSolutionShown());
    QVERIFY(m_open->editor().isAncestorOf(OpenCode::focused()));
}

void TestCodePane::solutionWaitsForPassing()
{
    QSignalSpy asked(&m_open->pane, &CodePane::solutionRequested);
    QAction *action = nullptr;
    for (QAction *each : m_open->pane.findChildren<QAction *>()) {
        if (each->text() == s("Show the reference solution"))
            action = each;
    }
    QVERIFY(action);
    QVERIFY(!action->isEnabled());
    QVERIFY(action->toolTip().startsWith(s("After you have passed")));
    m_open->pane.setSolutionAvailable(true);
    action->trigger();
    QCOMPARE(asked.size(), 1);
    m_open->pane.showSolution(s("x"));
    QCOMPARE(action->text(), s("Hide the reference solution"));
    action->trigger();
    QVERIFY(!m_open->pane.isSolutionShown());
    QCOMPARE(asked.size(), 1);
}

void TestCodePane::staysReadableInEveryWidth_data()
{
    QTest::addColumn<int>("width");
    for (const int width : {460, 560, 700, 1200})
        QTest::addRow("%d px", width) << width;
}

void TestCodePane::staysReadableInEveryWidth()
{
    QFETCH(const int, width);
    CodePane pane;
    pane.setState(CodeState::Broken);
    pane.setStepping(true);
    pane.resize(width, 264);
    pane.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pane, patience));
    QVERIFY2(pane.minimumSizeHint().width() <= 460,
             qPrintable(QString::number(pane.minimumSizeHint().width())));
    QList<QRect> places;
    for (auto *button : pane.findChildren<QAbstractButton *>()) {
        if (button->isVisible() && button->parentWidget()->parentWidget() == &pane)
            places.append(QRect(button->mapTo(&pane, QPoint()), button->size()));
    }
    QVERIFY(places.size() >= 5);
    for (int i = 0; i < places.size(); ++i) {
        QVERIFY(pane.rect().contains(places[i]));
        for (int j = 0; j < i; ++j)
            QVERIFY(!places[i].intersects(places[j]));
    }
}

void TestCodePane::tellsWhatIsSavedInLargeTexts_data()
{
    QTest::addColumn<int>("percent");
    for (const int percent : {100, 125, 150, 175, 200})
        QTest::addRow("%d %%", percent) << percent;
}

void TestCodePane::tellsWhatIsSavedInLargeTexts()
{
    QFETCH(const int, percent);
    setTextScale(percent / 100.0);
    m_open->pane.setState(CodeState::Saved);
    for (const int width : {486, 560, 1200}) { // the first as in a window of 1440 px
        m_open->window.resize(width, 500);
        settle();
        QVERIFY(m_open->says(s("saved")));
        const auto *atOnce = m_open->shown<QPushButton>(s("Run as I type"));
        const auto *run = m_open->shown<QPushButton>(s("Run code"));
        QVERIFY(atOnce->width() >= atOnce->sizeHint().width()); // its name is whole
        // In a row of its own where there is no room beside the other buttons, and only there.
        if (width == 1200 || percent == 100)
            QCOMPARE(atOnce->y(), run->y());
        else if (percent == 200)
            QVERIFY(atOnce->y() >= run->geometry().bottom());
    }
    setTextScale(1.0);
}

QTEST_MAIN(TestCodePane)
#include "test_code_pane.moc"
