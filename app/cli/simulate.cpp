// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommand.h"

#include "app/cli/simulate_progress.h"
#include "app/cli/simulate_run.h"
#include "app/cli/stop_signal.h"
#include "model/world/shortest_number.h"
#include "tasks/report/report_text.h"

#include <QCoreApplication>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// \return whether it came to the end, or to where the program stops
bool runWatched(SimulateRun &run)
{
    watchForStop();
    SimulateProgress progress;
    return run.run([&progress](double share) {
        progress.show(share);
        return !stopAsked();
    });
}

/// The summary, where it is wanted; else what must not go unsaid, on standard error.
std::optional<Error> writeSummary(const SimulateRequest &request, const SimulateRun &run)
{
    if (request.wantsSummary())
        return writeText({}, request.asJson ? run.summaryJson() : run.summaryText());
    if (const auto from = run.mergedFrom())
        QTextStream(stderr) << mergedText(*from) << Qt::endl;
    return std::nullopt;
}

} // namespace

ExitCode simulate(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(SimulateText::tr(
        "Runs a scene, by its laws or by a program, and writes what happens: tables, or without "
        "any a summary. If the program stops, why is on standard error as FILE:LINE: message, the "
        "tables reach up to there, and the exit status is 1. Ctrl+C ends the run: what is written "
        "reaches up to there, and the exit status is 130."));
    parser.addPositionalArgument(QStringLiteral("PRESET.json"), SimulateText::tr("the scene"));
    addSimulateOptions(parser);
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    const Result<SimulateRequest> request = readSimulateRequest(parser);
    if (!request)
        return complain(request.error());
    SimulateRun run(*request);
    const bool whole = runWatched(run);
    if (run.error())
        QTextStream(stderr) << placedMessage(*run.error(), request->programFile) << Qt::endl;
    if (!whole)
        QTextStream(stderr) << SimulateText::tr("stopped at %1 s").arg(shortestNumber(run.time()))
                            << Qt::endl;
    if (const auto error = run.writeTables())
        return complainUnwritten(*error);
    if (const auto error = writeSummary(*request, run))
        return complainUnwritten(*error);
    if (!whole)
        return Stopped;
    return run.error() ? NotPassed : Done;
}

} // namespace cradle::cli
