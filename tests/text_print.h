// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/asked_values.h"
#include "tasks/judging/program_rows.h"
#include "tasks/judging/quantities.h"
#include "tasks/judging/repairs.h"

#include <QCryptographicHash>

#include <concepts>

/// Hashes of what is read in a program's text.
namespace cradle::approved {

/// What is tried for values, which takes longest.
inline constexpr std::pair<Aspect, Suspect> valued[] = {{Aspect::Motion, Suspect::Answer},
                                                        {Aspect::Walls, Suspect::Reach},
                                                        {Aspect::Contact, Suspect::Reach},
                                                        {Aspect::Response, Suspect::Answer},
                                                        {Aspect::Response, Suspect::Masses}};
/// A hash of texts and numbers, in turn.
class TextPrint
{
public:
    TextPrint &operator<<(const QString &text)
    {
        m_hash.addData(text.toUtf8() + '\n');
        return *this;
    }
    TextPrint &operator<<(const QStringList &all) { return *this << all.join(QLatin1Char('\t')); }
    template <typename Number>
    TextPrint &operator<<(Number number) requires std::is_arithmetic_v<Number>
    {
        return *this << QString::number(number);
    }
    template <typename Numbers>
    TextPrint &
    operator<<(const Numbers &all) requires std::is_integral_v<typename Numbers::value_type>
    {
        for (const auto each : all)
            *this << each;
        return *this << QStringLiteral(".");
    }
    TextPrint &operator<<(const NamedCircle &c)
    {
        return *this << c.position << c.velocity << c.radius << c.density;
    }
    TextPrint &operator<<(const std::vector<Repair> &all)
    {
        for (const Repair &each : all)
            *this << each.source << each.line << each.alone << each.told << each.isDoubtful;
        return *this << all.size();
    }
    [[nodiscard]] QString text() const
    {
        return QString::fromLatin1(m_hash.result().toHex().left(12));
    }

private:
    QCryptographicHash m_hash{QCryptographicHash::Sha256};
};

inline QString statements(const ProgramLines &program)
{
    TextPrint print;
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    print << program.timesteps() << deadLines(program)
          << copiesOf(program, assignments, {QStringLiteral("radius"), QStringLiteral("density")});
    for (const ProgramAssignment &each : assignments)
        print << each.line << each.name << each.isField << each.target << each.from << each.to
              << each.last << valuesIn(program, each.from, each.to) << isHandedOn(program, each)
              << isNumber(program, each);
    const std::vector<ProgramFunction> functions = functionsOf(program);
    for (const ProgramFunction &each : functions)
        print << each.name << each.parameters << each.first << each.last;
    for (std::size_t i = 0; i < program.tokens().size(); ++i) {
        print << program.afterOperand(i) << afterExpression(program, i) << program.isNewName(i)
              << opensBlock(program, i) << endOfBlock(program, i);
        for (const TokenRange &given : argumentsOf(program, i))
            print << given.from << given.to;
    }
    for (int line = 1; line <= program.count(); ++line)
        print << (functionAt(functions, line) ? functionAt(functions, line)->first : 0)
              << isOfStart(functions, line) << appliesGiven(program, line);
    return print.text();
}

inline QString lines(const ProgramLines &program)
{
    TextPrint print;
    print << program.countsOfLoops();
    const QStringList rows = rowsOf(program.source());
    const AskedValues asked(program);
    for (int line = 1; line <= program.count(); ++line) {
        const QString &row = rows[line - 1];
        const RowRange range = functionOf(rows, line);
        print << program.bodiesNear(line) << program.forgotten(line) << program.isCall(line) << row
              << compares(row) << worksOut(row) << asksForWall(row) << range.first << range.last;
        for (const int twin : program.twinsOf(line))
            print << twin << program.inTwin(row, line, twin)
                  << program.placeIn(line, twin, row.size() / 2).value_or(-1);
        for (const AskedValue &value : asked.of(line))
            print << value.line << value.isReach;
        print << asked.asksReach(line) << asked.valueBehind(line, true)
              << asked.valueBehind(line, false) << asked.isJoined(line);
    }
    return print.text();
}

inline QString quantities(const ProgramLines &program)
{
    TextPrint print;
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const std::vector<ProgramFunction> functions = functionsOf(program);
    for (int line = 1; line <= program.count(); line += 5) {
        const NamesAtHand names(program, assignments, functions, line);
        for (const NamedCircle &circle : names.circles())
            print << circle;
        if (const auto pair = names.pair())
            print << pair->first << pair->second;
        print << names.radii() << names.normals() << names.ofRadius() << names.parameters()
              << names.masses();
        for (const auto &[aspect, suspect] : valued) {
            const Quantities all(names, program.timesteps(), aspect, suspect);
            print << all.all() << all.soundFor(QStringLiteral("radius")) << all.parts()
                  << all.sides(QStringLiteral("d"))
                  << all.completed(QStringLiteral("v"), program.forgotten(line));
        }
    }
    return print.text();
}

/// All that may stand in place of values of all kinds, wherever they stand.
inline QString values(const ProgramLines &program)
{
    constexpr const char *kinds[] = {"radius",  "u < w",   "p:length()", "math.abs(p.x)",
                                     "3.5",     "0",       "i",          "c.density * r ^ 3",
                                     "v",       "mass",    "v.x",        "v:dot(n)",
                                     "c.index", "volume_2"};
    TextPrint print;
    const std::vector<ProgramAssignment> assignments = assignmentsOf(program);
    const std::vector<ProgramFunction> functions = functionsOf(program);
    for (int line = 1; line <= program.count(); ++line) {
        const NamesAtHand names(program, assignments, functions, line);
        print << names.rebound();
        for (const Aspect aspect : {Aspect::Motion, Aspect::Walls, Aspect::Course, Aspect::Contact,
                                    Aspect::Response, Aspect::Start}) {
            for (const Suspect suspect : {Suspect::Answer, Suspect::Masses}) {
                const Quantities all(names, program.timesteps(), aspect, suspect);
                print << all.all() << all.parts();
                for (const char *kind : kinds) {
                    const QString value = QLatin1String(kind);
                    print << all.soundFor(value) << all.sides(value) << all.sidesOfScene(value)
                          << all.completed(value, {QStringLiteral("kept")});
                }
            }
        }
    }
    return print.text();
}

} // namespace cradle::approved
