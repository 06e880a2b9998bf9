// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/gui/chart_scenes.h"
#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "tests/showing_program.h"
#include "views/console_view.h"

#include <QListView>
#include <QTest>

namespace cradle {

inline QString numbered(qint64 step)
{
    return QStringLiteral("line of %1\n").arg(step);
}

/// Prints a line in every step.
inline void printStep(World &world, ProgramOutput &output)
{
    output.text = numbered(world.step + 1);
}

/// A console beside a run of a program.
struct Console {
    ShowingProgram program;
    Simulation simulation{glancing()};
    ConsoleView view{simulation};
    QListView *list = view.findChild<QListView *>();

    explicit Console(ShowingProgram::Show show = printStep)
        : program(std::move(show))
    {
        simulation.setProgram(&program);
        view.resize(344, 240);
        view.show();
        (void)QTest::qWaitForWindowExposed(&view, patience);
        settle();
    }

    [[nodiscard]] int rows() const { return list->model()->rowCount(); }
    [[nodiscard]] QString text(int row) const
    {
        return list->model()->index(row, 0).data().toString();
    }
    /// The row at the lower edge.
    [[nodiscard]] int lowest() const
    {
        const QModelIndex index = list->indexAt({20, list->viewport()->height() - 12});
        return index.isValid() ? index.row() : rows() - 1;
    }
};

} // namespace cradle
