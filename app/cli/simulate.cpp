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

/// What was asked for; see simulate().
struct Request {
    Preset preset{};
    qint64 steps = 0;
    qint64 every = 1;
    QString states{}; ///< files; empty if not wanted, "-" for standard output
    QString totals{};
    QString events{};
};

struct SimulateOptions {
    QCommandLineOption duration = option("duration", SimulateText::tr("how long, s"), "S");
    QCommandLineOption timestep =
        option("timestep", SimulateText::tr("instead of the preset's, s"), "S");
    QCommandLineOption timing =
        option("timing", SimulateText::tr("discrete, continuous or exact"), "NAME");
    QCommandLineOption every = option("every", SimulateText::tr("write every N-th step only"), "N");
    QCommandLineOption states =
        option("states", SimulateText::tr("table of the circles' states"), "F.csv");
    QCommandLineOption totals =
        option("totals", SimulateText::tr("table of momentum and energy"), "F.csv");
    QCommandLineOption events = option("events", SimulateText::tr("table of the hits"), "F.csv");

    static QCommandLineOption option(const char *name, const QString &what, const char *value)
    {
        return {QString::fromLatin1(name), what, QString::fromLatin1(value)};
    }
};

Error wrong(const QCommandLineOption &option, const QString &text, const QString &right)
{
    return {.message = SimulateText::tr("--%1 %2 is not right; %3 is right")
                           .arg(option.names().first(), text, right)};
}

/// The number of an option, in (0, most].
Result<double> numberOf(const QCommandLineParser &parser, const QCommandLineOption &option,
                        double most)
{
    bool ok = false;
    const QString text = parser.value(option);
    const double value = text.toDouble(&ok);
    if (ok && value > 0.0 && value <= most)
        return value;
    return wrong(option, text,
                 SimulateText::tr("a number above 0 and at most %1").arg(shortestNumber(most)));
}

/// Reads the preset and lays the options over it.
Result<Request> requestOf(const QCommandLineParser &parser, const SimulateOptions &options)
{
    if (!parser.isSet(options.duration))
        return Error{.message = SimulateText::tr("--duration S is missing: how long, in s?")};
    const Result<double> seconds = numberOf(parser, options.duration, 1e9);
    if (!seconds)
        return seconds.error();
    Result<Preset> preset = readPreset(parser.positionalArguments().first());
    if (!preset)
        return preset.error();
    Request request{.preset = std::move(*preset)};
    if (parser.isSet(options.timestep)) {
        const Result<double> timestep = numberOf(parser, options.timestep, limits::maxTimestep);
        if (!timestep)
            return timestep.error();
        request.preset.timestep = *timestep;
    }
    if (parser.isSet(options.timing)) {
        const auto timing = timingFromName(parser.value(options.timing));
        if (!timing)
            return wrong(options.timing, parser.value(options.timing),
                         SimulateText::tr("discrete, continuous or exact"));
        request.preset.laws.timing = *timing;
    }
    if (parser.isSet(options.every)) {
        bool ok = false;
        request.every = parser.value(options.every).toLongLong(&ok);
        if (!ok || request.every < 1)
            return wrong(options.every, parser.value(options.every),
                         SimulateText::tr("a whole number from 1"));
    }
    // A part of a step at the end is a step: the run lasts at least as long as asked.
    const double steps = std::ceil(*seconds / request.preset.timestep * (1.0 - 1e-12));
    if (steps > mostSteps)
        return Error{.message = SimulateText::tr("%1 steps are too many; at most %2 are right")
                                    .arg(steps)
                                    .arg(mostSteps)};
    request.steps = static_cast<qint64>(steps);
    request.states = parser.value(options.states);
    request.totals = parser.value(options.totals);
    request.events = parser.value(options.events);
    return request;
}

/// Runs the scene and writes what was asked for, or a summary. \return what could not be written
std::optional<Error> run(const Request &request)
{
    Tables tables;
    tables.wantStates = !request.states.isEmpty();
    tables.wantTotals = !request.totals.isEmpty();
    Stepper stepper(request.preset);
    World world = initialWorld(request.preset);
    std::size_t hitCount = 0;
    std::vector<Hit> hits;
    tables.addState(world, request.preset);
    for (qint64 k = 1; k <= request.steps; ++k) {
        hits.clear();
        stepper.advance(world, hits);
        hitCount += hits.size();
        if (!request.events.isEmpty())
            tables.addHits(hits);
        if (k % request.every == 0)
            tables.addState(world, request.preset);
    }
    if (request.states.isEmpty() && request.totals.isEmpty() && request.events.isEmpty())
        return writeText({}, summary(request.preset, world, hitCount));
    for (const auto &[path, text] :
         {std::pair(request.states, tables.states), std::pair(request.totals, tables.totals),
          std::pair(request.events, tables.events)}) {
        if (path.isEmpty())
            continue;
        if (const auto error = writeText(path, text))
            return error;
    }
    return std::nullopt;
}

} // namespace

ExitCode simulate(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(SimulateText::tr("Runs a scene and writes what happens."));
    parser.addPositionalArgument(QStringLiteral("PRESET.json"), SimulateText::tr("the scene"));
    const SimulateOptions options;
    parser.addOptions({options.duration, options.timestep, options.timing, options.every,
                       options.states, options.totals, options.events});
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    const Result<Request> request = requestOf(parser, options);
    if (!request)
        return complain(request.error());
    const auto error = run(*request);
    return error ? complain(*error) : Done;
}

} // namespace cradle::cli
