// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/mending_values.h"

#include <QRegularExpression>

#include <algorithm>
#include <climits>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

using Numbers = std::vector<double>;

/// Of all that is wrong, what may be left: where in a step two touch is known to some degrees.
constexpr double mostLeft = 0.1;
/// Below this nothing is wrong, m/s.
constexpr double leastOff = 1e-6;
/// Values that a line gives; more mend anything.
constexpr std::size_t mostValues = 2;
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

MendingValues::MendingValues(const ProgramLines &program, const QString &reference,
                             const Moment &moment, const RanLines &ran, Aspect aspect,
                             std::function<bool(int)> isSound)
    : m_program(program)
    , m_moment(moment)
    , m_ran(ran)
    , m_aspect(aspect)
    , m_isSound(std::move(isSound))
    , m_assignments(assignmentsOf(m_program))
    , m_functions(functionsOf(m_program))
    , m_other(otherThan(moment.stage))
    , m_right(after(reference, moment.stage, moment.step))
    , m_own(after(m_program.source(), moment.stage, moment.step))
    , m_before(after(m_program.source(), moment.stage, moment.step - 1))
    , m_otherBefore(after(m_program.source(), m_other, moment.step - 1))
{
}

int MendingValues::line() const
{
    // A variable of that name would hide the count of steps.
    if (!m_right || !m_own || m_program.hasName(QStringLiteral("step")))
        return 0;
    const auto off = offOf(m_program.source());
    if (!off || normOf(*off) < leastOff)
        return 0;
    std::vector<std::pair<std::vector<int>, int>> ordered;
    for (const int line : suspects()) {
        std::vector<int> place = placeOf(line, 0);
        place.push_back(INT_MAX); // what it calls is done before it
        ordered.emplace_back(std::move(place), line);
    }
    std::sort(ordered.begin(), ordered.end());
    for (const auto &[place, line] : ordered) {
        const std::vector<TokenRange> values = valuesAt(line);
        if (!values.empty() && values.size() <= mostValues && !isHandingOn(line)
            && !appliesGiven(m_program, line) && mends(values) && !isKnown(line, values))
            return line;
    }
    return 0;
}

/// Where in a step a line runs: its own number, behind those of the lines that call its function.
std::vector<int> MendingValues::placeOf(int line, int depth) const
{
    constexpr int mostDepth = 6;
    const ProgramFunction *function = functionAt(m_functions, line);
    if (!function || function->name.isEmpty() || depth > mostDepth)
        return {line};
    for (const int call : m_ran.now) {
        const auto &row = m_program.tokensOf(call);
        const bool isOutside = call < function->first || call > function->last;
        if (isOutside && std::any_of(row.begin(), row.end(), [&](std::size_t i) {
                return m_program.tokens()[i].text == function->name && m_program.is(i + 1, "(");
            })) {
            std::vector<int> place = placeOf(call, depth + 1);
            place.push_back(line);
            return place;
        }
    }
    return {line};
}

bool MendingValues::knows(int line) const
{
    const std::vector<TokenRange> values = valuesAt(line);
    return m_ran.now.contains(line) && !values.empty() && isKnown(line, values);
}

std::set<int> MendingValues::suspects() const
{
    const std::vector<int> special = m_ran.special();
    std::set<int> lines(special.begin(), special.end());
    if (lines.empty() || m_aspect == Aspect::Motion)
        return m_ran.now;
    std::set<QString> called;
    for (std::size_t before = 0; before != lines.size();) {
        before = lines.size();
        for (const int line : lines) {
            for (const std::size_t i : m_program.tokensOf(line))
                called.insert(m_program.tokens()[i].text);
        }
        for (const ProgramFunction &function : m_functions) {
            for (int line = function.first; called.contains(function.name) && line <= function.last;
                 ++line) {
                if (m_ran.now.contains(line))
                    lines.insert(line);
            }
        }
    }
    return lines;
}

std::vector<TokenRange> MendingValues::valuesAt(int line) const
{
    std::vector<TokenRange> values;
    const auto addList = [&](std::size_t from) {
        while (true) {
            const std::size_t to = afterExpression(m_program, from);
            if (to == from)
                return;
            values.push_back({from, to});
            if (!m_program.is(to, ","))
                return;
            from = to + 1;
        }
    };
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line == line && each.from < each.to)
            values.push_back({each.from, each.to});
    }
    for (const std::size_t i : m_program.tokensOf(line)) {
        if (m_program.is(i, "return"))
            addList(i + 1);
        if (m_program.is(i, "{") && !m_program.is(i + 2, "="))
            addList(i + 1);
    }
    if (m_program.isCall(line)) {
        for (const std::size_t i : m_program.tokensOf(line)) {
            if (m_program.is(i + 1, "(") && values.empty()) {
                for (const TokenRange &given : argumentsOf(m_program, i))
                    values.push_back(given);
            }
        }
    }
    // One within another is changed by it.
    const bool areApart =
        std::adjacent_find(values.begin(), values.end(),
                           [](const auto &a, const auto &b) { return b.from < a.to; })
        == values.end();
    return areApart ? values : std::vector<TokenRange>{};
}

/// What a value has to be, by its name.
Known MendingValues::kindOf(int line, const TokenRange &value) const
{
    static const QRegularExpression normal(
        QStringLiteral("^([nk][xy12]?|n_[xy]|.*normal.*|unit.*)$"),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression reduced(QStringLiteral("^mu$|red(uced)?|eff(ective)?"),
                                            QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression root(QStringLiteral("\\bsqrt\\b|\\^ *(0?\\.5|\\(1 */ *2)"));
    static const QRegularExpression push(QStringLiteral("^j[xyn]?$|impuls|push|kick"),
                                         QRegularExpression::CaseInsensitiveOption);
    const ProgramFunction *function = functionAt(m_functions, line);
    const bool isReturned = m_program.is(value.from - 1, "return") && function;
    const auto isCalled = [&](const QRegularExpression &name) {
        return (isReturned && function->name.contains(name))
               || std::any_of(m_assignments.begin(), m_assignments.end(),
                              [&](const ProgramAssignment &each) {
                                  return each.from == value.from && each.name.contains(name);
                              });
    };
    // A square is one on the way to its root.
    return isCalled(normal)                    ? Known::Normal
           : isCalled(reduced)                 ? Known::Reduced
           : isCalled(push)                    ? Known::Push
           : m_program.source().contains(root) ? Known::Squared
                                               : Known::Any;
}

/// Whether all of the values are, whenever the line is come to at the moment, what is known of the
/// scene.
bool MendingValues::isKnown(int line, const std::vector<TokenRange> &values) const
{
    // A variable of that name would hide the count of steps.
    if (m_program.hasName(QStringLiteral("step")))
        return false;
    const auto isOfKind = [&](Known kind) {
        return std::any_of(values.begin(), values.end(),
                           [&](const auto &value) { return kindOf(line, value) == kind; });
    };
    if (!isOfKind(Known::Normal) && !isOfKind(Known::Reduced) && m_isSound(line))
        return true;
    const ProgramFunction *function = functionAt(m_functions, line);
    return std::all_of(values.begin(), values.end(), [&](const TokenRange &value) {
        const qsizetype from = m_program.tokens()[value.from].start;
        const qsizetype to = m_program.tokens()[value.to - 1].end();
        const bool isReturned = m_program.is(value.from - 1, "return") && function;
        QStringList given = isReturned ? function->parameters : QStringList{};
        given += {QStringLiteral("nil"), QStringLiteral("nil")};
        if (given.size() > 4)
            given = QStringList{QStringLiteral("nil"), QStringLiteral("nil")};
        QString source = m_program.source();
        source.replace(from, to - from,
                       QStringLiteral("known(%1, %2, %3)")
                           .arg(given[0], given[1], source.mid(from, to - from)));
        const Known kind = kindOf(line, value);
        const auto isIn = [&](const Stage &stage, const std::optional<World> &before,
                              bool isStrict) {
            return before
                   && after(knownQuantities(kind, m_moment.step - 1, stage.preset.timestep, *before,
                                            isStrict)
                                + source,
                            stage, m_moment.step);
        };
        return isIn(m_moment.stage, m_before, false) && isIn(m_other, m_otherBefore, false)
               && (isIn(m_other, m_otherBefore, true) || isIn(m_moment.stage, m_before, true));
    });
}

/// Other velocities: what is right in one scene by chance is not in both.
Stage MendingValues::otherThan(const Stage &stage)
{
    Stage other = stage;
    for (PresetCircle &circle : other.preset.circles) {
        const Vec2 v = circle.body.velocity;
        circle.body.velocity = {1.05 * v.x + 0.03, 0.96 * v.y - 0.02};
    }
    return other;
}

bool MendingValues::isHandingOn(int line) const
{
    bool isAny = false;
    for (const ProgramAssignment &each : m_assignments) {
        if (each.line == line && !isHandedOn(m_program, each))
            return false;
        isAny = isAny || each.line == line;
    }
    return isAny;
}

bool MendingValues::mends(const std::vector<TokenRange> &values) const
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

QString MendingValues::changed(const std::vector<TokenRange> &values, const Numbers &by) const
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

std::optional<MendingValues::Numbers> MendingValues::offOf(const QString &program) const
{
    const auto made = after(program, m_moment.stage, m_moment.step);
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

std::optional<World> MendingValues::after(const QString &program, const Stage &stage, qint64 steps)
{
    Probe probe(&program, stage, true);
    for (qint64 k = 0; k < steps; ++k) {
        if (!probe.step())
            return std::nullopt;
    }
    return probe.runs() ? std::optional(probe.world()) : std::nullopt;
}

} // namespace cradle
