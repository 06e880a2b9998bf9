// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/mutations.h"

#include "tasks/authoring/lua_tokens.h"
#include "tasks/script/student_script.h"

#include <QCoreApplication>
#include <QSet>

#include <algorithm>

namespace cradle {

namespace {

struct MutationText {
    Q_DECLARE_TR_FUNCTIONS(Mutations)
};

/// What kind of mistake it is, and what a student is asked who made it.
struct Mistake {
    const char *name; ///< begins the name of the file
    QString headline;
    QString question;
};

/// Makes the mutants of one solution.
class Mutator
{
public:
    explicit Mutator(const QString &solution)
        : m_source(solution)
        , m_tokens(programTokens(solution))
        , m_lines(solution.split(QLatin1Char('\n')))
    {
        for (const ProgramToken &token : m_tokens) {
            if (token.kind == ProgramToken::Kind::Name)
                m_names.insert(token.text);
        }
    }

    std::vector<Mutant> make()
    {
        findStart();
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            if (isInStart(m_tokens[i].line))
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
        for (int line = 1; line <= static_cast<int>(m_lines.size()); ++line)
            changeStatement(line);
        return std::move(m_mutants);
    }

private:
    [[nodiscard]] const ProgramToken *at(std::size_t i) const
    {
        return i < m_tokens.size() ? &m_tokens[i] : nullptr;
    }
    [[nodiscard]] bool isAt(std::size_t i, const char *word) const
    {
        return i < m_tokens.size() && m_tokens[i].is(word);
    }

    /// The lines of on_load: what stands there are the values of the scene.
    void findStart()
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
    [[nodiscard]] bool isInStart(int line) const
    {
        return line >= m_startFrom && line <= m_startTo;
    }

    /// Keeps the program in which the letters from \p from up to \p to became \p text, if it can be
    /// read.
    void add(const Mistake &mistake, int line, qsizetype from, qsizetype to, const QString &text)
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

    static QString commented(const QString &text)
    {
        QString comment;
        for (const QString &line : text.split(QLatin1Char('\n')))
            comment += (QStringLiteral("-- ") + line).trimmed() + QLatin1Char('\n');
        return comment;
    }

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
        add(mistake, sign.line, sign.start, sign.end(), other);
    }

    /// The token after the operand that begins at \p i: a name with its fields and calls, a number
    /// or a group in parentheses.
    [[nodiscard]] std::size_t afterOperand(std::size_t i) const
    {
        const ProgramToken *first = at(i);
        if (!first || !(first->endsOperand() || first->is("(")) || first->is(")"))
            return i;
        if (!first->is("("))
            ++i;
        while (const ProgramToken *next = at(i)) {
            if (next->is("(") || next->is("[")) {
                i = afterGroup(i);
            } else if ((next->is(".") || next->is(":")) && at(i + 1)) {
                i += 2;
            } else if (next->is("^") && at(i + 1)) {
                i += 2;
            } else {
                break;
            }
        }
        return i;
    }

    /// The token after the parenthesis or bracket that closes the one at \p i.
    [[nodiscard]] std::size_t afterGroup(std::size_t i) const
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

    void dropFactor(std::size_t i)
    {
        const ProgramToken &sign = m_tokens[i];
        if (sign.is("*") || sign.is("/") || sign.is("^")) {
            const std::size_t after = afterOperand(i + 1);
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
        const std::size_t after = afterOperand(i);
        if (after > i && isAt(after, "*") && at(after + 1))
            addDropped(m_source.mid(sign.start, m_tokens[after - 1].end() - sign.start), sign.line,
                       sign.start, m_tokens[after + 1].start);
    }

    void addDropped(const QString &factor, int line, qsizetype from, qsizetype to)
    {
        add({"factor", MutationText::tr("The factor `%1` is missing").arg(factor),
             MutationText::tr("Do both sides have the same unit? What changes if this factor is "
                              "twice as large?")},
            line, from, to, {});
    }

    void dropParentheses(std::size_t i)
    {
        if (!m_tokens[i].is("(") || (i > 0 && m_tokens[i - 1].endsOperand()))
            return;
        const std::size_t after = afterGroup(i);
        const bool product = isAt(after, "*") || isAt(after, "/")
                             || (i > 0 && (m_tokens[i - 1].is("*") || m_tokens[i - 1].is("/")));
        if (!product)
            return;
        const qsizetype from = m_tokens[i].start;
        const qsizetype to = m_tokens[after - 1].end();
        add({"parentheses", MutationText::tr("Something stands in the wrong place"),
             MutationText::tr("A product comes before a sum: what belongs together here?")},
            m_tokens[i].line, from, to, m_source.mid(from + 1, to - from - 2));
    }

    void dropNormalisation(std::size_t i)
    {
        if (!m_tokens[i].is(":") || !isAt(i + 1, "normalized"))
            return;
        const std::size_t after = afterGroup(i + 2);
        add({"not-normalised", MutationText::tr("The normal does not have the length 1"),
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
                add({"comparison", MutationText::tr("A comparison is the wrong way round"),
                     MutationText::tr("When should this happen: above or below?")},
                    m_tokens[i].line, m_tokens[i].start, m_tokens[i].end(), QLatin1String(other));
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
        add(mistake, m_tokens[i].line, m_tokens[first].start, m_tokens[i + 1].start, {});
        add(mistake, m_tokens[i].line, m_tokens[i - 1].end(), m_tokens[last - 1].end(), {});
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
        add({"never", MutationText::tr("One case is missing"),
             MutationText::tr("Go through the cases one by one: which of them does nothing?")},
            m_tokens[i].line, from, to, QStringLiteral("false"));
        add({"always", MutationText::tr("It happens always"),
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
        if (name.kind != ProgramToken::Kind::Name || isAt(i + 1, "="))
            return;
        const QString partner = partnerOf(name.text);
        if (partner.isEmpty())
            return;
        add({"exchanged",
             MutationText::tr("`%1` stands where `%2` belongs").arg(partner, name.text),
             MutationText::tr("Which circle, and which coordinate, is meant here?")},
            name.line, name.start, name.end(), partner);
    }

    void changeRestitution(std::size_t i)
    {
        const ProgramToken &name = m_tokens[i];
        if (!name.is("restitution") || isAt(i + 1, "="))
            return;
        add({"no-restitution", MutationText::tr("The hit takes nothing"),
             MutationText::tr("Which part of the velocity should become e times what it was?")},
            name.line, name.start, name.end(), QStringLiteral("1"));
        add({"restitution-twice", MutationText::tr("e counts twice"),
             MutationText::tr("How fast does it leave, compared with how fast it came?")},
            name.line, name.start, name.end(), QStringLiteral("restitution ^ 2"));
    }

    /// Whether a line is one whole statement that assigns or calls.
    [[nodiscard]] bool isStatement(int line) const
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

    [[nodiscard]] qsizetype startOf(int line) const
    {
        qsizetype start = 0;
        for (int i = 1; i < line; ++i)
            start += m_lines[i - 1].size() + 1;
        return start;
    }

    void changeStatement(int line)
    {
        if (!isStatement(line))
            return;
        const qsizetype from = startOf(line);
        const QString text = m_lines[line - 1];
        add({"missing", MutationText::tr("Something is left out"),
             MutationText::tr(
                 "Compare with the instructions what has to be done for every circle in "
                 "every step.")},
            line, from, from + text.size(), {});
        if (isInStart(line))
            return;
        add({"twice", MutationText::tr("Something happens twice"),
             MutationText::tr("How often does this run in one step?")},
            line, from, from + text.size(), text + QLatin1Char('\n') + text);
        if (line < static_cast<int>(m_lines.size()) && isStatement(line + 1)) {
            const QString next = m_lines[line];
            add({"order", MutationText::tr("Two lines stand in the other order"),
                 MutationText::tr(
                     "Which value does the second line need: the one from before or the "
                     "one from after the first?")},
                line, from, from + text.size() + 1 + next.size(), next + QLatin1Char('\n') + text);
        }
    }

    const QString &m_source;
    std::vector<ProgramToken> m_tokens;
    QStringList m_lines;
    QSet<QString> m_names{};
    QSet<QString> m_used{};
    int m_startFrom = 0; ///< lines of on_load
    int m_startTo = -1;
    std::vector<Mutant> m_mutants{};
};

} // namespace

std::vector<Mutant> mutantsOf(const QString &solution)
{
    return Mutator(solution).make();
}

} // namespace cradle
