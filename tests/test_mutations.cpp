// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/mutations.h"
#include "tasks/reading/known_scripts.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/script/program_tokens.h"
#include "tasks/script/student_script.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace cradle;

/// Mistakes made from a solution, and which of them a lab does not know.
class TestMutations : public QObject
{
    Q_OBJECT
private slots:
    void programIsCutIntoTokens();
    void physicalMistakesAreMade_data();
    void physicalMistakesAreMade();
    void partsOfConditionsKeepTheirBrackets();
    void callOfAMethodIsOneFactor();
    void everyMutantCanBeRead();
    void missingTestIsFound();
    void cancelledSearchSaysNothing();
    void radiusAndDensityAreEachSeen_data();
    void radiusAndDensityAreEachSeen();
};

namespace {

const QString fall =
    QStringLiteral("function on_load()\n"
                   "  circle1.velocity = vec(-2, 0)\n"
                   "end\n"
                   "function on_update(timestep)\n"
                   "  for _, c in ipairs(circles) do\n"
                   "    c.velocity = c.velocity + gravity * timestep\n"
                   "    c.position = c.position + c.velocity * timestep\n"
                   "    if c.position.y < 0 and c.velocity.y < 0 then\n"
                   "      c.velocity = (1 + restitution) * c.velocity\n"
                   "    end\n"
                   "  end\n"
                   "  local n = (circle2.position - circle1.position):normalized()\n"
                   "  circle1.mass = circle1.density * circle2.radius ^ 3\n"
                   "end\n");

QStringList changesOf(const QString &solution)
{
    QStringList changes;
    for (const Mutant &mutant : mutantsOf(solution))
        changes.append(QStringLiteral("%1: %2").arg(mutant.line).arg(mutant.change));
    return changes;
}

} // namespace

void TestMutations::programIsCutIntoTokens()
{
    QStringList words;
    for (const ProgramToken &token :
         programTokens(QStringLiteral("a.b = 'x -- y' -- no\n--[[ no\n]] c <= 1e-3 ... [[z]]")))
        words.append(QStringLiteral("%1@%2").arg(token.text).arg(token.line));
    QCOMPARE(words,
             (QStringList{QStringLiteral("a@1"), QStringLiteral(".@1"), QStringLiteral("b@1"),
                          QStringLiteral("=@1"), QStringLiteral("'x -- y'@1"),
                          QStringLiteral("c@3"), QStringLiteral("<=@3"), QStringLiteral("1e-3@3"),
                          QStringLiteral("...@3"), QStringLiteral("[[z]]@3")}));
}

void TestMutations::physicalMistakesAreMade_data()
{
    QTest::addColumn<QString>("change");
    const auto row = [](const char *name, const char *change) {
        QTest::newRow(name) << QString::fromUtf8(change);
    };
    row("sign of a term", "6: c.velocity = c.velocity - gravity * timestep");
    row("timestep dropped", "6: c.velocity = c.velocity + gravity");
    row("first factor dropped", "7: c.position = c.position + timestep");
    row("order of the updates", "6: c.position = c.position + c.velocity * timestep");
    row("statement missing", "6: ");
    row("statement twice", "6: c.velocity = c.velocity + gravity * timestep");
    row("test missing", "8: if c.position.y < 0 then");
    row("other test missing", "8: if c.velocity.y < 0 then");
    row("comparison", "8: if c.position.y > 0 and c.velocity.y < 0 then");
    row("coordinate", "8: if c.position.y < 0 and c.velocity.x < 0 then");
    row("case missing", "8: if false then");
    row("always", "8: if true then");
    row("e missing", "9: c.velocity = (1 + 1) * c.velocity");
    row("e twice", "9: c.velocity = (1 + restitution ^ 2) * c.velocity");
    row("e at the wrong place", "9: c.velocity = 1 + restitution * c.velocity");
    row("normal not normalised", "12: local n = (circle2.position - circle1.position)");
    row("circle", "12: local n = (circle2.position - circle2.position):normalized()");
    row("mass of the other", "13: circle1.mass = circle2.density * circle2.radius ^ 3");
    row("power dropped", "13: circle1.mass = circle1.density * circle2.radius");
    row("start left out", "2: ");
}

void TestMutations::physicalMistakesAreMade()
{
    QFETCH(QString, change);
    // A coordinate has a partner only where the program knows both.
    const QString both = QString(fall).replace(QStringLiteral("(-2, 0)"),
                                               QStringLiteral("(-2, circle1.velocity.x)"));
    const QStringList changes = changesOf(both);
    QVERIFY2(changes.contains(change), qPrintable(changes.join(QLatin1Char('\n'))));
}

/// A part of a condition is left out with its brackets, and none beyond those that it stands in.
void TestMutations::partsOfConditionsKeepTheirBrackets()
{
    const QStringList changes = changesOf(QStringLiteral("function on_update(h)\n"
                                                         "  if f(a) and g(c, (d)) then\n"
                                                         "    x = 1\n"
                                                         "  end\n"
                                                         "  return (a or (b)) ~= not c\n"
                                                         "end\n"));
    for (const char *change : {"2: if g(c, (d)) then", "2: if f(a) then",
                               "5: return ((b)) ~= not c", "5: return (a) ~= not c"})
        QVERIFY2(changes.contains(QLatin1String(change)), qPrintable(changes.join(u'\n')));
}

/// It is left out with what it is called on, and not without.
void TestMutations::callOfAMethodIsOneFactor()
{
    const QStringList changes =
        changesOf(QStringLiteral("function on_update(h)\n  x = v:dot(n) * m\nend\n"));
    QVERIFY2(changes.contains(QLatin1String("2: x = m")), qPrintable(changes.join(u'\n')));
    QVERIFY2(!changes.contains(QLatin1String("2: x = v:m")), qPrintable(changes.join(u'\n')));
}

void TestMutations::everyMutantCanBeRead()
{
    const Result<Lab> lab = readLab(QLatin1String(shippedLab));
    QVERIFY(lab.ok());
    for (const Task &task : lab->tasks) {
        const std::vector<Mutant> mutants = mutantsOf(task.solution);
        QVERIFY2(mutants.size() >= 5, qPrintable(task.id));
        std::set<QString> names;
        for (const Mutant &mutant : mutants) {
            QVERIFY2(!findSyntaxError(mutant.source), qPrintable(task.id + mutant.name));
            QVERIFY2(names.insert(mutant.name).second, qPrintable(task.id + mutant.name));
            QCOMPARE(firstCommentBlock(mutant.source).section(QLatin1Char('\n'), 0, 0),
                     mutant.message.section(QLatin1Char('\n'), 0, 0));
            QVERIFY(!mutant.source.endsWith(task.solution));
        }
    }
}

/// A step whose only check looks at the first second of a drift to the right.
void TestMutations::missingTestIsFound()
{
    Task task;
    task.id = QStringLiteral("S1");
    task.preset.circles.resize(1);
    task.preset.circles[0].body = {.position = {-2, 0}, .velocity = {1, 0}};
    task.solution = QStringLiteral("function on_update(timestep)\n"
                                   "  local c = circle1\n"
                                   "  c.position = c.position + c.velocity * timestep\n"
                                   "  if c.position.x + c.radius > square.right then\n"
                                   "    c.velocity = vec(-1, 0)\n"
                                   "  end\n"
                                   "end\n");
    task.checks = {{.id = QStringLiteral("drifts"),
                    .title = {},
                    .kind = QStringLiteral("integrates"),
                    .circles = {0},
                    .scene = {{QStringLiteral("kind"), QStringLiteral("own")},
                              {QStringLiteral("duration"), 1.0}}}};
    const std::vector<Suggestion> suggestions = suggestMistakes({}, task).list;
    const auto find = [&](const QString &change) {
        const auto found =
            std::find_if(suggestions.begin(), suggestions.end(),
                         [&](const Suggestion &s) { return s.mutant.change == change; });
        return found == suggestions.end() ? nullptr : &*found;
    };
    // No check looks at the wall.
    const Suggestion *wall = find(QStringLiteral("if false then"));
    QVERIFY(wall);
    QCOMPARE(wall->kind, Suggestion::Kind::Passes);
    // Made twice it does what it does once: that tells nothing.
    const auto twice = mutantsOf(task.solution);
    QVERIFY(std::any_of(twice.begin(), twice.end(), [](const Mutant &mutant) {
        return mutant.change == QLatin1String("c.velocity = vec(-1, 0)");
    }));
    QVERIFY(!find(QStringLiteral("c.velocity = vec(-1, 0)")));
    // The lab has no mistake for this one, yet what is measured tells of it.
    const Suggestion *faster = find(QStringLiteral("c.position = c.position + c.velocity"));
    QVERIFY(faster);
    QCOMPARE(faster->kind, Suggestion::Kind::ToldByLaw);
    QCOMPARE(faster->check, QStringLiteral("drifts"));
    QVERIFY(!faster->finding.isEmpty());
    QVERIFY(suggestions.front().kind == Suggestion::Kind::Passes);
    // Progress goes on from nothing to all, step by step.
    std::vector<std::pair<int, int>> told;
    (void)suggestMistakes(
        {}, task, {.progress = [&](int done, int total) { told.emplace_back(done, total); }});
    QVERIFY(told.size() > suggestions.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        QVERIFY(told[i].first <= told[i].second && told[i].second == told[0].second);
        QVERIFY(i == 0 || told[i].first >= told[i - 1].first);
    }
    QCOMPARE(told.back().first, told.back().second);

    // Once it has one, it is not suggested again.
    task.mistakes = {{QStringLiteral("known"), faster->mutant.source, QStringLiteral("Known")}};
    for (const Suggestion &s : suggestMistakes({}, task).list)
        QVERIFY(s.mutant.change != faster->mutant.change);
}

void TestMutations::cancelledSearchSaysNothing()
{
    Task task;
    task.preset.circles.resize(1);
    task.solution = fall;
    QVERIFY(suggestMistakes({}, task, {.cancelled = [] { return true; }}).list.empty());
}

void TestMutations::radiusAndDensityAreEachSeen_data()
{
    QTest::addColumn<QString>("start");
    QTest::newRow("radius") << QStringLiteral("circle1.radius = 0.4");
    QTest::newRow("density") << QStringLiteral("circle1.density = 3");
}

/// A start that no check of the step asks for: who leaves it out moves alike, and is no other
/// spelling of the solution.
void TestMutations::radiusAndDensityAreEachSeen()
{
    QFETCH(QString, start);
    Task task;
    task.id = QStringLiteral("S1");
    task.preset.circles.resize(1);
    task.preset.circles[0].body = {.velocity = {1, 0}, .radius = 0.2};
    task.solution = QStringLiteral("function on_load()\n  %1\nend\n"
                                   "function on_update(h)\n"
                                   "  circle1.position = circle1.position + circle1.velocity * h\n"
                                   "end\n")
                        .arg(start);
    CheckSpec check;
    check.id = QStringLiteral("drifts");
    check.kind = QStringLiteral("integrates");
    check.circles = {0};
    check.scene = {{QStringLiteral("kind"), QStringLiteral("own")},
                   {QStringLiteral("duration"), 1.0}};
    task.checks = {check};
    Lab lab;
    lab.tasks = {task};
    const Suggestions found = suggestMistakes(lab, task, {});
    const auto passes =
        std::count_if(found.list.begin(), found.list.end(), [](const Suggestion &s) {
            return s.kind == Suggestion::Kind::Passes && s.mutant.line == 2;
        });
    QCOMPARE(passes, 1);
}

QTEST_GUILESS_MAIN(TestMutations)
#include "test_mutations.moc"
