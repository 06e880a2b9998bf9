// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/program_text.h"

#include "tasks/script/script_limits.h"

#include <QTest>

using namespace cradle;

/// What bytes are a program, and what those that are none were meant to be.
class TestProgramText final : public QObject
{
    Q_OBJECT
private slots:
    void takesUtf8();
    void saysWhatElseItIs_data();
    void saysWhatElseItIs();
    void noughtsTellUtf16_data();
    void noughtsTellUtf16();
    void tooLongIsNoProgram();
};

void TestProgramText::takesUtf8()
{
    const auto text = programFrom("-- Größe\n", QStringLiteral("f.lua"));
    QVERIFY(text);
    QCOMPARE(*text, QString::fromUtf8("-- Größe\n"));
    QVERIFY(programFrom({}, {}));
    QVERIFY(programFrom(QByteArray(limits::sourceBytes, ' '), {}));
}

void TestProgramText::saysWhatElseItIs_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("converted");
    const QString meant = QString::fromUtf8("x = 1 -- Größe\n");
    const auto *units = reinterpret_cast<const char *>(meant.utf16());
    const QByteArray little(units, meant.size() * 2);
    QByteArray big;
    for (qsizetype i = 0; i < little.size(); i += 2)
        big.append(little[i + 1]).append(little[i]);
    QTest::newRow("UTF-16 with a mark") << "\xff\xfe" + little << "UTF-16" << 0 << meant;
    QTest::newRow("UTF-16 without") << little << "UTF-16" << 0 << meant;
    QTest::newRow("the other UTF-16") << "\xfe\xff" + big << "UTF-16" << 0 << meant;
    QTest::newRow("the other without") << big << "UTF-16" << 0 << meant;
    QTest::newRow("Latin-1") << meant.toLatin1() << "UTF-8" << 1 << meant;
    QTest::newRow("a NUL") << QByteArray("x = 1\ny = \0 2\n", 14) << "UTF-8" << 2
                           << QStringLiteral("x = 1\ny =  2\n");
}

void TestProgramText::saysWhatElseItIs()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QString, words);
    QFETCH(int, line);
    QFETCH(QString, converted);
    const auto text = programFrom(bytes, QStringLiteral("f.lua"));
    QVERIFY(!text);
    QVERIFY2(text.error().message.contains(words), qPrintable(text.error().message));
    QCOMPARE(text.error().line, line);
    QCOMPARE(text.error().file, QStringLiteral("f.lua"));
    QCOMPARE(convertedProgram(bytes), std::optional(converted));
}

void TestProgramText::noughtsTellUtf16_data()
{
    QTest::addColumn<int>("even"); // noughts at places that are so, of 64 bytes
    QTest::addColumn<int>("odd");
    QTest::addColumn<bool>("isUtf16");
    QTest::newRow("a quarter, odd") << 0 << 16 << false;
    QTest::newRow("more, odd") << 0 << 17 << true;
    QTest::newRow("a quarter, even") << 16 << 0 << false;
    QTest::newRow("more, even") << 17 << 0 << true;
    QTest::newRow("few among the others") << 1 << 17 << true;
    QTest::newRow("an eighth among the others") << 2 << 17 << false;
    QTest::newRow("few among the others, even") << 17 << 1 << true;
    QTest::newRow("an eighth among the others, even") << 17 << 2 << false;
    QTest::newRow("both") << 20 << 20 << false;
}

void TestProgramText::noughtsTellUtf16()
{
    QFETCH(int, even);
    QFETCH(int, odd);
    QByteArray bytes(64, 'x');
    for (int i = 0; i < even; ++i)
        bytes[2 * i] = '\0';
    for (int i = 0; i < odd; ++i)
        bytes[2 * i + 1] = '\0';
    const auto text = programFrom(bytes, QStringLiteral("f.lua"));
    QVERIFY(!text);
    QTEST(text.error().message.contains(QLatin1String("UTF-16")), "isUtf16");
}

void TestProgramText::tooLongIsNoProgram()
{
    const QByteArray bytes(limits::sourceBytes + 1, 'x');
    const auto text = programFrom(bytes, QStringLiteral("f.lua"));
    QVERIFY(!text);
    QVERIFY2(text.error().message.contains(QLatin1String("too long")),
             qPrintable(text.error().message));
    QVERIFY(!convertedProgram(bytes));
    // As text it would be longer still.
    QVERIFY(!convertedProgram(QByteArray(limits::sourceBytes, '\xe4')));
}

QTEST_APPLESS_MAIN(TestProgramText)
#include "test_program_text.moc"
