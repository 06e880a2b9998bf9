// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/other_mistakes.h"

#include "tests/authoring_labs.h"

#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_reader.h"

using namespace cradle;
using namespace cradle::authoring;

/// Mistakes that one step knows are offered in another.
class TestOtherMistakes : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void whatAppliesIsOffered();
    void oneKeptWholeIsOfferedAlike();
    void takenOverItFailsThereToo();
    void ownNamesAndProgramsAreNotOffered();
    void ownNameIsNotOfferedWithAnotherProgram();
    void stepWithoutASolutionIsOfferedNothing();

private:
    LabFiles m_lab;
};

namespace {

const QString step = text("L42T10");

std::vector<OtherMistake> named(const std::vector<OtherMistake> &all, const QString &name)
{
    std::vector<OtherMistake> found;
    std::copy_if(all.begin(), all.end(), std::back_inserter(found),
                 [&](const OtherMistake &each) { return each.name == name; });
    return found;
}

} // namespace

void TestOtherMistakes::initTestCase()
{
    TAKE(m_lab, readLabFiles(shippedFolder));
}

void TestOtherMistakes::whatAppliesIsOffered()
{
    const auto offered = mistakesOfOtherSteps(m_lab, step);
    QVERIFY(offered.size() >= 5);
    const auto ceiling = named(offered, text("ceiling-asks-downward")); // the nearest that has it
    QCOMPARE(ceiling.size(), std::size_t(1));
    QCOMPARE(ceiling[0].headline, text("The ceiling lets the circles through"));
    const QString solution = textOf(m_lab, step + text("/solution.lua"));
    QString wrong = solution;
    wrong.replace(text("p.y + r > square.top and v.y > 0"),
                  text("p.y + r > square.top and v.y < 0"));
    QVERIFY(wrong != solution);
    QVERIFY(ceiling[0].program.endsWith(wrong));
    // The nearest step before comes first.
    QVERIFY(stepsOf(m_lab).indexOf(offered.front().step) < stepsOf(m_lab).indexOf(step));
}

void TestOtherMistakes::oneKeptWholeIsOfferedAlike()
{
    const auto before = named(mistakesOfOtherSteps(m_lab, step), text("ceiling-asks-downward"));
    QCOMPARE(before.size(), std::size_t(1));
    const QString path = knownPath(before[0].step, KnownKind::Mistake, before[0].name);
    LabFiles files = m_lab;
    const Result<QString> whole = programText(files, path);
    QVERIFY(whole && isDiff(files, path));
    files = withoutFile(files, path.chopped(4) + text(".diff"));
    files = withText(files, path, *whole);
    QVERIFY(!isDiff(files, path));
    QCOMPARE(named(mistakesOfOtherSteps(files, step), before[0].name), before);
}

/// With its words in every language, kept as a difference, and undone by one step of undo.
void TestOtherMistakes::takenOverItFailsThereToo()
{
    const auto ceiling =
        named(mistakesOfOtherSteps(m_lab, step), text("ceiling-asks-downward")).front();
    LabFiles taken;
    TAKE(taken, withOtherMistake(m_lab, step, ceiling));
    QCOMPARE(differences(m_lab, taken),
             (QStringList{step + text("/mistakes/ceiling-asks-downward.diff"),
                          step + text("/task.ar.json"), step + text("/task.de.json"),
                          step + text("/task.fr.json")}));
    for (const char *language : {"de", "fr", "ar"})
        QCOMPARE(knownText(taken, step, KnownKind::Mistake, ceiling.name, text(language)),
                 knownText(m_lab, ceiling.step, KnownKind::Mistake, ceiling.name, text(language)));
    const Result<Lab> lab = readLab(taken, text("lab"));
    QVERIFY2(lab->findings.empty(),
             lab->findings.empty() ? "" : qPrintable(lab->findings[0].toString()));
    const auto task = std::find_if(lab->tasks.begin(), lab->tasks.end(),
                                   [](const Task &each) { return each.id == step; });
    const auto report =
        judgeTask(*lab, *task, Submission(task->preset, ceiling.program), 1, JudgeHooks());
    QVERIFY(report && !report->passed);
    QCOMPARE(report->diagnosis()->mistake, ceiling.name);
    QVERIFY(named(mistakesOfOtherSteps(taken, step), ceiling.name).empty());
}

void TestOtherMistakes::ownNamesAndProgramsAreNotOffered()
{
    const QStringList own = knownNames(m_lab, step, KnownKind::Mistake);
    QStringList names;
    for (const OtherMistake &each : mistakesOfOtherSteps(m_lab, step)) {
        QVERIFY2(!own.contains(each.name), qPrintable(each.name));
        QVERIFY2(!names.contains(each.name), qPrintable(each.name));
        names.append(each.name);
        QVERIFY2(each.program != textOf(m_lab, step + text("/solution.lua")),
                 qPrintable(each.name));
    }
}

void TestOtherMistakes::ownNameIsNotOfferedWithAnotherProgram()
{
    const QString name = text("ceiling-asks-downward");
    QVERIFY(!named(mistakesOfOtherSteps(m_lab, step), name).empty());
    LabFiles files;
    TAKE(files, withKnownAdded(m_lab, step, KnownKind::Mistake, name,
                               text("-- Nothing moves\nfunction on_update(h) end\n")));
    QVERIFY(named(mistakesOfOtherSteps(files, step), name).empty());
}

void TestOtherMistakes::stepWithoutASolutionIsOfferedNothing()
{
    LabFiles files = m_lab;
    files.contents.remove(step + text("/solution.lua"));
    QVERIFY(mistakesOfOtherSteps(files, step).empty());
}

QTEST_GUILESS_MAIN(TestOtherMistakes)
#include "test_other_mistakes.moc"
