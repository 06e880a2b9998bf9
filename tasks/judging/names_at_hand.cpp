// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/names_at_hand.h"

#include <QRegularExpression>

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace cradle {

namespace {

/// The fields in which a circle or a table has something, that of a circle first.
QStringList fieldsOf(const ProgramLines &program, const std::vector<ProgramAssignment> &assignments,
                     const QString &field)
{
    QStringList fields{field};
    const QStringList copies = QStringList{field} + copiesOf(program, assignments, {field});
    for (const ProgramAssignment &each : assignments) {
        if (each.isField && isHandedOn(program, each)
            && copies.contains(program.tokens()[each.to - 1].text) && !fields.contains(each.name))
            fields.append(each.name);
    }
    return fields;
}

/// \p owner 's field: the one that is named of it, else the likeliest.
QString fieldOf(const QString &owner, const QStringList &fields, const QStringList &named,
                bool isTable)
{
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const QString &field) {
        return named.contains(owner + QLatin1Char('.') + field);
    });
    const QString &field = found != fields.end()          ? *found
                           : isTable && fields.size() > 1 ? fields[1]
                                                          : fields.front();
    return owner + QLatin1Char('.') + field;
}

/// The names that loops of a function give, c of `for _, c in ipairs(circles)`: of those around
/// \p line, or of all others.
QStringList loopNames(const ProgramLines &program, const ProgramFunction *function, int line,
                      bool isAround)
{
    QStringList names;
    for (std::size_t i = 0; i < program.tokens().size(); ++i) {
        const int own = program.tokens()[i].line;
        if (!program.is(i, "for") || (function && (own < function->first || own > function->last)))
            continue;
        std::size_t at = i + 1;
        QStringList given;
        for (; at < program.tokens().size() && !program.is(at, "in") && !program.is(at, "="); ++at)
            given.append(program.tokens()[at].text);
        while (at < program.tokens().size() && !program.is(at, "do"))
            ++at;
        const std::size_t end = endOfBlock(program, at);
        const int last =
            end < program.tokens().size() ? program.tokens()[end].line : program.count();
        if (isAround == (own <= line && line <= last))
            names += given;
    }
    return names;
}

} // namespace

NamesAtHand::NamesAtHand(const ProgramLines &program,
                         const std::vector<ProgramAssignment> &assignments,
                         const std::vector<ProgramFunction> &functions, int line)
{
    const ProgramFunction *function = functionAt(functions, line);
    const auto isWithin = [&](int at) {
        return !function || (function->first <= at && at <= function->last);
    };
    std::vector<std::size_t> names;
    for (std::size_t i = 0; i < program.tokens().size(); ++i) {
        const ProgramToken &token = program.tokens()[i];
        if (token.kind == ProgramToken::Kind::Name && isWithin(token.line)
            && !program.is(i - 1, "."))
            names.push_back(i);
    }
    m_rebound = program.hasName(QStringLiteral("restitution")) ? QStringLiteral("(1 + restitution)")
                                                               : QStringLiteral("2");
    m_parameters = function ? function->parameters : QStringList{};
    nameCircles(program, assignments, names, function, line);
    // What is named later has no value yet.
    std::erase_if(names, [&](std::size_t i) {
        return program.tokens()[i].line > line
               || (program.tokens()[i].line == line && program.isNewName(i)
                   && !m_parameters.contains(program.tokens()[i].text));
    });
    nameNumbers(program, names);
    static const QRegularExpression normal(QStringLiteral("^(n|normal|dir|direction|unit)$"));
    m_normals = m_parameters.filter(normal);
    for (const ProgramAssignment &each : assignments) {
        if (each.isField || each.line >= line || !isWithin(each.line))
            continue;
        if (each.name.contains(normal) && !m_normals.contains(each.name))
            m_normals.append(each.name);
        for (std::size_t i = each.from; i < each.to; ++i) {
            const bool isRadius =
                program.is(i, "radius") || m_radii.contains(program.tokens()[i].text);
            if (isRadius && !isHandedOn(program, each))
                m_ofRadius.append(each.name);
        }
    }
}

void NamesAtHand::nameCircles(const ProgramLines &program,
                              const std::vector<ProgramAssignment> &assignments,
                              const std::vector<std::size_t> &names,
                              const ProgramFunction *function, int line)
{
    const QStringList positions = fieldsOf(program, assignments, QStringLiteral("position"));
    const QStringList velocities = fieldsOf(program, assignments, QStringLiteral("velocity"));
    const QStringList radii = fieldsOf(program, assignments, QStringLiteral("radius"));
    const QStringList densities = fieldsOf(program, assignments, QStringLiteral("density"));
    const QStringList all = positions + velocities + radii + densities;
    QStringList owners;
    QStringList named;
    for (const std::size_t i : names) {
        const QString &owner = program.tokens()[i].text;
        if (!program.is(i + 1, ".") || !all.contains(program.tokens()[i + 2].text))
            continue;
        named.append(owner + QLatin1Char('.') + program.tokens()[i + 2].text);
        if (!owners.contains(owner))
            owners.append(owner);
    }
    // a and b, p and q: one is a circle, so the other is, too.
    for (const QString &parameter : m_parameters) {
        const bool isPartner = std::any_of(owners.begin(), owners.end(), [&](const QString &owner) {
            return m_parameters.contains(owner) && owner.size() == parameter.size()
                   && owner.chopped(1) == parameter.chopped(1)
                   && std::abs(owner.back().unicode() - parameter.back().unicode()) == 1;
        });
        if (isPartner && !owners.contains(parameter))
            owners.append(parameter);
    }
    // Parameters first, in their order; last, besides two others, who goes through all of them.
    const QStringList gone = loopNames(program, function, line, false);
    const QStringList loops = loopNames(program, function, line, true);
    owners.removeIf([&](const QString &owner) {
        return gone.contains(owner) && !loops.contains(owner) && !m_parameters.contains(owner);
    });
    const auto isLoop = [&](const QString &owner) { return loops.contains(owner); };
    if (owners.size() - std::count_if(owners.begin(), owners.end(), isLoop) > 1)
        std::stable_partition(owners.begin(), owners.end(), std::not_fn(isLoop));
    std::stable_sort(owners.begin(), owners.end(), [&](const QString &a, const QString &b) {
        const auto rank = [&](const QString &owner) {
            const qsizetype at = m_parameters.indexOf(owner);
            return at < 0 ? m_parameters.size() : at;
        };
        return rank(a) < rank(b);
    });
    for (const QString &owner : owners) {
        const auto has = [&](const QStringList &fields) {
            return named.contains(owner + QLatin1Char('.') + fields.front());
        };
        const bool isTable = !has(positions) && !has(velocities) && !has(radii);
        m_circles.push_back(
            {fieldOf(owner, positions, named, isTable), fieldOf(owner, velocities, named, isTable),
             fieldOf(owner, radii, named, isTable), fieldOf(owner, densities, named, isTable)});
    }
}

void NamesAtHand::nameNumbers(const ProgramLines &program, const std::vector<std::size_t> &names)
{
    static const QRegularExpression mass(QStringLiteral("^m(ass)?_?(\\d|[abij]|one|two)?$"),
                                         QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression radius(QStringLiteral("^r(ad|adius)?_?(\\d|[abij])?$"));
    for (const std::size_t i : names) {
        const bool isField = program.is(i + 1, ".") && i + 2 < program.tokens().size();
        const QString &name = program.tokens()[isField ? i + 2 : i].text;
        if (program.is(isField ? i + 3 : i + 1, "("))
            continue;
        const QString whole = isField ? program.tokens()[i].text + QLatin1Char('.') + name : name;
        if (name.contains(mass) && !m_masses.contains(whole))
            m_masses.append(whole);
        if (!isField && name.contains(radius) && !m_radii.contains(whole))
            m_radii.append(whole);
    }
    if (m_masses.size() != 2)
        m_masses.clear();
}

QStringList NamesAtHand::radii() const
{
    QStringList all;
    for (const NamedCircle &circle : m_circles)
        all.append(circle.radius);
    return all + m_radii;
}

std::optional<std::pair<NamedCircle, NamedCircle>> NamesAtHand::pair() const
{
    if (m_circles.size() > 1)
        return std::pair{m_circles[0], m_circles[1]};
    if (!m_circles.empty() || m_parameters.size() > 1)
        return std::nullopt;
    return pairOfScene();
}

std::pair<NamedCircle, NamedCircle> NamesAtHand::pairOfScene()
{
    const auto ofScene = [](int number) {
        const QString owner = QStringLiteral("circles[%1].").arg(number);
        return NamedCircle{owner + QLatin1String("position"), owner + QLatin1String("velocity"),
                           owner + QLatin1String("radius"), owner + QLatin1String("density")};
    };
    return {ofScene(1), ofScene(2)};
}

} // namespace cradle
