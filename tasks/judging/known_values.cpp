// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/known_values.h"

#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace cradle {

KnownValues::KnownValues(const ProgramLines &program, const Moment &moment,
                         std::function<bool(int)> isSound)
    : m_program(program)
    , m_moment(moment)
    , m_assignments(assignmentsOf(program))
    , m_functions(functionsOf(program))
    , m_isSound(std::move(isSound))
    , m_other(otherThan(moment.stage))
    , m_before(worldAfter(program.source(), moment.stage, moment.step - 1))
    , m_otherBefore(worldAfter(program.source(), m_other, moment.step - 1))
{
}

/// What a value has to be, by its name.
Known KnownValues::kindOf(int line, const TokenRange &value) const
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

bool KnownValues::holds(int line, const std::vector<TokenRange> &values) const
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
                   && worldAfter(knownQuantities(kind, m_moment.step - 1, stage.preset.timestep,
                                                 *before, isStrict)
                                     + source,
                                 stage, m_moment.step);
        };
        return isIn(m_moment.stage, m_before, false) && isIn(m_other, m_otherBefore, false)
               && (isIn(m_other, m_otherBefore, true) || isIn(m_moment.stage, m_before, true));
    });
}

/// Other velocities: what is right in one scene by chance is not in both.
Stage KnownValues::otherThan(const Stage &stage)
{
    Stage other = stage;
    for (PresetCircle &circle : other.preset.circles) {
        const Vec2 v = circle.body.velocity;
        circle.body.velocity = {1.05 * v.x + 0.03, 0.96 * v.y - 0.02};
    }
    return other;
}

} // namespace cradle
