// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_tables.h"

#include "model/measurements.h"
#include "model/shortest_number.h"

#include <QCoreApplication>
#include <QStringList>

namespace cradle::cli {

namespace {

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

void append(QByteArray &table, const QStringList &row)
{
    table += row.join(QLatin1Char(',')).toUtf8() + '\n';
}

} // namespace

void SimulateTables::addState(const World &world, const Preset &scene)
{
    if (wantStates) {
        for (std::size_t i = 0; i < world.circles.size(); ++i) {
            const Circle &c = world.circles[i];
            append(states,
                   {QString::number(world.step), shortestNumber(world.time), QString::number(i + 1),
                    shortestNumber(c.position.x), shortestNumber(c.position.y),
                    shortestNumber(c.velocity.x), shortestNumber(c.velocity.y)});
        }
    }
    if (wantTotals) {
        const Totals t = measure(world.circles, scene.gravity, scene.halfWidth);
        append(totals,
               {QString::number(world.step), shortestNumber(world.time),
                shortestNumber(t.momentum.x), shortestNumber(t.momentum.y),
                shortestNumber(t.kinetic), shortestNumber(t.potential), shortestNumber(t.total())});
    }
}

void SimulateTables::addHits(const std::vector<Hit> &hits)
{
    static const QStringList walls{QStringLiteral("left"), QStringLiteral("right"),
                                   QStringLiteral("bottom"), QStringLiteral("top")};
    if (!wantEvents)
        return;
    for (const Hit &hit : hits) {
        const bool wall = hit.kind == Hit::Kind::Wall;
        append(events,
               {shortestNumber(hit.time), wall ? QStringLiteral("wall") : QStringLiteral("circle"),
                QString::number(hit.a + 1), wall ? walls.at(hit.b) : QString::number(hit.b + 1),
                shortestNumber(hit.normal.x), shortestNumber(hit.normal.y),
                shortestNumber(hit.impulse)});
    }
}

QByteArray summaryOf(const Preset &scene, const World &world, std::size_t hits)
{
    const Totals t = measure(world.circles, scene.gravity, scene.halfWidth);
    return SimulateText::tr("%1: %2 circles, %3 steps, %4 s, %5 hits\n"
                            "momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J\n")
        .arg(scene.name, QString::number(world.circles.size()), QString::number(world.step),
             shortestNumber(world.time), QString::number(hits), shortestNumber(t.momentum.x),
             shortestNumber(t.momentum.y), shortestNumber(t.kinetic), shortestNumber(t.potential))
        .toUtf8();
}

} // namespace cradle::cli
