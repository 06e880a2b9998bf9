// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/value_solver.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

using Numbers = std::vector<double>;

/// Of all that is wrong, what may be left: where in a step two touch is known to some degrees.
constexpr double mostLeft = 0.1;
/// Below this nothing is wrong, m/s.
constexpr double leastOff = 1e-6;
constexpr int mostRounds = 4;
/// Of what is wrong, after one more round: else it comes to nothing.
constexpr double mostKept = 0.8;
/// Of a change by which is found what it does.
constexpr double small = 1e-4;

double normOf(const Numbers &numbers)
{
    double sum = 0.0;
    for (const double each : numbers)
        sum += each * each;
    return std::sqrt(sum);
}

/// The least change by which J x = -f as nearly as can be, by elimination in JᵀJ.
Numbers leastSquares(const std::vector<Numbers> &columns, const Numbers &f)
{
    const std::size_t n = columns.size();
    std::vector<Numbers> a(n, Numbers(n + 1, 0.0));
    double most = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < f.size(); ++k) {
            for (std::size_t j = 0; j < n; ++j)
                a[i][j] += columns[i][k] * columns[j][k];
            a[i][n] -= columns[i][k] * f[k];
        }
        most = std::max(most, a[i][i]);
    }
    for (std::size_t i = 0; i < n; ++i)
        a[i][i] += 1e-9 * most + 1e-300; // what changes nothing stays
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t row = 0; row < n; ++row) {
            if (row == i)
                continue;
            const double share = a[row][i] / a[i][i];
            for (std::size_t j = i; j <= n; ++j)
                a[row][j] -= share * a[i][j];
        }
    }
    Numbers x(n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = a[i][n] / a[i][i];
    return x;
}

} // namespace

ValueSolver::ValueSolver(const ProgramLines &program, const QString &reference,
                         const Moment &moment, Aspect aspect)
    : m_program(program)
    , m_moment(moment)
    , m_aspect(aspect)
    , m_right(worldAfter(reference, moment.stage, moment.step))
    , m_own(worldAfter(program.source(), moment.stage, moment.step))
{
}

bool ValueSolver::isWrong() const
{
    // A variable of that name would hide the count of steps.
    if (!m_right || !m_own || m_program.hasName(QStringLiteral("step")))
        return false;
    const auto off = offOf(m_program.source());
    return off && normOf(*off) >= leastOff;
}

bool ValueSolver::mends(const std::vector<TokenRange> &values) const
{
    const std::size_t count = 2 * values.size();
    Numbers by(count, 0.0);
    auto off = offOf(m_program.source());
    const double most = mostLeft * normOf(*off);
    std::vector<bool> acts(count, true);
    for (int round = 0; round < mostRounds; ++round) {
        std::vector<Numbers> columns;
        for (std::size_t k = 0; k < count; ++k) {
            if (!acts[k]) {
                columns.emplace_back(off->size(), 0.0);
                continue;
            }
            Numbers other = by;
            other[k] += small;
            const auto then = offOf(changed(values, other));
            if (!then)
                return false;
            Numbers column(off->size());
            for (std::size_t i = 0; i < column.size(); ++i)
                column[i] = ((*then)[i] - (*off)[i]) / small;
            acts[k] = normOf(column) > 0.0;
            columns.push_back(std::move(column));
        }
        if (std::none_of(acts.begin(), acts.end(), [](bool each) { return each; }))
            return false;
        const Numbers more = leastSquares(columns, *off);
        for (std::size_t k = 0; k < count; ++k)
            by[k] += more[k];
        const double before = normOf(*off);
        off = offOf(changed(values, by));
        if (!off || (round > 0 && normOf(*off) > mostKept * before))
            return false;
        if (normOf(*off) <= most)
            return true;
    }
    return false;
}

QString ValueSolver::changed(const std::vector<TokenRange> &values, const Numbers &by) const
{
    static const QString change = QStringLiteral(
        "local mended_by, often = {%1}, 0 local function mended(k, v, ...) if step %2 %3 then "
        "often = often + (k == 1 and step == %3 and 1 or 0) if often > %4 then error('') end "
        "local x, y = mended_by[2 * k - 1], mended_by[2 * k] "
        "if type(v) == 'number' then v = v + x "
        "elseif type(v) == 'vector' then v = v + vec(x, y) "
        "elseif type(v) == 'table' then local w = {} for i, q in pairs(v) do w[i] = q end v = w "
        "if type(v[1]) == 'number' then v[1], v[2] = v[1] + x, (v[2] or 0) + y "
        "elseif type(v.x) == 'number' then v.x, v.y = v.x + x, (v.y or 0) + y end "
        "end end return v, ... end ");
    QString source = m_program.source();
    QStringList numbers;
    for (const double each : by)
        numbers.append(QString::number(each, 'g', 17));
    for (std::size_t k = values.size(); k > 0; --k) {
        const qsizetype from = m_program.tokens()[values[k - 1].from].start;
        const qsizetype to = m_program.tokens()[values[k - 1].to - 1].end();
        source.replace(
            from, to - from,
            QStringLiteral("mended(%1, %2)").arg(k).arg(m_program.source().mid(from, to - from)));
    }
    // What a step does wrong it did before, too.
    const QLatin1String when(m_aspect == Aspect::Motion ? "<=" : "==");
    // Who is called for one thing and for another mends both only by chance.
    const std::size_t often = m_aspect == Aspect::Motion ? m_moment.stage.preset.circles.size() : 1;
    return change.arg(numbers.join(QLatin1String(", ")), when).arg(m_moment.step - 1).arg(often)
           + source;
}

std::optional<ValueSolver::Numbers> ValueSolver::offOf(const QString &program) const
{
    const auto made = worldAfter(program, m_moment.stage, m_moment.step);
    if (!made)
        return std::nullopt;
    Numbers off;
    const auto add = [&](Vec2 difference) {
        off.push_back(difference.x);
        off.push_back(difference.y);
    };
    for (std::size_t i = 0; i < made->circles.size(); ++i) {
        const auto &all = m_moment.circles;
        const bool isWrong = std::find(all.begin(), all.end(), static_cast<int>(i)) != all.end();
        const Circle &right = isWrong ? m_right->circles[i] : m_own->circles[i];
        add(made->circles[i].velocity - right.velocity);
        if (m_aspect == Aspect::Motion)
            add((made->circles[i].position - right.position) / m_moment.stage.preset.timestep);
    }
    return off;
}

} // namespace cradle
