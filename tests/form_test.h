// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/lab_test.h"
#include "tests/other_forms.h"

namespace cradle {

/// A test that judges programs in other forms than the lab's own files: another integrator, other
/// walls, other numbers, another structure.
class FormTest : public LabTest
{
protected:
    [[nodiscard]] CheckReport judgedForm(const QString &step, const programs::OtherForm &form) const
    {
        return *judgeTask(m_lab, task(step), Submission(task(step).preset, form.source()), 1);
    }
    [[nodiscard]] static QString headlineOf(const Finding &finding)
    {
        return finding.message.section(QLatin1Char('\n'), 0, 0);
    }
};

} // namespace cradle
