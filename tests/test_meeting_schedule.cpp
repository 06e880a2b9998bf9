// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/meeting_schedule.h"
#include "tests/scenes.h"

#include <map>

using namespace cradle;
using namespace cradle::scenes;

/// Each pair is put down for the step in which it first meets, worked out pair by pair, and for
/// none before: no step looks at more than it must.
class TestMeetingSchedule : public QObject
{
    Q_OBJECT
private slots:
    void pairsAreDueWhenTheyMeet_data();
    void pairsAreDueWhenTheyMeet();
    void whoIsDisturbedIsLookedAtWhereItIsNear_data();
    void whoIsDisturbedIsLookedAtWhereItIsNear();
};

namespace {

/// Two circles, or one and -1 for a wall.
using Who = std::pair<int, int>;

struct Sorted {
    explicit Sorted(double gravity)
    {
        Preset preset = scene({}, {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous});
        preset.gravity = {0.0, -gravity};
        preset.circles = *makeCircles(
            {.count = 120, .radius = 0.1, .rmsSpeed = 2.0, .density = 7.8, .seed = 3}, halfWidth);
        World world = initialWorld(preset);
        circles = world.circles;
        crowd.start(rulesOf(preset), circles);
        near.start(crowd);
        near.sort(dt, crowd, {});
    }

    [[nodiscard]] std::map<Who, int> due()
    {
        std::map<Who, int> steps;
        for (std::size_t k = 0; k < near.skin().steps(); ++k) {
            for (const auto &[a, b] : schedule.due(k)) {
                const int first = static_cast<int>(crowd.ids[a]);
                const int second = b == Crowd::wall ? -1 : static_cast<int>(crowd.ids[b]);
                steps[std::minmax(first, second)] = static_cast<int>(k);
            }
        }
        return steps;
    }

    std::vector<Circle> circles{};
    Crowd crowd{};
    BroadPhase near{};
    MeetingSchedule schedule{};
};

/// When two that fly alike are as near as \p reach, s.
std::optional<double> meetingOf(const Circle &a, const Circle &b, double reach)
{
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const double closest = -dot(d, v) / lengthSquared(v); // s
    const double missed = lengthSquared(d + closest * v);
    if (closest <= 0.0 || missed > reach * reach)
        return std::nullopt;
    return closest - std::sqrt((reach * reach - missed) / lengthSquared(v));
}

double wallOf(const Circle &c)
{
    const auto until = [&](double x, double v) {
        return (halfWidth - c.radius - (v > 0.0 ? x : -x)) / std::abs(v);
    };
    return std::min(until(c.position.x, c.velocity.x), until(c.position.y, c.velocity.y));
}

} // namespace

void TestMeetingSchedule::pairsAreDueWhenTheyMeet_data()
{
    QTest::addColumn<double>("gravity");
    QTest::newRow("gas") << 0.0;
    QTest::newRow("that falls alike") << g;
}

void TestMeetingSchedule::pairsAreDueWhenTheyMeet()
{
    QFETCH(double, gravity);
    Sorted sorted(gravity);
    sorted.schedule.fill(sorted.crowd, sorted.near);
    const double until = sorted.near.timeLeft();
    std::map<Who, int> wanted;
    const auto meet = [&](Who who, double time) {
        if (time < until)
            wanted[who] = static_cast<int>(time / dt);
    };
    for (int i = 0; i < static_cast<int>(sorted.circles.size()); ++i) {
        const Circle &a = sorted.circles[static_cast<std::size_t>(i)];
        for (int j = i + 1; j < static_cast<int>(sorted.circles.size()); ++j) {
            const Circle &b = sorted.circles[static_cast<std::size_t>(j)];
            if (const auto time = meetingOf(a, b, a.radius + b.radius))
                meet({i, j}, *time);
        }
        if (gravity == 0.0)
            meet({-1, i}, wallOf(a));
    }
    QVERIFY(wanted.size() > 10);
    auto due = sorted.due();
    if (gravity > 0.0)
        std::erase_if(due, [](const auto &one) { return one.first.first < 0; });
    QVERIFY(due == wanted);
}

void TestMeetingSchedule::whoIsDisturbedIsLookedAtWhereItIsNear_data()
{
    pairsAreDueWhenTheyMeet_data();
}

/// Who may rest does not fall as it flies: under gravity those are due at once that a step may
/// bring to it, and no others before they meet.
void TestMeetingSchedule::whoIsDisturbedIsLookedAtWhereItIsNear()
{
    QFETCH(double, gravity);
    int met = 0;
    for (Crowd::Slot slot = 0; slot < 120; ++slot) {
        Sorted sorted(gravity);
        sorted.schedule.addAround(sorted.crowd, sorted.near, slot);
        const double until = sorted.near.timeLeft();
        const int i = static_cast<int>(sorted.crowd.ids[slot]);
        const Circle &a = sorted.circles[static_cast<std::size_t>(i)];
        auto due = sorted.due();
        std::erase_if(due, [](const auto &one) { return one.first.first < 0; });
        for (int j = 0; j < static_cast<int>(sorted.circles.size()); ++j) {
            if (i == j)
                continue;
            const Circle &b = sorted.circles[static_cast<std::size_t>(j)];
            const double reach = a.radius + b.radius;
            const double step = dt * (length(b.velocity - a.velocity) + 2.0 * gravity * dt);
            const bool isNear = gravity > 0.0 && length(b.position - a.position) <= reach + step;
            const auto time = meetingOf(a, b, reach);
            const auto found = due.find(std::minmax(i, j));
            if (time && *time < until) {
                QVERIFY(found != due.end());
                QCOMPARE(found->second, isNear ? 0 : static_cast<int>(*time / dt));
                ++met;
            } else if (found != due.end()) { // nor who flies away
                QVERIFY(isNear);
                QCOMPARE(found->second, 0);
            }
        }
    }
    QVERIFY(met > 20);
}

QTEST_APPLESS_MAIN(TestMeetingSchedule)
#include "test_meeting_schedule.moc"
