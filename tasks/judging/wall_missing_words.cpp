// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include <algorithm>

namespace cradle {

namespace {

/// Finds the walls that turn nothing round.
class MissingJudge : WallComparison
{
public:
    explicit MissingJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    [[nodiscard]] std::vector<LawDeviation> find()
    {
        findMissing();
        return std::move(m_found);
    }

private:
    void add(const QString &headline, const QString &body, const WallHit &hit,
             const std::vector<int> &circles, Suspect suspect, bool isPosition = false)
    {
        m_found.push_back(deviation(headline, body, hit, circles, suspect, isPosition));
    }

    void findMissing()
    {
        std::vector<std::pair<int, std::set<Wall>>> open;
        const WallHit *first = nullptr;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &hit = m_own.hits[i];
            if (hit.missed || hit.turned || hit.held || !rightOf(i).turned)
                continue;
            first = first ? first : &hit;
            if (open.empty() || open.back().first != hit.circle)
                open.push_back({hit.circle, {}});
            open.back().second.insert(hit.wall);
        }
        if (open.empty())
            return;
        const bool all = std::all_of(open.begin(), open.end(),
                                     [](const auto &each) { return each.second.size() == 4; });
        std::vector<int> circles;
        for (const auto &[circle, walls] : open)
            circles.push_back(circle);
        if (all) {
            add(WallText::tr("None of the four walls turns %who round"),
                WallText::tr("Thrown at each of the four walls, %1 m/s fast, it goes on through "
                             "them. After every move each circle needs its questions: is its rim "
                             "past a wall?")
                    .arg(brief(
                        length(first->stage.preset.circles[static_cast<std::size_t>(first->circle)]
                                   .body.velocity))),
                as(*first), circles, Suspect::Omission);
            noteMissing(circles);
            return;
        }
        for (std::size_t i = 0; i < open.size(); ++i) {
            const auto &[circle, walls] = open[i];
            std::vector<int> same{circle};
            for (std::size_t j = i + 1; j < open.size(); ++j) {
                if (open[j].second == walls)
                    same.push_back(open[j].first);
            }
            std::erase_if(open, [&, w = walls, c = circle](const auto &each) {
                return each.first != c && each.second == w;
            });
            const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), [&](const auto &h) {
                return h.circle == same.front() && !h.turned && !h.held && !h.missed;
            });
            add(WallText::tr("Not every wall holds %who: %1").arg(namesOf(open[i].second)),
                WallText::tr(
                    "Thrown there, the circle goes on past the wall. A square has four walls: look "
                    "at the question that your program asks for each."),
                as(*at), same, Suspect::Omission);
            noteMissing(same);
        }
    }

    /// Of the fault that was found last.
    void noteMissing(const std::vector<int> &circles)
    {
        m_found.back().family = QStringLiteral("missing");
        m_found.back().shown = static_cast<int>(
            std::count_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
                return std::find(circles.begin(), circles.end(), hit.circle) != circles.end()
                       && !hit.turned && !hit.held && !hit.missed;
            }));
    }

    /// A hit that does not come, at the step in which it should.
    [[nodiscard]] WallHit as(WallHit missing) const
    {
        for (const WallHit &right : m_right.hits) {
            if (right.circle == missing.circle && right.wall == missing.wall && right.turned) {
                missing.step = right.step;
                break;
            }
        }
        return missing;
    }

    std::vector<LawDeviation> m_found;
};

} // namespace

std::vector<LawDeviation> missingDeviations(const WallComparison &walls)
{
    return MissingJudge(walls).find();
}

} // namespace cradle
