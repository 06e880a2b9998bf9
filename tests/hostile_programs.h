// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

/// Programs that try, by accident or on purpose, to hang or break what runs them.
namespace cradle::programs {

struct HostileProgram {
    const char *name;
    QString source;
    const char *kind; ///< of the error that it must end with
};

inline constexpr auto noKind = "none"; ///< it does no harm and runs
inline constexpr auto syntaxKind = "syntax";
inline constexpr auto runtimeKind = "runtime";
inline constexpr auto timeKind = "time";
inline constexpr auto memoryKind = "memory";

/// \p statements in an update.
inline QString inUpdate(const char *statements)
{
    return QStringLiteral("function on_update(dt)\n%1\nend").arg(QString::fromUtf8(statements));
}

inline QString atLoad(const char *statements)
{
    return QString::fromUtf8(statements);
}

/// \p begin, \p count times \p middle, then \p end. "#" stands for the number of the turn.
inline QString repeated(const char *begin, const char *middle, int count, const char *end)
{
    const QString part = QString::fromUtf8(middle);
    QString text = QString::fromUtf8(begin);
    for (int i = 0; i < count; ++i)
        text += QString(part).replace(QLatin1Char('#'), QString::number(i));
    return text + QString::fromUtf8(end);
}

/// Those that take time without end.
inline std::vector<HostileProgram> endlessPrograms()
{
    return {
        {"loop at top level", atLoad("while true do end"), timeKind},
        {"loop in on_load", atLoad("function on_load() repeat until false end"), timeKind},
        {"loop in on_update", inUpdate("while true do end"), timeKind},
        {"loop of jumps", inUpdate("::again:: goto again"), timeKind},
        {"loop to the largest number", inUpdate("for i = 1, math.maxinteger do end"), timeKind},
        {"loop that makes vectors", inUpdate("while true do local v = vec(1, 2) * 2 end"),
         timeKind},
        {"loop over a circle list",
         inUpdate("local i = 0 while true do for _, c in "
                  "ipairs(circles) do i = i + c.radius end end"),
         timeKind},
        {"loop in pcall", inUpdate("pcall(function() while true do end end)"), timeKind},
        {"loop in pcall in a loop",
         inUpdate("while true do pcall(function() while true do end end) "
                  "end"),
         timeKind},
        {"loop of failing pcalls", inUpdate("while true do pcall(error) end"), timeKind},
        {"loop in nested pcalls",
         inUpdate("local function f(n) if n == 0 then while true do end end pcall(f, n - 1) end "
                  "f(100)"),
         timeKind},
        {"tree of pcalls", inUpdate("local function f() pcall(f) pcall(f) end f()"), timeKind},
        {"comparator without end",
         inUpdate("table.sort({1, 2, 3}, function() while true do end end)"), timeKind},
        {"sort of many",
         inUpdate("local t = {} for i = 1, 400000 do t[i] = -i end "
                  "table.sort(t, function(a, b) return a < b end)"),
         timeKind},
        {"sort of long texts alike",
         inUpdate("local s = 'x' for i = 1, 20 do s = s .. s end local t = {} "
                  "for i = 1, 30 do t[i] = s .. i end "
                  "while true do for i = 1, 30 do t[i], t[31 - i] = t[31 - i], t[i] end "
                  "table.sort(t) end"),
         noKind},
        {"insert at the front", inUpdate("local t = {} while true do table.insert(t, 1, 0) end"),
         timeKind},
        {"remove at the front",
         inUpdate("local t = {} for i = 1, 400000 do t[i] = i end "
                  "while #t > 0 do table.remove(t, 1) end"),
         timeKind},
        {"concat of many again and again",
         inUpdate("local t = {} for i = 1, 200000 do t[i] = 'abc' end "
                  "while true do local s = table.concat(t) end"),
         timeKind},
        {"long text to upper again and again",
         inUpdate("local s = 'x' for i = 1, 23 do s = s .. s end "
                  "while true do local u = s:upper() end"),
         timeKind},
        {"pairs of many again and again",
         inUpdate("local t = {} for i = 1, 100000 do t['k' .. i] = i end "
                  "while true do pairs(t) end"),
         timeKind},
        {"number from a long text again and again",
         inUpdate("local s = '1' for i = 1, 22 do s = s .. s end "
                  "while true do local n = tonumber(s) end"),
         timeKind},
        {"garbage beside a full store",
         inUpdate("kept = {} for i = 1, 620000 do kept[i] = {i} end "
                  "while true do local a, b, c, d = {}, {}, {}, {} end"),
         noKind},
        {"recursion without end in a loop of tail calls",
         inUpdate("local function f() return f() end f()"), timeKind},
    };
}

/// Those that take memory without end.
inline std::vector<HostileProgram> greedyPrograms()
{
    return {
        {"table without end", inUpdate("local t = {} for i = 1, 1e9 do t[i] = {i} end"),
         memoryKind},
        {"text that doubles", inUpdate("local s = 'x' while true do s = s .. s end"), memoryKind},
        {"text that doubles at top level", atLoad("s = 'x' while true do s = s .. s end"),
         memoryKind},
        {"text that doubles in pcall",
         inUpdate("pcall(function() local s = 'x' while true do s = s .. s end end)"), memoryKind},
        {"again and again in pcall",
         inUpdate("while true do pcall(function() local s = 'x' while true do s = s .. s end end) "
                  "end"),
         memoryKind},
        {"a little in every step",
         inUpdate("kept = kept or {} local t = {} for i = 1, 60000 do t[i] = i end "
                  "kept[#kept + 1] = t")
             .prepend(QStringLiteral("kept = false\n")),
         memoryKind},
        {"concat of long texts",
         inUpdate("local s = 'x' for i = 1, 20 do s = s .. s end local t = {} "
                  "for i = 1, 1000 do t[i] = s end local u = table.concat(t)"),
         memoryKind},
        {"format of long texts",
         inUpdate("local s = 'x' for i = 1, 22 do s = s .. s end "
                  "local u = string.format('%s%s%s%s%s%s%s%s%s%s%s%s%s%s%s%s', "
                  "s, s, s, s, s, s, s, s, s, s, s, s, s, s, s, s)"),
         memoryKind},
        {"very many globals", inUpdate("for i = 1, 1e9 do _ENV['g' .. i] = i end"), noKind},
        {"very many fields of a circle", inUpdate("for i = 1, 1e9 do circle1['f' .. i] = i end"),
         noKind},
        {"closures that keep each other",
         inUpdate("local f = print while true do local g = f f = function() return g end end"),
         memoryKind},
    };
}

/// Those that overflow something.
inline std::vector<HostileProgram> overflowingPrograms()
{
    return {
        {"recursion", inUpdate("local function f() return 1 + f() end f()"), runtimeKind},
        {"mutual recursion",
         inUpdate("local g local function f() g() return 1 end g = function() f() return 1 end "
                  "f()"),
         runtimeKind},
        {"recursion with many locals",
         inUpdate("local function f(a, b, c, d) local e, f2, g = a, b, c f(b, c, d, a) return e "
                  "end f(1, 2, 3, 4)"),
         runtimeKind},
        {"recursion in pcall",
         inUpdate("if step > 0 then return end local function f() f() return 1 end pcall(f)"),
         noKind},
        {"recursion through pcall", inUpdate("local function f() pcall(f) end f()"), noKind},
        {"recursion through sort", inUpdate("local function f() table.sort({1, 2}, f) end f()"),
         runtimeKind},
        {"unpack of many",
         inUpdate("local t = {} for i = 1, 300000 do t[i] = i end "
                  "return select('#', table.unpack(t, 1, 1e8))"),
         runtimeKind},
        {"unpack of as many as fit",
         inUpdate("if step > 0 then return end "
                  "local t = {} for i = 1, 300000 do t[i] = i end local n = {table.unpack(t)}"),
         noKind},
        {"select beyond", inUpdate("return select(-1e9, 1)"), runtimeKind},
        {"select far beyond", inUpdate("return select(math.maxinteger, 1)"), noKind},
        {"concat of a wide range", inUpdate("return table.concat({}, '', 1, math.maxinteger)"),
         runtimeKind},
        {"wide format", inUpdate("return string.format('%99999d', 1)"), runtimeKind},
        {"wide format that is allowed", inUpdate("local s = string.format('%99.99f', 1e308)"),
         noKind},
        {"integer overflow", inUpdate("local n = math.maxinteger + 1 assert(n == math.mininteger)"),
         noKind},
        {"integer division by zero", inUpdate("return 1 // 0"), runtimeKind},
        {"smallest integer divided by -1",
         inUpdate("local a, b = math.mininteger // -1, math.mininteger % -1 "
                  "local c, d = 1 << 64, 1 >> -64"),
         noKind},
        {"walk that overflows",
         inUpdate("local walk, list = pairs(circles) local x = walk(list, math.maxinteger)"),
         noKind},
        {"deep parentheses", repeated("x = ", "(", 5000, "1"), syntaxKind},
        {"deep calls", repeated("x = ", "print(", 5000, "1"), syntaxKind},
        {"deep tables", repeated("x = ", "{", 100000, "1"), syntaxKind},
        {"deep blocks", repeated("", "do ", 40000, ""), syntaxKind},
        {"deep functions", repeated("", "function f() ", 9000, ""), syntaxKind},
        {"long chain of texts", repeated("x = ''", " .. 'a'", 18000, ""), syntaxKind},
        {"long chain of sums", repeated("x = 1", " + 1", 30000, ""), noKind},
        {"long chain of conditions",
         repeated("x = 1 if x == 0 then ", "elseif x then ", 9000, "end"), noKind},
        {"labels side by side", repeated("do ", "::a#:: ", 10000, "end"), syntaxKind},
        {"very many labels", repeated("do ", "::a#:: x = 1 ", 8000, "end"), noKind},
        {"very many jumps", repeated("do ", "goto b ", 18000, "::b:: end"), noKind},
        {"very many locals", repeated("", "local a# = 1 ", 300, ""), syntaxKind},
        {"very many constants", repeated("x = {", "'t#',", 14000, "}"), noKind},
        {"a long line", repeated("x = '", "0123456789", 13000, "'"), noKind},
        {"10 MB of source", repeated("", "x = 1234\n", 1200000, ""), memoryKind},
    };
}

/// Those that send strange values about.
inline std::vector<HostileProgram> strangePrograms()
{
    return {
        {"error with a table", inUpdate("error({})"), runtimeKind},
        {"error with nil", inUpdate("error(nil)"), runtimeKind},
        {"error with a long text",
         inUpdate("local s = 'x' for i = 1, 24 do s = s .. s end error(s)"), runtimeKind},
        {"error after an error", inUpdate("local ok, e = pcall(error, {}) error(e)"), runtimeKind},
        {"error in a comparator", inUpdate("table.sort({1, 2, 3}, error)"), runtimeKind},
        {"comparator that contradicts itself",
         inUpdate("local t = {} for i = 1, 200 do t[i] = i end "
                  "pcall(table.sort, t, function() return true end)"),
         noKind},
        {"sort of a table that changes",
         inUpdate("local t = {} for i = 1, 200 do t[i] = i % 7 end "
                  "pcall(table.sort, t, function(a, b) t[a] = nil return a < b end)"),
         noKind},
        {"bytecode", QStringLiteral("\x1bLua\x54"), syntaxKind},
        {"not UTF-8", QString::fromUtf8("x = 1 \xff\xfe\x80"), syntaxKind},
        {"NUL", QStringLiteral("x = 1 ") + QChar(0) + QStringLiteral(" y = 2"), syntaxKind},
        {"NUL in a text", QStringLiteral("x = 'a") + QChar(0) + QStringLiteral("b'"), noKind},
        {"flood of print", inUpdate("while true do print('0123456789') end"), runtimeKind},
        {"flood of print in pcall", inUpdate("while true do pcall(print, '0123456789') end"),
         runtimeKind},
        {"print of a long text", inUpdate("local s = 'x' for i = 1, 24 do s = s .. s end print(s)"),
         runtimeKind},
        {"flood of plot", inUpdate("while true do plot('a', 1) end"), runtimeKind},
        {"flood of names in plot", inUpdate("for i = 1, 1e9 do plot('a' .. i, 1) end"),
         runtimeKind},
        {"flood of draw", inUpdate("while true do draw.point(vec(0, 0)) end"), runtimeKind},
        {"our functions replaced",
         inUpdate("vec = nil circle1 = 5 print = nil pcall = error math = nil circles = nil "
                  "square = {} dot = 1"),
         runtimeKind},
        {"vec replaced and used", inUpdate("vec = 5 circle1.position = vec(1, 2)"), runtimeKind},
        {"library changed", inUpdate("string.sub = nil table.sort = error local s = ('a'):sub(1)"),
         runtimeKind},
        {"update replaced in an update",
         inUpdate("on_update = function() circle1.position = vec(0, 0) end"), noKind},
        {"update that is a number", atLoad("on_update = 5"), runtimeKind},
        {"circle far away in the list", inUpdate("return circles[1e9].position"), runtimeKind},
        {"circle without number", inUpdate("return circles['x']"), runtimeKind},
        {"circle of a vector", inUpdate("return circles[vec(1, 2)]"), runtimeKind},
        {"vector of texts", inUpdate("return vec('a', 'b')"), runtimeKind},
        {"huge numbers",
         inUpdate("circle1.position = vec(1e308, -1e308) "
                  "circle1.velocity = circle1.position"),
         noKind},
        {"beyond all numbers", inUpdate("circle1.position = vec(1e308, 0) * 1e308"), runtimeKind},
        {"not a number", inUpdate("circle1.velocity = vec(0, 0 / 0)"), runtimeKind},
        {"radius beyond all bounds", inUpdate("circle1.radius = 1e308"), noKind},
        {"time assigned", inUpdate("time = 1"), runtimeKind},
        {"method of a text with a number", inUpdate("return ('x'):sub('y')"), runtimeKind},
        {"variable to be closed", inUpdate("while true do local x <close> = nil end"), timeKind},
        {"variable that cannot be closed", inUpdate("local x <close> = {}"), runtimeKind},
        {"environment emptied", inUpdate("local _ENV = {} return os.exit()"), runtimeKind},
        {"environment taken away", inUpdate("_ENV = nil x = 1"), runtimeKind},
        {"metatable of texts", inUpdate("return getmetatable('').__index"), runtimeKind},
        {"addresses",
         inUpdate("local s = tostring(print) .. tostring({}) .. "
                  "string.format('%p', {})"),
         runtimeKind},
    };
}

} // namespace cradle::programs
