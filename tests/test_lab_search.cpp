// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/lab_search.h"

#include "tests/authoring_labs.h"

using namespace cradle;
using namespace cradle::authoring;

/// Finding and replacing over all files of a lab.
class TestLabSearch : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void everyKindOfFileIsLookedAt();
    void caseAndWholeWordsAndStepNarrowIt();
    void textsOfJsonAreFoundAtTheirPlace();
    void wordsOfTheFormatStay();
    void differencesShowWhatIsTheirsAlone();
    void replacingReachesSolutionAndDifferences();
    void replacingTouchesNothingElse();
    void replacementIsTakenLiterally();
    void whatWouldNotBeRightIsRefused();
    void brokenFilesAreLookedAtToo();

private:
    LabFiles m_ball;
};

namespace {

QStringList pathsOf(const std::vector<LabHit> &hits)
{
    QStringList paths;
    for (const LabHit &hit : hits)
        paths.append(hit.path);
    return paths;
}

} // namespace

void TestLabSearch::init()
{
    TAKE(m_ball, readLabFiles(sourcePath("tasks/labs/bouncing-ball")));
}

void TestLabSearch::everyKindOfFileIsLookedAt()
{
    const QStringList paths = pathsOf(findInLab(m_ball, {.text = text("symplectic euler")}));
    for (const char *path : {"BALL1/instructions.md", "BALL1/solution.lua", "BALL1/task.json",
                             "BALL1/mistakes/old-velocity.diff"})
        QVERIFY2(paths.contains(text(path)), path);
    QVERIFY(!paths.contains(text("BALL1/starter.lua"))); // it does not give it away
    QVERIFY(findInLab(m_ball, {.text = {}}).empty());
    QVERIFY(findInLab(m_ball, {.text = text("phlogiston")}).empty());
}

void TestLabSearch::caseAndWholeWordsAndStepNarrowIt()
{
    LabFiles files;
    files.contents.insert(text("A/instructions.md"), "Ball\nball, ball_1 and balls: Ball\n");
    files.contents.insert(text("B/instructions.md"), "a ball\n");
    const auto count = [&](const LabSearch &search) {
        int all = 0;
        for (const LabHit &hit : findInLab(files, search))
            all += hit.count;
        return all;
    };
    QCOMPARE(count({.text = text("ball")}), 6);
    QCOMPARE(count({.text = text("ball"), .matchCase = true}), 4);
    QCOMPARE(count({.text = text("ball"), .wholeWords = true}), 4);
    QCOMPARE(count({.text = text("ball"), .matchCase = true, .wholeWords = true}), 2);
    QCOMPARE(count({.text = text("ball"), .step = text("B")}), 1);
    const std::vector<LabHit> hits = findInLab(files, {.text = text("balls")});
    QCOMPARE(hits.size(), std::size_t(1));
    QCOMPARE(hits[0].line, 2);
    QCOMPARE(hits[0].at, 17);
}

void TestLabSearch::textsOfJsonAreFoundAtTheirPlace()
{
    const std::vector<LabHit> hits =
        findInLab(m_ball, {.text = text("On the Moon, thrown"), .step = text("BALL1")});
    QCOMPARE(hits.size(), std::size_t(1));
    QCOMPARE(hits[0].path, text("BALL1/task.json"));
    QCOMPARE(hits[0].pointer, text("/checks/2/title"));
    QCOMPARE(hits[0].line, 0);
}

void TestLabSearch::wordsOfTheFormatStay()
{
    // "moon" is the id of a check and in its title; "integrates" is a kind alone.
    QVERIFY(
        findInLab(m_ball, {.text = text("integrates"), .wholeWords = true, .step = text("BALL1")})
            .empty());
    LabFiles renamed;
    TAKE(renamed,
         replacedInLab(m_ball, {.text = text("moon"), .step = text("BALL1")}, text("Mars")));
    TaskForm form;
    TAKE(form, taskForm(renamed, text("BALL1")));
    QCOMPARE(form.checks[2].id, text("moon"));
    QCOMPARE(form.checks[2].title,
             text("On the Mars, thrown, it falls by the gravity of the Mars"));
}

void TestLabSearch::differencesShowWhatIsTheirsAlone()
{
    // The line stands in the solution and, as what it was or stays, in eight differences.
    const QStringList paths =
        pathsOf(findInLab(m_ball, {.text = text("+ gravity * timestep"), .step = text("BALL1")}));
    QCOMPARE(paths.count(text("BALL1/mistakes/gravity-subtracted.diff")), 0);
    QCOMPARE(paths.count(text("BALL1/mistakes/gravity-twice.diff")), 1); // the second one
    QCOMPARE(paths.count(text("BALL1/solution.lua")), 1);
}

void TestLabSearch::replacingReachesSolutionAndDifferences()
{
    LabFiles files;
    TAKE(files, replacedInLab(m_ball,
                              {.text = text("timestep"), .wholeWords = true, .step = text("BALL1")},
                              text("dt")));
    QVERIFY(!textOf(files, text("BALL1/solution.lua")).contains(text("timestep")));
    for (const QString &name : knownNames(files, text("BALL1"), KnownKind::Mistake)) {
        const QString path = knownPath(text("BALL1"), KnownKind::Mistake, name);
        QString before, after;
        TAKE(before, programText(m_ball, path));
        TAKE(after, programText(files, path)); // it still applies
        QCOMPARE(after, before.replace(text("timestep"), text("dt")));
        QVERIFY2(isDiff(files, path), qPrintable(name));
    }
    // And back again.
    LabFiles back;
    TAKE(back, replacedInLab(files, {.text = text("dt"), .wholeWords = true, .step = text("BALL1")},
                             text("timestep")));
    QCOMPARE(textOf(back, text("BALL1/solution.lua")), textOf(m_ball, text("BALL1/solution.lua")));
}

void TestLabSearch::replacingTouchesNothingElse()
{
    LabFiles files;
    TAKE(files, replacedInLab(m_ball, {.text = text("It is let go at rest"), .step = text("BALL1")},
                              text("It hangs at rest")));
    QCOMPARE(differences(m_ball, files), QStringList{text("BALL1/task.json")});
    QCOMPARE(
        newLines(m_ball.contents[text("BALL1/task.json")], files.contents[text("BALL1/task.json")])
            .size(),
        1);
    TAKE(files, replacedInLab(m_ball, {.text = text("phlogiston")}, text("heat")));
    QCOMPARE(files, m_ball);
}

void TestLabSearch::replacementIsTakenLiterally()
{
    LabFiles files;
    files.contents.insert(text("A/instructions.md"), "a.b a.b axb\n");
    LabFiles replaced;
    TAKE(replaced, replacedInLab(files, {.text = text("a.b")}, text("\\1 $& \\frac")));
    QCOMPARE(replaced.contents[text("A/instructions.md")],
             QByteArray("\\1 $& \\frac \\1 $& \\frac axb\n"));
}

void TestLabSearch::whatWouldNotBeRightIsRefused()
{
    // A title has at most 200 characters.
    const auto tooLong =
        replacedInLab(m_ball, {.text = text("Drop it")}, QString(201, QLatin1Char('x')));
    QVERIFY(!tooLong.ok());
    QVERIFY(tooLong.error().toString().contains(text("title")));
}

/// Line by line; but replaced is nothing, not even elsewhere, before they are mended.
void TestLabSearch::brokenFilesAreLookedAtToo()
{
    LabFiles files = m_ball;
    files.contents[text("BALL1/task.json")].chop(4);
    const std::vector<LabHit> whole = findInLab(m_ball, {.text = text("\"title\"")});
    QVERIFY(whole.empty()); // a key is no text of the author
    const std::vector<LabHit> hits = findInLab(files, {.text = text("\"title\"")});
    QVERIFY(!hits.empty());
    QCOMPARE(hits.front().path, text("BALL1/task.json"));
    QVERIFY(hits.front().line > 0);
    const Result<LabFiles> replaced = replacedInLab(files, {.text = text("Ball")}, text("Disc"));
    QVERIFY(!replaced);
    QCOMPARE(replaced.error().file, text("BALL1/task.json"));
    QVERIFY(replaced.error().message.contains(text("broken")));
    // Where the broken file has it not, nothing stands in the way.
    QVERIFY(replacedInLab(files, {.text = text("phlogiston")}, text("x")));
}

QTEST_GUILESS_MAIN(TestLabSearch)

#include "test_lab_search.moc"
