// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/run_tables.h"

#include "model/files/file_io.h"
#include "model/world/measurements.h"
#include "model/world/shortest_number.h"

#include <QStringList>

#include <utility>

namespace cradle {

namespace {

/// Rows are collected up to so many bytes before they go to the file.
constexpr qsizetype chunk = 1 << 20;

QByteArray row(const QStringList &cells)
{
    return cells.join(QLatin1Char(',')).toUtf8() + '\n';
}

} // namespace

QByteArray headerOf(RunTable table)
{
    switch (table) {
    case RunTable::States:
        return "step,time,circle,x,y,vx,vy\n";
    case RunTable::Totals:
        return "step,time,px,py,kinetic,potential,total\n";
    case RunTable::Events:
        break;
    }
    return "time,kind,a,b,nx,ny,impulse\n";
}

QByteArray rowsOf(RunTable table, const World &world, const Preset &scene)
{
    QByteArray rows;
    if (table == RunTable::States) {
        for (std::size_t i = 0; i < world.circles.size(); ++i) {
            const Circle &c = world.circles[i];
            rows += row({QString::number(world.step), shortestNumber(world.time),
                         QString::number(i + 1), shortestNumber(c.position.x),
                         shortestNumber(c.position.y), shortestNumber(c.velocity.x),
                         shortestNumber(c.velocity.y)});
        }
    } else if (table == RunTable::Totals) {
        const Totals t = measure(world.circles, scene.gravity, scene.halfWidth);
        rows = row({QString::number(world.step), shortestNumber(world.time),
                    shortestNumber(t.momentum.x), shortestNumber(t.momentum.y),
                    shortestNumber(t.kinetic), shortestNumber(t.potential),
                    shortestNumber(t.total())});
    }
    return rows;
}

QByteArray rowOf(const Hit &hit)
{
    static const QStringList walls{QStringLiteral("left"), QStringLiteral("right"),
                                   QStringLiteral("bottom"), QStringLiteral("top")};
    const bool wall = hit.kind == Hit::Kind::Wall;
    return row({shortestNumber(hit.time), wall ? QStringLiteral("wall") : QStringLiteral("circle"),
                QString::number(hit.a + 1), wall ? walls.at(hit.b) : QString::number(hit.b + 1),
                shortestNumber(hit.normal.x), shortestNumber(hit.normal.y),
                shortestNumber(hit.impulse)});
}

std::optional<Error> saveRunTable(RunTable table, const Recording &recording, const Preset &scene,
                                  const QString &path)
{
    WholeFile file(path);
    QByteArray pending = headerOf(table);
    const auto add = [&](const QByteArray &rows) {
        pending += rows;
        if (pending.size() >= chunk)
            file.append(std::exchange(pending, {}));
    };
    if (table == RunTable::Events) {
        for (const Hit &hit : recording.hits())
            add(rowOf(hit));
    } else {
        for (qint64 i = recording.first(); i <= recording.last(); ++i)
            add(rowsOf(table, recording.world(i), scene));
    }
    file.append(pending);
    return file.commit();
}

} // namespace cradle
