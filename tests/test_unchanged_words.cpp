// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/unchanged_words.h"

#include "tests/check_spec.h"

#include <QTest>

using namespace cradle;

/// Programs that never give a circle another velocity, seen in their own scene alone.
class TestUnchangedWords : public QObject
{
    Q_OBJECT
private slots:
    void aVelocityThatNothingChangesIsTold_data();
    void aVelocityThatNothingChangesIsTold();
    void aPartThatIsNeverWrittenIsTold_data();
    void aPartThatIsNeverWrittenIsTold();
    void aPartThatMovesAnotherIsNotTold();
};

void TestUnchangedWords::aVelocityThatNothingChangesIsTold_data()
{
    QTest::addColumn<Vec2>("other");    // where the other circle rests, m
    QTest::addColumn<Vec2>("velocity"); // m/s
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("told");
    const QString none;
    QTest::newRow("through both") << Vec2{2, 0} << Vec2{1, 0} << none << true;
    QTest::newRow("beside the other") << Vec2{2, 1} << Vec2{1, 0} << none << false;
    QTest::newRow("stays away from walls") << Vec2{2, 0} << Vec2{0.12, 0} << none << false;
    QTest::newRow("turned once") << Vec2{2, 0} << Vec2{1, 0}
                                 << QStringLiteral("if circle1.position.x > 3 then "
                                                   "circle1.velocity = vec(-1, 0) end")
                                 << false;
    QTest::newRow("stops in the end") << Vec2{2, 0} << Vec2{1, 0}
                                      << QStringLiteral("if circle1.position.x > 5 then "
                                                        "error('far') end")
                                      << false;
    QTest::newRow("rests") << Vec2{0.3, 0} << Vec2{} << none << false;
}

/// Both have to come their way in 20 s.
void TestUnchangedWords::aVelocityThatNothingChangesIsTold()
{
    QFETCH(Vec2, other);
    QFETCH(Vec2, velocity);
    QFETCH(QString, line);
    QFETCH(bool, told);
    Task task;
    task.preset.gravity = {};
    task.preset.circles.resize(2);
    task.preset.circles[0].body = {.velocity = velocity, .radius = 0.2};
    task.preset.circles[1].body = {.position = other, .radius = 0.2};
    task.checks = {checkOf("integrates", {}, {0, 1})};
    const QString program =
        QStringLiteral("function on_update(h)\n"
                       "  circle1.position = circle1.position + circle1.velocity * h\n"
                       "  %1\n"
                       "end\n")
            .arg(line);
    const Ground ground(task, task.preset);
    const auto found = unchangedVelocity(&program, ground);
    QCOMPARE(found.has_value(), told);
    if (found)
        QCOMPARE(found->moment.circles, std::vector<int>{0});
}

void TestUnchangedWords::aPartThatIsNeverWrittenIsTold_data()
{
    QTest::addColumn<Vec2>("start");    // m/s
    QTest::addColumn<QString>("shown"); // of the own velocity v, m/s
    QTest::addColumn<QString>("words"); // empty: nothing is told
    QTest::newRow("both") << Vec2{2.1, 1.7} << QStringLiteral("v") << QString();
    QTest::newRow("x alone") << Vec2{2.1, 1.7} << QStringLiteral("vec(v.x, circle1.velocity.y)")
                             << QStringLiteral("the y is still that of the start");
    QTest::newRow("y alone") << Vec2{1.7, 2.1} << QStringLiteral("vec(circle1.velocity.x, v.y)")
                             << QStringLiteral("the x is still that of the start");
    QTest::newRow("none") << Vec2{2.1, 1.7} << QStringLiteral("circle1.velocity")
                          << QStringLiteral("its velocity is still the (2.1, 1.7) m/s");
}

void TestUnchangedWords::aPartThatIsNeverWrittenIsTold()
{
    QFETCH(Vec2, start);
    QFETCH(QString, shown);
    QFETCH(QString, words);
    Task task;
    task.preset.gravity = {};
    task.preset.circles.resize(1);
    task.preset.circles[0].body = {.velocity = start, .radius = 0.2};
    task.checks = {checkOf("integrates", {}, {0})};
    const QString program = QStringLiteral(R"lua(
        local v
        function on_update(h)
          v = v or circle1.velocity
          circle1.position = circle1.position + v * h
          local p = circle1.position
          if math.abs(p.x) > 3.8 and p.x * v.x > 0 then v = vec(-v.x, v.y) end
          if math.abs(p.y) > 3.8 and p.y * v.y > 0 then v = vec(v.x, -v.y) end
          circle1.velocity = %1
        end)lua")
                                .arg(shown);
    const Ground ground(task, task.preset);
    const auto found = unwrittenVelocity(&program, ground, true);
    // All of it is told in any case.
    QCOMPARE(unwrittenVelocity(&program, ground, false).has_value(),
             shown == QLatin1String("circle1.velocity"));
    QCOMPARE(found.has_value(), !words.isEmpty());
    if (!found)
        return;
    QVERIFY2(found->message.contains(words), qPrintable(found->message));
    // The line that is marked: who writes one part of a velocity forgets the other there.
    QCOMPARE(found->moment.isPosition, shown == QLatin1String("circle1.velocity"));
}

/// The x of the velocity moves it in y: that is no velocity of its own.
void TestUnchangedWords::aPartThatMovesAnotherIsNotTold()
{
    Task task;
    task.preset.gravity = {};
    task.preset.circles.resize(2);
    task.preset.circles[0].body = {.velocity = {2.1, 0.0}, .radius = 0.2};
    task.preset.circles[1].body = {.position = {3.0, 3.0}, .radius = 0.2};
    task.checks = {checkOf("collides", {}, {0, 1})};
    const QString program = QStringLiteral(R"lua(
        function on_update(h)
          local c = circle1
          c.position = c.position + vec(c.velocity.x, c.velocity.x) * h
          if math.abs(c.position.x) > 3.8 and c.position.x * c.velocity.x > 0 then
            c.velocity = vec(-c.velocity.x, c.velocity.y)
          end
        end)lua");
    QVERIFY(!unwrittenVelocity(&program, Ground(task, task.preset), true));
}

QTEST_GUILESS_MAIN(TestUnchangedWords)
#include "test_unchanged_words.moc"
