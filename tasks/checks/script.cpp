// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/kinds.h"

#include "tasks/checks/check_script.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle::kinds {

namespace {

struct ScriptCheckText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// "checks/heights.lua:12".
QString placeOf(const CheckSpec &check, const ProgramError &error)
{
    const QString file =
        QStringLiteral("checks/") + check.parameters.value(QStringLiteral("script")).toString();
    return error.line > 0 ? file + QStringLiteral(":%1").arg(error.line) : file;
}

} // namespace

std::optional<Fault> script(const CheckSpec &check, const Observation &o)
{
    const ScriptVerdict verdict = runCheckScript(check.source, o, check.language);
    if (verdict.error)
        return Fault{.message = ScriptCheckText::tr("%1: the check itself stopped, so it says "
                                                    "nothing of your work: %2")
                                    .arg(placeOf(check, *verdict.error), verdict.error->message),
                     .checkStopped = true};
    if (verdict.passed)
        return std::nullopt;
    Fault fault{.message = verdict.message,
                .expected = verdict.expected,
                .observed = verdict.observed,
                .unit = verdict.unit};
    if (verdict.time)
        fault.step = static_cast<qint64>(std::ceil(*verdict.time / o.timestep() - 1e-6));
    return fault;
}

} // namespace cradle::kinds
