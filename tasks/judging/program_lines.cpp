// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/program_lines.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

ProgramLines::ProgramLines(const QString &source)
    : m_source(source)
    , m_tokens(programTokens(source))
    , m_rows(source.split(QLatin1Char('\n')))
{
    qsizetype start = 0;
    for (const QString &row : m_rows) {
        m_starts.push_back(start);
        start += row.size() + 1;
    }
    for (std::size_t i = 0; i < m_tokens.size(); ++i) {
        note(i);
        m_rowTokens[m_tokens[i].line].push_back(i);
    }
}

const std::vector<std::size_t> &ProgramLines::tokensOf(int line) const
{
    static const std::vector<std::size_t> none;
    const auto row = m_rowTokens.find(line);
    return row == m_rowTokens.end() ? none : row->second;
}

void ProgramLines::note(std::size_t i)
{
    const ProgramToken &token = m_tokens[i];
    if (token.kind != ProgramToken::Kind::Name)
        return;
    ++m_names[token.text];
    if (is(i + 1, "."))
        m_owners.insert(token.text);
    const bool field = is(i + 1, ".") && i + 2 < m_tokens.size()
                       && (m_tokens[i + 2].is("position") || m_tokens[i + 2].is("radius")
                           || m_tokens[i + 2].is("velocity"));
    if (field && !is(i - 1, "."))
        m_bodies[token.line].insert(token.text);
    QString timestep;
    if (token.is("on_update") && is(i + 1, "(") && i + 2 < m_tokens.size())
        timestep = m_tokens[i + 2].text;
    if (token.is("dt") || token.is("timestep") || token.is("h"))
        timestep = token.text;
    if (!timestep.isEmpty() && !m_timesteps.contains(timestep))
        m_timesteps.append(timestep);
}

QStringList ProgramLines::bodiesNear(int line) const
{
    QStringList found;
    for (int away = 0; away < 12; ++away) {
        for (const int at : {line - away, line + away}) {
            const auto names = m_bodies.find(at);
            if (names == m_bodies.end())
                continue;
            for (const QString &name : names->second) {
                if (!found.contains(name))
                    found.append(name);
            }
        }
    }
    return found.mid(0, 3);
}

QStringList ProgramLines::countsOfLoops() const
{
    QStringList counts;
    for (std::size_t i = 0; i + 5 < m_tokens.size(); ++i) {
        const ProgramToken &count = m_tokens[i + 5];
        if (is(i, "for") && is(i + 2, "=") && is(i + 4, ",") && !counts.contains(count.text)
            && (count.kind == ProgramToken::Kind::Number || count.kind == ProgramToken::Kind::Name))
            counts.append(count.text);
    }
    return counts;
}

QStringList ProgramLines::forgotten(int line) const
{
    constexpr int near = 12;
    QStringList found;
    for (int at = std::max(1, line - near); at < line; ++at) {
        const std::vector<std::size_t> &row = tokensOf(at);
        if (row.size() > 2 && is(row[0], "local")
            && m_tokens[row[1]].kind == ProgramToken::Kind::Name
            && m_names.value(m_tokens[row[1]].text) == 1)
            found.append(m_tokens[row[1]].text);
    }
    return found;
}

bool ProgramLines::isCall(int line) const
{
    static const QRegularExpression call(QStringLiteral("^\\s*[\\w.:\\[\\]]+\\(.*\\)\\s*$"));
    return row(line).contains(call);
}

bool ProgramLines::isNewName(std::size_t i) const
{
    while (i > 0 && (is(i - 1, ",") || m_tokens[i - 1].kind == ProgramToken::Kind::Name))
        --i;
    return is(i - 1, "local");
}

std::size_t ProgramLines::afterOperand(std::size_t i) const
{
    if (i >= m_tokens.size())
        return i;
    std::size_t at = i;
    if (m_tokens[at].is("("))
        at = afterGroup(at);
    else if (m_tokens[at].endsOperand())
        ++at;
    else
        return i;
    while (at < m_tokens.size()) {
        if ((m_tokens[at].is(".") || m_tokens[at].is(":")) && at + 1 < m_tokens.size())
            at += 2;
        else if ((m_tokens[at].is("(") || m_tokens[at].is("["))
                 && m_tokens[at].line == m_tokens[at - 1].line)
            at = afterGroup(at);
        else
            break;
    }
    return at;
}
std::size_t ProgramLines::afterGroup(std::size_t i) const
{
    int depth = 0;
    for (; i < m_tokens.size(); ++i) {
        if (m_tokens[i].is("(") || m_tokens[i].is("["))
            ++depth;
        if ((m_tokens[i].is(")") || m_tokens[i].is("]")) && --depth == 0)
            return i + 1;
    }
    return i;
}

std::vector<int> ProgramLines::twinsOf(int line) const
{
    constexpr int near = 12;
    std::vector<int> twins;
    const auto own = m_rowTokens.find(line);
    if (own == m_rowTokens.end() || own->second.size() < 4)
        return twins;
    for (auto it = m_rowTokens.lower_bound(line - near);
         it != m_rowTokens.end() && it->first <= line + near; ++it) {
        const bool same =
            std::equal(own->second.begin(), own->second.end(), it->second.begin(), it->second.end(),
                       [&](std::size_t a, std::size_t b) {
                           const ProgramToken &x = m_tokens[a];
                           const ProgramToken &y = m_tokens[b];
                           const bool isName = x.kind == ProgramToken::Kind::Name
                                               || x.kind == ProgramToken::Kind::Number;
                           const bool isSum = (x.is("+") || x.is("-")) && (y.is("+") || y.is("-"));
                           return x.kind == y.kind && (isName || isSum || x.text == y.text);
                       });
        if (same && it->first != line)
            twins.push_back(it->first);
    }
    return twins;
}

std::optional<qsizetype> ProgramLines::placeIn(int line, int twin, qsizetype at) const
{
    const std::vector<std::size_t> &own = tokensOf(line);
    const std::vector<std::size_t> &other = tokensOf(twin);
    for (std::size_t k = 0; k < own.size(); ++k) {
        if (m_tokens[own[k]].start == at)
            return m_tokens[other[k]].start;
        if (m_tokens[own[k]].end() == at)
            return m_tokens[other[k]].end();
    }
    return std::nullopt;
}

QString ProgramLines::inTwin(const QString &text, int line, int twin) const
{
    const std::vector<std::size_t> &own = tokensOf(line);
    const std::vector<std::size_t> &other = tokensOf(twin);
    QString result;
    for (qsizetype at = 0, end = 0; at < text.size(); at = end) {
        end = at + 1;
        if (!isOfName(text[at]) || text[at].isDigit()) {
            result += text[at];
            continue;
        }
        while (end < text.size() && isOfName(text[end]))
            ++end;
        QString name = text.mid(at, end - at);
        for (std::size_t k = 0; k < own.size(); ++k) {
            if (m_tokens[own[k]].text == name) {
                name = m_tokens[other[k]].text;
                break;
            }
        }
        result += name;
    }
    return result;
}

} // namespace cradle
