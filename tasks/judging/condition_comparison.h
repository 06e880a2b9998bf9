// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/condition_words.h"
#include "tasks/judging/tried_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <set>

namespace cradle {

struct ConditionText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// Things of one kind that a program and the reference did, those that can be judged.
template <class Seen>
struct Series {
    struct One {
        const Seen *own;
        const Seen *right;
    };
    std::vector<One> all{};
    std::vector<Occasion> when{};

    void add(const Seen &own, const Seen &right, bool isRight)
    {
        all.push_back({&own, &right});
        when.push_back(own.when);
        when.back().isRight = isRight;
    }
    /// There is one.
    [[nodiscard]] const One &firstWrong() const
    {
        const auto at = std::find_if(when.begin(), when.end(),
                                     [](const Occasion &one) { return !one.isRight; });
        return all[static_cast<std::size_t>(at - when.begin())];
    }
    /// Those of which \p is says so.
    template <class Is>
    [[nodiscard]] Series those(Is is) const
    {
        Series some;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (is(*all[i].own))
                some.add(*all[i].own, *all[i].right, when[i].isRight);
        }
        return some;
    }
    /// The circles of those that do not come out right.
    template <class CircleOf>
    [[nodiscard]] std::vector<int> wrongCircles(CircleOf circleOf) const
    {
        std::set<int> wrong;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (!when[i].isRight)
                wrong.insert(circleOf(*all[i].own));
        }
        return {wrong.begin(), wrong.end()};
    }
};

/// Judges one aspect of a program in long runs beside the reference.
class ConditionComparison
{
public:
    ConditionComparison(std::vector<LawDeviation> found, const MeasuredLaws &own,
                        const MeasuredLaws &right, const Ground &ground, const Moment &shown)
        : m_own(own)
        , m_right(right)
        , m_ground(ground)
        , m_shown(shown)
    {
        m_said.deviations = std::move(found);
    }

protected:
    /// What is said of things that come out right at times.
    struct Said {
        QString headline{}; ///< with %who for the circles
        QString seen{};     ///< of one that comes out wrong
        QString told{};     ///< how many come out right, and which
    };

    /// Says \p what first, and nothing that \p isReplaced is true of.
    /// \param place  where it shows, if it is the place that counts
    template <class IsReplaced>
    void say(Aspect aspect, const Said &what, const Condition &condition,
             const std::vector<int> &circles, const Moment &place, IsReplaced isReplaced)
    {
        std::erase_if(m_said.deviations, isReplaced);
        add(aspect, what, condition, circles, place);
    }

    const MeasuredLaws &m_own;
    const MeasuredLaws &m_right;
    const Ground &m_ground;
    const Moment &m_shown;
    ConditionedAspect m_said{};

private:
    void add(Aspect aspect, const Said &what, const Condition &condition,
             const std::vector<int> &circles, const Moment &place);
};

[[nodiscard]] ConditionedAspect conditionedFlight(const ConditionComparison &comparison);
[[nodiscard]] ConditionedAspect conditionedWalls(const ConditionComparison &comparison);
/// \param aspect  contact or response
[[nodiscard]] ConditionedAspect conditionedPair(const ConditionComparison &comparison,
                                                Aspect aspect);

} // namespace cradle
