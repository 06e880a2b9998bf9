// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/work_bound.h"

#include "tasks/script/plain_tokens.h"
#include "tasks/script/script_limits.h"

#include <QByteArray>

#include <algorithm>
#include <array>
#include <vector>

namespace cradle {

namespace {

using Names = std::vector<std::string_view>;

/// A sign of arithmetic makes two instructions, a comparison whose result is kept runs three;
/// nothing that is written makes more of them run.
constexpr qint64 perToken = 3;
/// So that nothing overflows; far above what anybody asks for.
constexpr qint64 mostWork = 1'000'000'000;
constexpr std::size_t mostDigits = 3; ///< of a number that ends a loop

bool contains(const Names &names, std::string_view name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Adds up the work of one program; used once.
class Estimate
{
public:
    Estimate(const PlainTokens &tokens, std::size_t circles)
        : m_tokens(tokens)
        , m_circles(static_cast<qint64>(circles))
    {
    }

    std::optional<qint64> work()
    {
        if (!findFunctions())
            return std::nullopt;
        for (m_at = 0; m_at < m_tokens.size(); ++m_at) {
            if (!take())
                return std::nullopt;
        }
        // A loop that begins at another's variable begins where that is, and nowhere else.
        const bool moved = std::any_of(m_bases.begin(), m_bases.end(), [&](std::string_view name) {
            return contains(m_assigned, name);
        });
        if (moved || !m_blocks.empty())
            return std::nullopt;
        qint64 most = m_fileWork;
        for (const Function &function : m_functions)
            most = std::max(most, function.work);
        return most;
    }

private:
    struct Function {
        std::string_view name;
        qint64 work = perToken; ///< its return
        bool ended = false;
    };
    struct Block {
        enum class Kind { Function, Loop, Other } kind = Kind::Other;
        qint64 outerTimes;           ///< that what is around it runs
        std::size_t outer = 0;       ///< the function around it, if it is one
        std::string_view variable{}; ///< of a loop through numbers
    };
    static constexpr auto file = static_cast<std::size_t>(-1); ///< no function

    /// Empty before the first and behind the last.
    [[nodiscard]] std::string_view at(std::size_t i) const
    {
        return i < m_tokens.size() ? m_tokens[i] : std::string_view();
    }
    [[nodiscard]] std::string_view ahead(std::size_t n) const { return at(m_at + n); }

    /// All must have a name that nothing else bears.
    bool findFunctions()
    {
        for (std::size_t i = 0; i < m_tokens.size(); ++i) {
            if (m_tokens[i] != "function")
                continue;
            const std::string_view name = at(i + 1);
            if (!isName(name) || at(i + 2) != "(" || find(name))
                return false;
            m_functions.push_back({.name = name});
        }
        return true;
    }

    Function *find(std::string_view name)
    {
        const auto found =
            std::find_if(m_functions.begin(), m_functions.end(),
                         [&](const Function &function) { return function.name == name; });
        return found == m_functions.end() ? nullptr : &*found;
    }

    void add(qint64 work)
    {
        qint64 &sum = m_current == file ? m_fileWork : m_functions[m_current].work;
        sum = std::min(mostWork, sum + std::min(mostWork, work) * m_times);
    }

    bool take()
    {
        const std::string_view token = m_tokens[m_at];
        add(perToken);
        if (token.size() == 1 && !isName(token)) {
            takeSign(token.front());
            return true;
        }
        if (token == "for")
            return takeLoop();
        if (token == "end")
            return close();
        if (token == "function")
            return open();
        if (token == "do" || token == "if") {
            m_blocks.push_back({.outerTimes = m_times});
            return true;
        }
        // Without those that are or make loops, ways to functions, and other ways to declare.
        static constexpr std::array<std::string_view, 7> others{"while",  "repeat", "goto", "_ENV",
                                                                "ipairs", "const",  "close"};
        if (std::find(others.begin(), others.end(), token) != others.end())
            return false;
        if (token == "circles" && ahead(1) != "[" && at(m_at - 1) != "#")
            return false;
        if (ahead(1) == "=" || (ahead(1) == "," && m_depth == 0))
            m_assigned.push_back(token);
        return takeName(token);
    }

    void takeSign(char sign)
    {
        // No comma stands in square brackets alone.
        if (sign == '(' || sign == '{')
            ++m_depth;
        else if (sign == ')' || sign == '}')
            --m_depth;
    }

    /// A function of the program is called, behind its end, or it is not spoken of; a field may
    /// bear its name.
    bool takeName(std::string_view name)
    {
        const std::string_view before = at(m_at - 1);
        const Function *function = before == "." || before == ":" ? nullptr : find(name);
        if (!function)
            return true;
        if (!function->ended || ahead(1) != "(")
            return false;
        add(function->work);
        return true;
    }

    bool open()
    {
        ++m_at; // its name
        m_blocks.push_back(
            {.kind = Block::Kind::Function, .outerTimes = m_times, .outer = m_current});
        m_current = static_cast<std::size_t>(find(m_tokens[m_at]) - m_functions.data());
        m_times = 1;
        return true;
    }

    bool close()
    {
        if (m_blocks.empty())
            return false;
        const Block block = m_blocks.back();
        m_blocks.pop_back();
        if (block.kind == Block::Kind::Function) {
            m_functions[m_current].ended = true;
            m_current = block.outer;
        }
        m_times = block.outerTimes;
        return true;
    }

    /// for i = 1, #circles - 1 do; for j = i + 1, 2 do; for i, circle in ipairs(circles) do
    bool takeLoop()
    {
        const std::string_view variable = ahead(1);
        if (!isVariable(variable))
            return false;
        if (ahead(2) == "," && isVariable(ahead(3)) && ahead(4) == "in" && ahead(5) == "ipairs"
            && ahead(6) == "(" && ahead(7) == "circles" && ahead(8) == ")" && ahead(9) == "do")
            return beginLoop(9, m_circles, {});
        std::size_t next = 3;
        if (ahead(2) != "=" || !takeFirst(next) || ahead(next) != ",")
            return false;
        if (ahead(next + 1) == "#" && ahead(next + 2) == "circles") {
            next += ahead(next + 3) == "-" && number(ahead(next + 4)) ? 5 : 3;
            return ahead(next) == "do" && beginLoop(next, m_circles, variable);
        }
        const auto last = number(ahead(next + 1));
        return last && ahead(next + 2) == "do" && beginLoop(next + 2, *last, variable);
    }

    /// Where a loop begins: never below 0. \param next  the token; becomes that behind it
    bool takeFirst(std::size_t &next)
    {
        if (number(ahead(next))) {
            ++next;
            return true;
        }
        const std::string_view base = ahead(next);
        for (auto block = m_blocks.rbegin();
             block != m_blocks.rend() && block->kind != Block::Kind::Function; ++block) {
            if (block->variable.empty() || block->variable != base)
                continue;
            m_bases.push_back(base);
            ++next;
            if (ahead(next) == "+" && number(ahead(next + 1)))
                next += 2;
            return true;
        }
        return false;
    }

    /// \param head  tokens up to "do"
    bool beginLoop(std::size_t head, qint64 last, std::string_view variable)
    {
        // From 0, the end is reached once more, and asked for once more.
        add(perToken * (static_cast<qint64>(head) + last + 2));
        m_at += head;
        m_blocks.push_back(
            {.kind = Block::Kind::Loop, .outerTimes = m_times, .variable = variable});
        m_times = std::min(mostWork, m_times * (last + 1));
        return true;
    }

    bool isVariable(std::string_view name)
    {
        return isName(name) && name != "circles" && name != "ipairs" && !find(name);
    }

    static std::optional<qint64> number(std::string_view token)
    {
        if (token.empty() || token.size() > mostDigits)
            return std::nullopt;
        qint64 value = 0;
        for (const char c : token) {
            if (c < '0' || c > '9')
                return std::nullopt;
            value = value * 10 + (c - '0');
        }
        return value;
    }

    const PlainTokens &m_tokens;
    qint64 m_circles;
    std::size_t m_at = 0;
    std::vector<Function> m_functions{};
    std::vector<Block> m_blocks{}; ///< that are open
    std::size_t m_current = file;
    qint64 m_times = 1; ///< that what is here runs, of the function around it
    qint64 m_fileWork = perToken;
    int m_depth = 0;    ///< of brackets in which commas part no names that are set
    Names m_assigned{}; ///< names that may be given another value
    Names m_bases{};    ///< of loops, at which others begin
};

} // namespace

std::optional<qint64> workBound(std::string_view text, std::size_t circles)
{
    // Programs are read by the hundred: its memory is used again.
    thread_local PlainTokens tokens;
    if (!readPlainTokens(text, tokens))
        return std::nullopt;
    return Estimate(tokens, circles).work();
}

bool takesLittle(const QString &program, std::size_t circles)
{
    struct Known {
        QString program{};
        std::size_t circles = 0;
        bool little = false;
    };
    thread_local Known known;
    if (known.circles == circles && known.program == program)
        return known.little;
    const QByteArray text = program.toUtf8();
    const auto bound =
        workBound({text.constData(), static_cast<std::size_t>(text.size())}, circles);
    known = {program, circles, bound && *bound < limits::uncountedInstructions};
    return known.little;
}

} // namespace cradle
