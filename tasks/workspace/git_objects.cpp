// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/git_objects.h"

#include <QtEndian>

#include <zlib.h>

#include <algorithm>

namespace cradle {

// The formats: gitformat-pack(5), gitrepository-layout(5), and "Git Objects" of the book Pro Git.

namespace {

constexpr qsizetype idBytes = 20;
constexpr qsizetype mostObject = 1024 * 1024; ///< of a commit or a tree
constexpr qint64 mostUnpacked = 64 * 1024 * 1024;
constexpr int mostDepth = 60; ///< of deltas upon deltas; git itself makes 50
constexpr int mostParents = 16;

QByteArray idFrom(const QByteArray &hex)
{
    const QByteArray id = QByteArray::fromHex(hex);
    return hex.size() == 2 * idBytes && id.size() == idBytes ? id : QByteArray();
}

quint32 numberAt(const QByteArray &bytes, qsizetype place)
{
    return qFromBigEndian<quint32>(bytes.constData() + place);
}

// Where the parts of an index of version 2 are.
constexpr qsizetype fanOut = 8;
constexpr qsizetype firstId = fanOut + 256 * 4;

/// A number of seven bits a byte, the lowest first, as a delta begins with.
std::optional<qsizetype> sizeFrom(const QByteArray &delta, qsizetype &at)
{
    qsizetype size = 0;
    for (int shift = 0; at < delta.size() && shift < 28; shift += 7) {
        const auto byte = static_cast<unsigned char>(delta[at++]);
        size |= static_cast<qsizetype>(byte & 0x7f) << shift;
        if (!(byte & 0x80))
            return size;
    }
    return std::nullopt;
}

/// \p base with the changes of \p delta; empty if they do not fit.
QByteArray changed(const QByteArray &base, const QByteArray &delta)
{
    qsizetype at = 0;
    const auto from = sizeFrom(delta, at);
    const auto to = sizeFrom(delta, at);
    if (!from || !to || *from != base.size() || *to > mostObject)
        return {};
    QByteArray made;
    while (at < delta.size()) {
        const auto order = static_cast<unsigned char>(delta[at++]);
        if (!(order & 0x80)) { // so many bytes of its own
            if (order == 0 || at + order > delta.size())
                return {};
            made += delta.mid(at, order);
            at += order;
        } else { // a part of the base
            qsizetype part[2] = {0, 0};
            for (int bit = 0; bit < 7; ++bit) {
                if (!(order >> bit & 1))
                    continue;
                if (at >= delta.size())
                    return {};
                const auto byte = static_cast<unsigned char>(delta[at++]);
                part[bit < 4 ? 0 : 1] |= static_cast<qsizetype>(byte)
                                         << 8 * (bit < 4 ? bit : bit - 4);
            }
            const qsizetype size = part[1] == 0 ? 0x10000 : part[1];
            if (part[0] > base.size() || size > base.size() - part[0])
                return {};
            made += base.mid(part[0], size);
        }
        if (made.size() > *to)
            return {};
    }
    return made.size() == *to ? made : QByteArray();
}

} // namespace

GitObjects::GitObjects(const RepositoryFiles &files)
    : m_files(files)
    , m_left(mostUnpacked)
{
    for (const QByteArray &line : files.value(QStringLiteral("packed-refs")).split('\n')) {
        if (const QByteArray id = idFrom(line.left(2 * idBytes)); !id.isEmpty())
            m_references.insert(QString::fromUtf8(line.mid(2 * idBytes + 1)), id);
    }
    for (auto it = files.begin(); it != files.end(); ++it) {
        if (it.key().endsWith(QLatin1String(".idx")))
            addPack(*it, files.value(it.key().chopped(3) + QStringLiteral("pack")));
    }
}

void GitObjects::addPack(const QByteArray &index, const QByteArray &data)
{
    if (index.size() < firstId || !index.startsWith(QByteArray("\377tOc\0\0\0\2", 8)))
        return;
    const quint32 count = numberAt(index, fanOut + 255 * 4);
    if (index.size() < firstId + qsizetype(count) * (idBytes + 8) || !data.startsWith("PACK"))
        return;
    m_packs.push_back({index, data, count});
}

std::optional<qsizetype> GitObjects::Pack::placeOf(const QByteArray &id) const
{
    const auto first = static_cast<unsigned char>(id[0]);
    quint32 low = first == 0 ? 0 : numberAt(index, fanOut + (first - 1) * 4);
    quint32 high = std::min(count, numberAt(index, fanOut + first * 4));
    while (low < high) {
        const quint32 middle = low + (high - low) / 2;
        const auto order =
            QByteArray::fromRawData(index.constData() + firstId + middle * idBytes, idBytes)
                .compare(id);
        if (order == 0) {
            const auto place =
                numberAt(index, firstId + qsizetype(count) * (idBytes + 4) + qsizetype(middle) * 4);
            return qsizetype(place) < data.size() ? std::optional<qsizetype>(place) : std::nullopt;
        }
        (order < 0 ? low : high) = order < 0 ? middle + 1 : middle;
    }
    return std::nullopt;
}

QByteArray GitObjects::reference(const QString &name) const
{
    QString wanted = name;
    for (int links = 0; links < 5; ++links) {
        const QByteArray text = m_files.value(wanted).trimmed();
        if (!text.startsWith("ref: "))
            return text.isEmpty() ? m_references.value(wanted) : idFrom(text);
        wanted = QString::fromUtf8(text.mid(5));
    }
    return {};
}

/// \return empty if it is broken, or larger than \p most
QByteArray GitObjects::unpacked(const char *data, qsizetype size, qsizetype most)
{
    const qsizetype limit = std::min(most, mostObject) + 1;
    QByteArray made(std::min(limit, 4 * size + 1024), Qt::Uninitialized);
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK)
        return {};
    // It only reads there.
    stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(data));
    stream.avail_in = static_cast<uInt>(size);
    qsizetype got = 0;
    int end = Z_OK;
    while (true) {
        stream.next_out = reinterpret_cast<Bytef *>(made.data()) + got;
        stream.avail_out = static_cast<uInt>(made.size() - got);
        end = inflate(&stream, Z_NO_FLUSH);
        got = made.size() - static_cast<qsizetype>(stream.avail_out);
        if (end != Z_OK || stream.avail_out > 0 || made.size() == limit)
            break;
        made.resize(std::min(limit, 2 * made.size()));
    }
    inflateEnd(&stream);
    m_left -= got;
    if (end != Z_STREAM_END || got == limit || m_left < 0)
        return {};
    made.truncate(got);
    return made;
}

std::optional<GitObjects::Object> GitObjects::looseObject(const QByteArray &file)
{
    const QByteArray all = unpacked(file.constData(), file.size(), mostObject);
    const qsizetype end = all.indexOf('\0');
    if (end < 0)
        return std::nullopt;
    const int kind = all.startsWith("commit ") ? CommitKind
                     : all.startsWith("tree ") ? TreeKind
                                               : NoKind;
    return Object{kind, all.mid(end + 1)};
}

std::optional<GitObjects::Object> GitObjects::packedObject(const Pack &pack, qsizetype place,
                                                           int depth)
{
    const QByteArray &data = pack.data;
    qsizetype at = place;
    const auto next = [&] { return static_cast<unsigned char>(data[at++]); };
    if (at >= data.size() || depth > mostDepth)
        return std::nullopt;
    unsigned char byte = next();
    const int kind = byte >> 4 & 7;
    qsizetype size = byte & 15;
    for (int shift = 4; byte & 0x80; shift += 7) {
        if (at >= data.size() || shift > 25)
            return std::nullopt;
        byte = next();
        size |= static_cast<qsizetype>(byte & 0x7f) << shift;
    }
    std::optional<Object> base;
    if (kind == OffsetDelta) {
        qsizetype back = 0;
        do {
            if (at >= data.size() || back > data.size())
                return std::nullopt;
            byte = next();
            back = (back << 7) + (byte & 0x7f) + (byte & 0x80 ? 1 : 0);
        } while (byte & 0x80);
        if (back <= 0 || back > place)
            return std::nullopt;
        base = packedObject(pack, place - back, depth + 1);
    } else if (kind == IdDelta) {
        base = object(data.mid(at, idBytes), depth + 1);
        at += idBytes;
    }
    if (at >= data.size() || size > mostObject
        || ((kind == OffsetDelta || kind == IdDelta) && !base))
        return std::nullopt;
    const QByteArray content = unpacked(data.constData() + at, data.size() - at, size);
    if (content.size() != size)
        return std::nullopt;
    if (!base)
        return Object{kind, content};
    return Object{base->kind, changed(base->content, content)};
}

std::optional<GitObjects::Object> GitObjects::object(const QByteArray &id, int depth)
{
    if (id.size() != idBytes || m_left < 0)
        return std::nullopt;
    const QString hex = QString::fromLatin1(id.toHex());
    const auto loose =
        m_files.constFind(QStringLiteral("objects/%1/%2").arg(hex.left(2), hex.mid(2)));
    if (loose != m_files.constEnd())
        return looseObject(*loose);
    for (const Pack &pack : m_packs) {
        if (const auto place = pack.placeOf(id))
            return packedObject(pack, *place, depth);
    }
    return std::nullopt;
}

std::optional<GitObjects::Commit> GitObjects::commit(const QByteArray &id)
{
    const auto found = object(id);
    if (!found || found->kind != CommitKind)
        return std::nullopt;
    Commit commit;
    const qsizetype end = found->content.indexOf("\n\n");
    for (const QByteArray &line : found->content.left(end).split('\n')) {
        if (line.startsWith("tree "))
            commit.tree = idFrom(line.mid(5));
        else if (line.startsWith("parent ") && commit.parents.size() < mostParents)
            commit.parents.push_back(idFrom(line.mid(7)));
        else if (line.startsWith("committer ")) // NAME <ADDRESS> SECONDS ZONE
            commit.time = line.mid(line.lastIndexOf('>') + 1).trimmed().split(' ')[0].toLongLong();
    }
    commit.message = end < 0 ? QByteArray() : found->content.mid(end + 2);
    return commit;
}

QMap<QByteArray, QByteArray> GitObjects::tree(const QByteArray &id)
{
    QMap<QByteArray, QByteArray> entries;
    const auto found = object(id);
    if (!found || found->kind != TreeKind)
        return entries;
    const QByteArray &content = found->content;
    for (qsizetype at = 0; at < content.size();) { // MODE NAME, a zero, and 20 bytes
        const qsizetype space = content.indexOf(' ', at);
        const qsizetype end = content.indexOf('\0', at);
        if (space < 0 || end < space || end + idBytes >= content.size())
            break;
        entries.insert(content.mid(space + 1, end - space - 1), content.mid(end + 1, idBytes));
        at = end + 1 + idBytes;
    }
    return entries;
}

} // namespace cradle
