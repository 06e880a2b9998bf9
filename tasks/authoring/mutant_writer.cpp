// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/mutant_writer.h"

#include "tasks/script/student_script.h"

namespace cradle {

namespace {

QString commented(const QString &text)
{
    QString comment;
    for (const QString &line : text.split(QLatin1Char('\n')))
        comment += (QStringLiteral("-- ") + line).trimmed() + QLatin1Char('\n');
    return comment;
}

} // namespace

MutantWriter::MutantWriter(const QString &solution)
    : m_source(solution)
    , m_tokens(programTokens(solution))
    , m_lines(solution.split(QLatin1Char('\n')))
{
    findStart();
}

const ProgramToken *MutantWriter::at(std::size_t i) const
{
    return i < m_tokens.size() ? &m_tokens[i] : nullptr;
}

bool MutantWriter::isAt(std::size_t i, const char *word) const
{
    return i < m_tokens.size() && m_tokens[i].is(word);
}

void MutantWriter::findStart()
{
    for (std::size_t i = 0; i + 1 < m_tokens.size(); ++i) {
        if (!m_tokens[i].is("function") || !m_tokens[i + 1].is("on_load"))
            continue;
        m_startFrom = m_tokens[i].line;
        m_startTo = m_startFrom;
        while (m_startTo < static_cast<int>(m_lines.size())
               && !m_lines[m_startTo - 1].startsWith(QLatin1String("end")))
            ++m_startTo;
    }
}

std::size_t MutantWriter::afterOperand(std::size_t i) const
{
    const ProgramToken *first = at(i);
    if (!first || !(first->endsOperand() || first->is("(")) || first->is(")"))
        return i;
    if (!first->is("("))
        ++i;
    while (const ProgramToken *next = at(i)) {
        if (next->is("(") || next->is("[")) {
            i = afterGroup(i);
        } else if (next->is(".") || next->is(":") || next->is("^")) {
            i += 2; // of a program that can be read, a name or an operand follows
        } else {
            break;
        }
    }
    return i;
}

std::size_t MutantWriter::afterGroup(std::size_t i) const
{
    int depth = 0;
    for (; i < m_tokens.size(); ++i) {
        if (m_tokens[i].is("(") || m_tokens[i].is("["))
            ++depth;
        else if ((m_tokens[i].is(")") || m_tokens[i].is("]")) && --depth == 0)
            return i + 1;
    }
    return i;
}

bool MutantWriter::isStatement(int line) const
{
    const ProgramToken *first = nullptr;
    int depth = 0;
    bool acts = false;
    for (const ProgramToken &token : m_tokens) {
        if (token.line != line)
            continue;
        first = first ? first : &token;
        if (token.kind == ProgramToken::Kind::Keyword && !token.is("and") && !token.is("or")
            && !token.is("not") && !token.is("true") && !token.is("false"))
            return false;
        depth += token.is("(") || token.is("{") ? 1 : token.is(")") || token.is("}") ? -1 : 0;
        acts = acts || token.is("=") || token.is("(");
    }
    return first && first->kind == ProgramToken::Kind::Name && depth == 0 && acts;
}

qsizetype MutantWriter::startOf(int line) const
{
    qsizetype start = 0;
    for (int i = 1; i < line; ++i)
        start += m_lines[i - 1].size() + 1;
    return start;
}

void MutantWriter::add(const Mistake &mistake, int line, qsizetype from, qsizetype to,
                       const QString &text)
{
    Mutant mutant;
    const QString program = QString(m_source).replace(from, to - from, text);
    if (program == m_source || findSyntaxError(program))
        return;
    mutant.line = line;
    mutant.name = QStringLiteral("%1-line-%2").arg(QLatin1String(mistake.name)).arg(line);
    for (int n = 2; m_used.contains(mutant.name); ++n)
        mutant.name =
            QStringLiteral("%1-line-%2-%3").arg(QLatin1String(mistake.name)).arg(line).arg(n);
    m_used.insert(mutant.name);
    const QStringList lines = program.split(QLatin1Char('\n'));
    mutant.change = lines.value(line - 1).trimmed();
    mutant.message = mistake.headline + QStringLiteral("\n\n") + mistake.question;
    mutant.source = commented(mutant.message) + QLatin1Char('\n') + program;
    m_mutants.push_back(mutant);
}

} // namespace cradle
