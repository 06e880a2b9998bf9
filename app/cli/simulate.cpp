// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommand.h"

#include "model/measurements.h"
#include "model/preset_json.h"
#include "model/shortest_number.h"
#include "model/stepper.h"

#include <QCoreApplication>
#include <QTextStream>

#include <cmath>

namespace cradle::cli {

namespace {

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// Steps of one run: a day of the scene at a fine timestep.
constexpr double mostSteps = 1e8;

/// Collects the three tables of a run, each only if somebody asked for it.
class Tables
{
public:
    QByteArray states = "step,time,circle,x,y,vx,vy\n";
    QByteArray totals = "step,time,px,py,kinetic,potential,total\n";
    QByteArray events = "time,kind,a,b,nx,ny,impulse\n";
    bool wantStates = false;
    bool wantTotals = false;
    bool wantEvents = false;

    void addState(const World &world, const Preset &preset)
    {
        if (wantStates) {
            for (std::size_t i = 0; i < world.circles.size(); ++i) {
                const Circle &c = world.circles[i];
                append(states, {QString::number(world.step), shortestNumber(world.time),
                                QString::number(i + 1), shortestNumber(c.position.x),
                                shortestNumber(c.position.y), shortestNumber(c.velocity.x),
                                shortestNumber(c.velocity.y)});
            }
        }
        if (wantTotals) {
            const Totals t = measure(world.circles, preset.gravity, preset.halfWidth);
            append(totals, {QString::number(world.step), shortestNumber(world.time),
                            shortestNumber(t.momentum.x), shortestNumber(t.momentum.y),
                            shortestNumber(t.kinetic), shortestNumber(t.potential),
                            shortestNumber(t.total())});
        }
    }

    void addHits(const std::vector<Hit> &hits)
    {
        static const QStringList walls{QStringLiteral("left"), QStringLiteral("right"),
                                       QStringLiteral("bottom"), QStringLiteral("top")};
        for (const Hit &hit : hits) {
            const bool wall = hit.kind == Hit::Kind::Wall;
            append(events,
                   {shortestNumber(hit.time),
                    wall ? QStringLiteral("wall") : QStringLiteral("circle"),
                    QString::number(hit.a + 1), wall ? walls.at(hit.b) : QString::number(hit.b + 1),
                    shortestNumber(hit.normal.x), shortestNumber(hit.normal.y),
                    shortestNumber(hit.impulse)});
        }
    }

private:
    static void append(QByteArray &table, const QStringList &row)
    {
        table += row.join(QLatin1Char(',')).toUtf8() + '\n';
    }
};

QByteArray summary(const Preset &preset, const World &world, std::size_t hits)
{
    const Totals t = measure(world.circles, preset.gravity, preset.halfWidth);
    return SimulateText::tr("%1: %2 circles, %3 steps, %4 s, %5 hits\n"
                            "momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J\n")
        .arg(preset.name, QString::number(world.circles.size()), QString::number(world.step),
             shortestNumber(world.time), QString::number(hits), shortestNumber(t.momentum.x),
             shortestNumber(t.momentum.y), shortestNumber(t.kinetic), shortestNumber(t.potential))
        .toUtf8();
}

/// The number of an option within (0, most]; nullopt (and a complaint) else.
std::optional<double> numberOf(const QCommandLineParser &parser, const QCommandLineOption &option,
                               double most)
{
    bool ok = false;
    const QString text = parser.value(option);
    const double value = text.toDouble(&ok);
    if (ok && value > 0.0 && value <= most)
        return value;
    complain(SimulateText::tr("--%1 %2 is not right; a number above 0 and at most %3 is right")
                 .arg(option.names().first(), text, shortestNumber(most)));
    return std::nullopt;
}

} // namespace

ExitCode simulate(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(SimulateText::tr("Runs a scene and writes what happens."));
    parser.addPositionalArgument(QStringLiteral("PRESET.json"), SimulateText::tr("the scene"));
    const auto option = [&](const char *name, const QString &what, const char *value) {
        return QCommandLineOption(QString::fromLatin1(name), what, QString::fromLatin1(value));
    };
    const auto duration = option("duration", SimulateText::tr("how long, s"), "S");
    const auto timestep = option("timestep", SimulateText::tr("instead of the preset's, s"), "S");
    const auto timing = option("timing", SimulateText::tr("discrete, continuous or exact"), "NAME");
    const auto every = option("every", SimulateText::tr("write every N-th step only"), "N");
    const auto states = option("states", SimulateText::tr("table of the circles' states"), "F.csv");
    const auto totals = option("totals", SimulateText::tr("table of momentum and energy"), "F.csv");
    const auto events = option("events", SimulateText::tr("table of the hits"), "F.csv");
    parser.addOptions({duration, timestep, timing, every, states, totals, events});
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    if (!parser.isSet(duration))
        return complain(SimulateText::tr("--duration S is missing: how long, in s?"));
    const auto seconds = numberOf(parser, duration, 1e9);
    if (!seconds)
        return BadInput;
    Result<Preset> preset = readPreset(parser.positionalArguments().first());
    if (!preset)
        return complain(preset.error());
    if (parser.isSet(timestep)) {
        const auto value = numberOf(parser, timestep, limits::maxTimestep);
        if (!value)
            return BadInput;
        preset->timestep = *value;
    }
    if (parser.isSet(timing)) {
        const auto value = timingFromName(parser.value(timing));
        if (!value)
            return complain(SimulateText::tr("--timing %1 is not right; discrete, continuous or "
                                             "exact is right")
                                .arg(parser.value(timing)));
        preset->laws.timing = *value;
    }
    qint64 stride = 1;
    if (parser.isSet(every)) {
        const auto value = numberOf(parser, every, 1e9);
        if (!value)
            return BadInput;
        stride = static_cast<qint64>(*value);
        if (stride < 1)
            return complain(SimulateText::tr("--every counts whole steps; 1 or more is right"));
    }
    // A part of a step at the end is a step: the run lasts at least as long as asked.
    const double steps = std::ceil(*seconds / preset->timestep * (1.0 - 1e-12));
    if (steps > mostSteps)
        return complain(SimulateText::tr("%1 steps are too many; at most %2 are right")
                            .arg(steps)
                            .arg(mostSteps));

    Tables tables;
    tables.wantStates = parser.isSet(states);
    tables.wantTotals = parser.isSet(totals);
    tables.wantEvents = parser.isSet(events);
    Stepper stepper(*preset);
    World world = initialWorld(*preset);
    std::size_t hitCount = 0;
    std::vector<Hit> hits;
    tables.addState(world, *preset);
    for (qint64 k = 1; k <= static_cast<qint64>(steps); ++k) {
        hits.clear();
        stepper.advance(world, hits);
        hitCount += hits.size();
        if (tables.wantEvents)
            tables.addHits(hits);
        if (k % stride == 0)
            tables.addState(world, *preset);
    }

    const std::pair<const QCommandLineOption &, const QByteArray &> outputs[] = {
        {states, tables.states}, {totals, tables.totals}, {events, tables.events}};
    bool written = false;
    for (const auto &[wanted, text] : outputs) {
        if (!parser.isSet(wanted))
            continue;
        written = true;
        if (const auto error = writeText(parser.value(wanted), text))
            return complain(*error);
    }
    if (!written)
        writeText({}, summary(*preset, world, hitCount));
    return Done;
}

} // namespace cradle::cli
