// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/hit_columns.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

using HitIterator = std::deque<Encounter>::const_iterator;

bool isBefore(const Encounter &hit, double time)
{
    return hit.time < time;
}

/// The first hit not before \p time, which is likely to be near: looks twice as far each time.
HitIterator gallop(HitIterator from, const HitIterator &end, double time)
{
    std::ptrdiff_t stride = 1;
    while (end - from > stride && isBefore(from[stride], time)) {
        from += stride;
        stride *= 2;
    }
    return std::lower_bound(from, end - from > stride ? from + stride : end, time, isBefore);
}

} // namespace

std::vector<HitColumn> hitColumns(const std::deque<Encounter> &hits, double t0, double t1,
                                  int width)
{
    std::vector<HitColumn> columns;
    if (!(t0 < t1) || width <= 0)
        return columns;
    const double pixel = (t1 - t0) / width;
    auto hit = std::lower_bound(hits.begin(), hits.end(), t0, isBefore);
    while (hit != hits.end() && hit->time <= t1) {
        const int x = std::clamp(static_cast<int>(std::floor((hit->time - t0) / pixel)), 0, width);
        auto next = gallop(hit, hits.end(), t0 + (x + 1) * pixel);
        if (next == hit)
            ++next;
        columns.push_back({x, static_cast<std::size_t>(hit - hits.begin()),
                           static_cast<std::size_t>(next - hit)});
        hit = next;
    }
    return columns;
}

std::vector<std::pair<double, double>> lastingEncounters(const Recording &recording,
                                                         const std::function<double(double)> &xOf)
{
    std::vector<std::pair<double, double>> stretches;
    for (const qint64 index : recording.lastingEncounters()) {
        const Encounter &contact =
            recording.encounters()[static_cast<std::size_t>(index - recording.droppedEncounters())];
        stretches.emplace_back(xOf(contact.time), xOf(contact.endTime));
    }
    std::sort(stretches.begin(), stretches.end());
    std::size_t kept = 0;
    for (const auto &stretch : stretches) {
        if (kept > 0 && stretch.first <= stretches[kept - 1].second)
            stretches[kept - 1].second = std::max(stretches[kept - 1].second, stretch.second);
        else
            stretches[kept++] = stretch;
    }
    stretches.resize(kept);
    return stretches;
}

std::optional<std::size_t> nearestHit(const std::deque<Encounter> &hits, double time)
{
    if (hits.empty())
        return std::nullopt;
    const auto next = std::lower_bound(hits.begin(), hits.end(), time, isBefore);
    const auto index = static_cast<std::size_t>(next - hits.begin());
    if (index == hits.size())
        return index - 1;
    if (index > 0 && time - hits[index - 1].time < hits[index].time - time)
        return index - 1;
    return index;
}

std::optional<std::size_t> lastHit(const std::deque<Encounter> &hits, qint64 step)
{
    const auto later =
        std::upper_bound(hits.begin(), hits.end(), step,
                         [](qint64 s, const Encounter &hit) { return s < hit.step; });
    if (later == hits.begin())
        return std::nullopt;
    return static_cast<std::size_t>(later - hits.begin()) - 1;
}

} // namespace cradle
