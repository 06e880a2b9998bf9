// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/answer_programs.h"
#include "tests/lab_test.h"
#include "tests/law_print.h"
#include "tests/told_deviations.h"

#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_words.h"

using namespace cradle;
using namespace cradle::approved;

/// What is said of programs that answer walls and other circles by other laws,
/// with numbers in them that are wrong by a little or much. Hashes of what is
/// said of some ten each, and how often each headline is, are in
/// tests/approved/answers.txt.
class TestApprovedAnswers : public QObject
{
    Q_OBJECT
private slots:
    void whatIsSaidOfAnswersIsAsApproved();
};

namespace {

QString printOf(const MeasuredWalls &walls)
{
    Print print;
    for (const auto *hits : {&walls.hits, &walls.corners, &walls.slow, &walls.alike, &walls.denser,
                             &walls.slower, &walls.slanted, &walls.far, &walls.middle}) {
        for (const WallHit &hit : *hits)
            print.add(hit);
    }
    for (const Drop &drop : walls.drops)
        print.add(drop);
    return print.text();
}

QString printOf(const MeasuredPair &pair)
{
    Print print;
    for (const auto *hits :
         {&pair.contacts, &pair.otherRadii, &pair.modes, &pair.equals, &pair.radii, &pair.sizes,
          &pair.densities, &pair.rebounds, &pair.inSteps, &pair.partings, &pair.varied}) {
        for (const PairHit &hit : *hits)
            print.add(hit);
    }
    return print.text();
}

} // namespace

void TestApprovedAnswers::whatIsSaidOfAnswersIsAsApproved()
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    ToldDeviations told(QStringLiteral("answers.txt"));
    unsigned seed = 0;
    for (const char *step : {"L42T17", "L42T14", "L42T7"}) {
        const Task &task = lab.tasks[std::size_t(lab.indexOf(QLatin1String(step)))];
        const Ground ground(task, task.preset);
        const MeasuredLaws right(&task.solution, ground);
        for (int part = 1; part <= 10; ++part) {
            Draws draws(++seed);
            for (int i = 0; i < 8; ++i) {
                const QString source = answers::program(draws);
                const MeasuredLaws own(&source, ground);
                told.add(printOf(own.walls()));
                told.add(wallDeviations(own.walls(), right.walls(), ground));
                told.add(own.walls().isLike(right.walls()));
                if (!ground.pair.asked)
                    continue;
                told.add(printOf(own.pair()));
                told.add(contactDeviations(own.pair(), right.pair(), ground));
                told.add(responseDeviations(own.pair(), right.pair(), ground));
                told.add(own.pair().contactIsLike(right.pair()));
            }
            const QString odd = told.endPart(task.id + QStringLiteral(" %1").arg(part));
            QVERIFY2(odd.isEmpty(), qPrintable(odd));
        }
    }
    const QString difference = told.end();
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedAnswers)
#include "test_approved_answers.moc"
