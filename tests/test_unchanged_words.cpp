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

QTEST_GUILESS_MAIN(TestUnchangedWords)
#include "test_unchanged_words.moc"
