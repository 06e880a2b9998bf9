// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/plain_text.h"

#include <QTest>

using namespace cradle;

/// CommonMark with TeX for those who see neither.
class TestPlainText : public QObject
{
    Q_OBJECT
private slots:
    void marksGiveWayToText_data();
    void marksGiveWayToText();
    void linesAreBrokenAnew();
    void formulaIsNotBroken();
    void blocksStayApart();
    void numberInAParagraphBeginsNoList();
    void markdownKeepsItsMarks();
    void oddLettersAreLeftOut();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace

void TestPlainText::marksGiveWayToText_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("plain");
    const auto row = [](const char *name, const char *markdown, const char *plain) {
        QTest::newRow(name) << text(markdown) << text(plain);
    };
    row("formula", "At $t = 2.9$ s", "At t = 2.9 s");
    row("display", "$$x = v$$", "x = v");
    row("power", "$g \\, \\Delta t^2$", "g Δt²");
    row("power in braces", "$e^{2}$", "e²");
    row("larger power", "$e^{10}$", "e^10");
    row("fraction", "$\\frac{1}{2} g$", "1/2 g");
    row("fraction of a sum", "$\\frac{m_1}{m_1 + m_2}$", "m_1/(m_1 + m_2)");
    row("nested fraction", "$\\frac{1}{\\frac{2}{3}}$", "1/(2/3)");
    row("dot", "$(u_1 - u_2) \\cdot n$", "(u_1 - u_2) · n");
    row("unknown command", "$\\sin x$", "sin x");
    row("brace not closed", "a $\\frac{$ b", "a $\\frac{$ b");
    row("brace not opened", "$x}$", "$x}$");
    row("braces the wrong way", "$}x{$", "$}x{$");
    row("escaped braces", "a $\\{x$", "a {x");
    row("money", "$5 and $6", "$5 and $6");
    row("strong and emphasis", "the **whole** *old* place", "the whole old place");
    row("emphasis in strong", "**an *old* place**", "an old place");
    row("formula in strong", "**at $x_1$**", "at x_1");
    row("product is no emphasis", "2 * 3 * 4", "2 * 3 * 4");
    row("name is no emphasis", "circle_1_old", "circle_1_old");
    row("code", "`a * b * $c$`", "`a * b * $c$`");
    row("escaped", "\\*not\\* \\$x\\$", "*not* $x$");
    row("heading", "## What to do", "What to do");
    row("nothing", "", "");
}

void TestPlainText::marksGiveWayToText()
{
    QFETCH(QString, markdown);
    QFETCH(QString, plain);
    QCOMPARE(plainText(markdown, 80), plain);
}

void TestPlainText::linesAreBrokenAnew()
{
    QCOMPARE(plainText(text("one two\nthree four five"), 13), text("one two three\nfour five"));
    QCOMPARE(plainText(text("incomprehensible word"), 5), text("incomprehensible\nword"));
    QCOMPARE(wrapped(text("one two three"), 9, text("ok  "), text("    ")),
             text("ok  one\n    two\n    three"));
}

void TestPlainText::formulaIsNotBroken()
{
    QCOMPARE(plainText(text("where $x = 2$ m"), 9), text("where\nx = 2 m"));
    // One of 24 letters is not, one of 25 is.
    QCOMPARE(plainText(text("$abcdefghij = klmnopqrstu$"), 9), text("abcdefghij = klmnopqrstu"));
    QCOMPARE(plainText(text("$abcdefghij = klmnopqrstuv$"), 9),
             text("abcdefghij\n=\nklmnopqrstuv"));
}

void TestPlainText::blocksStayApart()
{
    QCOMPARE(plainText(text("Title\n\nLook at\nthis:\n- one\n  more\n- two\n\n```lua\nx  =  1\n\n"
                            "y = 2\n```\nand go on"),
                       80),
             text("Title\n\nLook at this:\n- one more\n- two\n\n    x  =  1\n\n    y = 2\n"
                  "and go on"));
}

void TestPlainText::numberInAParagraphBeginsNoList()
{
    QCOMPARE(plainText(text("stays (2,\n0) m/s"), 80), text("stays (2, 0) m/s"));
    QCOMPARE(plainText(text("Do:\n1. this\n2. that"), 80), text("Do:\n1. this\n2. that"));
}

void TestPlainText::markdownKeepsItsMarks()
{
    QCOMPARE(withPlainFormulas(text("The **whole** $\\Delta t$\n\n- `a`\n- $e^2$")),
             text("The **whole** Δt\n\n- `a`\n- e²"));
    const QString code = text("Try\n\n```\n$x$ = 1\n```");
    QCOMPARE(withPlainFormulas(code), code);
}

void TestPlainText::oddLettersAreLeftOut()
{
    QString odd = text("a\tb\n🎱ü🎱"); // also as the last letter
    const QString right = odd;
    for (const char16_t c : {u'\0', u'\x1b', u'\x7f', u'\x9b', char16_t(0xd800), char16_t(0xffff)})
        odd.insert(1, QChar(c));
    QCOMPARE(printable(odd), right);
}

QTEST_APPLESS_MAIN(TestPlainText)
#include "test_plain_text.moc"
