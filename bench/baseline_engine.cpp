// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/gas_engine.h"
#include "model/world/world.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace cradle {

namespace {

/// Hard discs from event to event: every pair of neighbouring cells is predicted, an event whose
/// circles have been hit since is dropped when its turn comes, and each circle has its own clock.
/// Source: Alder, Wainwright, J. Chem. Phys. 31 (1959) 459; Rapaport, The Art of Molecular
/// Dynamics Simulation, 2nd ed., chapter 14.
class BaselineEngine final : public GasEngine
{
public:
    explicit BaselineEngine(const Preset &gas)
        : m_reach(gas.halfWidth - gas.circles.front().body.radius)
        , m_diameter(2.0 * gas.circles.front().body.radius)
        , m_halfWidth(gas.halfWidth)
        , m_columns(std::max(1, static_cast<int>(2.0 * gas.halfWidth / m_diameter)))
        , m_cellWidth(2.0 * gas.halfWidth / m_columns)
        , m_heads(static_cast<std::size_t>(m_columns * m_columns), -1)
    {
        for (const PresetCircle &circle : gas.circles) {
            const Vec2 p = circle.body.position;
            m_discs.push_back({.position = p,
                               .velocity = circle.body.velocity,
                               .column = columnOf(p.x),
                               .row = columnOf(p.y)});
            link(static_cast<int>(m_discs.size()) - 1);
        }
        for (int i = 0; i < static_cast<int>(m_discs.size()); ++i)
            predict(i);
    }

    void step() override
    {
        const double end = ++m_frames / 60.0;
        while (!m_queue.empty() && m_queue.top().time <= end) {
            const Event event = m_queue.top();
            m_queue.pop();
            if (disc(event.a).count != event.countA)
                continue;
            if (event.b < 0)
                meetWallOrCell(event);
            else if (disc(event.b).count == event.countB)
                meetDisc(event);
        }
    }
    [[nodiscard]] int stepsPerFrame() const override { return 1; }
    [[nodiscard]] qint64 hitCount() const override { return m_hitCount; }

    void read(std::vector<Motion> &motions) const override
    {
        motions.clear();
        for (const Disc &d : m_discs) {
            const Vec2 way = (m_frames / 60.0 - d.time) * d.velocity;
            motions.push_back({d.position + way, d.velocity});
        }
    }

private:
    struct Disc {
        Vec2 position{};
        Vec2 velocity{};
        double time = 0.0;  ///< of position, s
        unsigned count = 0; ///< of hits: what was predicted before the last is void
        int column = 0;     ///< of its cell
        int row = 0;
        int previous = -1; ///< in its cell
        int next = -1;
    };
    /// b is a disc, or ~Wall where the centre meets the edge of its cell or of its room.
    struct Event {
        double time = 0.0;
        int a = 0;
        int b = 0;
        unsigned countA = 0;
        unsigned countB = 0;
        friend bool operator>(const Event &e, const Event &f) { return e.time > f.time; }
    };

    Disc &disc(int i) { return m_discs[static_cast<std::size_t>(i)]; }
    int &head(int column, int row)
    {
        return m_heads[static_cast<std::size_t>(row * m_columns + column)];
    }
    [[nodiscard]] int columnOf(double x) const
    {
        return std::clamp(static_cast<int>((x + m_halfWidth) / m_cellWidth), 0, m_columns - 1);
    }

    void link(int i)
    {
        Disc &d = disc(i);
        int &first = head(d.column, d.row);
        d.previous = -1;
        d.next = first;
        if (first >= 0)
            disc(first).previous = i;
        first = i;
    }

    void unlink(int i)
    {
        const Disc &d = disc(i);
        (d.previous >= 0 ? disc(d.previous).next : head(d.column, d.row)) = d.next;
        if (d.next >= 0)
            disc(d.next).previous = d.previous;
    }

    void carryTo(Disc &d, double time)
    {
        d.position += (time - d.time) * d.velocity;
        d.time = time;
    }

    void predict(int i)
    {
        predictWallOrCell(i);
        predictDiscs(i, -1, 1, -1, 1);
    }

    /// The next edge of the cell or of the room, whichever way it comes first.
    void predictWallOrCell(int i)
    {
        const Disc &d = disc(i);
        const auto wait = [this](double x, double v, int column) {
            if (v == 0.0)
                return std::numeric_limits<double>::infinity();
            const double edge = -m_halfWidth + (v > 0.0 ? column + 1 : column) * m_cellWidth;
            return std::max(0.0, (std::clamp(edge, -m_reach, m_reach) - x) / v);
        };
        const double x = wait(d.position.x, d.velocity.x, d.column);
        const double y = wait(d.position.y, d.velocity.y, d.row);
        const Wall wall = x < y ? (d.velocity.x > 0.0 ? Wall::Right : Wall::Left)
                                : (d.velocity.y > 0.0 ? Wall::Top : Wall::Bottom);
        m_queue.push({d.time + std::min(x, y), i, ~static_cast<int>(wall), d.count, 0});
    }

    /// All hits of i on discs of the cells from (left, bottom) to (right, top) around its own.
    void predictDiscs(int i, int left, int right, int bottom, int top)
    {
        const Disc &d = disc(i);
        for (int row = std::max(0, d.row + bottom); row <= std::min(m_columns - 1, d.row + top);
             ++row) {
            for (int column = std::max(0, d.column + left);
                 column <= std::min(m_columns - 1, d.column + right); ++column) {
                for (int j = head(column, row); j >= 0; j = disc(j).next) {
                    if (j != i)
                        predictPair(i, j);
                }
            }
        }
    }

    void predictPair(int i, int j)
    {
        const Disc &a = disc(i);
        const Disc &b = disc(j);
        // |r + v τ| = d, from a's moment on; τ in the form that does not cancel.
        const Vec2 r = b.position + (a.time - b.time) * b.velocity - a.position;
        const Vec2 v = b.velocity - a.velocity;
        const double approach = -dot(r, v);
        if (approach <= 0.0)
            return;
        const double gap = lengthSquared(r) - m_diameter * m_diameter;
        const double discriminant = approach * approach - lengthSquared(v) * gap;
        if (discriminant < 0.0)
            return;
        const double wait = std::max(0.0, gap / (approach + std::sqrt(discriminant)));
        m_queue.push({a.time + wait, i, j, a.count, b.count});
    }

    void meetDisc(const Event &event)
    {
        Disc &a = disc(event.a);
        Disc &b = disc(event.b);
        carryTo(a, event.time);
        carryTo(b, event.time);
        const Vec2 n = normalized(b.position - a.position);
        const Vec2 exchanged = dot(a.velocity - b.velocity, n) * n;
        a.velocity -= exchanged;
        b.velocity += exchanged;
        ++a.count;
        ++b.count;
        ++m_hitCount;
        predict(event.a);
        predict(event.b);
    }

    void meetWallOrCell(const Event &event)
    {
        Disc &d = disc(event.a);
        carryTo(d, event.time);
        const auto wall = static_cast<Wall>(~event.b);
        const bool sideways = wall == Wall::Left || wall == Wall::Right;
        const int way = wall == Wall::Left || wall == Wall::Bottom ? -1 : 1;
        int &cell = sideways ? d.column : d.row;
        if (const int next = cell + way; next >= 0 && next < m_columns) {
            unlink(event.a);
            cell = next;
            link(event.a);
            predictWallOrCell(event.a);
            if (sideways)
                predictDiscs(event.a, way, way, -1, 1);
            else
                predictDiscs(event.a, -1, 1, way, way);
            return;
        }
        double &speed = sideways ? d.velocity.x : d.velocity.y;
        speed = -speed;
        ++d.count;
        ++m_hitCount;
        predict(event.a);
    }

    double m_reach; ///< of a centre from the middle, m
    double m_diameter;
    double m_halfWidth;
    int m_columns;
    double m_cellWidth;       ///< m, at least a diameter
    std::vector<int> m_heads; ///< the first disc of each cell
    std::vector<Disc> m_discs;
    std::priority_queue<Event, std::vector<Event>, std::greater<>> m_queue;
    int m_frames = 0;
    qint64 m_hitCount = 0;
};

} // namespace

std::unique_ptr<GasEngine> makeBaseline(const Gas &gas)
{
    return std::make_unique<BaselineEngine>(gas);
}

} // namespace cradle
