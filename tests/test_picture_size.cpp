// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_files/lab_files.h"

#include <QTest>
#include <QtEndian>

using namespace cradle;

/// How large a picture is, by its header alone: of each format just small enough, and a little too
/// large in either direction.
class TestPictureSize : public QObject
{
    Q_OBJECT
private slots:
    void isReadFromTheHeader_data();
    void isReadFromTheHeader();
    void whatHasNoSizeIsNotRefused_data();
    void whatHasNoSizeIsNotRefused();
};

namespace {

template <typename T>
QByteArray big(T number)
{
    QByteArray bytes(sizeof(T), '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

template <typename T>
QByteArray little(T number)
{
    QByteArray bytes(sizeof(T), '\0');
    qToLittleEndian(number, bytes.data());
    return bytes;
}

QByteArray png(qint64 width, qint64 height)
{
    return QByteArray("\x89PNG\r\n\x1a\n") + big(quint32(13)) + "IHDR" + big(quint32(width))
           + big(quint32(height)) + QByteArray::fromHex("0806000000");
}

/// A segment of a JPEG, of that many bytes behind its marker.
QByteArray segment(uchar marker, quint16 length)
{
    return '\xff' + QByteArray(1, char(marker)) + big(length) + QByteArray(length - 2, '\x01');
}

QByteArray frame(uchar marker, qint64 width, qint64 height)
{
    return '\xff' + QByteArray(1, char(marker)) + big(quint16(17)) + '\x08' + big(quint16(height))
           + big(quint16(width));
}

QByteArray jpeg(qint64 width, qint64 height, uchar marker = 0xc0)
{
    return "\xff\xd8" + segment(0xe0, 16) + segment(0xdb, 67) + frame(marker, width, height);
}

QByteArray gif(const char *version, qint64 width, qint64 height)
{
    return version + little(quint16(width)) + little(quint16(height)) + QByteArray(3, '\x07');
}

QByteArray bmp(qint64 width, qint64 height)
{
    return "BM" + little(quint32(70)) + little(quint32(0)) + little(quint32(54))
           + little(quint32(40)) + little(qint32(width)) + little(qint32(height))
           + little(quint16(1));
}

/// What lies beside or between the markers of frames.
constexpr uchar noFrames[] = {0xbf, 0xc4, 0xc8, 0xcc, 0xd0};

} // namespace

void TestPictureSize::isReadFromTheHeader_data()
{
    using Make = std::function<QByteArray(qint64, qint64)>;
    QTest::addColumn<Make>("make");
    QTest::newRow("png") << Make(png);
    QTest::newRow("gif of 1987") << Make([](qint64 w, qint64 h) { return gif("GIF87a", w, h); });
    QTest::newRow("gif of 1989") << Make([](qint64 w, qint64 h) { return gif("GIF89a", w, h); });
    QTest::newRow("bmp") << Make(bmp);
    QTest::newRow("bmp from the top down") << Make([](qint64 w, qint64 h) { return bmp(w, -h); });
    QTest::newRow("jpeg whose frame is first")
        << Make([](qint64 w, qint64 h) { return "\xff\xd8" + frame(0xc0, w, h); });
    for (int marker = 0xc0; marker <= 0xcf; ++marker) {
        const auto sof = static_cast<uchar>(marker);
        // Tables and what is reserved lie between.
        if (marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
            QTest::addRow("jpeg, frame %x", marker)
                << Make([sof](qint64 w, qint64 h) { return jpeg(w, h, sof); });
    }
    for (const uchar table : noFrames)
        QTest::addRow("jpeg, segment %x before the frame", table)
            << Make([table](qint64 w, qint64 h) {
                   return "\xff\xd8" + segment(table, 12) + frame(0xc2, w, h);
               });
}

void TestPictureSize::isReadFromTheHeader()
{
    QFETCH(std::function<QByteArray(qint64, qint64)>, make);
    // At most 32 million pixels.
    QCOMPARE(faultOfPicture(make(8000, 4000)), QString());
    QCOMPARE(faultOfPicture(make(4000, 8000)), QString());
    QCOMPARE(faultOfPicture(make(8002, 4000)),
             QStringLiteral("the picture has 8002 × 4000 pixels; at most 32 million are right"));
    QCOMPARE(faultOfPicture(make(8000, 4002)),
             QStringLiteral("the picture has 8000 × 4002 pixels; at most 32 million are right"));
    QCOMPARE(faultOfPicture(make(300, 32767)), QString());
    QCOMPARE(faultOfPicture(make(32767, 300)), QString());
}

void TestPictureSize::whatHasNoSizeIsNotRefused_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("png cut short") << png(60'000, 60'000).left(23);
    QTest::newRow("gif cut short") << gif("GIF89a", 60'000, 60'000).left(9);
    QTest::newRow("gif of another year") << gif("GIF88a", 60'000, 60'000);
    QTest::newRow("jpeg cut short") << jpeg(60'000, 60'000).chopped(1);
    QTest::newRow("jpeg without a frame") << "\xff\xd8" + segment(0xe0, 16);
    QTest::newRow("jpeg whose scan begins first")
        << "\xff\xd8" + segment(0xe0, 16) + '\x01' + frame(0xc0, 60'000, 60'000);
    QTest::newRow("frame of a jpeg that is none") << frame(0xc0, 60'000, 60'000);
    QTest::newRow("bmp cut short") << bmp(60'000, 60'000).left(26);
    QTest::newRow("text that begins like a BMP")
        << QByteArray("BMX bikes have wheels of 20 inches");
    for (const uchar marker : noFrames)
        QTest::addRow("jpeg, no frame %x", marker) << jpeg(60'000, 60'000, marker);
}

void TestPictureSize::whatHasNoSizeIsNotRefused()
{
    QFETCH(QByteArray, content);
    QCOMPARE(faultOfPicture(content), QString());
}

QTEST_GUILESS_MAIN(TestPictureSize)
#include "test_picture_size.moc"
