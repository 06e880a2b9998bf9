// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QtEndian>

#include <array>
#include <optional>

namespace cradle::authoring {

/// Writes zip archives byte by byte, also such as no decent program writes.
class ZipMaker
{
public:
    struct Entry {
        QByteArray name{};
        QByteArray content{};
        quint32 mode = 0100644; ///< of Unix, with the kind of the file
        quint16 flags = 0;      ///< general purpose bits
        quint16 method = 0;     ///< 0: stored; 8 with \c deflate
        bool deflate = false;
        quint8 system = 3; ///< that made it: 3 is Unix, 0 MS-DOS, whose attributes are no modes
        std::optional<quint32> crc{};
        std::optional<quint32> declaredSize{};
        std::optional<quint32> declaredPacked{};
    };

    ZipMaker &add(const Entry &entry)
    {
        const QByteArray packed = entry.deflate ? deflated(entry.content) : entry.content;
        const quint16 method = entry.deflate ? quint16{8} : entry.method;
        const QByteArray both = number<quint16>(entry.flags) + number(method)
                                + number<quint32>(0x00210000) // 1980-01-01
                                + number(entry.crc.value_or(crcOf(entry.content)))
                                + number(entry.declaredPacked.value_or(quint32(packed.size())))
                                + number(entry.declaredSize.value_or(quint32(entry.content.size())))
                                + number(quint16(entry.name.size())) + number<quint16>(0);
        m_directory += "PK\x01\x02" + number<quint16>(quint16(entry.system << 8 | 20))
                       + number<quint16>(20) + both + number<quint16>(0) + number<quint16>(0)
                       + number<quint16>(0) + number(entry.mode << 16)
                       + number(quint32(m_files.size())) + entry.name;
        m_files += "PK\x03\x04" + number<quint16>(20) + both + entry.name + packed;
        ++m_count;
        return *this;
    }

    /// The entries of another one after its own.
    ZipMaker &add(const ZipMaker &other)
    {
        QByteArray directory = other.m_directory;
        // Each place in the directory counts from the beginning of all files.
        for (qsizetype at = 0; at < directory.size();) {
            const auto offset = qFromLittleEndian<quint32>(directory.constData() + at + 42);
            directory.replace(at + 42, 4, number(quint32(offset + m_files.size())));
            at += 46 + qFromLittleEndian<quint16>(directory.constData() + at + 28);
        }
        m_directory += directory;
        m_files += other.m_files;
        m_count += other.m_count;
        return *this;
    }

    [[nodiscard]] QByteArray toBytes() const
    {
        return m_files + m_directory + "PK\x05\x06" + number<quint32>(0) + number(quint16(m_count))
               + number(quint16(m_count)) + number(quint32(m_directory.size()))
               + number(quint32(m_files.size())) + number<quint16>(0);
    }

private:
    template <typename T>
    static QByteArray number(T value)
    {
        QByteArray bytes(sizeof(T), '\0');
        qToLittleEndian(value, bytes.data());
        return bytes;
    }

    static quint32 crcOf(const QByteArray &bytes)
    {
        static const std::array<quint32, 256> table = [] {
            std::array<quint32, 256> entries{};
            for (quint32 i = 0; i < 256; ++i) {
                quint32 crc = i;
                for (int bit = 0; bit < 8; ++bit)
                    crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
                entries[i] = crc;
            }
            return entries;
        }();
        quint32 crc = 0xffffffff;
        for (const char byte : bytes)
            crc = (crc >> 8) ^ table[(crc ^ static_cast<uchar>(byte)) & 0xff];
        return ~crc;
    }

    /// qCompress() has four bytes of its own and the frame of zlib around the raw stream.
    static QByteArray deflated(const QByteArray &bytes)
    {
        const QByteArray framed = qCompress(bytes, 9);
        return framed.mid(6, framed.size() - 10);
    }

    QByteArray m_files{};
    QByteArray m_directory{};
    int m_count = 0;
};

} // namespace cradle::authoring
