// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"
#include "views/task_pane/task_pane.h"
#include "views/theme.h"

#include <QAbstractButton>
#include <QLabel>
#include <QTest>

namespace cradle {

inline Lab threeSteps()
{
    Lab lab;
    lab.id = QStringLiteral("lab");
    for (int i = 1; i <= 3; ++i) {
        Task task;
        task.id = QStringLiteral("T%1").arg(i);
        task.title = QStringLiteral("Title %1").arg(i);
        task.instructions = QStringLiteral("# Head\nText of step %1, see [two](step:T2).").arg(i);
        task.hints = {QStringLiteral("a nudge"), QStringLiteral("more"), QStringLiteral("nearly")};
        lab.tasks.push_back(task);
    }
    lab.tasks[2].extra = true;
    return lab;
}

inline CheckReport report(bool passed)
{
    CheckReport made;
    made.passed = passed;
    made.commit = QStringLiteral("T1: Set it moving");
    made.checks = {{.id = QStringLiteral("a"), .title = QStringLiteral("It moves"), .passed = true},
                   {.id = QStringLiteral("b"),
                    .title = QStringLiteral("It bounces"),
                    .passed = passed,
                    .message = passed ? QString() : QStringLiteral("It left the square."),
                    .step = passed ? -1 : 42}};
    if (!passed)
        made.checks[1].scene = Preset{};
    return made;
}

/// A pane that is shown, with the second of three steps open, and ways to what is in it.
class OpenTaskPane final
{
public:
    /// \return whether it has the focus
    bool show();

    [[nodiscard]] bool says(const QString &part) const;
    [[nodiscard]] QAbstractButton *button(const QString &name) const;

    TaskPane pane;
    Lab lab = threeSteps();
};

inline bool OpenTaskPane::show()
{
    pane.resize(320, 800);
    pane.setLab(lab);
    pane.setProgress({true, false, false}, 1);
    pane.showTask(lab.tasks[1], 0);
    pane.show();
    pane.activateWindow();
    return QTest::qWaitForWindowActive(&pane, patience);
}

inline bool OpenTaskPane::says(const QString &part) const
{
    for (const auto *label : pane.findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().contains(part))
            return true;
    }
    return false;
}

inline QAbstractButton *OpenTaskPane::button(const QString &name) const
{
    for (auto *each : pane.findChildren<QAbstractButton *>()) {
        if (each->isVisible()
            && (each->accessibleName().startsWith(name) || each->text().startsWith(name)))
            return each;
    }
    return nullptr;
}

} // namespace cradle
