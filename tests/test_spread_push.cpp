// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_numbers.h"

#include "tasks/judging/judgement.h"
#include "tasks/judging/response_law_words.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is said of hits that go on over several steps.
class TestSpreadPush : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void stepsOfAPushAreTold_data();
    void stepsOfAPushAreTold();
    void nothingElseIsSaidOfIt();
    void depthIsTold();
    void otherLawsAreNoSpreadPush_data();
    void otherLawsAreNoSpreadPush();

private:
    [[nodiscard]] std::optional<LawDeviation> spread(const QString &step, const QString &hit) const
    {
        const LawBench bench(task(step));
        const QString program = programOf(hit);
        const MeasuredLaws own(&program, bench.ground);
        return spreadDeviation(own.pair(), bench.right.pair());
    }
    [[nodiscard]] static QString programOf(const QString &hit)
    {
        LawProgram program = withHit(hit);
        program.start = QStringLiteral("left, pushed = 0, vec(0, 0)");
        program.walls = wallsOf(wallWays[0]);
        return written(program, structures[3]);
    }
};

namespace {

QString spring(const char *force)
{
    return QStringLiteral("local d = q.position - p.position "
                          "local deep = p.radius + q.radius - d:length() "
                          "if deep > 0 then "
                          "local push = d:normalized() * (%1) * h "
                          "p.velocity, q.velocity = p.velocity - push, q.velocity + push end")
        .arg(QLatin1String(force));
}

/// The right push in so many parts, one a step.
QString inParts(int parts)
{
    return QStringLiteral("local d = q.position - p.position "
                          "local n = d:normalized() "
                          "local closing = (p.velocity - q.velocity):dot(n) "
                          "if left == 0 and closing > 0 and d:length() < p.radius + q.radius then "
                          "left, pushed = %1, n * closing / %1 end "
                          "if left > 0 then left = left - 1 "
                          "p.velocity, q.velocity = p.velocity - pushed, q.velocity + pushed end")
        .arg(parts);
}

} // namespace

/// Of equal circles that meet with 1.2 and −0.4 m/s, or 1.2 and 0, a quarter of 1/60 s after the
/// step begins, so that they are three quarters of the way of a step in each other after it: 0.02
/// m, or 0.015.
void TestSpreadPush::stepsOfAPushAreTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("hit");
    QTest::addColumn<std::vector<double>>("left"); ///< after the first step and the last, m/s
    QTest::addColumn<int>("steps");
    const auto row = [](const char *step, const char *name, const QString &hit,
                        const std::vector<double> &left, int steps) {
        QTest::addRow("%s, %s", step, name) << QString::fromLatin1(step) << hit << left << steps;
    };
    row("L42T12", "two halves", inParts(2), {0.4, 0.4, -0.4, 1.2}, 2);
    row("L42T12", "three parts", inParts(3), {0.667, 0.133, -0.4, 1.2}, 3);
    row("L42T11", "two halves", inParts(2), {0.6, 0.6, 0.0, 1.2}, 2);
    row("L42T14", "two halves", inParts(2), {0.4, 0.4, -0.4, 1.2}, 2);
    // 3600/s² times the overlap: its push is 60/s times that. After the second step they are out.
    row("L42T12", "spring", spring("3600 * deep"), {0.0, 0.8, -0.4, 1.2}, 2);
    row("L42T10", "spring", spring("3600 * deep"), {0.0, 0.8, -0.4, 1.2}, 2);
    row("L42T12", "always the same force", spring("60"), {0.2, 0.6, -0.8, 1.6}, 2);
}

void TestSpreadPush::stepsOfAPushAreTold()
{
    QFETCH(QString, step);
    QFETCH(QString, hit);
    QFETCH(std::vector<double>, left);
    QFETCH(int, steps);
    const auto found = spread(step, hit);
    QVERIFY(found);
    const auto n = numbersIn(found->message,
                             "The first step of the hit, of 1/60 s, left them with # and # m/s, "
                             "step # of it with # and # m/s; # and # m/s are right");
    QVERIFY2(n.size() == 7, qPrintable(found->message));
    QVERIFY(isNear(n[0], left[0]) && isNear(n[1], left[1]));
    QCOMPARE(int(n[2]), steps);
    QVERIFY(isNear(n[3], left[2]) && isNear(n[4], left[3]));
    QVERIFY(isNear(n[5], step == QLatin1String("L42T11") ? 0.0 : -0.4) && isNear(n[6], 1.2));
}

/// No meeting is said to be answered too early, and no law to be another one.
void TestSpreadPush::nothingElseIsSaidOfIt()
{
    for (const char *step : {"L42T10", "L42T12"}) {
        const Task &of = task(QLatin1String(step));
        const CheckReport report =
            *judgeTask(m_lab, of, Submission(of.preset, programOf(inParts(3))), 1);
        QStringList said;
        for (const Finding &finding : report.findings) {
            if (finding.aspect == Aspect::Contact || finding.aspect == Aspect::Response)
                said.append(finding.message.section(QLatin1Char('\n'), 0, 0));
        }
        QCOMPARE(said, QStringList(QStringLiteral("The push of a hit is spread over several "
                                                  "steps")));
    }
}

void TestSpreadPush::depthIsTold()
{
    const QString depth = QStringLiteral("How deep they overlap after a step is chance");
    QVERIFY(spread(QStringLiteral("L42T12"), spring("3600 * deep"))->message.contains(depth));
    QVERIFY(!spread(QStringLiteral("L42T12"), spring("60"))->message.contains(depth));
    QVERIFY(!spread(QStringLiteral("L42T12"), inParts(2))->message.contains(depth));
}

void TestSpreadPush::otherLawsAreNoSpreadPush_data()
{
    QTest::addColumn<QString>("hit");
    const auto row = [](const char *name, const HitWay &way, const char *answer,
                        const char *approach = "closing > 0") {
        QTest::newRow(name) << hitOf(way, {.approach = QString::fromLatin1(approach),
                                           .mass = QStringLiteral("1"),
                                           .answer = QString::fromLatin1(answer)});
    };
    const HitWay &inPlace = hitWays[1];
    row("right", inPlace,
        "p.velocity, q.velocity = p.velocity - closing * n, "
        "q.velocity + closing * n");
    row("a share of the speed, again and again", inPlace,
        "p.velocity, q.velocity = p.velocity - 0.3 * closing * n, "
        "q.velocity + 0.3 * closing * n");
    row("too much, turned round again", inPlace,
        "p.velocity, q.velocity = p.velocity - 1.3 * closing * n, "
        "q.velocity + 1.3 * closing * n",
        "true");
    row("right, turned round again", inPlace,
        "p.velocity, q.velocity = p.velocity - closing * n, q.velocity + closing * n", "true");
    row("as long as they come nearer", inPlace,
        "p.velocity, q.velocity = p.velocity - 0.3 * n, q.velocity + 0.3 * n");
    // Walls bring them back, still in each other, so that they are hit again.
    row("far too much", inPlace,
        "p.velocity, q.velocity = p.velocity - 300 * closing * n, "
        "q.velocity + 300 * closing * n");
    row("along another normal, again and again", inPlace,
        "local a = math.deg(math.atan(n.y, n.x)) n = vec(math.cos(a), math.sin(a)) "
        "closing = math.max(dot(p.velocity - q.velocity, n), 0) "
        "p.velocity, q.velocity = p.velocity - closing * n, q.velocity + closing * n",
        "true");
    QTest::newRow("each of two steps more than all of it")
        << inParts(2).replace(QLatin1String("closing / 2"), QLatin1String("closing * 1.5"));
    QTest::newRow("nothing is left for the second of two steps")
        << inParts(2).replace(QLatin1String("closing / 2"), QLatin1String("closing * 1.2"));
}

void TestSpreadPush::otherLawsAreNoSpreadPush()
{
    QFETCH(QString, hit);
    const auto found = spread(QStringLiteral("L42T12"), hit);
    QVERIFY2(!found, qPrintable(found ? found->message : QString()));
}

QTEST_GUILESS_MAIN(TestSpreadPush)
#include "test_spread_push.moc"
