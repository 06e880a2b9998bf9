// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/ordered_pairs.h"

#include "tasks/script/sandbox.h"
#include "tasks/script/script_host.h"
#include "tasks/script/vector_binding.h"
#include "tasks/script/world_binding.h"

#include <QCoreApplication>

#include <algorithm>
#include <compare>
#include <string_view>
#include <vector>

namespace cradle {

namespace {

struct PairsText {
    Q_DECLARE_TR_FUNCTIONS(Script)
};

/// Instructions that a key counts: what Lua's own loop takes, and a share of sorting.
constexpr qint64 instructionsPerKey = 10;
/// A table may have room for far more keys than it holds, all of which is looked through: at most
/// what all tables take. Bytes that take as long as an instruction.
constexpr std::size_t bytesPerInstruction = 512;

struct Key {
    enum class Rank { Integer, Number, Text, False, True, Circle, Vector, Other };

    Rank rank = Rank::Other;
    lua_Integer integer = 0;
    double number = 0.0;
    std::string_view text{}; ///< of Lua's; the list of keys keeps it
    Vec2 vector{};
    lua_Integer slot = 0; ///< in the list of keys as Lua gave them: another in every run

    friend bool operator<(const Key &a, const Key &b)
    {
        if (a.rank != b.rank)
            return a.rank < b.rank;
        switch (a.rank) {
        case Rank::Integer:
        case Rank::Circle:
            return a.integer < b.integer;
        case Rank::Number:
            return a.number < b.number;
        case Rank::Text:
            return a.text < b.text;
        case Rank::Vector:
            if (const auto x = std::strong_order(a.vector.x, b.vector.x); std::is_neq(x))
                return std::is_lt(x);
            return std::is_lt(std::strong_order(a.vector.y, b.vector.y));
        case Rank::False:
        case Rank::True:
        case Rank::Other:
            break;
        }
        return false;
    }
};

Key keyAt(lua_State *L, int index, lua_Integer slot)
{
    Key key;
    key.slot = slot;
    if (lua_isinteger(L, index)) {
        key.rank = Key::Rank::Integer;
        key.integer = lua_tointeger(L, index);
    } else if (lua_type(L, index) == LUA_TNUMBER) {
        key.rank = Key::Rank::Number;
        key.number = lua_tonumber(L, index);
    } else if (lua_type(L, index) == LUA_TSTRING) {
        key.rank = Key::Rank::Text;
        std::size_t size = 0;
        const char *text = lua_tolstring(L, index, &size);
        key.text = {text, size};
    } else if (lua_type(L, index) == LUA_TBOOLEAN) {
        key.rank = lua_toboolean(L, index) != 0 ? Key::Rank::True : Key::Rank::False;
    } else if (const Vec2 *vector = vectorAt(L, index)) {
        key.rank = Key::Rank::Vector;
        key.vector = *vector;
    } else if (const int circle = circleAt(L, index); circle >= 0) {
        key.rank = Key::Rank::Circle;
        key.integer = circle;
    }
    return key;
}

/// The next key that still has a value, with the value. Upvalues: the keys in order, and the place
/// of the last.
int nextPair(lua_State *L)
{
    lua_Integer place = lua_tointeger(L, lua_upvalueindex(2));
    lua_settop(L, 1);
    for (;;) {
        lua_settop(L, 1);
        if (lua_rawgeti(L, lua_upvalueindex(1), ++place) == LUA_TNIL)
            return 1;
        lua_pushvalue(L, -1);
        if (lua_rawget(L, 1) != LUA_TNIL)
            break;
    }
    lua_pushinteger(L, place);
    lua_replace(L, lua_upvalueindex(2));
    return 2;
}

/// Two keys that nothing but their address tells apart have no order that is the same in every run.
void refuseUnordered(lua_State *L, const std::vector<Key> &sorted)
{
    const auto alike = [](const Key &a, const Key &b) { return !(a < b); };
    if (std::adjacent_find(sorted.begin(), sorted.end(), alike) != sorted.end())
        raise(L, PairsText::tr("pairs needs keys that have an order: numbers, texts, circles. Of "
                               "tables, functions and equal vectors there may be one; keep them in "
                               "a list and go through it with ipairs"));
}

} // namespace

int orderedPairs(lua_State *L)
{
    lua_settop(L, 1);
    if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 3);
        return 3;
    }
    if (lua_type(L, 1) != LUA_TTABLE)
        raise(L,
              PairsText::tr("pairs goes through a table or circles, not %1").arg(nameValue(L, 1)));
    std::vector<Key> keys;
    lua_newtable(L); // as Lua gives them
    lua_pushnil(L);
    while (lua_next(L, 1) != 0) {
        lua_pop(L, 1);
        keys.push_back(keyAt(L, -1, static_cast<lua_Integer>(keys.size()) + 1));
        lua_pushvalue(L, -1);
        lua_rawseti(L, 2, keys.back().slot);
    }
    charge(L, instructionsPerKey * static_cast<qint64>(keys.size()) * instructionsPerText(L));
    charge(L, static_cast<qint64>(ScriptHost::of(L).memory.used() / bytesPerInstruction));
    const bool ordered = std::is_sorted(keys.begin(), keys.end());
    if (!ordered)
        std::sort(keys.begin(), keys.end());
    refuseUnordered(L, keys);
    if (!ordered) {
        lua_createtable(L, static_cast<int>(keys.size()), 0); // in order
        for (std::size_t i = 0; i < keys.size(); ++i) {
            lua_rawgeti(L, 2, keys[i].slot);
            lua_rawseti(L, 3, static_cast<lua_Integer>(i) + 1);
        }
    }
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, nextPair, 2);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

} // namespace cradle
