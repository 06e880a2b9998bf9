// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/icons.h"
#include "views/theme.h"

#include "tests/wcag.h"

#include <QApplication>
#include <QDir>
#include <QTest>

using namespace cradle;

/// Icons are drawn in the colours of the theme, and can be seen.
class TestIcons final : public QObject
{
    Q_OBJECT
private slots:
    void everyIconIsDrawnInTheTextColour();
    void paintedAsTheyAreIconsCanBeSeen_data();
    void paintedAsTheyAreIconsCanBeSeen();
    void unknownIconIsNull();
};

void TestIcons::everyIconIsDrawnInTheTextColour()
{
    const QStringList files = QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")});
    QVERIFY(files.size() >= 22);
    // These are of the style sheet, which cannot tint.
    const QStringList untinted{QStringLiteral("chevron-down"), QStringLiteral("chevron-up"),
                               QStringLiteral("close"),        QStringLiteral("float"),
                               QStringLiteral("tick-dark"),    QStringLiteral("tick-light")};
    for (const QString &file : files) {
        const QString name = file.chopped(4);
        const QIcon drawn = icon(name);
        QVERIFY2(!drawn.isNull(), qPrintable(name));
        if (untinted.contains(name))
            continue;
        for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
            applyTheme(choice);
            const QImage image = drawn.pixmap(48, 48).toImage();
            int inked = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    if (image.pixelColor(x, y).alpha() < 255)
                        continue;
                    ++inked;
                    QCOMPARE(image.pixelColor(x, y), theme().text);
                }
            }
            QVERIFY2(inked > 20, qPrintable(name));
        }
    }
}

void TestIcons::paintedAsTheyAreIconsCanBeSeen_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"chevron-down", "close", "float"})
        QTest::addRow("%s", name) << QString::fromLatin1(name);
}

/// What the style sheet cannot tint is seen on the panels of both themes.
void TestIcons::paintedAsTheyAreIconsCanBeSeen()
{
    QFETCH(QString, name);
    applyTheme(ThemeChoice::Light);
    QVERIFY(qApp->styleSheet().contains(QStringLiteral("url(:/icons/%1.svg)").arg(name)));
    const QImage image = icon(name).pixmap(48, 48).toImage();
    int inked = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            if (pixel.alpha() < 255)
                continue;
            ++inked;
            QVERIFY(wcag(pixel, Theme::lightTheme().panel) >= 3.0);
            QVERIFY(wcag(pixel, Theme::darkTheme().panel) >= 3.0);
        }
    }
    QVERIFY(inked > 20);
}

void TestIcons::unknownIconIsNull()
{
    QVERIFY(icon(u"no such icon").isNull());
}

QTEST_MAIN(TestIcons)
#include "test_icons.moc"
