// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_run.h"

#include "app/cli/subcommand.h"
#include "model/world/measurements.h"
#include "model/world/shortest_number.h"
#include "tasks/text/plain_text.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct SimulateRunText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

std::optional<StudentScript> scriptOf(const SimulateRequest &request)
{
    if (!request.program)
        return std::nullopt;
    return std::optional<StudentScript>(std::in_place, *request.program);
}

Totals measured(const Runner &run)
{
    return measure(run.world().circles, run.scene().gravity, run.scene().halfWidth);
}

} // namespace

QString mergedText(double from)
{
    return SimulateRunText::tr("contacts merged from %1 s on").arg(shortestNumber(from));
}

SimulateRun::SimulateRun(const SimulateRequest &request)
    : m_request(request)
    , m_program(scriptOf(request))
    , m_run(request.preset, m_program ? &*m_program : nullptr)
    , m_tables{{{RunTable::States, request.states, {}},
                {RunTable::Totals, request.totals, {}},
                {RunTable::Events, request.events, {}}}}
{
    for (Table &table : m_tables)
        table.text = headerOf(table.kind);
    print();
    addState();
}

bool SimulateRun::run(const std::function<bool(double share)> &goesOn)
{
    const auto share = [this] {
        return static_cast<double>(m_run.world().step) / static_cast<double>(m_request.steps);
    };
    const Runner::End end =
        m_run.run({.steps = m_request.steps, .stop = [&] { return !goesOn(share()); }},
                  [this] { addStep(); });
    print();
    return end != Runner::End::Stopped;
}

void SimulateRun::addStep()
{
    print();
    m_hitCount += m_run.hits().size();
    addHits();
    if (m_run.world().step % m_request.every == 0)
        addState();
}

void SimulateRun::addState()
{
    for (Table &table : m_tables) {
        if (!table.path.isEmpty())
            table.text += rowsOf(table.kind, m_run.world(), m_run.scene());
    }
}

void SimulateRun::addHits()
{
    Table &events = m_tables.back();
    if (events.path.isEmpty())
        return;
    for (const Hit &hit : m_run.hits())
        events.text += rowOf(hit);
}

/// On standard error, so that a table may go to standard output.
void SimulateRun::print()
{
    if (!m_program)
        return;
    if (const QString text = m_program->takeOutput().text; !text.isEmpty())
        QTextStream(stderr) << printable(text);
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
    const Totals t = measured(m_run);
    const World &world = m_run.world();
    QString text = SimulateRunText::tr("%1: %2 circles, %3 steps, %4 s, %5 hits\n"
                                       "momentum (%6, %7) kg m/s, kinetic %8 J, potential %9 J\n")
                       .arg(m_run.scene().name, QString::number(world.circles.size()),
                            QString::number(world.step), shortestNumber(world.time),
                            QString::number(m_hitCount), shortestNumber(t.momentum.x),
                            shortestNumber(t.momentum.y), shortestNumber(t.kinetic),
                            shortestNumber(t.potential));
    if (const auto from = mergedFrom())
        text += mergedText(*from) + QLatin1Char('\n');
    return text.toUtf8();
}

QByteArray SimulateRun::summaryJson() const
{
    const Totals t = measured(m_run);
    const World &world = m_run.world();
    const auto from = mergedFrom();
    const QJsonObject json{{QStringLiteral("format"), 1},
                           {QStringLiteral("name"), m_run.scene().name},
                           {QStringLiteral("circles"), static_cast<qint64>(world.circles.size())},
                           {QStringLiteral("steps"), world.step},
                           {QStringLiteral("time"), world.time},
                           {QStringLiteral("hits"), static_cast<qint64>(m_hitCount)},
                           {QStringLiteral("momentum"), QJsonArray{t.momentum.x, t.momentum.y}},
                           {QStringLiteral("kinetic"), t.kinetic},
                           {QStringLiteral("potential"), t.potential},
                           {QStringLiteral("merged_from"), from ? QJsonValue(*from) : QJsonValue()},
                           {QStringLiteral("complete"), world.step >= m_request.steps}};
    return QJsonDocument(json).toJson();
}

} // namespace cradle::cli
