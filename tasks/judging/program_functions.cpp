// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_functions.h"

#include <algorithm>

namespace cradle {

std::vector<ProgramFunction> functionsOf(const ProgramLines &program)
{
    const std::vector<ProgramToken> &tokens = program.tokens();
    std::vector<ProgramFunction> functions;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (!program.is(i, "function"))
            continue;
        const std::size_t end = endOfBlock(program, i);
        ProgramFunction function{.first = tokens[i].line,
                                 .last = end < tokens.size() ? tokens[end].line : program.count()};
        std::size_t at = i + 1;
        for (; at < tokens.size() && !program.is(at, "("); ++at)
            function.name = tokens[at].text;
        if (function.name.isEmpty() && i > 1 && program.is(i - 1, "="))
            function.name = tokens[i - 2].text;
        for (; at < tokens.size() && !program.is(at, ")"); ++at) {
            if (tokens[at].kind == ProgramToken::Kind::Name)
                function.parameters.append(tokens[at].text);
        }
        functions.push_back(function);
    }
    return functions;
}

const ProgramFunction *functionAt(const std::vector<ProgramFunction> &functions, int line)
{
    const ProgramFunction *innermost = nullptr;
    for (const ProgramFunction &function : functions) {
        if (function.first <= line && line <= function.last)
            innermost = &function;
    }
    return innermost;
}

bool isOfStart(const std::vector<ProgramFunction> &functions, int line)
{
    const ProgramFunction *function = functionAt(functions, line);
    return !function || function->name == QLatin1String("on_load");
}

std::set<int> deadLines(const ProgramLines &program)
{
    const std::vector<ProgramFunction> functions = functionsOf(program);
    std::set<int> dead;
    for (std::size_t before = dead.size() + 1; before != dead.size();) {
        before = dead.size();
        for (const ProgramFunction &function : functions) {
            const bool isNamed =
                function.name.isEmpty() || function.name == QLatin1String("on_load")
                || function.name == QLatin1String("on_update")
                || std::any_of(program.tokens().begin(), program.tokens().end(),
                               [&](const ProgramToken &token) {
                                   const bool isWithin =
                                       function.first <= token.line && token.line <= function.last;
                                   return token.text == function.name && !isWithin
                                          && !dead.contains(token.line);
                               });
            for (int line = function.first; !isNamed && line <= function.last; ++line)
                dead.insert(line);
        }
    }
    return dead;
}

bool appliesGiven(const ProgramLines &program, int line)
{
    const std::vector<ProgramFunction> functions = functionsOf(program);
    const ProgramFunction *function = functionAt(functions, line);
    bool isAny = false;
    for (const ProgramAssignment &each : assignmentsOf(program)) {
        if (each.line != line)
            continue;
        QStringList names = valuesIn(program, each.from, each.to);
        names.removeAll(each.name); // to which it is added
        bool isWorkedOut = false;
        for (std::size_t i = each.from; i < each.to; ++i)
            isWorkedOut = isWorkedOut || program.is(i, "*") || program.is(i, "/")
                          || program.is(i, "(") || program.is(i, "-");
        if (!function || !each.isField || isWorkedOut || names.size() != 1
            || !function->parameters.contains(names.front()))
            return false;
        isAny = true;
    }
    return isAny;
}

bool opensBlock(const ProgramLines &program, std::size_t i)
{
    return program.is(i, "function") || program.is(i, "if") || program.is(i, "do")
           || program.is(i, "repeat");
}

std::size_t endOfBlock(const ProgramLines &program, std::size_t i)
{
    int depth = 0;
    for (std::size_t at = i; at < program.tokens().size(); ++at) {
        if (opensBlock(program, at))
            ++depth;
        else if ((program.is(at, "end") || program.is(at, "until")) && --depth <= 0)
            return at;
    }
    return program.tokens().size();
}

std::vector<TokenRange> argumentsOf(const ProgramLines &program, std::size_t i)
{
    std::vector<TokenRange> given;
    for (std::size_t from = i + 2; program.is(i + 1, "(") && !program.is(from, ")");) {
        const std::size_t to = afterExpression(program, from);
        if (to == from)
            break;
        given.push_back({from, to});
        if (!program.is(to, ","))
            break;
        from = to + 1;
    }
    return given;
}

} // namespace cradle
