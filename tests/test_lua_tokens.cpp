// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/lua_tokens.h"

#include "tasks/script/program_tokens.h"

#include <QTest>

using namespace cradle;

/// The words and signs of a Lua program, as the editor and the mutations see them.
class TestLuaTokens : public QObject
{
    Q_OBJECT
private slots:
    void textIsCutIntoTokens_data();
    void textIsCutIntoTokens();
    void programTellsLinesAndLetters();
};

void TestLuaTokens::textIsCutIntoTokens_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArrayList>("tokens");
    const auto row = [](const char *text, const QByteArrayList &tokens) {
        QTest::newRow(text) << QByteArray(text) << tokens;
    };
    row("", {});
    row("a.b[1]", {"a", ".", "b", "[", "1", "]"});
    row("a..b", {"a", "..", "b"});
    row("1..2", {"1", "..", "2"});
    row("1.5.. ...", {"1.5", "..", "..."});
    row("a<=b>=c==d~=e", {"a", "<=", "b", ">=", "c", "==", "d", "~=", "e"});
    row("a//b<<c>>d", {"a", "//", "b", "<<", "c", ">>", "d"});
    row("::here:: x:y()", {"::", "here", "::", "x", ":", "y", "(", ")"});
    row("a=-1e-3", {"a", "=", "-", "1e-3"});
    row("0x1p-2", {"0x1p-2"});
    row("'a\\'b' \"c\"", {"'a\\'b'", "\"c\""});
    row("[==[ a ]] ]==] b", {"[==[ a ]] ]==]", "b"});
    row("a -- b\nc --[[ d\n]] e", {"a", "-- b", "c", "--[[ d\n]]", "e"});
    row("'open\nx", {"'open", "x"});
}

void TestLuaTokens::textIsCutIntoTokens()
{
    QFETCH(QByteArray, text);
    QFETCH(QByteArrayList, tokens);
    QByteArrayList found;
    for (const LuaToken &token : luaTokens(text))
        found.append(token.in(text).toByteArray());
    QCOMPARE(found, tokens);
}

/// Letters that take two bytes come before; comments are left out.
void TestLuaTokens::programTellsLinesAndLetters()
{
    const QString source = QStringLiteral("-- Größe\nlocal s = 'ä' -- ü\nreturn s <= nil");
    const std::vector<ProgramToken> tokens = programTokens(source);
    QCOMPARE(tokens.size(), std::size_t{8});
    using Kind = ProgramToken::Kind;
    const Kind kinds[] = {Kind::Keyword, Kind::Name, Kind::Sign, Kind::Text,
                          Kind::Keyword, Kind::Name, Kind::Sign, Kind::Keyword};
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        QCOMPARE(tokens[i].kind, kinds[i]);
        QCOMPARE(source.mid(tokens[i].start, tokens[i].text.size()), tokens[i].text);
        QCOMPARE(tokens[i].line, i < 4 ? 2 : 3);
    }
}

QTEST_GUILESS_MAIN(TestLuaTokens)
#include "test_lua_tokens.moc"
