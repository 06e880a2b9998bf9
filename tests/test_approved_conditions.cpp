// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/answer_programs.h"
#include "tests/lab_test.h"
#include "tests/told_deviations.h"

#include "tasks/judging/condition_words.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_words.h"

using namespace cradle;
using namespace cradle::approved;

/// What is said in the end of programs that answer walls and other circles wrongly, at times or
/// always: hashes of what is said of five each, and how often each headline is, are in
/// tests/approved/conditions.txt.
class TestApprovedConditions : public QObject
{
    Q_OBJECT
private slots:
    void whatIsSaidInTheEndIsAsApproved();
};

void TestApprovedConditions::whatIsSaidInTheEndIsAsApproved()
{
    const Lab lab = *readLab(QLatin1String(shippedLab));
    ToldDeviations told(QStringLiteral("conditions.txt"));
    unsigned seed = 100;
    for (const char *step : {"L42T17", "L42T12", "L42T7"}) {
        const Task &task = lab.tasks[std::size_t(lab.indexOf(QLatin1String(step)))];
        const Ground ground(task, task.preset);
        const MeasuredLaws right(&task.solution, ground);
        for (int part = 1; part <= 8; ++part) {
            Draws draws(++seed);
            for (int i = 0; i < 5; ++i) {
                const QString source = answers::program(draws);
                const MeasuredLaws own(&source, ground);
                const auto add = [&](Aspect aspect, std::vector<LawDeviation> found) {
                    const Moment shown =
                        found.empty() ? Moment{{ground.own}, 1, {0, 1}} : found.front().moment;
                    const ConditionedAspect said =
                        conditioned(aspect, std::move(found), own, right, ground, shown);
                    told.add(said.deviations);
                    told.add(said.isOfPlace);
                };
                add(Aspect::Walls, wallDeviations(own.walls(), right.walls(), ground));
                if (!ground.pair.asked)
                    continue;
                add(Aspect::Contact, contactDeviations(own.pair(), right.pair(), ground));
                add(Aspect::Response, responseDeviations(own.pair(), right.pair(), ground));
            }
            const QString odd = told.endPart(task.id + QStringLiteral(" %1").arg(part));
            QVERIFY2(odd.isEmpty(), qPrintable(odd));
        }
    }
    const QString difference = told.end();
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedConditions)
#include "test_approved_conditions.moc"
