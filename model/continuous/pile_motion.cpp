// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/pile_motion.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// An overlap of more than so many that may be, which no run of its own leaves, shrinks by this
/// share in a step, whatever energy that takes.
constexpr double deepOverlap = 20.0;
constexpr double repairedOfPile = 0.1;
/// Sweeps over the contacts in a step, at most: as many as set so many contacts right, for what a
/// heavy circle does to light ones takes many, and in a small pile they cost little. But so many in
/// any case, of heaps higher than those of 1,000 circles so many more for each row that as many
/// alike would fill a square with.
constexpr int mostSetRight = 120000;
constexpr int surelySweeps = 120;
constexpr double sweepsPerRow = 10.0;
constexpr double fewPileRows = 32.0;
/// And so many once more, where circles would then overlap by more than this share of what may be
/// in the mean: to part them in a dense heap would take longer.
constexpr double hardOverlap = 0.25;
/// After so many it is seen whether there are other contacts.
constexpr int firstSweeps = 16;
/// So often, at most, however few the sweeps.
constexpr int mostRounds = 40;
/// A pile whose pushes throw circles farther than was foreseen looks around anew, so often.
constexpr int mostLooks = 8;

/// Sweeps over so many contacts in a step, at most.
int mostSweeps(const Pile &pile, std::size_t contacts)
{
    const double rows = std::sqrt(static_cast<double>(pile.count()));
    const int surely =
        surelySweeps + static_cast<int>(sweepsPerRow * std::max(0.0, rows - fewPileRows));
    return std::max(surely, mostSetRight / static_cast<int>(std::max<std::size_t>(contacts, 1)));
}

/// At which speed a contact may close in the step, m/s; where they overlap deeply it shall part.
double limitOf(const Pile &pile, double gap)
{
    if (gap < -deepOverlap * pile.borne)
        return repairedOfPile * (gap + pile.borne) / pile.dt;
    return std::max(0.0, gap - pile.apart) / pile.dt;
}

/// Whether the two are so near and so slow that any push may make them meet.
bool isSlow(const Pile &pile, const NearPair &near)
{
    const Vec2 other = pile.isWall(near.b) ? Vec2{} : pile.circles[near.b].velocity;
    return quickLength(pile.circles[near.a].velocity - other) <= 4.0 * pile.gain
           && near.gap <= 2.0 * pile.gain * pile.dt;
}

void addContact(const Pile &pile, const PilePushes &pushes, std::uint32_t index, PileMotion &motion)
{
    NearPair &near = motion.near[index];
    near.active = true;
    motion.nearOf.push_back(index);
    motion.contacts.push_back(
        {near.a, near.b, near.normal, limitOf(pile, near.gap), pushes.of(pile, near)});
}

/// Looks around for who may meet, and takes as contacts who would.
/// \param again  who was a contact before that, too
void beginContacts(const Pile &pile, const PilePushes &pushes, std::span<const double> ways,
                   bool again, PileMotion &motion)
{
    findNearPairs(pile, ways, motion.near);
    motion.contacts.clear();
    motion.nearOf.clear();
    for (std::uint32_t k = 0; k < motion.near.size(); ++k) {
        const NearPair &near = motion.near[k];
        if (near.met >= 0.0 || isSlow(pile, near) || (again && pushes.knows(pile, near)))
            addContact(pile, pushes, k, motion);
    }
}

/// Whether two that are no contact would overlap in the step at \p velocities (m/s).
bool wouldOverlap(const Pile &pile, const NearPair &near, std::span<const Vec2> velocities)
{
    const double closing = dot(velocities[near.a] - velocities[near.b], near.normal);
    if (pile.dt * closing <= near.gap)
        return false;
    if (pile.isWall(near.b))
        return true;
    // They may pass each other beside this normal.
    const Circle &a = pile.circles[near.a];
    const Circle &b = pile.circles[near.b];
    const Vec2 d = b.position - a.position;
    const Vec2 v = velocities[near.b] - velocities[near.a];
    const double sum = a.radius + b.radius;
    const double nearest =
        lengthSquared(v) > 0.0 ? std::clamp(-dot(d, v) / lengthSquared(v), 0.0, pile.dt) : 0.0;
    return lengthSquared(d + nearest * v) < sum * sum;
}

/// Takes in who would overlap at \p velocities. \return whether there was any
bool addMissed(const Pile &pile, const PilePushes &pushes, std::span<const Vec2> velocities,
               PileMotion &motion)
{
    const std::size_t before = motion.contacts.size();
    for (std::uint32_t k = 0; k < motion.near.size(); ++k) {
        if (!motion.near[k].active && wouldOverlap(pile, motion.near[k], velocities))
            addContact(pile, pushes, k, motion);
    }
    return motion.contacts.size() > before;
}

/// By how much the contacts would overlap at \p velocities (m/s), all together: for each circle,
/// in overlaps that may be.
double overlapOf(const Pile &pile, const PileMotion &motion, std::span<const Vec2> velocities)
{
    double sum = 0.0;
    for (const PileContact &c : motion.contacts) {
        const double closing = dot(velocities[c.a] - velocities[c.b], c.normal);
        sum += std::max(0.0, pile.dt * (closing - c.limit) - pile.apart);
    }
    return sum / (pile.borne * pile.count());
}

/// Whether a circle goes farther than whom it may meet was looked for; its way is half as far again
/// now, m, lest the next pushes, which may throw it a little farther, want another look.
bool haveComeFar(const Pile &pile, std::span<const Vec2> velocities, std::span<double> ways)
{
    bool far = false;
    for (Pile::Body i = 0; i < pile.count(); ++i) {
        const double way = pile.dt * quickLength(velocities[i]);
        if (way <= ways[i])
            continue;
        far = true;
        ways[i] = 1.5 * way;
    }
    return far;
}

} // namespace

void findMotion(const Pile &pile, PilePushes &pushes, PileMotion &motion)
{
    std::vector<double> ways = foreseenWays(pile);
    beginContacts(pile, pushes, ways, false, motion);
    PileBodies bodies{{}, pile.inverseMasses};
    int looks = 1;
    int taken = 0; // sweeps
    int part = firstSweeps;
    int more = 0; // sweeps, where all are taken in vain
    for (int round = 0; round < mostRounds; ++round) {
        pile.setFree(bodies);
        const int sweeps = solvePile(motion.contacts, bodies, pile.tolerance, part);
        taken += sweeps;
        int left = mostSweeps(pile, motion.contacts.size()) + more - taken;
        if (left <= 0 && more == 0 && overlapOf(pile, motion, bodies.velocities) > hardOverlap) {
            more = surelySweeps;
            left += more;
        }
        const bool ends = left <= 0 || sweeps < part;
        part = std::clamp(left, firstSweeps, 2 * part);
        if (looks < mostLooks && haveComeFar(pile, bodies.velocities, ways)) {
            ++looks;
            pushes.keep(pile, motion.contacts, motion.near, motion.nearOf);
            beginContacts(pile, pushes, ways, true, motion);
        } else if (!addMissed(pile, pushes, bodies.velocities, motion) && ends) {
            break;
        }
    }
    bodies.velocities.resize(pile.count());
    motion.velocities = std::move(bodies.velocities);
}

std::uint64_t PilePushes::keyOf(const Pile &pile, const NearPair &pair)
{
    const std::uint64_t a = pile.ids[pair.a];
    const std::uint64_t b = pile.isWall(pair.b)
                                ? ~std::uint64_t{pair.b - pile.count()} & 0xffffffffU
                                : pile.ids[pair.b];
    return std::min(a, b) << 32U | std::max(a, b);
}

double PilePushes::of(const Pile &pile, const NearPair &pair) const
{
    const auto known = m_pushes.find(keyOf(pile, pair));
    return known == m_pushes.end() ? 0.0 : known->second;
}

void PilePushes::keep(const Pile &pile, std::span<const PileContact> contacts,
                      std::span<const NearPair> near, std::span<const std::uint32_t> pairOf)
{
    // Those of pairs that have parted are many in time, and a guess that is missing costs little.
    if (m_pushes.size() > 8 * contacts.size() + 1024)
        m_pushes.clear();
    for (std::size_t k = 0; k < contacts.size(); ++k)
        m_pushes[keyOf(pile, near[pairOf[k]])] = contacts[k].push;
}

} // namespace cradle
