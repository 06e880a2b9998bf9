// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_code.h"
#include "views/code/completion_popup.h"

using namespace cradle;

class TestCompletion final : public CodeTest
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void init() { openAnew(); }
    void cleanup() { m_open.reset(); }

    void completesAfterTwoLetters();
    void completesMembersAfterADot_data();
    void completesMembersAfterADot();
    void completesNotInCommentsAndStrings();
    void completionByKeyboardAndItsEnd();
    void completesOwnWords();
    void callTipFollowsTheArguments();
};

void TestCompletion::completesAfterTwoLetters()
{
    m_open->type("c");
    QCOMPARE(m_open->offered(), QStringList());
    m_open->type("i");
    QCOMPARE(m_open->offered(), QStringList({s("circle1"), s("circle2"), s("circles")}));
    m_open->type("x");
    QCOMPARE(m_open->offered(), QStringList());
    m_open->editor().setText({});
    m_open->press(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(m_open->offered().contains(s("on_update")));
    QVERIFY(m_open->offered().contains(s("while")));
}

void TestCompletion::completesMembersAfterADot_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QStringList>("first");
    QTest::newRow("circle") << "circle1."
                            << QStringList({s("position"), s("velocity"), s("radius")});
    QTest::newRow("of a list") << "circles[i]." << QStringList({s("position")});
    QTest::newRow("square") << "square." << QStringList({s("half_width"), s("left")});
    QTest::newRow("drawing") << "draw." << QStringList({s("arrow"), s("line"), s("point")});
    QTest::newRow("numbers") << "math.sq" << QStringList({s("sqrt")});
    QTest::newRow("texts") << "string." << QStringList({s("format")});
    QTest::newRow("lists") << "table.in" << QStringList({s("insert")});
    QTest::newRow("parts") << "circle2.velocity." << QStringList({s("x"), s("y")});
    QTest::newRow("methods") << "v:" << QStringList({s("length"), s("length_squared")});
    QTest::newRow("unknown") << "v." << QStringList();
    QTest::newRow("joined texts") << "a.." << QStringList();
    QTest::newRow("number") << "x = 1." << QStringList();
}

void TestCompletion::completesMembersAfterADot()
{
    QFETCH(const QString, typed);
    QFETCH(const QStringList, first);
    m_open->type(typed.toLatin1().constData());
    QCOMPARE(m_open->offered().mid(0, first.size()), first);
    QCOMPARE(m_open->offered().isEmpty(), first.isEmpty());
}

void TestCompletion::completesNotInCommentsAndStrings()
{
    m_open->type("-- circle");
    QCOMPARE(m_open->offered(), QStringList());
    m_open->type("\nx = \"circle");
    QCOMPARE(m_open->offered(), QStringList());
    m_open->type("\" ci");
    QVERIFY(!m_open->offered().isEmpty());
}

void TestCompletion::completionByKeyboardAndItsEnd()
{
    m_open->type("ci");
    m_open->press(Qt::Key_Down);
    m_open->press(Qt::Key_Return);
    QCOMPARE(m_open->editor().text(), s("circle2"));
    QVERIFY(m_open->offered().isEmpty());
    m_open->type(".pos");
    m_open->press(Qt::Key_Tab);
    QCOMPARE(m_open->editor().text(), s("circle2.position"));
    m_open->type(" ve");
    QVERIFY(!m_open->offered().isEmpty());
    m_open->press(Qt::Key_Escape);
    QVERIFY(m_open->offered().isEmpty());
    m_open->press(Qt::Key_Tab); // that Escape was for the list
    QVERIFY(m_open->editor().isAncestorOf(OpenCode::focused()));
    m_open->type("ve");
    QVERIFY(!m_open->offered().isEmpty());
    m_open->press(Qt::Key_Backspace);
    m_open->press(Qt::Key_Left);
    QVERIFY(m_open->offered().isEmpty());
}

void TestCompletion::completesOwnWords()
{
    m_open->editor().setText(s("local old_position = 1\n"));
    m_open->editor().goToLine(2);
    m_open->type("ol");
    QCOMPARE(m_open->offered(), QStringList({s("old_position")}));
    m_open->press(Qt::Key_Return);
    QVERIFY(m_open->editor().text().endsWith(s("\nold_position")));
}

void TestCompletion::callTipFollowsTheArguments()
{
    m_open->type("draw.arrow");
    QCOMPARE(m_open->tip(), QString());
    m_open->type("(");
    QVERIFY2(m_open->tip().startsWith(s("draw.arrow(from, vector, colour, label)\n"))
                 || m_open->tip().startsWith(s("arrow(from, vector, colour, label)\n")),
             qPrintable(m_open->tip()));
    m_open->type("vec(1");
    QVERIFY(m_open->tip().startsWith(s("vec(x, y)")));
    m_open->type(", 2)");
    QVERIFY(m_open->tip().contains(s("arrow(")));
    m_open->type(")");
    QCOMPARE(m_open->tip(), QString());
    m_open->editor().setText(s("local function gap(a, b)\nend\n"));
    m_open->editor().goToLine(3);
    m_open->type("gap(");
    QVERIFY(m_open->tip().startsWith(s("gap(a, b)")));
    m_open->press(Qt::Key_Escape);
    QCOMPARE(m_open->tip(), QString());
}

QTEST_MAIN(TestCompletion)
#include "test_completion.moc"
