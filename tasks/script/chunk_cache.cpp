// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/chunk_cache.h"

#include "tasks/script/script_limits.h"

#include <QCache>
#include <QMutex>

namespace cradle {

namespace {

constexpr qsizetype mostBytes = 8 * 1024 * 1024;

class ChunkCache
{
public:
    /// Empty if there is none.
    QByteArray find(const QByteArray &key)
    {
        const QMutexLocker lock(&m_mutex);
        const QByteArray *found = m_chunks.object(key);
        return found ? *found : QByteArray();
    }

    void keep(const QByteArray &key, const QByteArray &chunk)
    {
        const QMutexLocker lock(&m_mutex);
        m_chunks.insert(key, new QByteArray(chunk), key.size() + chunk.size());
    }

private:
    QMutex m_mutex;
    QCache<QByteArray, QByteArray> m_chunks{mostBytes};
};

ChunkCache &cache()
{
    static ChunkCache chunks;
    return chunks;
}

int append(lua_State *, const void *part, std::size_t size, void *chunk)
{
    static_cast<QByteArray *>(chunk)->append(static_cast<const char *>(part),
                                             static_cast<qsizetype>(size));
    return 0;
}

int load(lua_State *L, const QByteArray &bytes, const char *name, const char *mode)
{
    return luaL_loadbufferx(L, bytes.constData(), static_cast<std::size_t>(bytes.size()), name,
                            mode);
}

/// What \p text is compiled to; empty if it cannot be read.
QByteArray compiled(const QByteArray &text, const char *name)
{
    // In a state of its own: the program's is the same whether it was compiled before or not.
    LuaMemory memory(limits::scriptBytes);
    lua_State *const state = newLuaState(memory);
    QByteArray chunk;
    if (!state)
        return chunk;
    memory.hold(state);
    // With all names and lines: errors tell them.
    if (load(state, text, name, "t") == LUA_OK)
        lua_dump(state, append, &chunk, 0);
    memory.release();
    return chunk;
}

} // namespace

int loadProgram(lua_State *L, const QByteArray &text, const char *name)
{
    const QByteArray key = name + ('\n' + text); // A name of ours has no end of line.
    QByteArray chunk = cache().find(key);
    if (chunk.isEmpty()) {
        chunk = compiled(text, name);
        if (chunk.isEmpty())
            return readProgram(L, text, name); // That says why not.
        cache().keep(key, chunk);
    }
    return load(L, chunk, name, "b");
}

int readProgram(lua_State *L, const QByteArray &text, const char *name)
{
    return load(L, text, name, "t");
}

} // namespace cradle
