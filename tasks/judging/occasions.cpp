// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/occasions.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

using Kind = Condition::Kind;

/// A single one may lie at the edge of all places, or be the first, by chance.
constexpr int fewest = 2;

/// Tells the right ones from the others by one thing at a time.
class Division
{
public:
    explicit Division(const std::vector<Occasion> &occasions)
        : m_all(occasions)
    {
    }

    /// Whether exactly those come out right of which \p holds is true.
    template <class Holds>
    [[nodiscard]] bool is(Holds holds) const
    {
        return std::all_of(m_all.begin(), m_all.end(),
                           [&](const Occasion &one) { return one.isRight == holds(one); });
    }

    /// That those come out right of which \p part is great enough: between which two values.
    template <class Part>
    [[nodiscard]] std::optional<Condition> atLeast(Kind kind, Part part) const
    {
        double right = std::numeric_limits<double>::infinity();
        double wrong = -right;
        for (const Occasion &one : m_all) {
            if (one.isRight)
                right = std::min<double>(right, part(one));
            else
                wrong = std::max<double>(wrong, part(one));
        }
        return wrong < right ? std::optional(Condition{kind, right, wrong}) : std::nullopt;
    }
    template <class Part>
    [[nodiscard]] std::optional<Condition> atMost(Kind kind, Part part) const
    {
        auto found = atLeast(kind, [&](const Occasion &one) { return -part(one); });
        if (found)
            found = {kind, -found->inside, -found->outside};
        return found;
    }

private:
    const std::vector<Occasion> &m_all;
};

} // namespace

void Occasion::comesWith(Vec2 towards, Vec2 normal)
{
    velocity = towards;
    speed = length(towards);
    into = dot(towards, normal);
    along = std::abs(dot(towards, perpendicular(normal)));
}

int rightOnes(const std::vector<Occasion> &occasions)
{
    return static_cast<int>(std::count_if(occasions.begin(), occasions.end(),
                                          [](const Occasion &one) { return one.isRight; }));
}

namespace {

/// A way to count them.
struct Number {
    int Occasion::*of;
    Condition::Counted counted;
};
constexpr Number numbers[] = {{&Occasion::number, Condition::Counted::InRun},
                              {&Occasion::ownNumber, Condition::Counted::OfCircle},
                              {&Occasion::likeNumber, Condition::Counted::InRun},
                              {&Occasion::wallNumber, Condition::Counted::AtWall}};

/// That the first ones of a run come out right, or the others, counted by \p number.
std::optional<Condition> byNumber(const Division &by, int Occasion::*number)
{
    const auto is = [&](auto holds) {
        return by.is([&](const Occasion &one) { return holds(one.*number); });
    };
    if (is([](int n) { return n == 1; }))
        return Condition{Kind::First};
    if (is([](int n) { return n > 1; }))
        return Condition{Kind::NotFirst};
    if (is([](int n) { return n % 2 == 1; }))
        return Condition{Kind::OddOnes};
    if (is([](int n) { return n % 2 == 0; }))
        return Condition{Kind::EvenOnes};
    return std::nullopt;
}

/// Of 14, two are the last by chance in one of a hundred ways to count; three are not.
constexpr int fewestOfMany = 3;

/// The same with another number than the first.
std::optional<Condition> byHigherNumber(const Division &by, int Occasion::*number)
{
    const auto part = [&](const Occasion &one) { return static_cast<double>(one.*number); };
    const auto few = by.atMost(Kind::FirstFew, part);
    return few ? few : by.atLeast(Kind::AfterFew, part);
}

/// A number, counted in the first way in which one divides.
template <class By>
void takeNumber(std::vector<Condition> &all, const Division &by, By byIt)
{
    for (const Number &number : numbers) {
        if (auto found = byIt(by, number.of)) {
            found->counted = number.counted;
            all.push_back(*found);
            return;
        }
    }
}

} // namespace

std::vector<Condition> conditionsOf(const std::vector<Occasion> &occasions)
{
    const int right = rightOnes(occasions);
    const int wrong = static_cast<int>(occasions.size()) - right;
    std::vector<Condition> all;
    if (right < fewest || wrong < fewest)
        return all;
    const Division by(occasions);
    takeNumber(all, by, byNumber);
    if (by.is([](const Occasion &one) { return !one.hasMet; }))
        all.push_back({Kind::BeforeMet});
    if (by.is([](const Occasion &one) { return !one.hasHit; }))
        all.push_back({Kind::BeforeHit});
    if (by.is([](const Occasion &one) { return one.hasHit; }))
        all.push_back({Kind::AfterHit});
    if (all.empty() && std::min(right, wrong) >= fewestOfMany)
        takeNumber(all, by, byHigherNumber);
    const auto take = [&](const std::optional<Condition> &one) {
        if (one)
            all.push_back(*one);
    };
    // The first of a run has no pause before it.
    const auto pause = by.atLeast(Kind::Pause, [](const Occasion &one) { return one.pause; });
    if (pause && std::isfinite(pause->inside))
        all.push_back(*pause);
    struct Part {
        double (*of)(const Occasion &);
        Kind most;
        Kind least;
    };
    for (const Part &part :
         {Part{[](const Occasion &one) { return one.time; }, Kind::Until, Kind::From},
          Part{[](const Occasion &one) { return one.place.y; }, Kind::Below, Kind::Above},
          Part{[](const Occasion &one) { return one.place.x; }, Kind::LeftOf, Kind::RightOf},
          Part{[](const Occasion &one) { return one.speed; }, Kind::Slower, Kind::Faster},
          Part{[](const Occasion &one) { return one.into; }, Kind::SlowerInto, Kind::FasterInto},
          Part{[](const Occasion &one) { return one.along; }, Kind::SlowerAlong,
               Kind::FasterAlong}}) {
        take(by.atMost(part.most, part.of));
        take(by.atLeast(part.least, part.of));
    }
    struct Way {
        Vec2 to;
        Kind kind;
        Kind ofOther;
    };
    for (const Way &way : {Way{{1.0, 0.0}, Kind::Rightward, Kind::OtherRightward},
                           Way{{-1.0, 0.0}, Kind::Leftward, Kind::OtherLeftward},
                           Way{{0.0, 1.0}, Kind::Upward, Kind::OtherUpward},
                           Way{{0.0, -1.0}, Kind::Downward, Kind::OtherDownward}}) {
        if (by.is([&](const Occasion &one) { return dot(one.velocity, way.to) > 0.0; }))
            all.push_back({way.kind});
        if (by.is([&](const Occasion &one) { return dot(one.otherVelocity, way.to) > 0.0; }))
            all.push_back({way.ofOther});
    }
    for (const int setting : {0, 1}) {
        if (by.is([&](const Occasion &one) { return one.setting == setting; }))
            all.push_back({Kind::Setting});
    }
    return all;
}

std::optional<Condition> conditionOf(const std::vector<Occasion> &occasions)
{
    const int right = rightOnes(occasions);
    if (right == 0 || right == static_cast<int>(occasions.size()))
        return std::nullopt;
    const std::vector<Condition> all = conditionsOf(occasions);
    return all.size() == 1 ? all.front() : Condition{};
}

} // namespace cradle
