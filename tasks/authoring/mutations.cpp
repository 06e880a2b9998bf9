// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/mutations.h"

#include "tasks/authoring/mutant_writer.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct MutationText {
    Q_DECLARE_TR_FUNCTIONS(Mutations)
};

/// Makes the mutants of one solution.
class Mutator
{
public:
    explicit Mutator(const QString &solution)
        : m_text(solution)
        , m_source(m_text.source())
        , m_tokens(m_text.tokens())
    {
        for (const ProgramToken &token : m_tokens) {
            if (token.kind == ProgramToken::Kind::Name)
                m_names.insert(token.text);
        }
    }

    std::vector<Mutant> make()
    {
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            if (m_text.isInStart(m_tokens[i].line))
                continue;
            turnSign(i);
            dropFactor(i);
            dropParentheses(i);
            dropNormalisation(i);
            turnComparison(i);
            dropCondition(i);
            decideCondition(i);
            exchangeNames(i);
            changeRestitution(i);
        }
        for (int line = 1; line <= static_cast<int>(m_text.lines().size()); ++line)
            changeStatement(line);
        return m_text.take();
    }

private:
    void turnSign(std::size_t i)
    {
        const ProgramToken &sign = m_tokens[i];
        if (!sign.is("+") && !sign.is("-"))
            return;
        const Mistake mistake{"sign", MutationText::tr("A term has the wrong sign"),
                              MutationText::tr("Which way should this term act? Try it with a "
                                               "circle that moves to the right.")};
        const bool binary = i > 0 && m_tokens[i - 1].endsOperand();
        const QString other = !binary        ? QString()
                              : sign.is("+") ? QStringLiteral("-")
                                             : QStringLiteral("+");
        m_text.add(mistake, sign.line, sign.start, sign.end(), other);
    }

    void dropFactor(std::size_t i)
    {
        const ProgramToken &sign = m_tokens[i];
        if (sign.is("*") || sign.is("/") || sign.is("^")) {
            const std::size_t after = m_text.afterOperand(i + 1);
            if (after == i + 1)
                return;
            const qsizetype end = m_tokens[after - 1].end();
            addDropped(m_source.mid(m_tokens[i + 1].start, end - m_tokens[i + 1].start), sign.line,
                       sign.start, end);
            return;
        }
        // The first factor of a product.
        if (i > 0
            && (m_tokens[i - 1].is("*") || m_tokens[i - 1].is("/") || m_tokens[i - 1].is(".")
                || m_tokens[i - 1].is(":")))
            return;
        const std::size_t after = m_text.afterOperand(i);
        if (after > i && m_text.isAt(after, "*") && m_text.at(after + 1))
            addDropped(m_source.mid(sign.start, m_tokens[after - 1].end() - sign.start), sign.line,
                       sign.start, m_tokens[after + 1].start);
    }

    void addDropped(const QString &factor, int line, qsizetype from, qsizetype to)
    {
        m_text.add(
            {"factor", MutationText::tr("The factor `%1` is missing").arg(factor),
             MutationText::tr("Do both sides have the same unit? What changes if this factor is "
                              "twice as large?")},
            line, from, to, {});
    }

    void dropParentheses(std::size_t i)
    {
        if (!m_tokens[i].is("(") || (i > 0 && m_tokens[i - 1].endsOperand()))
            return;
        const std::size_t after = m_text.afterGroup(i);
        const bool product = m_text.isAt(after, "*") || m_text.isAt(after, "/")
                             || (i > 0 && (m_tokens[i - 1].is("*") || m_tokens[i - 1].is("/")));
        if (!product)
            return;
        const qsizetype from = m_tokens[i].start;
        const qsizetype to = m_tokens[after - 1].end();
        m_text.add({"parentheses", MutationText::tr("Something stands in the wrong place"),
                    MutationText::tr("A product comes before a sum: what belongs together here?")},
                   m_tokens[i].line, from, to, m_source.mid(from + 1, to - from - 2));
    }

    void dropNormalisation(std::size_t i)
    {
        if (!m_tokens[i].is(":") || !m_text.isAt(i + 1, "normalized"))
            return;
        const std::size_t after = m_text.afterGroup(i + 2);
        m_text.add({"not-normalised", MutationText::tr("The normal does not have the length 1"),
                    MutationText::tr(
                        "How long is this vector? A part along it is right only if its length "
                        "is 1.")},
                   m_tokens[i].line, m_tokens[i].start, m_tokens[after - 1].end(), {});
    }

    void turnComparison(std::size_t i)
    {
        static const QList<std::pair<const char *, const char *>> pairs{
            {"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}};
        for (const auto &[sign, other] : pairs) {
            if (m_tokens[i].is(sign))
                m_text.add({"comparison", MutationText::tr("A comparison is the wrong way round"),
                            MutationText::tr("When should this happen: above or below?")},
                           m_tokens[i].line, m_tokens[i].start, m_tokens[i].end(),
                           QLatin1String(other));
        }
    }

    /// One side of an "and" or "or".
    void dropCondition(std::size_t i)
    {
        if (!m_tokens[i].is("and") && !m_tokens[i].is("or"))
            return;
        const auto stops = [&](const ProgramToken &token) {
            return token.kind == ProgramToken::Kind::Keyword && !token.is("not");
        };
        std::size_t first = i;
        int depth = 0;
        while (first > 0 && !stops(m_tokens[first - 1])) {
            depth += m_tokens[first - 1].is(")") ? 1 : m_tokens[first - 1].is("(") ? -1 : 0;
            if (depth < 0)
                break;
            --first;
        }
        std::size_t last = i + 1;
        depth = 0;
        while (last < m_tokens.size() && !stops(m_tokens[last])) {
            depth += m_tokens[last].is("(") ? 1 : m_tokens[last].is(")") ? -1 : 0;
            if (depth < 0)
                break;
            ++last;
        }
        const Mistake mistake{"condition", MutationText::tr("A part of a condition is missing"),
                              MutationText::tr("When should this happen, and when not? Think of "
                                               "circles that already move apart, and of every "
                                               "wall.")};
        m_text.add(mistake, m_tokens[i].line, m_tokens[first].start, m_tokens[i + 1].start, {});
        m_text.add(mistake, m_tokens[i].line, m_tokens[i - 1].end(), m_tokens[last - 1].end(), {});
    }

    /// A branch that is never or always taken.
    void decideCondition(std::size_t i)
    {
        if (!m_tokens[i].is("if") && !m_tokens[i].is("elseif"))
            return;
        std::size_t then = i + 1;
        while (then < m_tokens.size() && !m_tokens[then].is("then"))
            ++then;
        if (then >= m_tokens.size())
            return;
        const qsizetype from = m_tokens[i + 1].start;
        const qsizetype to = m_tokens[then - 1].end();
        m_text.add(
            {"never", MutationText::tr("One case is missing"),
             MutationText::tr("Go through the cases one by one: which of them does nothing?")},
            m_tokens[i].line, from, to, QStringLiteral("false"));
        m_text.add({"always", MutationText::tr("It happens always"),
                    MutationText::tr("When should this happen, and when not?")},
                   m_tokens[i].line, from, to, QStringLiteral("true"));
    }

    /// The name that goes with \p name as b goes with a, or circle2 with circle1; empty if none.
    [[nodiscard]] QString partnerOf(const QString &name) const
    {
        static const QList<std::pair<QChar, QChar>> ends{
            {QLatin1Char('a'), QLatin1Char('b')}, {QLatin1Char('b'), QLatin1Char('a')},
            {QLatin1Char('1'), QLatin1Char('2')}, {QLatin1Char('2'), QLatin1Char('1')},
            {QLatin1Char('x'), QLatin1Char('y')}, {QLatin1Char('y'), QLatin1Char('x')}};
        for (const auto &[end, other] : ends) {
            if (!name.endsWith(end))
                continue;
            const QString partner = name.chopped(1) + other;
            if (m_names.contains(partner))
                return partner;
        }
        return {};
    }

    void exchangeNames(std::size_t i)
    {
        const ProgramToken &name = m_tokens[i];
        if (name.kind != ProgramToken::Kind::Name || m_text.isAt(i + 1, "="))
            return;
        const QString partner = partnerOf(name.text);
        if (partner.isEmpty())
            return;
        m_text.add({"exchanged",
                    MutationText::tr("`%1` stands where `%2` belongs").arg(partner, name.text),
                    MutationText::tr("Which circle, and which coordinate, is meant here?")},
                   name.line, name.start, name.end(), partner);
    }

    void changeRestitution(std::size_t i)
    {
        const ProgramToken &name = m_tokens[i];
        if (!name.is("restitution") || m_text.isAt(i + 1, "="))
            return;
        m_text.add(
            {"no-restitution", MutationText::tr("The hit takes nothing"),
             MutationText::tr("Which part of the velocity should become e times what it was?")},
            name.line, name.start, name.end(), QStringLiteral("1"));
        m_text.add({"restitution-twice", MutationText::tr("e counts twice"),
                    MutationText::tr("How fast does it leave, compared with how fast it came?")},
                   name.line, name.start, name.end(), QStringLiteral("restitution ^ 2"));
    }

    void changeStatement(int line)
    {
        if (!m_text.isStatement(line))
            return;
        const qsizetype from = m_text.startOf(line);
        const QString text = m_text.lines()[line - 1];
        m_text.add({"missing", MutationText::tr("Something is left out"),
                    MutationText::tr(
                        "Compare with the instructions what has to be done for every circle in "
                        "every step.")},
                   line, from, from + text.size(), {});
        if (m_text.isInStart(line))
            return;
        m_text.add({"twice", MutationText::tr("Something happens twice"),
                    MutationText::tr("How often does this run in one step?")},
                   line, from, from + text.size(), text + QLatin1Char('\n') + text);
        if (line < static_cast<int>(m_text.lines().size()) && m_text.isStatement(line + 1)) {
            const QString next = m_text.lines()[line];
            m_text.add({"order", MutationText::tr("Two lines stand in the other order"),
                        MutationText::tr(
                            "Which value does the second line need: the one from before or the "
                            "one from after the first?")},
                       line, from, from + text.size() + 1 + next.size(),
                       next + QLatin1Char('\n') + text);
        }
    }

    MutantWriter m_text;
    const QString &m_source;
    const std::vector<ProgramToken> &m_tokens;
    QSet<QString> m_names{};
};

} // namespace

std::vector<Mutant> mutantsOf(const QString &solution)
{
    return Mutator(solution).make();
}

} // namespace cradle
