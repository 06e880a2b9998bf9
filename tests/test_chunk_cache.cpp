// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/script_run.h"

#include "tasks/script/student_script.h"

#include <QtConcurrentFilter>

using namespace cradle;
using namespace cradle::programs;

/// A program that was compiled before is the same program.
class TestChunkCache : public QObject
{
    Q_OBJECT
private slots:
    void laterRunsTellTheSame();
    void whatCannotBeReadIsRefusedAgain();
    void manyThreadsMayAsk();
};

void TestChunkCache::laterRunsTellTheSame()
{
    const QString source = lua("local limit = 2\nfunction on_update(dt)\n  local speed = nil\n"
                               "  if step == limit then speed.x = 1 end\nend");
    const ScriptRun first = runScript(source, 5);
    VERIFY_STOPS(first, 4, lua("`speed` is nil"));
    for (int i = 0; i < 3; ++i)
        QCOMPARE(runScript(source, 5).error, first.error);
}

void TestChunkCache::whatCannotBeReadIsRefusedAgain()
{
    for (int i = 0; i < 3; ++i)
        VERIFY_STOPS(runScript(lua("\nx = = 1")), 2, lua("unexpected symbol"));
}

void TestChunkCache::manyThreadsMayAsk()
{
    QList<int> numbers;
    for (int i = 0; i < 200; ++i)
        numbers.append(i % 20);
    const auto wrong = QtConcurrent::blockingFiltered(numbers, [](int n) {
        const ScriptRun run = runScript(lua("print(%1)").arg(n));
        return run.error || run.output.text != QStringLiteral("%1\n").arg(n);
    });
    QCOMPARE(wrong, QList<int>());
}

QTEST_GUILESS_MAIN(TestChunkCache)
#include "test_chunk_cache.moc"
