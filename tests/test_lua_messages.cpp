// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/lua_message.h"
#include "tasks/script/student_script.h"

#include <QTest>
#include <QTranslator>

using namespace cradle;
using namespace cradle::programs;

/// What Lua itself says of a program is said in the language of the application.
class TestLuaMessages : public QObject
{
    Q_OBJECT
private slots:
    void syntaxIsToldInEveryLanguage_data();
    void syntaxIsToldInEveryLanguage();
    void errorIsToldInEveryLanguage_data();
    void errorIsToldInEveryLanguage();
    void namesWithAPercentStay();
    void otherMessagesStay();
};

namespace {

/// A language in which every text is itself, marked.
class Marked final : public QTranslator
{
public:
    [[nodiscard]] QString translate(const char *, const char *source, const char *,
                                    int) const override
    {
        return QStringLiteral("«") + QString::fromUtf8(source) + QStringLiteral("»");
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

QString inOtherLanguage(const std::function<QString()> &message)
{
    Marked language;
    QCoreApplication::installTranslator(&language);
    const QString text = message();
    QCoreApplication::removeTranslator(&language);
    return text;
}

} // namespace

void TestLuaMessages::syntaxIsToldInEveryLanguage_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("english");
    const auto row = [](const char *program, const char *english) {
        QTest::newRow(english) << lua(program) << lua(english);
    };
    row("if true then\n  x = 1\n", "'end' expected (to close 'if' at line 1) near <eof>");
    row("x 1", "syntax error near '1'");
    row("local = 1", "<name> expected near '='");
    row("x = = 1", "unexpected symbol near '='");
    row("x = 'a\n", "unfinished string near ''a'");
    row("x = [[a", "unfinished long string (starting at line 1)");
    row("--[[ a", "unfinished long comment (starting at line 1)");
    row("x = 1x", "malformed number near '1x'");
    row("x = '\\q'", "invalid escape sequence near ''\\q'");
    row("break", "break outside loop at line 1");
    row("goto on", "no visible label 'on' for goto at line 1");
    row("::a:: ::a::", "label 'a' already defined on line 1");
    row("local a <const> = 1 a = 2", "attempt to assign to const variable 'a'");
}

void TestLuaMessages::syntaxIsToldInEveryLanguage()
{
    QFETCH(QString, program);
    QFETCH(QString, english);
    const auto message = [&] { return findSyntaxError(program)->message; };
    QVERIFY(findSyntaxError(program));
    QCOMPARE(message(), english);
    const QString other = inOtherLanguage(message);
    QVERIFY2(other.startsWith(QStringLiteral("«")) && other.endsWith(QStringLiteral("»")),
             qPrintable(other));
}

void TestLuaMessages::errorIsToldInEveryLanguage_data()
{
    QTest::addColumn<QString>("statement");
    QTest::addColumn<QString>("english");
    const auto row = [](const char *statement, const char *english) {
        QTest::newRow(statement) << lua(statement) << lua(english);
    };
    row("local v = 'a' .. {}", "this value is table, so .. cannot join it to a text");
    row("local n = nil local v = 'a' .. n", "`n` is nil, so .. cannot join it to a text");
    row("local n = 3 local v = #n", "`n` is number, so it has no length");
    row("local v = 1 < {}",
        "attempt to compare number with table; only numbers compare with numbers (the length of a "
        "vector is v:length())");
    row("local v = {} < {}",
        "attempt to compare two table values; only numbers compare with numbers (the length of a "
        "vector is v:length())");
    row("local v = 1 // 0", "attempt to divide a whole number by zero");
    row("local v = 1 % 0", "attempt to take the rest of a division by zero");
    row("math.sqrt('a')", "bad argument #1 to 'sqrt' (number expected, got string)");
    row("math.random(2, 1)", "bad argument #1 to 'random' (out of range)");
    row("local v = 1.5 | 1", "number has no integer representation");
    row("for i = 'a', 2 do end", "the first value of 'for' must be a number");
    row("for i = 1, 'b' do end", "the last value of 'for' must be a number");
    row("for i = 1, 2, {} do end", "the step of 'for' must be a number");
    row("for i = 1, 2, 0 do end", "the step of 'for' is zero");
    row("assert(false)", "assertion failed!");
}

void TestLuaMessages::errorIsToldInEveryLanguage()
{
    QFETCH(QString, statement);
    QFETCH(QString, english);
    const auto message = [&] {
        const ScriptRun run = runScript(statement);
        return run.error ? run.error->message : QString();
    };
    QCOMPARE(message(), english);
    const QString other = inOtherLanguage(message);
    QVERIFY2(other.startsWith(QStringLiteral("«")) && other.endsWith(QStringLiteral("»")),
             qPrintable(other));
}

void TestLuaMessages::namesWithAPercentStay()
{
    QCOMPARE(plainSyntaxMessage(lua("'%2' expected near '%1'")), lua("'%2' expected near '%1'"));
}

void TestLuaMessages::otherMessagesStay()
{
    for (const char *message : {"", "my own words", "the values of a program: near 1"}) {
        QCOMPARE(plainSyntaxMessage(lua(message)), lua(message));
        QCOMPARE(plainRuntimeMessage(lua(message)), lua(message));
    }
}

QTEST_GUILESS_MAIN(TestLuaMessages)
#include "test_lua_messages.moc"
