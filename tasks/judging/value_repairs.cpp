// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/value_repairs.h"

#include "tasks/judging/quantities.h"
#include "tasks/judging/repair_list.h"

#include <QRegularExpression>

#include <algorithm>
#include <set>

namespace cradle {

namespace {

/// Of one program; more are of many values that have nothing to do with the fault.
constexpr std::size_t mostValueRepairs = 300;

/// Tokens \p from to \p to without \p to.
struct Value {
    std::size_t from;
    std::size_t to;
    bool isSide = false; ///< of a question
};

/// The first token of the sum that ends before \p end, in a question.
std::size_t sumStart(const ProgramLines &program, std::size_t end)
{
    std::size_t at = end;
    int depth = 0;
    while (at > 0) {
        const ProgramToken &token = program.tokens()[at - 1];
        if (depth == 0
            && (token.kind == ProgramToken::Kind::Keyword || token.is("(") || token.is(",")
                || token.is("=")))
            break;
        depth += token.is(")") || token.is("]") ? 1 : token.is("(") || token.is("[") ? -1 : 0;
        --at;
    }
    return at;
}

/// The token after the sum that begins at \p i.
std::size_t afterSum(const ProgramLines &program, std::size_t i)
{
    std::size_t at = program.afterOperand(program.is(i, "-") ? i + 1 : i);
    while (program.is(at, "+") || program.is(at, "-") || program.is(at, "*") || program.is(at, "/")
           || program.is(at, "^")) {
        const std::size_t next = program.afterOperand(at + 1);
        if (next == at + 1)
            break;
        at = next;
    }
    return at;
}

/// Whether the function in which \p line stands is called twice in a line: x and y, or squares of
/// this and that. What it returns is no quantity, unless a mass.
bool isOfSeveral(const RepairList &repairs, int line)
{
    const ProgramFunction *function = functionAt(repairs.functions(), line);
    if (!function || function->name.isEmpty())
        return false;
    const ProgramLines &program = repairs.program();
    int called = 0;
    int before = 0;
    for (std::size_t i = 0; i < program.tokens().size(); ++i) {
        const ProgramToken &token = program.tokens()[i];
        if (token.text != function->name || !program.is(i + 1, "("))
            continue;
        called = token.line == before ? called + 1 : 1;
        before = token.line;
        if (called == 2)
            return true;
    }
    return false;
}

/// What line \p line gives, returns, hands on to a function or compares.
std::vector<Value> valuesAt(const RepairList &repairs, int line, Aspect aspect)
{
    const ProgramLines &program = repairs.program();
    std::vector<Value> values;
    const auto addList = [&](std::size_t from) {
        while (true) {
            const std::size_t to = afterExpression(program, from);
            if (to == from)
                return;
            values.push_back({from, to, false});
            if (!program.is(to, ","))
                return;
            from = to + 1;
        }
    };
    for (const ProgramAssignment &each : repairs.assignments()) {
        if (each.line == line && each.from < each.to)
            values.push_back({each.from, each.to, false});
    }
    for (const std::size_t i : program.tokensOf(line)) {
        const bool calls =
            program.is(i, "(") && i > 0 && program.tokens()[i - 1].kind == ProgramToken::Kind::Name
            && (aspect == Aspect::Walls || aspect == Aspect::Motion
                || std::any_of(repairs.functions().begin(), repairs.functions().end(),
                               [&](const ProgramFunction &function) {
                                   return function.name == program.tokens()[i - 1].text;
                               }));
        const bool compares =
            program.is(i, "<") || program.is(i, ">") || program.is(i, "<=") || program.is(i, ">=");
        if (compares && aspect == Aspect::Contact) {
            for (const Value &side : {Value{sumStart(program, i), i, true},
                                      Value{i + 1, afterSum(program, i + 1), true}}) {
                if (side.from < side.to)
                    values.push_back(side);
            }
        }
        if (program.is(i, "return") || calls)
            addList(i + 1);
    }
    return values;
}

/// Whether a value is a difference of what has names, with nothing worked out.
bool isDifference(const QString &text)
{
    static const QRegularExpression plain(QStringLiteral("^[\\w.\\s\\[\\]]+-[\\w.\\s\\[\\]]+$"));
    return text.contains(plain);
}

/// Whether a value may be one that the fault is about: a motion needs numbers and gravity, a mass
/// is worked out.
bool isSuspicious(const ProgramLines &program, const Value &value, Aspect aspect, Suspect suspect,
                  ValueChange change)
{
    const auto any = [&](const auto &fits) {
        for (std::size_t i = value.from; i < value.to; ++i) {
            if (fits(program.tokens()[i]))
                return true;
        }
        return false;
    };
    if (aspect == Aspect::Motion)
        return any([&](const ProgramToken &token) {
            return token.kind == ProgramToken::Kind::Number || token.is("gravity")
                   || (change == ValueChange::Completed && (token.is("velocity") || token.is("v")));
        });
    // A length that a wall turns at is worked out of places and radii.
    if (aspect == Aspect::Walls || aspect == Aspect::Course)
        return !any([](const ProgramToken &token) {
            return token.is("density") || token.is("mass") || token.is("pi");
        });
    // What is a mass at last may lack something, too.
    if (suspect == Suspect::Masses && program.is(value.from - 1, "return"))
        return true;
    if (suspect == Suspect::Masses)
        return any([](const ProgramToken &token) {
            return token.is("*") || token.is("/") || token.is("^") || token.is("density");
        });
    return true;
}

/// The program, which stops as soon as the value is none of \p quantities.
QString stopping(const QString &source, qsizetype from, qsizetype to, const QStringList &quantities)
{
    static const QString watch = QStringLiteral(
        "local other_quantity = {} local function is_quantity(v, ...) local any = false "
        "for k, q in ipairs({...}) do local near = type(v) == type(q) and "
        "(type(v) == 'number' and math.abs(v - q) <= 1e-9 * (1 + math.abs(q)) or "
        "type(v) == 'vector' and (v - q):length() <= 1e-9 and q:length() > 0) "
        "if not near then other_quantity[k] = true end any = any or not other_quantity[k] end "
        "if not any then error('') end return v end ");
    QString changed = source;
    changed.replace(from, to - from,
                    QStringLiteral("is_quantity(%1, %2)")
                        .arg(source.mid(from, to - from), quantities.join(QLatin1String(", "))));
    return watch + changed;
}

/// Other velocities: what is right in one scene by chance is not in both.
Stage varied(const Stage &stage)
{
    Stage other = stage;
    for (PresetCircle &circle : other.preset.circles) {
        const Vec2 v = circle.body.velocity;
        circle.body.velocity = {1.05 * v.x + 0.03, 0.96 * v.y - 0.02};
    }
    return other;
}

bool reaches(const QString &program, const Moment &moment, const Stage &stage)
{
    Probe probe(&program, stage, true);
    for (qint64 k = 0; k < moment.step; ++k) {
        if (!probe.step())
            return false;
    }
    return probe.runs();
}

} // namespace

bool SoundValues::has(qsizetype from, qsizetype to, const QStringList &quantities)
{
    if (quantities.isEmpty())
        return false;
    const QString program = stopping(m_source, from, to, quantities);
    const auto known = m_known.constFind(program);
    return known != m_known.cend()
               ? *known
               : *m_known.insert(program,
                                 reaches(program, m_moment, m_moment.stage)
                                     && reaches(program, m_moment, varied(m_moment.stage)));
}

const NamesAtHand &SoundValues::namesAt(int line)
{
    const auto known = m_names.find(line);
    return known != m_names.end()
               ? known->second
               : m_names.emplace(line, NamesAtHand(m_program, m_assignments, m_functions, line))
                     .first->second;
}

std::set<int> soundLines(SoundValues &sound, const std::vector<int> &lines, Aspect aspect,
                         Suspect suspect)
{
    const ProgramLines &program = sound.program();
    const RepairList repairs(program, true, 0);
    std::set<int> found;
    for (const int line : lines) {
        std::vector<Value> values = valuesAt(repairs, line, aspect);
        // Whom a function is given is no quantity.
        std::erase_if(values, [&](const Value &value) {
            return value.from + 1 == value.to && program.isOwner(program.tokens()[value.from].text);
        });
        const Quantities quantities(sound.namesAt(line), program.timesteps(), aspect, suspect);
        const bool isRight = std::all_of(values.begin(), values.end(), [&](const Value &value) {
            const qsizetype from = program.tokens()[value.from].start;
            const qsizetype to = program.tokens()[value.to - 1].end();
            const QString text = program.source().mid(from, to - from);
            if (text == QLatin1String("restitution") || text == QLatin1String("1 + restitution"))
                return true;
            const bool isPart = isDifference(text);
            return sound.has(from, to,
                             quantities.soundFor(text)
                                 + (isPart ? quantities.parts() : QStringList{}));
        });
        if (!values.empty() && isRight)
            found.insert(line);
    }
    return found;
}

std::vector<Repair> valueRepairsOf(SoundValues &sound, const std::vector<int> &lines, Aspect aspect,
                                   Suspect suspect, const std::set<int> &now, ValueChange change)
{
    const ProgramLines &program = sound.program();
    const QString &source = program.source();
    RepairList repairs(program, true, mostValueRepairs);
    const std::set<int> inOrder(lines.begin(), lines.end());
    std::vector<int> order(inOrder.begin(), inOrder.end());
    if (suspect == Suspect::Masses)
        std::reverse(order.begin(), order.end());
    // What runs at the moment before what was worked out at the start.
    std::stable_partition(order.begin(), order.end(), [&](int line) {
        return suspect == Suspect::Masses || now.contains(line);
    });
    for (const int line : order) {
        const std::vector<Value> values = valuesAt(repairs, line, aspect);
        if (values.empty())
            continue;
        const Quantities quantities(sound.namesAt(line), program.timesteps(), aspect, suspect);
        for (const Value &value : values) {
            const qsizetype from = program.tokens()[value.from].start;
            const qsizetype to = program.tokens()[value.to - 1].end();
            const QString text = source.mid(from, to - from);
            const QStringList &parts = quantities.parts();
            // Whose radius it is is another question.
            static const QRegularExpression radius(QStringLiteral("^\\w+\\.radius$"));
            if (aspect == Aspect::Contact && !value.isSide && text.contains(radius))
                continue;
            if (suspect != Suspect::Masses && program.is(value.from - 1, "return")
                && isOfSeveral(repairs, line))
                continue;
            if (!isSuspicious(program, value, aspect, suspect, change)
                || sound.has(from, to,
                             quantities.soundFor(text)
                                 + (isDifference(text) ? parts : QStringList{})))
                continue;
            const QStringList others =
                change == ValueChange::Completed
                    ? quantities.completed(text, program.forgotten(line))
                : change == ValueChange::OfScene
                    ? (value.isSide ? quantities.sidesOfScene(text) : QStringList{})
                : value.isSide ? quantities.sides(text)
                               : quantities.all();
            for (const QString &other : others)
                repairs.replace(line, from, to, other);
        }
    }
    return repairs.take();
}

} // namespace cradle
