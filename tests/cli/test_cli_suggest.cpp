// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/program_run.h"
#include "tests/test_paths.h"

#include <QDir>

using namespace cradle::programs;

/// cradle-cli suggest: mistakes that a lab does not know.
class TestCliSuggest : public QObject
{
    Q_OBJECT
private slots:
    void namesWhatPassesAndWhatIsNotExplained();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
};

namespace {

Outcome suggest(const QStringList &arguments)
{
    return runCli(QStringList{text("suggest")} + arguments);
}

} // namespace

/// A lab of one step that drifts and is looked at for a second only: no check sees the wall.
void TestCliSuggest::namesWhatPassesAndWhatIsNotExplained()
{
    const QTemporaryDir folder;
    for (const char *name : {"S1", "S1/mistakes"})
        QVERIFY(QDir(folder.path()).mkpath(text(name)));
    QVERIFY(!written(folder, "lab.json",
                     R"({"format": 1, "id": "small", "title": "Small", "version": "1",
                         "language": "en", "steps": ["S1"]})")
                 .isEmpty());
    QVERIFY(!written(folder, "S1/task.json",
                     R"({"format": 1, "id": "S1", "title": "Drift", "commit": "Drifted",
                         "preset": "preset.json", "hints": [],
                         "checks": [{"id": "drifts", "kind": "integrates", "title": "It drifts",
                                     "scene": {"kind": "own", "duration": 1}}]})")
                 .isEmpty());
    QVERIFY(!written(folder, "S1/preset.json",
                     R"({"format": 1, "circles": [{"position": [-2, 2], "velocity": [1, 0]}]})")
                 .isEmpty());
    QVERIFY(!written(folder, "S1/instructions.md", "# Drift\n").isEmpty());
    QVERIFY(!written(folder, "S1/solution.lua",
                     "function on_update(dt)\n"
                     "  local c = circle1\n"
                     "  c.position = c.position + c.velocity * dt\n"
                     "  if c.position.x + c.radius > square.right then\n"
                     "    c.velocity = vec(-1, 0)\n"
                     "  end\n"
                     "end\n")
                 .isEmpty());
    const Outcome outcome = suggest({folder.path(), text("S1")});
    VERIFY_CODE(outcome, 1);
    const QStringList lines = outcome.out.split(QLatin1Char('\n'));
    const auto after = [&](const char *change) {
        for (qsizetype i = 0; i + 1 < lines.size(); ++i) {
            if (lines[i].endsWith(text(change)))
                return lines[i + 1].trimmed();
        }
        return QString();
    };
    QCOMPARE(after(" if false then"), text("passes every check"));
    QVERIFY2(after(" c.position = c.position + c.velocity")
                 .startsWith(text("fails drifts; what is measured tells: The way of circle 1 is "
                                  "not multiplied by the timestep")),
             outcome.toText().constData());
}

void TestCliSuggest::wrongUsageIsSaid_data()
{
    QTest::addColumn<QStringList>("arguments");
    const QString good = cradle::fixturePath("labs/good");
    QTest::newRow("no lab") << QStringList{};
    QTest::newRow("unknown step") << QStringList{good, text("S9")};
    QTest::newRow("no such folder") << QStringList{text("nowhere")};
    QTest::newRow("too much") << QStringList{good, text("S1"), text("S2")};
}

void TestCliSuggest::wrongUsageIsSaid()
{
    QFETCH(QStringList, arguments);
    const Outcome outcome = suggest(arguments);
    VERIFY_CODE(outcome, 2);
    QVERIFY(outcome.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestCliSuggest)
#include "test_cli_suggest.moc"
