// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_report/set_formulas.h"
#include "views/formula_renderer.h"

#include <QTimer>

namespace cradle {

/// Sets all formulas of a report.
class FormulaSetting final : public QObject
{
    Q_OBJECT
public:
    explicit FormulaSetting(QObject *parent = nullptr);

    /// done() follows, at once if there is nothing to set, and at the latest after a while: what
    /// is wrong, or takes too long, is left out.
    void start(const std::vector<cradle::ReportFormula> &formulas);

signals:
    void done(const cradle::SetFormulas &formulas);

private:
    void take(const QString &tex, bool display, const Formula &formula);
    void finish();

    FormulaRenderer m_renderer;
    SetFormulas m_set{};
    std::size_t m_waiting = 0;
    QTimer m_patience;
};

} // namespace cradle
