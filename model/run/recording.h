// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/encounter_log.h"

#include <deque>
#include <span>

namespace cradle {

/// Every step of a run, with its hits, within a bound of memory: when that is reached the oldest
/// steps are dropped, a block at a time. Frames are known by their index since the start, which
/// stays the same when older ones are dropped.
class Recording
{
public:
    static constexpr qint64 defaultBytes = 64 * 1024 * 1024;

    explicit Recording(qint64 maxBytes = defaultBytes);

    /// Forgets all.
    void clear();
    /// Appends the state after a step. All frames of a recording have the same number of circles.
    void append(const World &world, std::span<const Hit> hits = {});
    /// Drops all frames and hits after \p index: a new run branches off there.
    void truncateAfter(qint64 index);

    [[nodiscard]] bool isEmpty() const { return m_end == m_begin; }
    [[nodiscard]] qint64 first() const { return m_begin; }  ///< oldest frame kept
    [[nodiscard]] qint64 last() const { return m_end - 1; } ///< newest frame
    [[nodiscard]] bool hasDropped() const { return m_begin > 0; }
    [[nodiscard]] std::size_t circleCount() const { return m_circleCount; }

    [[nodiscard]] double time(qint64 index) const; ///< s
    [[nodiscard]] qint64 step(qint64 index) const;
    [[nodiscard]] std::span<const Circle> circles(qint64 index) const;
    [[nodiscard]] World world(qint64 index) const;

    /// The last kept frame at or before \p time; the first kept one if all are later.
    [[nodiscard]] qint64 indexAt(double time) const;

    /// Hits of the kept frames, oldest first.
    [[nodiscard]] const std::deque<Hit> &hits() const { return m_hits; }
    /// How many hits were dropped with their frames; an index into all hits ever is this + i.
    [[nodiscard]] qint64 droppedHits() const { return m_droppedHits; }

    /// The same hits, of which those that go on with a contact are one with its first.
    [[nodiscard]] const std::deque<Encounter> &encounters() const
    {
        return m_encounters.encounters();
    }
    /// How many contacts were dropped with their frames.
    [[nodiscard]] qint64 droppedEncounters() const { return m_encounters.dropped(); }
    /// Indices of those that last, among all contacts ever.
    [[nodiscard]] const std::deque<qint64> &lastingEncounters() const
    {
        return m_encounters.lasting();
    }
    /// The first hit of a kept contact.
    [[nodiscard]] const Hit &hitOf(const Encounter &contact) const
    {
        return m_hits[static_cast<std::size_t>(contact.hit - m_droppedHits)];
    }

    [[nodiscard]] qint64 bytes() const; ///< memory held

private:
    struct Block {
        std::vector<double> times;
        std::vector<qint64> steps;
        std::vector<Circle> circles;
    };
    struct Slot {
        const Block &block;
        std::size_t row;
    };

    [[nodiscard]] Slot slot(qint64 index) const;
    [[nodiscard]] qint64 blockBytes() const;
    void dropOldest();

    qint64 m_maxBytes;
    qint64 m_begin = 0;
    qint64 m_end = 0;
    std::size_t m_circleCount = 0;
    std::deque<Block> m_blocks;
    std::deque<Hit> m_hits;
    qint64 m_droppedHits = 0;
    EncounterLog m_encounters;
};

} // namespace cradle
