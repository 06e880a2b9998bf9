// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_files/lab_files.h"

#include <QCoreApplication>
#include <QtEndian>

namespace cradle {

namespace {

struct PictureText {
    Q_DECLARE_TR_FUNCTIONS(LabFiles)
};

struct PictureSize {
    qint64 width = 0;
    qint64 height = 0;
};

template <typename T>
qint64 big(const QByteArray &bytes, qsizetype at)
{
    return at + qsizetype(sizeof(T)) <= bytes.size()
               ? qint64{qFromBigEndian<T>(bytes.constData() + at)}
               : 0;
}

template <typename T>
qint64 little(const QByteArray &bytes, qsizetype at)
{
    return at + qsizetype(sizeof(T)) <= bytes.size()
               ? qint64{qFromLittleEndian<T>(bytes.constData() + at)}
               : 0;
}

/// The size stands in the first segment SOFn (ITU T.81, B.2.2).
PictureSize jpegSize(const QByteArray &bytes)
{
    qsizetype at = 2;
    while (at + 9 <= bytes.size() && static_cast<uchar>(bytes[at]) == 0xff) {
        const auto marker = static_cast<uchar>(bytes[at + 1]);
        const bool isFrame =
            marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
        if (isFrame)
            return {big<quint16>(bytes, at + 7), big<quint16>(bytes, at + 5)};
        at += 2 + big<quint16>(bytes, at + 2);
    }
    return {};
}

/// As the header of a PNG, JPEG, GIF or BMP says; zero for anything else.
PictureSize sizeOf(const QByteArray &bytes)
{
    if (bytes.startsWith("\x89PNG\r\n\x1a\n"))
        return {big<quint32>(bytes, 16), big<quint32>(bytes, 20)};
    if (bytes.startsWith("\xff\xd8"))
        return jpegSize(bytes);
    if (bytes.startsWith("GIF87a") || bytes.startsWith("GIF89a"))
        return {little<quint16>(bytes, 6), little<quint16>(bytes, 8)};
    // Two letters alone may begin a text, too; four zeros may not.
    if (bytes.startsWith("BM") && bytes.size() > 26 && little<quint32>(bytes, 6) == 0)
        return {qAbs(little<qint32>(bytes, 18)), qAbs(little<qint32>(bytes, 22))};
    return {};
}

} // namespace

QString faultOfPicture(const QByteArray &content)
{
    const PictureSize size = sizeOf(content);
    // Both are below 2³², so that the product of two halves cannot overflow.
    if (size.width / 2 * (size.height / 2) <= limits::labPixels / 4)
        return {};
    return PictureText::tr("the picture has %1 × %2 pixels; at most %3 million are right")
        .arg(size.width)
        .arg(size.height)
        .arg(limits::labPixels / 1'000'000);
}

} // namespace cradle
