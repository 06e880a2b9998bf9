// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/recording.h"

namespace cradle {

namespace {

/// Frames to a block: dropping one loses about two seconds, finding one costs a division.
constexpr qint64 framesPerBlock = 128;

} // namespace

Recording::Recording(qint64 maxBytes)
    : m_maxBytes(maxBytes)
{
}

void Recording::clear()
{
    *this = Recording(m_maxBytes);
}

void Recording::append(const World &world, std::span<const Hit> hits)
{
    if (isEmpty())
        m_circleCount = world.circles.size();
    Q_ASSERT(world.circles.size() == m_circleCount);
    if (m_end % framesPerBlock == 0) {
        // At least one full block stays, however many circles there are.
        while (m_blocks.size() > 1 && bytes() + blockBytes() > m_maxBytes)
            dropOldest();
        m_blocks.emplace_back();
        m_blocks.back().times.reserve(framesPerBlock);
        m_blocks.back().steps.reserve(framesPerBlock);
        m_blocks.back().circles.reserve(framesPerBlock * m_circleCount);
    }
    Block &block = m_blocks.back();
    block.times.push_back(world.time);
    block.steps.push_back(world.step);
    block.circles.insert(block.circles.end(), world.circles.begin(), world.circles.end());
    m_encounters.add(hits, world.circles, m_droppedHits + static_cast<qint64>(m_hits.size()));
    m_hits.insert(m_hits.end(), hits.begin(), hits.end());
    ++m_end;
}

void Recording::truncateAfter(qint64 index)
{
    Q_ASSERT(index >= m_begin && index < m_end);
    const qint64 lastStep = step(index);
    while (!m_hits.empty() && m_hits.back().step > lastStep)
        m_hits.pop_back();
    m_encounters.truncateAfter(lastStep, time(index));
    const qint64 firstOfBlocks = m_begin / framesPerBlock;
    m_blocks.resize(static_cast<std::size_t>(index / framesPerBlock - firstOfBlocks + 1));
    const auto rows = static_cast<std::size_t>(index % framesPerBlock + 1);
    Block &block = m_blocks.back();
    block.times.resize(rows);
    block.steps.resize(rows);
    block.circles.resize(rows * m_circleCount);
    m_end = index + 1;
}

double Recording::time(qint64 index) const
{
    const Slot s = slot(index);
    return s.block.times[s.row];
}

qint64 Recording::step(qint64 index) const
{
    const Slot s = slot(index);
    return s.block.steps[s.row];
}

std::span<const Circle> Recording::circles(qint64 index) const
{
    const Slot s = slot(index);
    return std::span(s.block.circles).subspan(s.row * m_circleCount, m_circleCount);
}

World Recording::world(qint64 index) const
{
    const std::span<const Circle> row = circles(index);
    return {time(index), step(index), {row.begin(), row.end()}};
}

qint64 Recording::indexAt(double moment) const
{
    qint64 low = m_begin;
    qint64 high = m_end - 1;
    while (low < high) {
        const qint64 middle = low + (high - low + 1) / 2;
        if (time(middle) <= moment)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

qint64 Recording::bytes() const
{
    return static_cast<qint64>(m_blocks.size()) * blockBytes()
           + static_cast<qint64>(m_hits.size() * sizeof(Hit))
           + static_cast<qint64>(encounters().size() * sizeof(Encounter));
}

Recording::Slot Recording::slot(qint64 index) const
{
    Q_ASSERT(index >= m_begin && index < m_end);
    const qint64 block = index / framesPerBlock - m_begin / framesPerBlock;
    return {m_blocks[static_cast<std::size_t>(block)],
            static_cast<std::size_t>(index % framesPerBlock)};
}

qint64 Recording::blockBytes() const
{
    const auto frame =
        static_cast<qint64>(sizeof(double) + sizeof(qint64) + m_circleCount * sizeof(Circle));
    return framesPerBlock * frame;
}

void Recording::dropOldest()
{
    const qint64 lastStep = m_blocks.front().steps.back();
    while (!m_hits.empty() && m_hits.front().step <= lastStep) {
        m_hits.pop_front();
        ++m_droppedHits;
    }
    m_encounters.dropBefore(lastStep + 1);
    m_blocks.pop_front();
    m_begin += framesPerBlock;
}

} // namespace cradle
