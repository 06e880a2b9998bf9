// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/vec2.h"
#include "tasks/script/lua_state.h"

#include <QString>

namespace cradle {

/// The only kinds of objects of ours that a program can hold; every userdata begins with one.
enum class ObjectKind { Vector, Circle, Circles, Square };

struct VectorObject {
    ObjectKind kind = ObjectKind::Vector;
    Vec2 value{};
};

/// Adds vec, dot and what vectors can do; vectors never change once made.
void addVectors(lua_State *L);

/// Keeps \p name in the table on the top of the stack, which no program sees.
/// \return what lua_topointer() tells of that name as long as the state lives
const void *keepKey(lua_State *L, const char *name);

/// The vector at \p index, or null if something else is there.
[[nodiscard]] const Vec2 *vectorAt(lua_State *L, int index);

/// Pushes a new vector.
void pushVector(lua_State *L, Vec2 value);

/// The vector that an argument must be; raises an error that names \p what if it is not.
[[nodiscard]] Vec2 vectorArgument(lua_State *L, int index, const QString &what);

/// Pushes the text of a value as print and tostring show it: as Lua does, but without the address
/// of a table or a function, which is another one in every run.
const char *pushText(lua_State *L, int index, std::size_t *size = nullptr);

/// "(2, 0)", "3", "\"text\"", "circle 1", "nil": a value for the reader.
[[nodiscard]] QString describeValue(lua_State *L, int index);
/// The same as a function of Lua, for __tostring.
int describeObject(lua_State *L);
/// "a vector (2, 0)", "the number 3", "nil": for sentences.
[[nodiscard]] QString nameValue(lua_State *L, int index);

} // namespace cradle
