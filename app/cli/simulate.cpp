// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommand.h"

#include "app/cli/simulate_request.h"
#include "model/inferred_hits.h"
#include "model/measurements.h"
#include "model/shortest_number.h"
#include "model/stepper.h"
#include "tasks/plain_text.h"
#include "tasks/report_text.h"
#include "tasks/run_tables.h"
#include "tasks/script/student_script.h"

#include <QCoreApplication>
#include <QTextStream>

#include <array>
#include <optional>
#include <utility>

namespace cradle::cli {

namespace {

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// What became of a run, in two lines, for those who asked for no table.
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

/// One run of a scene, by its laws or by a program.
class SimulateRun
{
public:
    explicit SimulateRun(const SimulateRequest &request)
        : m_request(request)
        , m_scene(request.preset)
        , m_stepper(request.preset)
        , m_tables{{{RunTable::States, request.states, {}},
                    {RunTable::Totals, request.totals, {}},
                    {RunTable::Events, request.events, {}}}}
    {
        for (Table &table : m_tables)
            table.text = headerOf(table.kind);
        if (request.program)
            begin(*request.program);
        m_world = initialWorld(m_scene);
        addState();
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
            addHits();
            if (m_world.step % m_request.every == 0)
                addState();
        }
    }

    /// Why the program stopped.
    [[nodiscard]] const std::optional<ProgramError> &error() const { return m_error; }

    /// Writes the tables that were asked for, or a summary. \return what could not be written
    [[nodiscard]] std::optional<Error> write() const
    {
        if (!m_request.wantsTables())
            return writeText({}, summaryOf(m_scene, m_world, m_hitCount));
        for (const Table &table : m_tables) {
            if (table.path.isEmpty())
                continue;
            if (const auto error = writeText(table.path, table.text))
                return error;
        }
        return std::nullopt;
    }

private:
    /// A table of the run, which nobody wants if it has no path.
    struct Table {
        RunTable kind;
        QString path;
        QByteArray text;
    };

    void addState()
    {
        for (Table &table : m_tables) {
            if (!table.path.isEmpty())
                table.text += rowsOf(table.kind, m_world, m_scene);
        }
    }

    void addHits()
    {
        Table &events = m_tables.back();
        if (events.path.isEmpty())
            return;
        for (const Hit &hit : m_hits)
            events.text += rowOf(hit);
    }

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
    std::array<Table, 3> m_tables;
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
        return complainUnwritten(*error);
    return run.error() ? NotPassed : Done;
}

} // namespace cradle::cli
