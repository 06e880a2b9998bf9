// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/library_parts.h"
#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"

#include <QCoreApplication>

#include <string_view>

namespace cradle {

namespace {

struct TextText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Writing 1e308 with 99 decimals takes some microseconds.
constexpr qint64 instructionsPerValue = 50;

/// The letters of the conversions in a format: "sf" of "%s: %6.2f%%".
std::string conversionsOf(std::string_view format)
{
    std::string letters;
    for (std::size_t i = 0; i < format.size(); ++i) {
        if (format[i] != '%')
            continue;
        i = format.find_first_not_of("-+#0 .123456789", i + 1);
        if (i == std::string_view::npos)
            break; // Lua says what is wrong with it.
        if (format[i] != '%')
            letters += format[i];
    }
    return letters;
}

/// string.format without addresses. Upvalue: Lua's own.
int formatText(lua_State *L)
{
    std::size_t size = 0;
    const char *format = luaL_checklstring(L, 1, &size);
    {
        const std::string conversions = conversionsOf({format, size});
        charge(L, instructionsPerValue * static_cast<qint64>(conversions.size()));
        if (conversions.find('p') != std::string::npos)
            raise(L, TextText::tr("%p of string.format is not part of the lab's Lua: an address is "
                                  "another in every run"));
    }
    for (int i = 2; i <= lua_gettop(L); ++i) {
        if (lua_type(L, i) == LUA_TTABLE || lua_type(L, i) == LUA_TFUNCTION) {
            pushText(L, i);
            lua_replace(L, i);
        }
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

} // namespace

void pushTexts(lua_State *L)
{
    luaL_requiref(L, "string", luaopen_string, 0);
    keepOnly(L, "string",
             {{"format", formatText},
              {"sub", nullptr},
              {"len", nullptr},
              {"upper", nullptr},
              {"lower", nullptr}});
    // The methods of strings, ("x"):upper(), are the same few.
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushvalue(L, -3);
    lua_setfield(L, -2, "__index");
    lua_pop(L, 2);
}

} // namespace cradle
