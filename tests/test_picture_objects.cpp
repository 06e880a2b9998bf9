// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/picture_objects.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using cradle::Picture;
using cradle::PictureObjects;

class TestPictureObjects : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void readsPictureInFolder();
    void refusesPictures_data();
    void refusesPictures();

private:
    QTemporaryDir m_folder;
    const QString m_lab = m_folder.filePath(QStringLiteral("lab"));
};

void TestPictureObjects::initTestCase()
{
    const auto write = [](const QString &path, const QByteArray &content) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    };
    QVERIFY(QDir().mkpath(m_lab + QLatin1String("/pictures")));
    const QByteArray open = "<svg xmlns='http://www.w3.org/2000/svg' width='600' height='60'>";
    const QByteArray box = open + "<rect width='600' height='60' fill='currentColor'/></svg>";
    const QString outside = m_folder.filePath(QStringLiteral("outside.svg"));
    write(m_lab + QLatin1String("/box.svg"), box);
    write(m_lab + QLatin1String("/pictures/box.svg"), box);
    write(outside, box);
    write(m_lab + QLatin1String("/reads.svg"),
          open + "<image href='/etc/logo.png' width='9' height='9'/></svg>");
    write(m_lab + QLatin1String("/broken.png"), "no picture");
    write(m_lab + QLatin1String("/wide.svg"),
          "<svg xmlns='http://www.w3.org/2000/svg' width='1e9' height='9'></svg>");
    write(m_lab + QLatin1String("/tall.svg"),
          "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='1e9'></svg>");
    // A few hundred bytes that ask for gigabytes, and that a program must not unpack to know it.
    write(m_lab + QLatin1String("/bomb.gif"),
          QByteArray::fromHex(
              "474946383961ffffffff800000000000ffffff2c00000000ffffffff0002024401003b"));
    QVERIFY(QFile::link(outside, m_lab + QLatin1String("/link.svg")));
}

void TestPictureObjects::readsPictureInFolder()
{
    for (const char *name : {"box.svg", "pictures/box.svg", "pictures/b%6Fx.svg"}) {
        Picture picture;
        QCOMPARE(PictureObjects::read(m_lab, QLatin1String(name), picture), QString());
        QCOMPARE(picture.size, QSizeF(600, 60));
        QVERIFY(!picture.svg.isEmpty());
    }
}

void TestPictureObjects::refusesPictures_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("parent") << "../outside.svg"
                            << "in the folder";
    QTest::newRow("encoded parent") << "%2e%2e/outside.svg"
                                    << "in the folder";
    QTest::newRow("parent midway") << "pictures/../box.svg"
                                   << "in the folder";
    QTest::newRow("absolute") << m_folder.filePath(QStringLiteral("outside.svg"))
                              << "in the folder";
    QTest::newRow("resource") << ":/mathjax/version"
                              << "in the folder";
    QTest::newRow("symbolic link") << "link.svg"
                                   << "in the folder";
    QTest::newRow("web") << "https://example.org/a.png"
                         << "elsewhere";
    QTest::newRow("host") << "//example.org/a.png"
                          << "elsewhere";
    QTest::newRow("file URL") << "file:///etc/logo.png"
                              << "elsewhere";
    QTest::newRow("missing") << "none.svg"
                             << "no picture";
    QTest::newRow("no picture") << "broken.png"
                                << "cannot be read";
    for (const char *name : {"wide.svg", "tall.svg", "bomb.gif"})
        QTest::newRow(name) << name << "too large";
    QTest::newRow("reads others") << "reads.svg"
                                  << "another file";
}

void TestPictureObjects::refusesPictures()
{
    QFETCH(QString, name);
    QFETCH(QString, reason);
    Picture picture;
    const QString refusal = PictureObjects::read(m_lab, name, picture);
    QVERIFY2(refusal.contains(reason), qPrintable(refusal));
}

QTEST_MAIN(TestPictureObjects)
#include "test_picture_objects.moc"
