// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/local_names.h"

#include <QTest>

using namespace cradle;

class TestLocalNames : public QObject
{
    Q_OBJECT
private slots:
    void namesAreFoundWithTheirBlocks_data();
    void namesAreFoundWithTheirBlocks();
};

void TestLocalNames::namesAreFoundWithTheirBlocks_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("names"); // name:line-last line, * if outermost
    const auto row = [](const char *name, const char *source, const char *names) {
        QTest::newRow(name) << QString::fromLatin1(source) << QString::fromLatin1(names);
    };
    row("nothing", "", "");
    row("only a comment", "-- local x", "");
    row("in the file", "local a = 1\nlocal b, c = 2\nx = 3", "a:1-3* b:2-3* c:2-3*");
    row("with attributes", "local a <const>, b <close> = 1\n", "a:1-1* b:1-1*");
    row("function", "local function f(p, q)\n  local r\nend\nf()", "f:1-4* p:1-3 q:1-3 r:2-3");
    row("function of a table", "function t.go(p)\nend\nfunction t:went(q)\nend", "p:1-2 q:3-4");
    row("function as a value", "local f = function(p)\nend\nf()", "f:1-3* p:1-2");
    row("counters", "for i = 1, 2 do\n  x = i\nend\nfor k, v in pairs(t) do\nend",
        "i:1-3 k:4-5 v:4-5");
    row("branches", "if x then\n local a\nelseif y then\n local b\nelse\n local c\nend",
        "a:2-3 b:4-5 c:6-7");
    row("loops", "while x do\n local a\nend\nrepeat\n local b\nuntil b\ndo\n local c\nend",
        "a:2-3 b:5-6 c:8-9");
    row("loop over a function's result", "while f(function() local z end) do\n local a\nend",
        "z:1-1 a:2-3");
    row("texts and comments", "local a = 'local b' --[[\nlocal c ]] local d\n", "a:1-2* d:2-2*");
    row("a text of many lines", "local a = [[\n\n]] local b", "a:1-3* b:3-3*");
    row("a block alone", "do\n local a\nend\nlocal b", "a:2-3 b:4-4*");
    row("ends too many", "end end local a", "a:1-1*");
    row("blocks without an end", "if x then local a", "a:1-1");
    row("torn", "local function", "");
    row("torn list", "local a, ", "a:1-1*");
    row("torn function", "function (a", "a:1-1");
}

void TestLocalNames::namesAreFoundWithTheirBlocks()
{
    QFETCH(QString, source);
    QFETCH(QString, names);
    QStringList found;
    for (const LocalName &local : localNames(source))
        found.append(QStringLiteral("%1:%2-%3%4")
                         .arg(local.name)
                         .arg(local.line)
                         .arg(local.lastLine)
                         .arg(local.isOutermost ? QStringLiteral("*") : QString()));
    QCOMPARE(found.join(QLatin1Char(' ')), names);
}

QTEST_GUILESS_MAIN(TestLocalNames)
#include "test_local_names.moc"
