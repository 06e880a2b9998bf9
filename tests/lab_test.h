// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/files/preset_json.h"
#include "tasks/judging/judgement.h"
#include "tasks/reading/lab_reader.h"

#include <QTest>

namespace cradle {

/// The checks that failed, a line each.
inline QString failedChecks(const CheckReport &report)
{
    QStringList lines;
    for (const CheckOutcome &check : report.checks) {
        if (!check.passed)
            lines.append(check.id + QStringLiteral(": ") + check.message + QStringLiteral(" [")
                         + check.variant + QLatin1Char(']'));
    }
    return lines.join(QLatin1Char('\n'));
}

/// A test that judges a shipped lab from outside.
class LabTest : public QObject
{
protected:
    void read(const char *folder)
    {
        const Result<Lab> lab = readLab(QLatin1String(folder));
        QVERIFY2(lab.ok(), lab ? "" : qPrintable(lab.error().toString()));
        m_lab = *lab;
    }
    /// A row for every step.
    void addSteps() const
    {
        QTest::addColumn<QString>("step");
        for (const Task &task : m_lab.tasks)
            QTest::newRow(qPrintable(task.id)) << task.id;
    }
    [[nodiscard]] const Task &task(const QString &id) const
    {
        return m_lab.tasks[static_cast<std::size_t>(m_lab.indexOf(id))];
    }
    /// The scene that passes the step.
    [[nodiscard]] Preset solution(const QString &id) const
    {
        return *readPreset(task(id).folder + QStringLiteral("/solution-preset.json"));
    }
    [[nodiscard]] CheckReport judged(const QString &id, const Preset &preset, qint64 seed = 1) const
    {
        return *judgeTask(m_lab, task(id), preset, seed);
    }

    Lab m_lab;
};

} // namespace cradle
