// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_run.h"

#include "app/cli/subcommand.h"
#include "model/run/inferred_hits.h"
#include "model/world/measurements.h"
#include "model/world/shortest_number.h"
#include "tasks/text/plain_text.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

#include <utility>

namespace cradle::cli {

namespace {

struct SimulateText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// A step of exact timing is left for a moment after so many events: about 20 ms.
constexpr std::size_t eventsAtOnce = 16'384;

} // namespace

QString mergedText(double from)
{
    return SimulateText::tr("contacts merged from %1 s on").arg(shortestNumber(from));
}

SimulateRun::SimulateRun(const SimulateRequest &request)
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

void SimulateRun::begin(const QString &source)
{
    m_program.emplace(source);
    m_error = m_program->begin(m_scene);
    print();
    // What a program did before it stopped is no scene.
    if (m_error)
        m_scene = m_request.preset;
    m_stepper = Stepper(m_scene);
}

bool SimulateRun::run(const std::function<bool(double share)> &goesOn)
{
    while (!m_error && m_world.step < m_request.steps) {
        if (!goesOn(static_cast<double>(m_world.step) / static_cast<double>(m_request.steps)))
            return false;
        if (!step())
            continue;
        m_hitCount += m_hits.size();
        addHits();
        if (m_world.step % m_request.every == 0)
            addState();
    }
    return true;
}

/// \return false if the step is not done: the program cannot go on, or it goes on in the next call
bool SimulateRun::step()
{
    m_hits.clear();
    if (m_program && m_program->moves()) {
        stepByProgram();
        return !m_error;
    }
    const double end = static_cast<double>(m_world.step + 1) * m_scene.timestep;
    return m_stepper.advanceWithin(eventsAtOnce, m_world, m_scene.timestep, end, m_hits);
}

void SimulateRun::stepByProgram()
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

void SimulateRun::addState()
{
    for (Table &table : m_tables) {
        if (!table.path.isEmpty())
            table.text += rowsOf(table.kind, m_world, m_scene);
    }
}

void SimulateRun::addHits()
{
    Table &events = m_tables.back();
    if (events.path.isEmpty())
        return;
    for (const Hit &hit : m_hits)
        events.text += rowOf(hit);
}

/// On standard error, so that a table may go to standard output.
void SimulateRun::print()
{
    QTextStream(stderr) << printable(m_program->takeOutput().text);
}

std::optional<Error> SimulateRun::writeTables() const
{
    for (const Table &table : m_tables) {
        if (table.path.isEmpty())
            continue;
        if (const auto error = writeText(table.path, table.text))
            return error;
    }
    return std::nullopt;
}

QByteArray SimulateRun::summaryText() const
{
    const Totals t = measure(m_world.circles, m_scene.gravity, m_scene.halfWidth);
    QString text = SimulateText::tr("%1: %2 circles, %3 steps, %4 s, %5 hits\n"
                                    "momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J\n")
                       .arg(m_scene.name, QString::number(m_world.circles.size()),
                            QString::number(m_world.step), shortestNumber(m_world.time),
                            QString::number(m_hitCount), shortestNumber(t.momentum.x),
                            shortestNumber(t.momentum.y), shortestNumber(t.kinetic),
                            shortestNumber(t.potential));
    if (const auto from = mergedFrom())
        text += mergedText(*from) + QLatin1Char('\n');
    return text.toUtf8();
}

QByteArray SimulateRun::summaryJson() const
{
    const Totals t = measure(m_world.circles, m_scene.gravity, m_scene.halfWidth);
    const auto from = mergedFrom();
    const QJsonObject json{{QStringLiteral("format"), 1},
                           {QStringLiteral("name"), m_scene.name},
                           {QStringLiteral("circles"), static_cast<qint64>(m_world.circles.size())},
                           {QStringLiteral("steps"), m_world.step},
                           {QStringLiteral("time"), m_world.time},
                           {QStringLiteral("hits"), static_cast<qint64>(m_hitCount)},
                           {QStringLiteral("momentum"), QJsonArray{t.momentum.x, t.momentum.y}},
                           {QStringLiteral("kinetic"), t.kinetic},
                           {QStringLiteral("potential"), t.potential},
                           {QStringLiteral("merged_from"), from ? QJsonValue(*from) : QJsonValue()},
                           {QStringLiteral("complete"), m_world.step >= m_request.steps}};
    return QJsonDocument(json).toJson();
}

} // namespace cradle::cli
