// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/formula_setting.h"

#include <utility>

namespace cradle {

namespace {

constexpr int patience = 30'000; ///< ms: the notes of a whole lab take one or two seconds

} // namespace

FormulaSetting::FormulaSetting(QObject *parent)
    : QObject(parent)
{
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_renderer, &FormulaRenderer::ready, this, &FormulaSetting::take);
    connect(&m_patience, &QTimer::timeout, this, &FormulaSetting::finish);
}

void FormulaSetting::start(const std::vector<ReportFormula> &formulas)
{
    m_set.clear();
    m_waiting = formulas.size();
    if (formulas.empty())
        return finish();
    m_patience.start();
    for (const ReportFormula &formula : formulas)
        m_renderer.request(formula.tex, formula.display);
}

void FormulaSetting::take(const QString &tex, bool display, const Formula &formula)
{
    if (m_waiting == 0)
        return;
    if (formula.state == Formula::State::Ready)
        m_set[{tex, display}] = {formula.svg, formula.width, formula.height, formula.depth};
    if (--m_waiting == 0)
        finish();
}

void FormulaSetting::finish()
{
    m_patience.stop();
    m_waiting = 0;
    emit done(std::exchange(m_set, {}));
}

} // namespace cradle
