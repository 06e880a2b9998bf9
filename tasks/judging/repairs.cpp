// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/repairs.h"

#include "tasks/script/program_tokens.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QStringList>

#include <algorithm>
#include <map>
#include <optional>

namespace cradle {

namespace {

constexpr std::size_t mostRepairs = 900;

/// Undoes, token by token, what students get wrong.
class Repairer
{
public:
    Repairer(const QString &source, const std::set<int> &lines)
        : m_source(source)
        , m_lines(lines)
        , m_tokens(programTokens(source))
        , m_rows(source.split(QLatin1Char('\n')))
    {
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            note(i);
            m_rowTokens[m_tokens[i].line].push_back(i);
        }
    }

    std::vector<Repair> make()
    {
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            if (!m_lines.contains(m_tokens[i].line))
                continue;
            changeNumber(i);
            changeSign(i);
            exchangeName(i);
            dropOperand(i);
            addFactor(i);
            addRadius(i);
            changeCondition(i);
            changeLength(i);
            addDensity(i);
        }
        for (const int line : m_lines)
            changeStatement(line);
        return std::move(m_repairs);
    }

private:
    /// What names there are, and which of them are circles and timesteps.
    void note(std::size_t i)
    {
        const ProgramToken &token = m_tokens[i];
        if (token.kind != ProgramToken::Kind::Name)
            return;
        m_names.insert(token.text);
        const bool field = is(i + 1, ".") && i + 2 < m_tokens.size()
                           && (m_tokens[i + 2].is("position") || m_tokens[i + 2].is("radius")
                               || m_tokens[i + 2].is("velocity"));
        if (field && !(i > 0 && m_tokens[i - 1].is(".")))
            m_bodies[token.line].insert(token.text);
        if (token.is("on_update") && is(i + 1, "(") && i + 2 < m_tokens.size())
            m_timesteps.insert(m_tokens[i + 2].text);
        if (token.text == QLatin1String("dt") || token.text == QLatin1String("timestep")
            || token.text == QLatin1String("h"))
            m_timesteps.insert(token.text);
    }

    [[nodiscard]] bool is(std::size_t i, const char *word) const
    {
        return i < m_tokens.size() && m_tokens[i].is(word);
    }

    void replace(int line, qsizetype from, qsizetype to, const QString &text)
    {
        if (m_repairs.size() >= mostRepairs || m_source.mid(from, to - from) == text)
            return;
        QString changed = m_source;
        changed.replace(from, to - from, text);
        m_repairs.push_back({changed, line, true});
        replaceInTwins(line, from, to, text);
    }

    /// The same change in all lines that say the same of another circle, wall or part.
    void replaceInTwins(int line, qsizetype from, qsizetype to, const QString &text)
    {
        std::vector<Edit> edits{{from, to, text}};
        for (const int twin : twinsOf(line)) {
            const auto start = placeIn(line, twin, from);
            const auto end = placeIn(line, twin, to);
            if (start && end)
                edits.push_back({*start, *end, inTwin(text, line, twin)});
        }
        if (edits.size() < 2)
            return;
        std::sort(edits.begin(), edits.end(),
                  [](const Edit &a, const Edit &b) { return a.from > b.from; });
        QString changed = m_source;
        for (const Edit &edit : edits)
            changed.replace(edit.from, edit.to - edit.from, edit.text);
        m_repairs.push_back({changed, line, false});
    }

    /// Lines near \p line with the same tokens but for names, numbers and signs of order.
    [[nodiscard]] std::vector<int> twinsOf(int line) const
    {
        constexpr int near = 12;
        std::vector<int> twins;
        const auto own = m_rowTokens.find(line);
        if (own == m_rowTokens.end() || own->second.size() < 4)
            return twins;
        for (auto it = m_rowTokens.lower_bound(line - near);
             it != m_rowTokens.end() && it->first <= line + near; ++it) {
            const bool same =
                std::equal(own->second.begin(), own->second.end(), it->second.begin(),
                           it->second.end(), [&](std::size_t a, std::size_t b) {
                               const ProgramToken &x = m_tokens[a];
                               const ProgramToken &y = m_tokens[b];
                               const bool isName = x.kind == ProgramToken::Kind::Name
                                                   || x.kind == ProgramToken::Kind::Number;
                               return x.kind == y.kind && (isName || x.text == y.text);
                           });
            if (same && it->first != line)
                twins.push_back(it->first);
        }
        return twins;
    }

    /// The place in \p twin that \p at is in \p line; nothing if it is within a token.
    [[nodiscard]] std::optional<qsizetype> placeIn(int line, int twin, qsizetype at) const
    {
        const std::vector<std::size_t> &own = m_rowTokens.at(line);
        const std::vector<std::size_t> &other = m_rowTokens.at(twin);
        for (std::size_t k = 0; k < own.size(); ++k) {
            if (m_tokens[own[k]].start == at)
                return m_tokens[other[k]].start;
            if (m_tokens[own[k]].end() == at)
                return m_tokens[other[k]].end();
        }
        return std::nullopt;
    }

    /// \p text with the names of \p twin in place of those of \p line.
    [[nodiscard]] QString inTwin(QString text, int line, int twin) const
    {
        const std::vector<std::size_t> &own = m_rowTokens.at(line);
        const std::vector<std::size_t> &other = m_rowTokens.at(twin);
        static const QRegularExpression word(QStringLiteral("[A-Za-z_]\\w*"));
        QString result;
        qsizetype done = 0;
        for (auto it = word.globalMatch(text); it.hasNext();) {
            const QRegularExpressionMatch match = it.next();
            QString name = match.captured();
            for (std::size_t k = 0; k < own.size(); ++k) {
                if (m_tokens[own[k]].text == name) {
                    name = m_tokens[other[k]].text;
                    break;
                }
            }
            result += text.mid(done, match.capturedStart() - done) + name;
            done = match.capturedEnd();
        }
        return result + text.mid(done);
    }
    void replace(const ProgramToken &token, const QString &text)
    {
        replace(token.line, token.start, token.end(), text);
    }
    void insert(const ProgramToken &token, const QString &text)
    {
        replace(token.line, token.end(), token.end(), text);
    }

    /// Circles that are named near a line: in it, or in the lines around.
    [[nodiscard]] QStringList bodiesNear(int line) const
    {
        QStringList found;
        for (int away = 0; away < 12 && found.size() < 3; ++away) {
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

    void changeNumber(std::size_t i)
    {
        const ProgramToken &number = m_tokens[i];
        if (number.kind != ProgramToken::Kind::Number)
            return;
        QStringList others{QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("0.5"),
                           QStringLiteral("restitution")};
        if (number.text == QLatin1String("2"))
            others.append(QStringLiteral("(1 + restitution)"));
        if (i > 0 && m_tokens[i - 1].is("^"))
            others = {QStringLiteral("1"), QStringLiteral("2"), QStringLiteral("3")};
        for (const QString &other : others)
            replace(number, other);
        for (const QString &body : bodiesNear(number.line))
            replace(number, body + QStringLiteral(".radius"));
        // 1 / 60
        const std::size_t last = is(i + 1, "/") && i + 2 < m_tokens.size() ? i + 2 : i;
        for (const QString &timestep : m_timesteps)
            replace(number.line, number.start, m_tokens[last].end(), timestep);
        if (number.text.startsWith(QLatin1String("9.8")) && i > 0 && m_tokens[i - 1].is("-"))
            replace(number.line, m_tokens[i - 1].start, number.end(), QStringLiteral("gravity.y"));
    }

    void changeSign(std::size_t i)
    {
        static const QList<std::pair<const char *, const char *>> pairs{
            {"+", "-"}, {"-", "+"}, {"*", "/"},   {"/", "*"},
            {"<", ">"}, {">", "<"}, {"<=", ">="}, {">=", "<="}};
        const ProgramToken &sign = m_tokens[i];
        const bool binary = i > 0 && m_tokens[i - 1].endsOperand();
        for (const auto &[from, to] : pairs) {
            if (sign.is(from) && (binary || !sign.is("-")))
                replace(sign, QLatin1String(to));
        }
        if (sign.is("-") && !binary)
            replace(sign, {});
        // A minus in front of what is given to a velocity or a function.
        const bool begins = is(i, "=") || is(i, "(") || is(i, ",");
        if (begins && i + 1 < m_tokens.size() && !m_tokens[i + 1].is(")"))
            insert(sign, QStringLiteral(" -"));
    }

    /// circle2 for circle1, b for a, y for x.
    void exchangeName(std::size_t i)
    {
        const ProgramToken &name = m_tokens[i];
        if (name.kind != ProgramToken::Kind::Name)
            return;
        static const QList<std::pair<QChar, QChar>> ends{{QLatin1Char('a'), QLatin1Char('b')},
                                                         {QLatin1Char('1'), QLatin1Char('2')},
                                                         {QLatin1Char('x'), QLatin1Char('y')}};
        for (const auto &[one, two] : ends) {
            for (const auto &[from, to] : {std::pair(one, two), std::pair(two, one)}) {
                for (const qsizetype at : {qsizetype{0}, name.text.size() - 1}) {
                    QString partner = name.text;
                    if (partner[at] != from)
                        continue;
                    partner[at] = to;
                    if (m_names.contains(partner))
                        replace(name, partner);
                }
            }
        }
        static const QHash<QString, QString> pairs{
            {QStringLiteral("right"), QStringLiteral("left")},
            {QStringLiteral("left"), QStringLiteral("right")},
            {QStringLiteral("top"), QStringLiteral("bottom")},
            {QStringLiteral("bottom"), QStringLiteral("top")},
            {QStringLiteral("max"), QStringLiteral("min")},
            {QStringLiteral("min"), QStringLiteral("max")},
            {QStringLiteral("sin"), QStringLiteral("cos")},
            {QStringLiteral("cos"), QStringLiteral("sin")},
            {QStringLiteral("one"), QStringLiteral("other")},
            {QStringLiteral("other"), QStringLiteral("one")}};
        const QString partner = pairs.value(name.text);
        if (!partner.isEmpty())
            replace(name, partner);
        if (name.text == QLatin1String("restitution"))
            replace(name, QStringLiteral("1"));
    }

    /// The token after the operand that begins at \p i.
    [[nodiscard]] std::size_t afterOperand(std::size_t i) const
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
    [[nodiscard]] std::size_t afterGroup(std::size_t i) const
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

    /// A factor or a term too many.
    void dropOperand(std::size_t i)
    {
        const ProgramToken &sign = m_tokens[i];
        const bool joins = sign.is("*") || sign.is("/") || sign.is("^") || sign.is("+")
                           || (sign.is("-") && i > 0 && m_tokens[i - 1].endsOperand());
        if (joins) {
            const std::size_t after = afterOperand(i + 1);
            if (after > i + 1)
                replace(sign.line, sign.start, m_tokens[after - 1].end(), {});
        }
        const std::size_t after = afterOperand(i);
        if (after > i && after + 1 < m_tokens.size() && (m_tokens[after].is("*"))
            && !(i > 0 && (m_tokens[i - 1].is(".") || m_tokens[i - 1].is(":"))))
            replace(sign.line, sign.start, m_tokens[after + 1].start, {});
    }

    /// A factor that is missing behind an operand.
    void addFactor(std::size_t i)
    {
        const ProgramToken &token = m_tokens[i];
        if (i > 0 && (m_tokens[i - 1].is(".") || m_tokens[i - 1].is(":")))
            return;
        const std::size_t after = afterOperand(i);
        if (after == i || is(after, "=") || is(after, ",")
            || m_tokens[after - 1].line != token.line)
            return;
        const ProgramToken &last = m_tokens[after - 1];
        const bool isRate = last.is("velocity") || last.is("gravity") || last.is(")")
                            || last.is("x") || last.is("y") || last.text.startsWith(u'v')
                            || last.text.startsWith(u'g');
        if (isRate) {
            for (const QString &timestep : m_timesteps)
                insert(last, QStringLiteral(" * ") + timestep);
        }
        // Something that is turned round.
        const bool isTurned = i > 1 && m_tokens[i - 1].is("-") && !m_tokens[i - 2].endsOperand();
        if (isRate || isTurned)
            insert(last, QStringLiteral(" * restitution"));
        if (last.is("radius") && after >= 3) {
            const QString body = m_tokens[after - 3].text;
            insert(last, QStringLiteral(" * %1.radius").arg(body));
            insert(last, QStringLiteral(" * %1.density").arg(body));
        }
        if (last.kind == ProgramToken::Kind::Number || last.is("radius"))
            insert(last, QStringLiteral(" ^ 2"));
    }

    /// The rim for the centre, on either side of a comparison.
    void addRadius(std::size_t i)
    {
        const ProgramToken &sign = m_tokens[i];
        if (!(sign.is("<") || sign.is(">") || sign.is("<=") || sign.is(">=")) || i == 0)
            return;
        for (const QString &body : bodiesNear(sign.line)) {
            insert(m_tokens[i - 1], QStringLiteral(" + %1.radius").arg(body));
            insert(m_tokens[i - 1], QStringLiteral(" - %1.radius").arg(body));
        }
    }

    void changeCondition(std::size_t i)
    {
        const ProgramToken &word = m_tokens[i];
        if (word.is("and") || word.is("or")) {
            const auto stops = [&](const ProgramToken &t) {
                return t.kind == ProgramToken::Kind::Keyword && !t.is("not");
            };
            std::size_t first = i;
            while (first > 0 && !stops(m_tokens[first - 1]))
                --first;
            std::size_t last = i + 1;
            while (last < m_tokens.size() && !stops(m_tokens[last]))
                ++last;
            replace(word.line, m_tokens[first].start, m_tokens[i + 1].start, {});
            replace(word.line, m_tokens[i - 1].end(), m_tokens[last - 1].end(), {});
            replace(word, word.is("and") ? QStringLiteral("or") : QStringLiteral("and"));
        }
        if (word.is("if") || word.is("elseif")) {
            std::size_t then = i + 1;
            while (then < m_tokens.size() && !m_tokens[then].is("then"))
                ++then;
            if (then >= m_tokens.size())
                return;
            for (const char *verdict : {"true", "false"})
                replace(word.line, m_tokens[i + 1].start, m_tokens[then - 1].end(),
                        QLatin1String(verdict));
        }
    }

    /// A direction of length 1.
    void changeLength(std::size_t i)
    {
        if (!is(i, "=") || i + 1 >= m_tokens.size())
            return;
        const qsizetype from = m_tokens[i + 1].start;
        const QString row = m_rows[m_tokens[i].line - 1];
        qsizetype rowStart = 0;
        for (int line = 1; line < m_tokens[i].line; ++line)
            rowStart += m_rows[line - 1].size() + 1;
        const qsizetype end = rowStart + row.size();
        const QString right = m_source.mid(from, end - from);
        if (from >= end || right.contains(QLatin1String("--")) || right.contains(QLatin1Char(';')))
            return;
        replace(m_tokens[i].line, from, end, QStringLiteral("(%1):normalized()").arg(right));
        replace(m_tokens[i].line, from, end, QStringLiteral("-(%1)").arg(right));
    }

    /// A mass without its density.
    void addDensity(std::size_t i)
    {
        const ProgramToken &token = m_tokens[i];
        if (!(is(i, "=") || is(i, "return")) || i + 1 >= m_tokens.size()
            || m_tokens[i + 1].line != token.line)
            return;
        const std::vector<std::size_t> &row = m_rowTokens.at(token.line);
        for (std::size_t k = 2; k < row.size(); ++k) {
            if (row[k] > i && m_tokens[row[k]].is("radius") && m_tokens[row[k] - 1].is(".")) {
                insert(token, QStringLiteral(" %1.density *").arg(m_tokens[row[k] - 2].text));
                return;
            }
        }
    }

    void changeStatement(int line)
    {
        static const QRegularExpression statement(
            QStringLiteral("^\\s*(local\\s+)?[\\w.,\\s\\[\\]]+(=[^=]|\\().*[^,(]$"));
        if (line < 1 || line > m_rows.size() || !statement.match(m_rows[line - 1]).hasMatch())
            return;
        qsizetype from = 0;
        for (int before = 1; before < line; ++before)
            from += m_rows[before - 1].size() + 1;
        const QString row = m_rows[line - 1];
        replace(line, from, from + row.size(), {});
        if (line < m_rows.size() && statement.match(m_rows[line]).hasMatch())
            replace(line, from, from + row.size() + 1 + m_rows[line].size(),
                    m_rows[line] + QLatin1Char('\n') + row);
    }

    struct Edit {
        qsizetype from;
        qsizetype to;
        QString text;
    };

    const QString &m_source;
    const std::set<int> &m_lines;
    std::vector<ProgramToken> m_tokens;
    QStringList m_rows;
    std::map<int, std::vector<std::size_t>> m_rowTokens{}; ///< by line, from 1
    QSet<QString> m_names{};
    QSet<QString> m_timesteps{};
    std::map<int, std::set<QString>> m_bodies{}; ///< names of circles, by line
    std::vector<Repair> m_repairs{};
};

} // namespace

std::vector<Repair> repairsOf(const QString &source, const std::set<int> &lines)
{
    return Repairer(source, lines).make();
}

} // namespace cradle
