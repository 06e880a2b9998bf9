// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_code.h"
#include "tests/patience.h"
#include "views/code/code_colours.h"

#include <Qsci/qsciscintilla.h>

#include <QImage>
#include <QScrollBar>
#include <QSignalSpy>
#include <QWheelEvent>

using namespace cradle;

class TestCodeEditor final : public CodeTest
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init() { openAnew(); }
    void cleanup() { m_open.reset(); }

    void typingIsAnEditAndSetTextIsNone();
    void newTextHasNoUndo();
    void indentsLikeLua();
    void wordsThatOnlyBeginLikeEndStayIndented();
    void bothWaysOutByKeyboard();
    void knowsWordsForHelp_data();
    void knowsWordsForHelp();
    void marksStandWithTheirLines();
    void errorAfterTheLastLineIsShown();
    void messageIsScrolledIntoSight();
    void zoomsByKeyAndWheel();
    void commentsAndUncomments();
    void everyColourCanBeRead();
    void foldsAreMarkedByArrows();
};

void TestCodeEditor::typingIsAnEditAndSetTextIsNone()
{
    QSignalSpy edited(&m_open->pane, &CodePane::textEdited);
    m_open->editor().setText(s("x = 1\n"));
    QCOMPARE(edited.size(), 0);
    m_open->type("a");
    QTRY_COMPARE(edited.size(), 1);
    QCOMPARE(m_open->editor().text(), s("ax = 1\n"));
    m_open->press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(edited.size(), 2);
    QCOMPARE(m_open->editor().text(), s("x = 1\n"));
    m_open->press(Qt::Key_Y, Qt::ControlModifier);
    QTRY_COMPARE(edited.size(), 3);
    m_open->editor().setError(1, s("wrong"));
    m_open->editor().setSuspect(1);
    QTRY_COMPARE(edited.size(), 3);
}

void TestCodeEditor::newTextHasNoUndo()
{
    m_open->type("abc");
    m_open->editor().setText(s("other\r\nfile\r\n"));
    QCOMPARE(m_open->editor().text(), s("other\nfile\n"));
    QVERIFY(!m_open->editor().canUndo());
    m_open->press(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_open->editor().text(), s("other\nfile\n"));
}

void TestCodeEditor::indentsLikeLua()
{
    m_open->type("function f()\nif x then\ny = {\n1\n}\nelse\nz()\nend\nend\nw()");
    QCOMPARE(m_open->editor().text(), s("function f()\n"
                                        "  if x then\n"
                                        "    y = {\n"
                                        "      1\n"
                                        "    }\n"
                                        "  else\n"
                                        "    z()\n"
                                        "  end\n"
                                        "end\n"
                                        "w()"));
    m_open->editor().setText({});
    m_open->press(Qt::Key_Tab);
    QCOMPARE(m_open->editor().text(), s("  "));
    m_open->press(Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(m_open->editor().text(), QString());
}

void TestCodeEditor::wordsThatOnlyBeginLikeEndStayIndented()
{
    m_open->type("do\nendpoint");
    m_open->press(Qt::Key_Escape);
    QCOMPARE(m_open->editor().text(), s("do\n  endpoint"));
}

void TestCodeEditor::bothWaysOutByKeyboard()
{
    m_open->press(Qt::Key_Tab, Qt::ControlModifier);
    QVERIFY(!m_open->editor().isAncestorOf(OpenCode::focused()));
    QCOMPARE(m_open->editor().text(), QString());
    m_open->editor().setFocus();
    m_open->press(Qt::Key_Escape);
    m_open->press(Qt::Key_Tab);
    QVERIFY(!m_open->editor().isAncestorOf(OpenCode::focused()));
    m_open->editor().setFocus();
    m_open->press(Qt::Key_Escape);
    m_open->press(Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(!m_open->editor().isAncestorOf(OpenCode::focused()));
    // Back in it, Tab indents again.
    m_open->editor().setFocus();
    m_open->press(Qt::Key_Tab);
    QCOMPARE(m_open->editor().text(), s("  "));
    QVERIFY(m_open->shown<QAbstractScrollArea>(s("Program"))
                ->accessibleDescription()
                .contains(s("Ctrl+Tab")));
}

void TestCodeEditor::knowsWordsForHelp_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("word");
    QTest::newRow("alone") << "|circle1.position"
                           << "circle1";
    QTest::newRow("field") << "circle1.pos|ition"
                           << "position";
    QTest::newRow("library") << "math.sqrt|(2)"
                             << "math.sqrt";
    QTest::newRow("method") << "v:len|gth()"
                            << "length";
    QTest::newRow("nothing") << "x = | 1"
                             << "";
}

void TestCodeEditor::knowsWordsForHelp()
{
    QFETCH(QString, text);
    QFETCH(const QString, word);
    const auto at = text.indexOf(u'|');
    m_open->editor().setText(text.remove(u'|'));
    for (int i = 0; i < at; ++i)
        m_open->press(Qt::Key_Right);
    QSignalSpy asked(&m_open->pane, &CodePane::helpRequested);
    m_open->press(Qt::Key_F1);
    QCOMPARE(asked.size(), 1);
    QCOMPARE(asked.front().front().toString(), word);
}

void TestCodeEditor::marksStandWithTheirLines()
{
    m_open->editor().setText(s("one()\ntwo()\nthree()\n"));
    const QImage plain = m_open->editor().grab().toImage();
    const auto rows = [&](const QImage &other) {
        QList<int> differing;
        for (int y = 0; y < plain.height(); ++y) {
            if (plain.pixel(plain.width() / 2, y) != other.pixel(plain.width() / 2, y))
                differing.append(y);
        }
        return differing;
    };
    m_open->editor().setSuspect(2);
    const QList<int> suspect = rows(m_open->editor().grab().toImage());
    QVERIFY(suspect.size() > 8);
    m_open->editor().setSuspect(0);
    QVERIFY(rows(m_open->editor().grab().toImage()).isEmpty());
    m_open->editor().setExecuting(3);
    const QList<int> executing = rows(m_open->editor().grab().toImage());
    QVERIFY(executing.size() > 8);
    QVERIFY(executing.front() > suspect.back());
    m_open->editor().setExecuting(0);
    m_open->editor().setError(1, s("`one` is not known"));
    QVERIFY(!rows(m_open->editor().grab().toImage()).isEmpty());
    const auto *area = m_open->shown<QAbstractScrollArea>(s("Program"));
    QVERIFY(area->accessibleDescription().contains(s("Error in line 1: `one` is not known")));
    m_open->editor().clearError();
    QVERIFY(rows(m_open->editor().grab().toImage()).isEmpty());
    m_open->editor().setSuspect(1);
    m_open->editor().setText(s("new"));
    QCOMPARE(m_open->editor().suspectLine(), 0);
}

void TestCodeEditor::errorAfterTheLastLineIsShown()
{
    m_open->editor().setText(s("do"));
    const QImage plain = m_open->editor().grab().toImage();
    m_open->editor().setError(7, s("`end` is missing"));
    QVERIFY(plain != m_open->editor().grab().toImage());
    m_open->editor().clearError();
    m_open->editor().setError(0, s("no line"));
    QCOMPARE(m_open->editor().errorLine(), 0);
}

void TestCodeEditor::messageIsScrolledIntoSight()
{
    QStringList lines;
    for (int i = 1; i <= 60; ++i)
        lines << QStringLiteral("-- line %1").arg(i);
    CodeEditor &editor = m_open->editor();
    editor.setText(lines.join(u'\n'));
    auto *area = editor.findChild<QAbstractScrollArea *>();
    const auto top = [area] { return area->verticalScrollBar()->value(); };
    const int seen = area->verticalScrollBar()->pageStep();
    QCOMPARE(top(), 0);
    editor.setError(2, s("one\ntwo"));
    QCOMPARE(top(), 0);                   // there is room
    editor.setError(seen, s("one\ntwo")); // in the last line that is seen
    QCOMPARE(top(), 2);
    editor.setError(50, s("one\ntwo"));
    QCOMPARE(top(), 2); // far from what is looked at: only if asked for
    editor.revealLine(50);
    QVERIFY(top() > 50 - seen && top() + seen >= 52);
}

void TestCodeEditor::zoomsByKeyAndWheel()
{
    QSignalSpy zoomed(&m_open->editor(), &CodeEditor::zoomChanged);
    m_open->press(Qt::Key_Plus, Qt::ControlModifier);
    m_open->press(Qt::Key_Plus, Qt::ControlModifier);
    QCOMPARE(m_open->editor().zoom(), 2);
    m_open->press(Qt::Key_Minus, Qt::ControlModifier);
    QCOMPARE(m_open->editor().zoom(), 1);
    m_open->press(Qt::Key_0, Qt::ControlModifier);
    QCOMPARE(m_open->editor().zoom(), 0);
    m_open->press(Qt::Key_Plus, Qt::ControlModifier);
    m_open->press(Qt::Key_0, Qt::ControlModifier | Qt::ShiftModifier); // a French one is shifted
    QCOMPARE(m_open->editor().zoom(), 0);
    QCOMPARE(zoomed.size(), 6);
    auto *viewport = m_open->shown<QAbstractScrollArea>(s("Program"))->viewport();
    QWheelEvent wheel(QPointF(50, 50), viewport->mapToGlobal(QPointF(50, 50)), {}, {0, 120},
                      Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(viewport, &wheel);
    QCOMPARE(m_open->editor().zoom(), 1);
    m_open->editor().setZoom(1000);
    QVERIFY(m_open->editor().zoom() < 50);
}

void TestCodeEditor::commentsAndUncomments()
{
    m_open->editor().setText(s("do\n  x()\nend"));
    m_open->press(Qt::Key_A, Qt::ControlModifier);
    m_open->press(Qt::Key_Slash, Qt::ControlModifier);
    QCOMPARE(m_open->editor().text(), s("-- do\n  -- x()\n-- end"));
    m_open->press(Qt::Key_A, Qt::ControlModifier);
    m_open->press(Qt::Key_Slash, Qt::ControlModifier | Qt::ShiftModifier); // a German one is on 7
    QCOMPARE(m_open->editor().text(), s("do\n  x()\nend"));
}

void TestCodeEditor::everyColourCanBeRead()
{
    for (const auto choice : {ThemeChoice::Dark, ThemeChoice::Light}) {
        applyTheme(choice);
        const CodeColours c = codeColours();
        for (const QColor &text : {c.text, c.muted, c.keyword, c.constant, c.string, c.call,
                                   c.circle1, c.circle2, c.error}) {
            for (const QColor &behind :
                 {c.background, c.errorLine, c.suspectLine, c.executingLine, c.selection})
                QVERIFY(contrast(text, behind) >= 4.5);
        }
    }
}

/// Of every program, and not only after the colours changed.
void TestCodeEditor::foldsAreMarkedByArrows()
{
    for (const char *program : {"a", "b", "a"}) {
        m_open->editor().openDocument(s(program), s("if x then\nend\n"));
        const auto *area = m_open->window.findChild<QsciScintilla *>();
        QVERIFY(area);
        const auto drawn = [area](unsigned long marker) {
            return area->SendScintilla(QsciScintilla::SCI_MARKERSYMBOLDEFINED, marker);
        };
        QCOMPARE(drawn(QsciScintilla::SC_MARKNUM_FOLDER), long(QsciScintilla::SC_MARK_ARROW));
        QCOMPARE(drawn(QsciScintilla::SC_MARKNUM_FOLDEROPEN),
                 long(QsciScintilla::SC_MARK_ARROWDOWN));
    }
}

QTEST_MAIN(TestCodeEditor)
#include "test_code_editor.moc"
