// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_request.h"

#include "model/files/preset_json.h"
#include "model/world/shortest_number.h"
#include "tasks/script/program_text.h"
#include "tasks/values/values_of_file.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle::cli {

namespace {

struct AskedSimText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// Steps of one run: a day of the scene at a fine timestep.
constexpr double mostSteps = 1e8;

struct SimulateOptions {
    QCommandLineOption duration = option("duration", AskedSimText::tr("how long, s"), "S");
    QCommandLineOption timestep =
        option("timestep", AskedSimText::tr("instead of the preset's, s"), "S");
    QCommandLineOption timing =
        option("timing", AskedSimText::tr("discrete, continuous or exact"), "NAME");
    QCommandLineOption script = option(
        "script",
        AskedSimText::tr("a program that moves the circles; what it prints goes to standard error, "
                         "what it plots and draws is dropped, its hits are inferred"),
        "F.lua");
    QCommandLineOption student =
        option("student",
               AskedSimText::tr("of files of a lab that draws values: those of the student with "
                                "this number"),
               "NUMBER");
    QCommandLineOption every = option("every", AskedSimText::tr("write every N-th step only"), "N");
    QCommandLineOption states =
        option("states", AskedSimText::tr("table of the circles' states"), "F.csv");
    QCommandLineOption totals =
        option("totals", AskedSimText::tr("table of momentum and energy"), "F.csv");
    QCommandLineOption events = option("events", AskedSimText::tr("table of the hits"), "F.csv");
    QCommandLineOption format = option(
        "format",
        AskedSimText::tr("of the summary: text, or json, which is written beside tables, too"),
        "NAME");

    static QCommandLineOption option(const char *name, const QString &what, const char *value)
    {
        return {QString::fromLatin1(name), what, QString::fromLatin1(value)};
    }
};

Error wrong(const QCommandLineOption &option, const QString &text, const QString &right)
{
    return {.message = AskedSimText::tr("--%1 %2 is not right; %3 is right")
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
                 AskedSimText::tr("a number above 0 and at most %1").arg(shortestNumber(most)));
}

/// Reads of the summary whether it is wanted as JSON.
std::optional<Error> readFormat(const QCommandLineParser &parser, const SimulateOptions &options,
                                SimulateRequest &request)
{
    const QString format = parser.value(options.format);
    request.asJson = format == QLatin1String("json");
    if (parser.isSet(options.format) && !request.asJson && format != QLatin1String("text"))
        return wrong(options.format, format, QStringLiteral("text, json"));
    const bool tableThere =
        QStringList{request.states, request.totals, request.events}.contains(QLatin1String("-"));
    if (request.asJson && tableThere)
        return Error{.message = AskedSimText::tr(
                         "a table and the summary cannot both go to standard output; a file for "
                         "the table is right")};
    return std::nullopt;
}

} // namespace

void addSimulateOptions(QCommandLineParser &parser)
{
    const SimulateOptions options;
    parser.addOptions({options.duration, options.timestep, options.timing, options.script,
                       options.student, options.every, options.states, options.totals,
                       options.events, options.format});
}

Result<SimulateRequest> readSimulateRequest(const QCommandLineParser &parser)
{
    const SimulateOptions options;
    if (!parser.isSet(options.duration))
        return Error{.message = AskedSimText::tr("--duration S is missing: how long, in s?")};
    const Result<double> seconds = numberOf(parser, options.duration, 1e9);
    if (!seconds)
        return seconds.error();
    const QString student = parser.value(options.student);
    Result<Preset> preset = presetWithValues(parser.positionalArguments().first(), student);
    if (!preset)
        return preset.error();
    SimulateRequest request{.preset = std::move(*preset)};
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
                         AskedSimText::tr("discrete, continuous or exact"));
        request.preset.laws.timing = *timing;
    }
    if (parser.isSet(options.every)) {
        bool ok = false;
        request.every = parser.value(options.every).toLongLong(&ok);
        if (!ok || request.every < 1)
            return wrong(options.every, parser.value(options.every),
                         AskedSimText::tr("a whole number from 1"));
    }
    // A part of a step at the end is a step: the run lasts at least as long as asked.
    const double steps = std::ceil(*seconds / request.preset.timestep * (1.0 - 1e-12));
    if (steps > mostSteps)
        return Error{.message = AskedSimText::tr("%1 steps are too many; at most %2 are right")
                                    .arg(steps)
                                    .arg(mostSteps)};
    request.steps = static_cast<qint64>(steps);
    if (parser.isSet(options.script)) {
        const Result<QString> program = readProgram(parser.value(options.script));
        if (!program)
            return program.error();
        const auto own =
            withValuesOfItsStep(parser.value(options.script), program->toUtf8(), student);
        if (!own)
            return own.error();
        request.program = QString::fromUtf8(*own);
        request.programFile = parser.value(options.script);
    }
    request.states = parser.value(options.states);
    request.totals = parser.value(options.totals);
    request.events = parser.value(options.events);
    if (const auto error = readFormat(parser, options, request))
        return *error;
    return request;
}

} // namespace cradle::cli
