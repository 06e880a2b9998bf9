// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"

using namespace cradle;
using namespace cradle::programs;

/// Where some hits come out right and others do not, what divides them is said.
class TestMeetingSides : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void hitsAnsweredRightlyOnOneSideOnlySaySo();
    void hitsRightOnOneSideOnlySaySo_data();
    void hitsRightOnOneSideOnlySaySo();
    void hitsOfOneWayOfMovingSaySo();
};

/// An angle by its cosine is right above circle 1 only: every hit is answered, some wrongly.
void TestMeetingSides::hitsAnsweredRightlyOnOneSideOnlySaySo()
{
    const QString normal = QStringLiteral("(function() local f = math.acos(d.x / d:length()) "
                                          "return vec(math.cos(f), math.sin(f)) end)()");
    const Task &step = task(QStringLiteral("L42T12"));
    for (const Structure &structure : structures) {
        const LawProgram program =
            withHit(hitOf(hitWays[0], {.normal = normal, .mass = QStringLiteral("1")}));
        const auto report =
            judgeTask(m_lab, step, Submission(step.preset, written(program, structure)), 1);
        QVERIFY(report && !report->findings.empty());
        const QString said = report->findings.back().message; // the start is not that of the step
        QVERIFY2(
            said.contains(QStringLiteral(": those where circle 2 is above circle 1, no others.")),
            qPrintable(said));
    }
}

void TestMeetingSides::hitsRightOnOneSideOnlySaySo_data()
{
    QTest::addColumn<QString>("normal");
    QTest::addColumn<QString>("touch");
    QTest::addColumn<QString>("side");
    const auto angle = [](const char *name, const char *formula, const char *side) {
        QTest::newRow(name) << QStringLiteral("(function() local f = %1 return vec(math.cos(f), "
                                              "math.sin(f)) end)()")
                                   .arg(QLatin1String(formula))
                            << "d:length() < reach" << side;
    };
    angle("angle of a ratio", "math.atan(d.y / d.x)", "circle 2 is to the right of circle 1");
    angle("and turned by half a circle", "math.atan(d.y / d.x) + math.pi",
          "circle 2 is to the left of circle 1");
    QTest::newRow("distance without its sign") << "d:normalized()"
                                               << "d:length() < reach and d.x > 0"
                                               << "circle 2 is to the right of circle 1";
    QTest::newRow("only below") << "d:normalized()"
                                << "d:length() < reach and d.y < 0"
                                << "circle 2 is below circle 1";
}

void TestMeetingSides::hitsRightOnOneSideOnlySaySo()
{
    QFETCH(QString, normal);
    QFETCH(QString, touch);
    QFETCH(QString, side);
    const LawBench bench(task(QStringLiteral("L42T12")));
    for (const Structure &structure : structures) {
        const LawProgram program = withHit(
            hitOf(hitWays[0], {.touch = touch, .normal = normal, .mass = QStringLiteral("1")}));
        const auto found = bench.contactFound(written(program, structure));
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY2(
            found[0].message.contains(QStringLiteral(": those where %1, no others.").arg(side)),
            qPrintable(found[0].message));
    }
}

/// Whoever asks for one part of the velocity is not said to ask on which side the other is.
void TestMeetingSides::hitsOfOneWayOfMovingSaySo()
{
    const LawBench bench(task(QStringLiteral("L42T12")));
    for (const auto &[approach, way] : {std::pair("p.velocity.x > q.velocity.x", "to the right"),
                                        std::pair("p.velocity.x < q.velocity.x", "to the left"),
                                        std::pair("p.velocity.y > q.velocity.y", "upward"),
                                        std::pair("p.velocity.y < q.velocity.y", "downward")}) {
        const LawProgram program = withHit(
            hitOf(hitWays[0], {.approach = QLatin1String(approach), .mass = QStringLiteral("1")}));
        for (const int structure : {0, 3}) {
            const auto found = bench.contactFound(written(program, structures[structure]));
            QCOMPARE(found.size(), std::size_t{1});
            QVERIFY2(found[0].message.contains(
                         QStringLiteral(
                             ": those where circle 1, seen from circle 2, moves %1, no others.")
                             .arg(QLatin1String(way))),
                     qPrintable(found[0].message));
        }
    }
}

QTEST_GUILESS_MAIN(TestMeetingSides)
#include "test_meeting_sides.moc"
