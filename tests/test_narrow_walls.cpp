// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/judgement.h"
#include "tests/law_programs.h"

using namespace cradle;
using namespace cradle::programs;

/// What is said of walls that turn circles round far from where they should: it is theirs alone,
/// wherever the circles start and meet.
class TestNarrowWalls : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void onlyTheirPlaceIsTold_data();
    void onlyTheirPlaceIsTold();
    void hitsAreJudgedBetweenThem();
    void freeRoomEndsWhereTheyTurn();

private:
    [[nodiscard]] QStringList headlines(const LawProgram &pieces, const Structure &structure) const
    {
        LawProgram program = pieces;
        program.start = QStringLiteral("gravity = vec(0, 0) "
                                       "circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0) "
                                       "circle2.position, circle2.velocity = vec(2, 2), vec(0, 0)");
        const Task &of = task(QLatin1String("L42T9"));
        const CheckReport report =
            *judgeTask(m_lab, of, Submission(of.preset, written(program, structure)), 1);
        QStringList lines;
        for (const Finding &finding : report.findings)
            lines.append(finding.message.section(QLatin1Char('\n'), 0, 0));
        return lines;
    }
};

namespace {

/// Each part by itself, back to where it was, whichever way it moves.
const QString flips = QStringLiteral("local room = ROOM - c.radius "
                                     "if math.abs(c.position.x) > room then "
                                     "c.position, c.velocity = vec(old.x, c.position.y), "
                                     "vec(-c.velocity.x, c.velocity.y) end "
                                     "if math.abs(c.position.y) > room then "
                                     "c.position, c.velocity = vec(c.position.x, old.y), "
                                     "vec(c.velocity.x, -c.velocity.y) end");

QString flipsAt(const char *room)
{
    return QString(flips).replace(QLatin1String("ROOM"), QLatin1String(room));
}

const QString early = QStringLiteral("Hits at the walls turn both circles round too early");

/// With \p answer where they touch and come nearer.
QString hitWith(const char *answer)
{
    return QStringLiteral("local d = q.position - p.position "
                          "if d:length() < p.radius + q.radius "
                          "and (p.velocity - q.velocity):dot(d) > 0 then ")
           + QLatin1String(answer) + QStringLiteral(" end");
}

} // namespace

void TestNarrowWalls::onlyTheirPlaceIsTold_data()
{
    QTest::addColumn<QString>("walls");
    QTest::newRow("at half the width") << flipsAt("0.5 * square.half_width");
    QTest::newRow("at 2.3 m") << flipsAt("2.3");
    QTest::newRow("asked which way") << wallsOf(wallWays[0], "square.half_width / 2 + c.radius");
}

void TestNarrowWalls::onlyTheirPlaceIsTold()
{
    QFETCH(QString, walls);
    const LawProgram pieces{.walls = walls,
                            .hit = hitWith("p.velocity, q.velocity = vec(0, 0), vec(0, 0)")};
    for (const int structure : {0, 1, 3})
        QCOMPARE(headlines(pieces, structures[structure]), QStringList(early));
}

void TestNarrowWalls::hitsAreJudgedBetweenThem()
{
    const LawProgram pieces{.walls = flipsAt("0.5 * square.half_width"),
                            .hit = hitWith("p.position, q.position = oldp, oldq "
                                           "p.velocity = vec(0, 0)")};
    for (const int structure : {0, 3})
        QCOMPARE(headlines(pieces, structures[structure]),
                 (QStringList{early, QStringLiteral("A hit stops circle 1 and not circle 2")}));
}

void TestNarrowWalls::freeRoomEndsWhereTheyTurn()
{
    const LawBench bench(task(QLatin1String("L42T9")));
    QVERIFY(std::isinf(bench.right.walls().freeRoom()));
    const QString program = written({.walls = flipsAt("2.3")}, structures[0]);
    const MeasuredLaws own(&program, bench.ground);
    const double radius = 0.2;
    const double step = 2.9 / 60.0; // of what comes from the middle
    const double room = own.walls().freeRoom();
    QVERIFY(room < 2.3 - radius && room > 2.3 - radius - step);
    for (const Wall wall : allWalls) {
        QVERIFY(own.walls().turnsFarAt(0, wall, 4.0 - 2.3 + radius));
        QVERIFY(!own.walls().turnsFarAt(0, wall, 4.0 - 2.3 + radius + step));
        QVERIFY(!bench.right.walls().turnsFarAt(0, wall, radius));
    }
}

QTEST_GUILESS_MAIN(TestNarrowWalls)
#include "test_narrow_walls.moc"
