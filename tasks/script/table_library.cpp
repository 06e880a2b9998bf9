// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/chunk_cache.h"
#include "tasks/script/library_parts.h"
#include "tasks/script/sandbox.h"

#include <algorithm>

namespace cradle {

namespace {

/// Values that unpack may give back, and a little more; Lua refuses more at once.
constexpr lua_Integer mostValues = 1'000'000;
constexpr qint64 instructionsPerPart = 4; ///< of concat, which may be a number to be written

qint64 lengthAt(lua_State *L, int index)
{
    return lua_type(L, index) == LUA_TTABLE ? static_cast<qint64>(lua_rawlen(L, index)) : 0;
}

/// insert and remove move what lies behind \p place.
void chargeBehind(lua_State *L, int place)
{
    const qint64 length = lengthAt(L, 1);
    if (lua_isinteger(L, place) && lua_tointeger(L, place) > 0)
        charge(L, std::max<qint64>(0, length - lua_tointeger(L, place)));
}

// Upvalue of all of these: Lua's own.

int insert(lua_State *L)
{
    if (lua_gettop(L) == 3)
        chargeBehind(L, 2);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int remove(lua_State *L)
{
    chargeBehind(L, 2);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Of a wide range the first value that is not there ends it.
int concat(lua_State *L)
{
    charge(L, instructionsPerPart * lengthAt(L, 1));
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

int unpack(lua_State *L)
{
    const lua_Integer first = luaL_optinteger(L, 2, 1);
    const lua_Integer last = luaL_optinteger(L, 3, lengthAt(L, 1));
    if (first <= last) {
        const lua_Unsigned more =
            static_cast<lua_Unsigned>(last) - static_cast<lua_Unsigned>(first);
        charge(L, static_cast<qint64>(std::min<lua_Unsigned>(more, mostValues)));
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/// Only looks at what sort is given. What sort does is no work that the program's text bounds.
int checkSort(lua_State *L)
{
    luaL_checktype(L, 1, LUA_TTABLE);
    if (!lua_isnoneornil(L, 2))
        luaL_checktype(L, 2, LUA_TFUNCTION);
    countFromHere(L);
    return 0;
}

/// Lua's own sort chooses by the clock where it begins, so that equals, and all under a function
/// that contradicts itself, would lie otherwise in another run. This merges, keeps equals in their
/// order, and is counted like the program's own instructions.
constexpr char sortSource[] = R"lua(
local sort = ...
local function merge(from, to, low, middle, high, less)
  local i, j = low, middle
  for k = low, high - 1 do
    local first
    if j >= high then
      first = true
    elseif i >= middle then
      first = false
    elseif less then
      first = not less(from[j], from[i])
    else
      first = not (from[j] < from[i])
    end
    if first then
      to[k] = from[i]
      i = i + 1
    else
      to[k] = from[j]
      j = j + 1
    end
  end
end
return function(list, less)
  sort(list, less)
  local size = #list
  local from, to = {}, {}
  for i = 1, size do
    from[i] = list[i]
  end
  local width = 1
  while width < size do
    for low = 1, size, 2 * width do
      local middle, high = low + width, low + 2 * width
      middle = middle > size and size + 1 or middle
      high = high > size and size + 1 or high
      merge(from, to, low, middle, high, less)
    end
    from, to = to, from
    width = 2 * width
  end
  for i = 1, size do
    list[i] = from[i]
  end
end
)lua";

} // namespace

void pushTables(lua_State *L)
{
    luaL_requiref(L, "table", luaopen_table, 0);
    keepOnly(L, "table",
             {{"insert", insert},
              {"remove", remove},
              {"concat", concat},
              {"sort", nullptr},
              {"unpack", unpack}});
    static const QByteArray sort = QByteArray::fromRawData(sortSource, sizeof sortSource - 1);
    if (loadProgram(L, sort, "=table.sort") != LUA_OK)
        lua_error(L); // There is no memory.
    lua_pushcfunction(L, checkSort);
    lua_call(L, 1, 1);
    lua_setfield(L, -2, "sort");
}

} // namespace cradle
