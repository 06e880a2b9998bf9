// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/known_mistakes.h"

#include "tasks/judging/flight_words.h"
#include "tasks/judging/hit_kinds.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/pair_words.h"
#include "tasks/judging/wall_words.h"

#include <algorithm>

namespace cradle {

namespace {

/// Of a first look: two programs with one law may round a hit differently by a step.
constexpr double firstLook = 0.05;

bool sameStart(const Preset &a, const Preset &b)
{
    return a.gravity == b.gravity && a.restitution == b.restitution
           && std::equal(
               a.circles.begin(), a.circles.end(), b.circles.begin(), b.circles.end(),
               [](const PresetCircle &p, const PresetCircle &q) { return p.body == q.body; });
}

/// Whether what a mistake makes otherwise at the start than \p right is so in \p own, too: what is
/// said of it is said of that start.
bool startsLike(const Preset &own, const Preset &mistake, const Preset &right)
{
    const auto fits = [](const auto &ours, const auto &known, const auto &asked) {
        return known == asked || ours == known;
    };
    if (!fits(own.gravity, mistake.gravity, right.gravity)
        || !fits(own.restitution, mistake.restitution, right.restitution))
        return false;
    const std::size_t count =
        std::min({own.circles.size(), mistake.circles.size(), right.circles.size()});
    for (std::size_t i = 0; i < count; ++i) {
        const Circle &ours = own.circles[i].body;
        const Circle &known = mistake.circles[i].body;
        const Circle &asked = right.circles[i].body;
        if (!fits(ours.position, known.position, asked.position)
            || !fits(ours.velocity, known.velocity, asked.velocity)
            || !fits(ours.radius, known.radius, asked.radius)
            || !fits(ours.density, known.density, asked.density))
            return false;
    }
    return true;
}

/// The circles after the step in which the deviation shows.
std::vector<Circle> after(const QString *program, const Moment &moment)
{
    Probe probe(program, moment.stage);
    for (qint64 k = 0; k < moment.step; ++k) {
        if (!probe.step())
            return {};
    }
    return probe.world().circles;
}

/// Whether \p mistake does the same where the student goes wrong: a look that costs little.
/// \param own  what the student's program does there
bool looksAlike(const MistakeQuery &query, const KnownScript &mistake,
                const std::vector<Circle> &own)
{
    const std::vector<Circle> known = after(&mistake.source, query.deviations.front().moment);
    return !own.empty()
           && std::equal(own.begin(), own.end(), known.begin(), known.end(),
                         [](const Circle &a, const Circle &b) {
                             return isAlike(a.velocity, b.velocity, firstLook)
                                    && isAlike(a.position, b.position, firstLook);
                         });
}

/// Whether two programs are the same in all that is told of an aspect.
bool isSame(const MeasuredLaws &a, const MeasuredLaws &b, Aspect aspect, const Ground &ground)
{
    return isLike(a, b, aspect, ground)
           && (aspect != Aspect::Contact || !ground.pair.asked || a.pair().sequelIsLike(b.pair()));
}

/// Whether hits of many kinds are answered alike, as far as two programs see them along one line.
bool answersManyAlike(const MeasuredLaws &a, const MeasuredLaws &b)
{
    const std::vector<PairHit> &ours = a.pairAnswers();
    const std::vector<PairHit> &theirs = b.pairAnswers();
    return std::equal(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                      [](const PairHit &p, const PairHit &q) {
                          return !p.isMet() || !q.isMet() || !p.isAligned() || !q.isAligned()
                                 || isSameAnswerTo(p, p.leftParts(), q.leftParts());
                      });
}

/// Whether something is wrong with \p laws in an aspect that comes before that of the query.
bool deviatesBefore(const MistakeQuery &query, const MeasuredLaws &laws)
{
    const Ground &ground = query.known.ground();
    if (query.aspect == Aspect::Start || query.aspect == Aspect::Motion)
        return false;
    if (!flightDeviations(laws.flight(), query.known.right().flight(), ground).empty())
        return true;
    if (query.aspect == Aspect::Walls)
        return false;
    if (!ground.walls.circles.empty()
        && !wallDeviations(laws.walls(), query.known.right().walls(), ground).empty())
        return true;
    return query.aspect == Aspect::Response && ground.pair.asked
           && !contactDeviations(laws.pair(), query.known.right().pair(), ground).empty();
}

bool explains(const MistakeQuery &query, std::size_t i)
{
    const MeasuredLaws &known = query.known.mistake(i);
    const Ground &ground = query.known.ground();
    // What the mistake does rightly it cannot explain.
    return isSame(known, query.own, query.aspect, ground)
           && (query.aspect != Aspect::Response || answersManyAlike(known, query.own))
           && !isSame(known, query.known.right(), query.aspect, ground)
           && startsLike(query.own.flight().own().scene, known.flight().own().scene,
                         query.known.right().flight().own().scene)
           && !deviatesBefore(query, known);
}

} // namespace

bool isLike(const MeasuredLaws &a, const MeasuredLaws &b, Aspect aspect, const Ground &ground)
{
    const bool walls = !ground.walls.circles.empty();
    switch (aspect) {
    case Aspect::Start:
        return sameStart(a.flight().own().scene, b.flight().own().scene);
    case Aspect::Motion:
        return a.flight().isLike(b.flight());
    case Aspect::Walls:
    case Aspect::Course:
        return !walls || a.walls().isLike(b.walls());
    case Aspect::Contact:
        return !ground.pair.asked || a.pair().contactIsLike(b.pair());
    case Aspect::Response:
        break;
    }
    return !ground.pair.asked || a.pair().responseIsLike(b.pair());
}

std::optional<std::size_t> knownMistake(const MistakeQuery &query)
{
    const std::vector<KnownScript> &mistakes = query.task.mistakes;
    const bool looks = query.aspect != Aspect::Start && !mistakes.empty();
    const std::vector<Circle> own =
        looks ? after(query.submission.program(), query.deviations.front().moment)
              : std::vector<Circle>{};
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        if ((!looks || looksAlike(query, mistakes[i], own)) && explains(query, i))
            return i;
    }
    return std::nullopt;
}

} // namespace cradle
