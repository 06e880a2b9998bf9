// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/condition_words.h"
#include "tasks/reading/lab_list.h"

using namespace cradle;
using namespace cradle::programs;

/// What a program does right at some times or places only is not told as if it always, or never,
/// did it.
class TestConditions : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whatIsAlwaysSoHasNoCondition_data();
    void whatIsAlwaysSoHasNoCondition();
    void conditionIsNamed_data();
    void conditionIsNamed();
    void clockAnswersNothing();
    void wordsTellWhatWasSeen();
    void whoReachesAWallInAStepTouchesIt();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

/// What is said of all aspects in the end.
std::vector<LawDeviation> said(const LawBench &step, const QString &program)
{
    const MeasuredLaws own(&program, step.ground);
    std::vector<LawDeviation> all;
    const Moment shown{.stage = {step.ground.own, false}};
    for (const auto &[aspect, found] :
         {std::pair(Aspect::Motion,
                    flightDeviations(own.flight(), step.right.flight(), step.ground)),
          std::pair(Aspect::Walls, wallDeviations(own.walls(), step.right.walls(), step.ground)),
          std::pair(Aspect::Contact, contactDeviations(own.pair(), step.right.pair(), step.ground)),
          std::pair(Aspect::Response,
                    responseDeviations(own.pair(), step.right.pair(), step.ground))}) {
        // As a judge does: how they fly is not always the same.
        if (aspect != Aspect::Motion && !all.empty() && all.front().isConditional
            && all.front().aspect == Aspect::Motion) {
            all.insert(all.end(), found.begin(), found.end());
            continue;
        }
        const ConditionedAspect conditions =
            conditioned(aspect, found, own, step.right, step.ground, shown);
        all.insert(all.end(), conditions.deviations.begin(), conditions.deviations.end());
        if (conditions.isOfPlace)
            break;
    }
    return all;
}

QString eOf(const QString &step)
{
    return step == QLatin1String("L42T16") || step == QLatin1String("L42T17")
               ? QStringLiteral("restitution")
               : QStringLiteral("1");
}

/// Right work for a step, with conditions in front of its parts.
struct Conditions {
    const char *start = "";
    const char *move = "true";  ///< gravity
    const char *go = "true";    ///< the way
    const char *fresh = "true"; ///< that it is the new velocity that makes the way
    const char *walls = "true";
    const char *turned = "";         ///< what is done after a hit at a wall
    const char *radius = "c.radius"; ///< at the walls
    const char *back = "";           ///< what a wall gives back, if not what it should
    const char *hit = "closing > 0";
    const char *met = ""; ///< what is done after a hit of the two
    const char *e = "";
};

QString program(const QString &step, const Conditions &c, std::size_t form)
{
    const QString e =
        step == QLatin1String("L42T17") ? QStringLiteral("restitution") : QStringLiteral("1");
    const QByteArray back = *c.back ? QByteArray(c.back) : e.toLatin1();
    LawProgram law;
    law.start = text(c.start);
    law.move = text("local before = c.velocity "
                    "if %1 then c.velocity = c.velocity + gravity * h end "
                    "if %2 then c.position = c.position + (%3 and c.velocity or before) * h end")
                   .arg(text(c.move), text(c.go), text(c.fresh));
    law.walls = text("local came = c.velocity if %1 then %2 if c.velocity ~= came then %3 end end")
                    .arg(text(c.walls), wallsOf(wallWays[form], c.radius, back.constData()),
                         text(c.turned));
    if (step.mid(4).toInt() > 8)
        law.hit = hitOf(hitWays[form == 0 ? 0 : 2],
                        {.approach = text(c.hit),
                         .e = *c.e ? text(c.e) : eOf(step),
                         .answer = HitLaw().answer + QLatin1Char(' ') + text(c.met)});
    return written(law, structures[form == 0 ? 3 : 1]);
}

} // namespace

void TestConditions::whatIsAlwaysSoHasNoCondition_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("source");
    QTest::addColumn<QStringList>("headlines");
    for (const char *step : {"L42T7", "L42T12", "L42T16", "L42T17"}) {
        for (const std::size_t form : {0U, 1U})
            QTest::addRow("%s, form %zu", step, form)
                << text(step) << program(text(step), {}, form) << QStringList();
    }
    for (const std::size_t form : {0U, 1U}) {
        // In long runs, too, circles stay what they are: a program may keep their radii.
        QTest::addRow("radii of the start, and e squared, form %zu", form)
            << text("L42T17")
            << program(text("L42T17"),
                       {.start = "kept = {circle1.radius, circle2.radius}",
                        .radius = "kept[c.index]",
                        .back = "restitution ^ 2"},
                       form)
            << QStringList(text("At the walls e acts on both circles twice"));
        // What drag makes of a throw before it arrives is no fault of the hit.
        QTest::addRow("drag in x, form %zu", form)
            << text("L42T17")
            << program(text("L42T17"),
                       {.move = "true then c.velocity = vec(c.velocity.x * 0.99, c.velocity.y) end "
                                "if true"},
                       form)
            << QStringList(text("Something slows both circles down on the way (only in x)"));
        QTest::addRow("e squared at walls, form %zu", form)
            << text("L42T17") << program(text("L42T17"), {.back = "restitution ^ 2"}, form)
            << QStringList(text("At the walls e acts on both circles twice"));
        // Slow ones, too, come as late as those of another radius did.
        for (const char *step : {"L42T15", "L42T17"})
            QTest::addRow("late walls, %s, form %zu", step, form)
                << text(step) << program(text(step), {.radius = "c.radius - 0.1"}, form)
                << QStringList(text("Hits at the walls turn both circles round too late"));
        QTest::addRow("e squared in hits, form %zu", form)
            << text("L42T16") << program(text("L42T16"), {.e = "restitution ^ 2"}, form)
            << QStringList(text("e is squared in the hit of two circles"));
    }
}

void TestConditions::whatIsAlwaysSoHasNoCondition()
{
    QFETCH(QString, step);
    QFETCH(QString, source);
    QFETCH(QStringList, headlines);
    const LawBench bench(task(step));
    QCOMPARE(LawBench::headlines(said(bench, source)), headlines);
}

void TestConditions::conditionIsNamed_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("which");
    const auto rows = [](const char *name, std::initializer_list<const char *> steps,
                         const char *headline, const char *which, const Conditions &conditions) {
        for (const char *step : steps) {
            for (const std::size_t form : {0U, 1U})
                QTest::addRow("%s, %s, form %zu", name, step, form)
                    << text(step) << program(text(step), conditions, form) << text(headline)
                    << text(which);
        }
    };
    // Each number is that of the throw, hit or step that was the nearest to the limit.
    rows("walls above", {"L42T7", "L42T12", "L42T17"},
         "Some hits of both circles at the walls are ",
         ": all at y = ", {.walls = "c.position.y > 0"});
    rows("walls one way", {"L42T7", "L42T12"},
         "Some hits of both circles at the walls are not answered",
         ": all that moved to the right, no others.", {.walls = "c.velocity.x > 0"});
    rows("walls of the fast", {"L42T12"}, "Some hits of both circles at the walls are not answered",
         " m/s or more, none with up to ", {.walls = "c.velocity:length() > 3"});
    rows("walls while another goes left", {"L42T7", "L42T12"},
         "Some hits of circle 1 at the walls are not answered",
         ": all while another circle moved to the left, no others.",
         {.walls = "(c.index == 2 or circle2.velocity.x < 0)"});
    rows("walls while another goes up", {"L42T7", "L42T12"},
         "Some hits of circle 2 at the walls are not answered",
         ": all while another circle moved upward, no others.",
         {.walls = "(c.index == 1 or circle1.velocity.y > 0)"});
    rows("walls once", {"L42T7", "L42T12", "L42T17"},
         "Some hits of both circles at the walls are not answered",
         ": the first in a run, none of the later ones.",
         {.start = "done = false", .walls = "not done", .turned = "done = true"});
    rows("walls with a pause", {"L42T12", "L42T17"},
         "Some hits of both circles at the walls are answered too late",
         " s or more after the one before, none that came within ",
         {.start = "last = -9", .walls = "time - last > 0.2", .turned = "last = time"});
    rows("walls until", {"L42T7", "L42T12", "L42T17"},
         "Some hits of both circles at the walls are not answered", " s of a run, none from ",
         {.walls = "time < 3"});
    rows("e of the walls", {"L42T17"}, "Some hits of both circles at the walls come out wrong",
         " s of a run, none from ", {.back = "(time < 3 and restitution or 1)"});
    rows("walls until they meet", {"L42T12", "L42T17"},
         "Some hits of circle 2 at the walls are not answered",
         ": all before the two circles had hit each other, none after it.",
         {.start = "met = false", .walls = "not (met and c.index == 2)", .met = "met = true"});
    rows("fall above the floor", {"L42T3", "L42T7", "L42T17"}, "At times gravity acts wrongly on ",
         ": all at y = ", {.move = "c.position.y > -3.5"});
    rows("fall until", {"L42T7", "L42T17"}, "At times gravity acts wrongly on both circles",
         " s of a run, none from ", {.move = "time < 3"});
    rows("fall from", {"L42T7", "L42T17"}, "At times gravity acts wrongly on both circles",
         " s of a run on, none up to ", {.move = "time > 1"});
    rows("stop from", {"L42T12", "L42T16"}, "At times the velocity of both circles changes wrongly",
         " s of a run, none from ", {.move = "time > 3 then c.velocity = vec(0, 0) end if true"});
    rows("way to the left", {"L42T3", "L42T7", "L42T17"}, "At times the way of ",
         ": all at x = ", {.go = "c.position.x < 0.2"});
    rows("way until", {"L42T7", "L42T12"}, "At times the way of both circles in a step is not v Δt",
         " s of a run, none from ", {.go = "time < 5"});
    rows("method until", {"L42T7", "L42T17"},
         "At times the motion of both circles is not symplectic Euler", " s of a run, none from ",
         {.fresh = "time < 2"});
    rows("method until a wall", {"L42T7", "L42T17"},
         "At times the motion of both circles is not symplectic Euler",
         ": all before the circles had hit a wall, none after it.",
         {.start = "touched = false", .fresh = "not touched", .turned = "touched = true"});
    rows("method above", {"L42T7"}, "At times the motion of both circles is not symplectic Euler",
         ": all at y = ", {.fresh = "c.position.y > 0"});
    rows("method to the left", {"L42T3"}, "At times the motion of circle 1 is not Euler",
         ": all at x = ", {.fresh = "c.position.x < 0"});
    rows("gravity after a wall", {"L42T7"}, "At times gravity acts wrongly on both circles",
         ": all after the circles had hit a wall, none before it.",
         {.start = "touched = false", .move = "touched", .turned = "touched = true"});
    rows("first hit", {"L42T12", "L42T16", "L42T17"}, "A later hit is not answered", "",
         {.start = "met = false", .hit = "closing > 0 and not met", .met = "met = true"});
    rows("hits above", {"L42T12", "L42T16"}, "Some hits of the two circles are not answered",
         ": all at y = ", {.hit = "closing > 0 and p.position.y > 0"});
    rows("hits until", {"L42T12", "L42T17"}, "Some hits of the two circles are not answered",
         " s of a run, none from ", {.hit = "closing > 0 and time < 3"});
    rows("e from a step on", {"L42T16", "L42T17"}, "Some hits of the two circles come out wrong",
         " s of a run on, none up to ", {.e = "(step < 70 and 1 or restitution)"});
    rows("hits of slow ones", {"L42T12"}, "Some hits of the two circles come out wrong",
         ": all with circle 1 at up to ", {.e = "(p.velocity:length() > 2.2 and 0.5 or 1)"});
    rows("hits of the smaller", {"L42T14"}, "Some hits of the two circles come out wrong",
         ": all but those where circle 1 is the larger one.",
         {.e = "(p.radius > q.radius and 0.5 or 1)"});
    rows("hits upward", {"L42T12"}, "Some hits of the two circles come out wrong",
         ": all but those where circle 1 moves downward.",
         {.e = "(p.velocity.y < 0 and 0.5 or 1)"});
    rows("e that counts of fast ones", {"L42T16"}, "Some hits of the two circles come out wrong",
         " came out right.", {.e = "(p.velocity:length() > 2.2 and 1 or restitution)"});
    rows("what was kept from the first", {"L42T12"}, "Some hits of the two circles come out wrong",
         ": the first in a run, none of the later ones.",
         {.start = "kept = false",
          .hit = "closing > 0",
          .met = "kept = kept or q.velocity q.velocity = kept"});
}

/// Who stops all circles from a time on answers no hit.
void TestConditions::clockAnswersNothing()
{
    const LawBench bench(task(text("L42T12")));
    const QString source = program(text("L42T12"),
                                   {.move = "time > 1.7 then c.velocity = vec(0, 0) end if true",
                                    .hit = "closing < 0 and false"},
                                   0);
    const MeasuredLaws own(&source, bench.ground);
    const auto contact = conditioned(Aspect::Contact, {}, own, bench.right, bench.ground, {});
    QVERIFY(contact.deviations.empty());
}

void TestConditions::conditionIsNamed()
{
    QFETCH(QString, step);
    QFETCH(QString, source);
    QFETCH(QString, headline);
    QFETCH(QString, which);
    const LawBench bench(task(step));
    const auto all = said(bench, source);
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY2(all[0].message.startsWith(headline) && all[0].message.contains(which),
             qPrintable(all[0].message));
}

void TestConditions::wordsTellWhatWasSeen()
{
    const LawBench bench(task(text("L42T12")));
    const auto all = said(bench, program(text("L42T12"), {.hit = "closing > 0 and time < 3"}, 0));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(all.front().isConditional);
    QVERIFY2(all.front().message.contains(
                 text("Of 14 tries, early and late, here and there, 8 came out right: all up to ")),
             qPrintable(all.front().message));
}

/// Who falls so fast that a step takes it past the floor is put back rightly: no place divides it.
void TestConditions::whoReachesAWallInAStepTouchesIt()
{
    const LawBench bench(task(text("L42X6")));
    const QString source =
        written({.move = text("c.velocity = c.velocity + gravity * (time / 2) "
                              "c.position = c.position + c.velocity * h"),
                 .walls = text("local edge = square.half_width - c.radius "
                               "if math.abs(c.position.y) > edge then c.position = old "
                               "c.velocity = vec(c.velocity.x, -c.velocity.y) end")},
                structures[0]);
    const MeasuredLaws own(&source, bench.ground);
    const auto motion = conditioned(Aspect::Motion, {}, own, bench.right, bench.ground, {});
    for (const LawDeviation &each : motion.deviations)
        QVERIFY2(!each.message.contains(text("touching nothing, went (0, 0) m")),
                 qPrintable(each.message));
}

QTEST_GUILESS_MAIN(TestConditions)
#include "test_conditions.moc"
