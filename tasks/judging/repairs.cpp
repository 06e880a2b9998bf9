// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repairs.h"

#include "tasks/judging/repair_list.h"

#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace cradle {

namespace {

constexpr QLatin1String eWord("restitution");

struct Edit {
    qsizetype from;
    qsizetype to;
    QString text;
};

/// Whether the row at \p at compares a value with itself, or with itself and something more, or
/// gives two values to one name.
bool isAbsurd(const QString &source, qsizetype at)
{
    static const QRegularExpression same(QStringLiteral(
        "(?:\\b(?:if|elseif|and|or|not|return)\\b|=|\\() *([\\w.\\[\\]]+)(?: [+-] [\\w.]+)? "
        "?[<>]=? ?\\1(?: [+-] [\\w.]+)? *(?:\\b(?:then|and|or)\\b|\\)|$)"));
    const qsizetype from = QStringView(source).first(at).lastIndexOf(u'\n') + 1;
    const qsizetype to = source.indexOf(QLatin1Char('\n'), at);
    static const QRegularExpression twice(QStringLiteral("\\b(\\w+), *\\1 *="));
    const QString row = source.mid(from, to < 0 ? -1 : to - from);
    // A look for the signs without which nothing matches costs less, and most rows have none.
    const bool compares = row.contains(u'<') || row.contains(u'>');
    return (compares && row.contains(same)) || (row.contains(u',') && row.contains(twice));
}

/// Whether \p text is what was, turned round, or was a part of a question, or its answer, and is
/// nothing.
bool isRoundabout(const QString &was, const QString &text)
{
    static const QRegularExpression part(
        QStringLiteral("^\\s*(?:and|or)\\b|\\b(?:and|or)\\s*$|^\\s*return\\s*$"));
    return (was.isEmpty() && text.trimmed() == QLatin1String("-"))
           || text == QStringLiteral("-(%1)").arg(was) || (text.isEmpty() && was.contains(part));
}

} // namespace

void RepairList::replace(int line, qsizetype from, qsizetype to, const QString &text)
{
    const QString &source = m_program.source();
    if (m_repairs.size() >= m_most || source.mid(from, to - from) == text
        || (!m_rebounds && text.contains(eWord)))
        return;
    QString changed = source;
    changed.replace(from, to - from, text);
    if (isAbsurd(changed, from))
        return;
    const std::size_t before = m_repairs.size();
    add(changed, line, true);
    if (m_repairs.size() > before)
        m_repairs.back().isRoundabout = isRoundabout(source.mid(from, to - from), text);
    replaceInLike(line, from, to, text);
    replaceInTwins(line, from, to, text);
}

void RepairList::replaceInLike(int line, qsizetype from, qsizetype to, const QString &text)
{
    // The innermost bracket around it that stands in the line twice: (a - b) * (a - b).
    const QString &source = m_program.source();
    const qsizetype start = m_program.startOf(line);
    const qsizetype end = start + m_program.row(line).size();
    qsizetype open = std::min(from, source.size() - 1); // it may stand at the very end
    for (int depth = 0; open >= start; --open) {
        depth += source[open] == QLatin1Char(')') && open < from ? 1 : 0;
        if (source[open] == QLatin1Char('(') && depth-- == 0)
            break;
    }
    const qsizetype close = source.indexOf(QLatin1Char(')'), to);
    if (open < start || close < to || close >= end)
        return;
    const QString group = source.mid(open, close + 1 - open);
    const QString other = source.mid(open, from - open) + text + source.mid(to, close + 1 - to);
    QString row = m_program.row(line);
    if (row.count(group) < 2)
        return;
    row.replace(group, other);
    QString changed = source;
    changed.replace(start, end - start, row);
    add(changed, line, true);
}

void RepairList::replaceTelling(int line, qsizetype from, qsizetype to, const QString &text)
{
    const std::size_t before = m_repairs.size();
    replace(line, from, to, text);
    if (m_repairs.size() > before)
        m_repairs.back().told = true;
}

void RepairList::replaceInTwins(int line, qsizetype from, qsizetype to, const QString &text)
{
    if (m_twins.size() >= roomForTwins())
        return;
    std::vector<Edit> edits{{from, to, text}};
    int first = line;
    for (const int twin : m_program.twinsOf(line)) {
        const auto start = m_program.placeIn(line, twin, from);
        const auto end = m_program.placeIn(line, twin, to);
        if (!start || !end)
            continue;
        first = std::min(first, twin);
        edits.push_back({*start, *end, inTwin(text, line, twin, {from, to}, *start)});
    }
    if (edits.size() < 2)
        return;
    std::sort(edits.begin(), edits.end(),
              [](const Edit &a, const Edit &b) { return a.from > b.from; });
    QString changed = m_program.source();
    for (const Edit &edit : edits)
        changed.replace(edit.from, edit.to - edit.from, edit.text);
    add(changed, first, false);
}

QString RepairList::inTwin(const QString &text, int line, int twin, Place place,
                           qsizetype start) const
{
    // What is taken from one is added to the other.
    const QString &source = m_program.source();
    const bool isSign = text == QLatin1String("+") || text == QLatin1String("-");
    if (isSign && source[place.first] != source[start])
        return text == QLatin1String("+") ? QStringLiteral("-") : QStringLiteral("+");
    return m_program.inTwin(text, line, twin);
}

void RepairList::add(const QString &source, int line, bool alone)
{
    if (m_known.contains(source))
        return;
    m_known.insert(source);
    (alone ? m_repairs : m_twins).push_back({source, line, alone});
}

std::vector<Repair> RepairList::take()
{
    // What is the same in several lines is tried at last, but not left out.
    m_repairs.resize(std::min(m_repairs.size(), m_most - m_twins.size()));
    std::move(m_twins.begin(), m_twins.end(), std::back_inserter(m_repairs));
    return std::move(m_repairs);
}

std::vector<Repair> repairsOf(const QString &source, const QString &reference,
                              const std::vector<int> &lines, std::size_t most)
{
    const ProgramLines program(source);
    RepairList repairs(program, source.contains(eWord) || reference.contains(eWord), most);
    repairMirrors(repairs, lines);
    for (const int line : lines)
        repairLikes(repairs, line);
    for (const int line : lines) {
        for (const std::size_t i : program.tokensOf(line)) {
            repairWords(repairs, i);
            repairNames(repairs, i);
            repairTerms(repairs, i);
            repairStatements(repairs, i);
            repairElements(repairs, i);
            repairExchanges(repairs, i);
            repairFactors(repairs, i);
            repairPairs(repairs, i);
        }
        repairOrder(repairs, line);
    }
    // What is missing may be put in at many places: first what is there is changed.
    for (const int line : lines) {
        for (const std::size_t i : program.tokensOf(line)) {
            repairOmissions(repairs, i);
            scaleTerm(repairs, i);
            addCoordinate(repairs, i);
        }
        scaleValue(repairs, line);
        dropLine(repairs, line);
        repairLine(repairs, line);
    }
    // Twice as much of a product is twice as much of each of its factors: the last is worked out.
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        for (const std::size_t i : program.tokensOf(*line))
            repairScales(repairs, i);
    }
    return repairs.take();
}

} // namespace cradle
