// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/spoken_locale.h"
#include "tests/text.h"

#include <QTest>

using namespace cradle;

/// Numbers in texts are written with the digits that programs have, whatever the language.
class TestSpokenLocale : public QObject
{
    Q_OBJECT
private slots:
    void digitsAreThoseOfPrograms_data();
    void digitsAreThoseOfPrograms();
    void pagesRunInTheDirectionOfTheLanguage();
};

void TestSpokenLocale::digitsAreThoseOfPrograms_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("number");
    QTest::newRow("English") << text("en") << text("1.5");
    QTest::newRow("German") << text("de") << text("1,5");
    QTest::newRow("Arabic, of whom some have them, some of these a point")
        << text("ar") << text("1.5");
    QTest::newRow("Urdu") << text("ur") << text("1.5");
    QTest::newRow("Pashto, which has its own alone") << text("ps") << text("۱٫۵");
}

void TestSpokenLocale::digitsAreThoseOfPrograms()
{
    QFETCH(QString, language);
    const QLocale locale = spokenLocale(language);
    QTEST(locale.toString(1.5, 'f', 1), "number");
    QCOMPARE(locale.language(), QLocale(language).language());
}

void TestSpokenLocale::pagesRunInTheDirectionOfTheLanguage()
{
    QCOMPARE(directionAttribute(text("en")), QString());
    QCOMPARE(directionAttribute(text("ar")), text(" dir=\"rtl\""));
    QCOMPARE(spokenList({text("a"), text("b")}), text("a, b"));
}

QTEST_GUILESS_MAIN(TestSpokenLocale)
#include "test_spoken_locale.moc"
