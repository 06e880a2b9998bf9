// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/plain_tokens.h"

#include <QTest>

using namespace cradle;

/// The tokens of programs that are plain; the others are left to Lua.
class TestPlainTokens : public QObject
{
    Q_OBJECT
private slots:
    void textsHaveTheirTokens_data();
    void textsHaveTheirTokens();
    void namesBeginWithALetter();
};

void TestPlainTokens::textsHaveTheirTokens_data()
{
    QTest::addColumn<QByteArray>("source");
    QTest::addColumn<QByteArray>("tokens"); ///< a space between two; of a text its quote alone
    const auto row = [](const QByteArray &source, const QByteArray &tokens) {
        QTest::newRow(source.toPercentEncoding(" =<>~/:.'\"\\+-*()[]{};,").constData())
            << source << tokens;
    };
    QTest::newRow("nothing") << QByteArray() << QByteArray();
    row(" \t\n", "");
    row("a1_ _b C", "a1_ _b C");
    row("A Z A_Z", "A Z A_Z");
    row("a=b", "a = b");
    row("==", "==");
    row("=====", "== == =");
    row("/ // ///", "/ // // /");
    row(": :: :::", ": :: :: :");
    row("< << <= <<= <>", "< << <= << = < >");
    row("> >> >= >>= ><", "> >> >= >> = > <");
    row("~ ~= ~~ ~=~", "~ ~= ~ ~ ~= ~");
    row("= =~ =< =/", "= = ~ = < = /");
    row("/= :=", "/ = : =");
    row("+= -= *= ^= %=", "+ = - = * = ^ = % =");
    row(". .. ... .... a.b a..b", ". .. ... ... . a . b a .. b");
    row("()[]{};,#&|", "( ) [ ] { } ; , # & |");
    row("1 1.5 .5 5. 1..2", "1 1.5 .5 5. 1..2");
    row("1e5 1e+5 1E-5 1e5+2 1+e", "1e5 1e+5 1E-5 1e5 + 2 1 + e");
    row("1e+-5", "1e+ - 5");
    row("0x1f 0X1F 0x1p+4 0x1P-4 0x1e+4", "0x1f 0X1F 0x1p+4 0x1P-4 0x1e + 4");
    row("0X1P+4 0Xp+1", "0X1P+4 0Xp+1");
    row("10x1+2 1p+4 00x1", "10x1 + 2 1p + 4 00x1");
    row("3a.b_ 3-2", "3a.b_ 3 - 2");
    row("0x", "0x");
    row("'a b' x", "' x");
    row("\"a'b\" 'a\"b'", "\" '");
    row("'a\\'b' x", "' x");
    row("'a\\\\' x", "' x");
    row("''x", "' x");
    row("'a", "no");
    row("'a\\", "no");
    row("'a\\'", "no");
    row("'a\nb'", "no");
    row("'a\rb'", "no");
    row("'\ra'", "no");
    row("'a\\\nb'", "no");
    row("'a\\zb'", "no");
    row("'az' z", "' z");
    row("x -- a comment\ny", "x y");
    row("x -- a comment", "x");
    row("x --", "x");
    row("x - -1", "x - - 1");
    row("x --[ y\nz", "x z");
    row("x --[[ y\nz]]", "no");
    row("x --[=[ y\nz]=]", "no");
    row("x -- a\r\ny", "no");
    row("x\ny -- a\r", "no");
    row("a[1] a[b]", "a [ 1 ] a [ b ]");
    row("[[x]]", "no");
    row("[=[x]=]", "no");
    row("a[ [[x]] ]", "no");
    row("a ? b", "no");
    row("a @ b", "no");
    row("a \\ b", "no");
    row("a $", "no");
    row("a!", "no");
    row("\xc3\xa4", "no");
    row("x\r\ny", "no");
}

void TestPlainTokens::textsHaveTheirTokens()
{
    QFETCH(QByteArray, source);
    PlainTokens tokens{"left over"};
    QByteArrayList found;
    const bool isPlain =
        readPlainTokens({source.constData(), static_cast<std::size_t>(source.size())}, tokens);
    for (const std::string_view token : tokens)
        found.append(QByteArray(token.data(), static_cast<qsizetype>(token.size())));
    QTEST(isPlain ? found.join(' ') : QByteArray("no"), "tokens");
}

void TestPlainTokens::namesBeginWithALetter()
{
    for (const char *name : {"a", "z1", "A", "Z", "_"})
        QVERIFY2(isName(name), name);
    for (const char *other : {"", "1", "1a", "@", "[", "`", "{", "'", "."})
        QVERIFY2(!isName(other), other);
}

QTEST_APPLESS_MAIN(TestPlainTokens)
#include "test_plain_tokens.moc"
