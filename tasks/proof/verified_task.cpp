// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/verified_task.h"

namespace cradle {

void dropNeeded(VerifiedTask &verified, const QStringList &alone)
{
    std::erase_if(verified.warnings, [&](const LabFinding &warning) {
        return warning.kind == LabFinding::Kind::CheckNeverAlone && alone.contains(warning.check);
    });
}

QString programPath(const VerifiedProgram &program)
{
    switch (program.role) {
    case VerifiedProgram::Role::Starter:
    case VerifiedProgram::Role::Solution:
        return program.name;
    case VerifiedProgram::Role::Remark:
        return QStringLiteral("remarks/") + program.name;
    case VerifiedProgram::Role::Mistake:
        break;
    }
    return QStringLiteral("mistakes/") + program.name;
}

} // namespace cradle
