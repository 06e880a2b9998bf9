// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/api_words.h"

#include "tasks/script/lua_tokens.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace cradle {

namespace {

struct ApiText {
    Q_DECLARE_TR_FUNCTIONS(LuaApi)
};

struct Row {
    const char *owner;
    const char *signature;
    const char *doc; ///< to be translated
    ApiWord::Kind kind = ApiWord::Kind::Function;
};

constexpr auto valueKind = ApiWord::Kind::Value;
constexpr auto hook = ApiWord::Kind::Hook;

// clang-format off
constexpr Row apiRows[] = {
    {"", "on_load()", QT_TRANSLATE_NOOP("LuaApi", "You write it: runs once, before the first step"), hook},
    {"", "on_update(timestep)", QT_TRANSLATE_NOOP("LuaApi", "You write it: moves the circles by one step of timestep seconds"), hook},
    {"", "vec(x, y)", QT_TRANSLATE_NOOP("LuaApi", "A new vector; its unit is that of its numbers")},
    {"", "dot(a, b)", QT_TRANSLATE_NOOP("LuaApi", "The dot product of two vectors: a.x * b.x + a.y * b.y")},
    {"", "circle1", QT_TRANSLATE_NOOP("LuaApi", "The first circle"), valueKind},
    {"", "circle2", QT_TRANSLATE_NOOP("LuaApi", "The second circle"), valueKind},
    {"", "circles", QT_TRANSLATE_NOOP("LuaApi", "All circles: circles[1] to circles[#circles]"), valueKind},
    {"", "gravity", QT_TRANSLATE_NOOP("LuaApi", "The acceleration of every circle, a vector in m/s²; may be set in on_load"), valueKind},
    {"", "restitution", QT_TRANSLATE_NOOP("LuaApi", "From 0 (no rebound) to 1 (elastic); may be set in on_load"), valueKind},
    {"", "square", QT_TRANSLATE_NOOP("LuaApi", "The box that the circles are in"), valueKind},
    {"", "time", QT_TRANSLATE_NOOP("LuaApi", "Seconds since the start of the run, at the start of this step"), valueKind},
    {"", "step", QT_TRANSLATE_NOOP("LuaApi", "The number of steps made so far"), valueKind},
    {"", "plot(name, number)", QT_TRANSLATE_NOOP("LuaApi", "Adds a point of this step to the curve called name in the charts")},
    {"", "draw", QT_TRANSLATE_NOOP("LuaApi", "Draws over the scene, for this step"), valueKind},
    {"", "print(...)", QT_TRANSLATE_NOOP("LuaApi", "Writes a line to the console")},
    {"", "math", QT_TRANSLATE_NOOP("LuaApi", "Functions of numbers"), valueKind},
    {"", "string", QT_TRANSLATE_NOOP("LuaApi", "Functions of texts"), valueKind},
    {"", "table", QT_TRANSLATE_NOOP("LuaApi", "Functions of lists"), valueKind},
    {"", "ipairs(list)", QT_TRANSLATE_NOOP("LuaApi", "For a loop over a list in order: for i, v in ipairs(list) do")},
    {"", "pairs(table)", QT_TRANSLATE_NOOP("LuaApi", "For a loop over all fields of a table: for k, v in pairs(t) do")},
    {"", "select(n, ...)", QT_TRANSLATE_NOOP("LuaApi", "The arguments from number n on; with '#' how many there are")},
    {"", "type(value)", QT_TRANSLATE_NOOP("LuaApi", "What a value is, as a text: \"number\", \"vector\", \"circle\" …")},
    {"", "tostring(value)", QT_TRANSLATE_NOOP("LuaApi", "A value as a text")},
    {"", "tonumber(text, base)", QT_TRANSLATE_NOOP("LuaApi", "The number that a text says, or nil; base is 10 unless given")},
    {"", "assert(value, message)", QT_TRANSLATE_NOOP("LuaApi", "Stops the run with the message if value is false or nil")},
    {"", "error(message)", QT_TRANSLATE_NOOP("LuaApi", "Stops the run at this line with the message")},
    {"", "pcall(f, ...)", QT_TRANSLATE_NOOP("LuaApi", "Calls f: true and its results, or false and the error")},

    {"vec", "length()", QT_TRANSLATE_NOOP("LuaApi", "The length of the vector")},
    {"vec", "length_squared()", QT_TRANSLATE_NOOP("LuaApi", "The square of the length: v:dot(v)")},
    {"vec", "normalized()", QT_TRANSLATE_NOOP("LuaApi", "The vector of length 1 with the same direction; an error for (0, 0)")},
    {"vec", "dot(v)", QT_TRANSLATE_NOOP("LuaApi", "The dot product with another vector")},
    {"vec", "perpendicular()", QT_TRANSLATE_NOOP("LuaApi", "The vector turned left by 90°: (-y, x)")},
    {"xy", "x", QT_TRANSLATE_NOOP("LuaApi", "The part to the right; to change it, build a new vector"), valueKind},
    {"xy", "y", QT_TRANSLATE_NOOP("LuaApi", "The part upwards; to change it, build a new vector"), valueKind},

    {"circle", "position", QT_TRANSLATE_NOOP("LuaApi", "The centre, a vector in m"), valueKind},
    {"circle", "velocity", QT_TRANSLATE_NOOP("LuaApi", "A vector in m/s"), valueKind},
    {"circle", "radius", QT_TRANSLATE_NOOP("LuaApi", "In m, above 0"), valueKind},
    {"circle", "density", QT_TRANSLATE_NOOP("LuaApi", "In 1000 kg/m³, above 0: steel has 7.8"), valueKind},
    {"circle", "index", QT_TRANSLATE_NOOP("LuaApi", "The number of the circle, from 1; cannot be set"), valueKind},

    {"square", "half_width", QT_TRANSLATE_NOOP("LuaApi", "Half the side of the box, in m"), valueKind},
    {"square", "left", QT_TRANSLATE_NOOP("LuaApi", "The x of the left wall, in m"), valueKind},
    {"square", "right", QT_TRANSLATE_NOOP("LuaApi", "The x of the right wall, in m"), valueKind},
    {"square", "bottom", QT_TRANSLATE_NOOP("LuaApi", "The y of the floor, in m"), valueKind},
    {"square", "top", QT_TRANSLATE_NOOP("LuaApi", "The y of the ceiling, in m"), valueKind},

    {"draw", "arrow(from, vector, colour, label)", QT_TRANSLATE_NOOP("LuaApi", "An arrow that begins at from; colour and label may be left out")},
    {"draw", "line(a, b, colour)", QT_TRANSLATE_NOOP("LuaApi", "A line between two points; the colour may be left out")},
    {"draw", "point(p, colour)", QT_TRANSLATE_NOOP("LuaApi", "A dot; the colour may be left out")},
    {"draw", "text(p, text)", QT_TRANSLATE_NOOP("LuaApi", "A text at a point")},

    {"math", "abs(x)", QT_TRANSLATE_NOOP("LuaApi", "x without its sign")},
    {"math", "acos(x)", QT_TRANSLATE_NOOP("LuaApi", "The angle whose cosine is x, in radians")},
    {"math", "asin(x)", QT_TRANSLATE_NOOP("LuaApi", "The angle whose sine is x, in radians")},
    {"math", "atan(y, x)", QT_TRANSLATE_NOOP("LuaApi", "The angle of the direction (x, y), in radians; x is 1 unless given")},
    {"math", "ceil(x)", QT_TRANSLATE_NOOP("LuaApi", "The next whole number that is not below x")},
    {"math", "cos(x)", QT_TRANSLATE_NOOP("LuaApi", "The cosine of an angle in radians")},
    {"math", "deg(x)", QT_TRANSLATE_NOOP("LuaApi", "Radians in degrees")},
    {"math", "exp(x)", QT_TRANSLATE_NOOP("LuaApi", "e to the power of x")},
    {"math", "floor(x)", QT_TRANSLATE_NOOP("LuaApi", "The next whole number that is not above x")},
    {"math", "fmod(x, y)", QT_TRANSLATE_NOOP("LuaApi", "What is left of x divided by y, with the sign of x")},
    {"math", "huge", QT_TRANSLATE_NOOP("LuaApi", "Infinity: more than any number"), valueKind},
    {"math", "log(x, base)", QT_TRANSLATE_NOOP("LuaApi", "The logarithm of x; base is e unless given")},
    {"math", "max(x, ...)", QT_TRANSLATE_NOOP("LuaApi", "The largest of the numbers")},
    {"math", "maxinteger", QT_TRANSLATE_NOOP("LuaApi", "The largest whole number of Lua"), valueKind},
    {"math", "min(x, ...)", QT_TRANSLATE_NOOP("LuaApi", "The smallest of the numbers")},
    {"math", "mininteger", QT_TRANSLATE_NOOP("LuaApi", "The smallest whole number of Lua"), valueKind},
    {"math", "modf(x)", QT_TRANSLATE_NOOP("LuaApi", "The whole part of x, and the rest")},
    {"math", "pi", QT_TRANSLATE_NOOP("LuaApi", "3.14159…"), valueKind},
    {"math", "rad(x)", QT_TRANSLATE_NOOP("LuaApi", "Degrees in radians")},
    {"math", "random(m, n)", QT_TRANSLATE_NOOP("LuaApi", "From 0 up to 1, or a whole number from m to n; the same in every run")},
    {"math", "randomseed(x)", QT_TRANSLATE_NOOP("LuaApi", "Begins another row of random numbers")},
    {"math", "sin(x)", QT_TRANSLATE_NOOP("LuaApi", "The sine of an angle in radians")},
    {"math", "sqrt(x)", QT_TRANSLATE_NOOP("LuaApi", "The square root of x")},
    {"math", "tan(x)", QT_TRANSLATE_NOOP("LuaApi", "The tangent of an angle in radians")},
    {"math", "tointeger(x)", QT_TRANSLATE_NOOP("LuaApi", "x as a whole number, or nil if it is none")},
    {"math", "type(x)", QT_TRANSLATE_NOOP("LuaApi", "\"integer\", \"float\", or nil if x is no number")},
    {"math", "ult(m, n)", QT_TRANSLATE_NOOP("LuaApi", "Whether m is below n, both read without sign")},

    {"string", "format(pattern, ...)", QT_TRANSLATE_NOOP("LuaApi", "Values in a text: string.format(\"%.3f\", x)")},
    {"string", "len(s)", QT_TRANSLATE_NOOP("LuaApi", "The number of bytes of a text")},
    {"string", "lower(s)", QT_TRANSLATE_NOOP("LuaApi", "A text in small letters")},
    {"string", "sub(s, first, last)", QT_TRANSLATE_NOOP("LuaApi", "Part of a text; -1 is its last byte")},
    {"string", "upper(s)", QT_TRANSLATE_NOOP("LuaApi", "A text in capital letters")},

    {"table", "concat(list, separator)", QT_TRANSLATE_NOOP("LuaApi", "The elements of a list as one text")},
    {"table", "insert(list, position, value)", QT_TRANSLATE_NOOP("LuaApi", "Puts a value into a list, at its end if no position is given")},
    {"table", "remove(list, position)", QT_TRANSLATE_NOOP("LuaApi", "Takes an element out of a list, the last one unless told")},
    {"table", "sort(list, before)", QT_TRANSLATE_NOOP("LuaApi", "Sorts a list; before(a, b) says whether a comes first")},
    {"table", "unpack(list)", QT_TRANSLATE_NOOP("LuaApi", "The elements of a list as so many values")},
};
// clang-format on

ApiWord wordOf(const Row &row)
{
    ApiWord word;
    word.owner = QLatin1String(row.owner);
    word.signature = QLatin1String(row.signature);
    word.name = word.signature.section(u'(', 0, 0);
    word.doc = ApiText::tr(row.doc);
    word.kind = row.kind;
    return word;
}

} // namespace

std::vector<ApiWord> apiWords()
{
    std::vector<ApiWord> words;
    for (const Row &row : apiRows)
        words.push_back(wordOf(row));
    std::vector<QByteArrayView> reserved = luaKeywords();
    reserved.insert(reserved.end(), {"true", "false", "nil"});
    for (const QByteArrayView &keyword : reserved) {
        ApiWord word;
        word.name = QString::fromLatin1(keyword);
        word.signature = word.name;
        word.kind = ApiWord::Kind::Keyword;
        words.push_back(word);
    }
    return words;
}

QStringList headingsOf(const QString &word)
{
    static const QRegularExpression link(QStringLiteral("[.:]"));
    static const QRegularExpression circle(QStringLiteral("^circle[0-9]+$"));
    const QString name = word.section(link, -1, -1);
    QStringList headings{word};
    if (circle.match(word).hasMatch())
        headings << QStringLiteral("circles");
    for (const Row &row : apiRows) {
        if (QString(QLatin1String(row.signature)).section(u'(', 0, 0) != name)
            continue;
        const QString owner = QLatin1String(row.owner);
        if (owner == QLatin1String("vec"))
            headings << QStringLiteral("vec:") + name;
        else if (owner == QLatin1String("xy"))
            headings << QStringLiteral("vec.") + name;
        else if (owner == QLatin1String("circle"))
            headings << QStringLiteral("circle.") + name;
        else
            headings << (owner.isEmpty() ? name : owner + u'.' + name);
    }
    headings << QStringLiteral("circle.") + name; // such as mass, which there is not
    if (name != word)
        headings << word.section(link, 0, 0);
    headings.removeDuplicates();
    return headings;
}

} // namespace cradle
