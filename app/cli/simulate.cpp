// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommand.h"

#include "app/cli/simulate_request.h"
#include "app/cli/simulate_tables.h"
#include "model/inferred_hits.h"
#include "model/stepper.h"
#include "tasks/plain_text.h"
#include "tasks/report_text.h"
#include "tasks/script/student_script.h"

#include <QCoreApplication>
#include <QTextStream>

#include <optional>
#include <utility>

namespace cradle::cli {

namespace {

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// One run of a scene, by its laws or by a program.
class SimulateRun
{
public:
    explicit SimulateRun(const SimulateRequest &request)
        : m_request(request)
        , m_scene(request.preset)
        , m_stepper(request.preset)
    {
        m_tables.wantStates = !request.states.isEmpty();
        m_tables.wantTotals = !request.totals.isEmpty();
        m_tables.wantEvents = !request.events.isEmpty();
        if (request.program)
            begin(*request.program);
        m_world = initialWorld(m_scene);
        m_tables.addState(m_world, m_scene);
    }

    /// Runs to the end, or to where the program stops.
    void run()
    {
        while (!m_error && m_world.step < m_request.steps) {
            m_hits.clear();
            if (m_program && m_program->moves())
                stepByProgram();
            else
                m_stepper.advance(m_world, m_hits);
            if (m_error)
                return;
            m_hitCount += m_hits.size();
            m_tables.addHits(m_hits);
            if (m_world.step % m_request.every == 0)
                m_tables.addState(m_world, m_scene);
        }
    }

    /// Why the program stopped.
    [[nodiscard]] const std::optional<ProgramError> &error() const { return m_error; }

    /// Writes the tables that were asked for, or a summary. \return what could not be written
    [[nodiscard]] std::optional<Error> write() const
    {
        if (!m_request.wantsTables())
            return writeText({}, summaryOf(m_scene, m_world, m_hitCount));
        for (const auto &[path, text] : {std::pair(m_request.states, m_tables.states),
                                         std::pair(m_request.totals, m_tables.totals),
                                         std::pair(m_request.events, m_tables.events)}) {
            if (path.isEmpty())
                continue;
            if (const auto error = writeText(path, text))
                return error;
        }
        return std::nullopt;
    }

private:
    void begin(const QString &source)
    {
        m_program.emplace(source);
        m_error = m_program->begin(m_scene);
        print();
        // What a program did before it stopped is no scene.
        if (m_error)
            m_scene = m_request.preset;
        m_stepper = Stepper(m_scene);
    }

    void stepByProgram()
    {
        World next = m_world;
        m_error = m_program->advance(next, m_scene.timestep);
        print();
        if (m_error)
            return;
        ++next.step;
        next.time = static_cast<double>(next.step) * m_scene.timestep;
        inferHits(m_scene, m_world.circles, next.circles, m_scene.timestep, next.step, next.time,
                  m_hits);
        m_world = std::move(next);
    }

    /// On standard error, so that a table may go to standard output.
    void print() { QTextStream(stderr) << printable(m_program->takeOutput().text); }

    const SimulateRequest &m_request;
    Preset m_scene; ///< what the program made of the preset
    Stepper m_stepper;
    std::optional<StudentScript> m_program{};
    std::optional<ProgramError> m_error{};
    World m_world{};
    std::vector<Hit> m_hits{}; ///< of the step
    std::size_t m_hitCount = 0;
    SimulateTables m_tables{};
};

} // namespace

ExitCode simulate(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(SimulateText::tr(
        "Runs a scene, by its laws or by a program, and writes what happens: tables, or without "
        "any a summary. If the program stops, why is on standard error as FILE:LINE: message, the "
        "tables reach up to there, and the exit status is 1."));
    parser.addPositionalArgument(QStringLiteral("PRESET.json"), SimulateText::tr("the scene"));
    addSimulateOptions(parser);
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    const Result<SimulateRequest> request = readSimulateRequest(parser);
    if (!request)
        return complain(request.error());
    SimulateRun run(*request);
    run.run();
    if (run.error())
        QTextStream(stderr) << placedMessage(*run.error(), request->programFile) << Qt::endl;
    if (const auto error = run.write())
        return complain(*error);
    return run.error() ? NotPassed : Done;
}

} // namespace cradle::cli
