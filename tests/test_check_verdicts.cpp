// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_script.h"

#include <QTest>

using namespace cradle;

/// What is taken of the answer of a check in Lua, and what is none.
class TestCheckVerdicts : public QObject
{
    Q_OBJECT
private slots:
    void rightNeedsNoWords();
    void wrongNeedsAMessage_data();
    void wrongNeedsAMessage();
    void whatIsNotGivenIsNotMadeUp();
};

namespace {

ScriptVerdict answer(const QString &body)
{
    Preset preset;
    preset.circles.resize(1);
    return runCheckScript(QStringLiteral("function check(run)\n%1\nend").arg(body),
                          observe({QStringLiteral("preset"), preset, 0.5}));
}

} // namespace

void TestCheckVerdicts::rightNeedsNoWords()
{
    const ScriptVerdict verdict = answer(QStringLiteral("return true"));
    QVERIFY(!verdict.error && verdict.passed);
}

void TestCheckVerdicts::wrongNeedsAMessage_data()
{
    QTest::addColumn<QString>("body");
    QTest::newRow("none") << QStringLiteral("return false");
    QTest::newRow("an empty one") << QStringLiteral("return false, ''");
    QTest::newRow("a table") << QStringLiteral("return false, {}");
}

void TestCheckVerdicts::wrongNeedsAMessage()
{
    QFETCH(QString, body);
    const ScriptVerdict verdict = answer(body);
    QVERIFY(verdict.error);
    QVERIFY2(verdict.error->message.contains(QStringLiteral("without a message")),
             qPrintable(verdict.error->message));
}

void TestCheckVerdicts::whatIsNotGivenIsNotMadeUp()
{
    const ScriptVerdict verdict =
        answer(QStringLiteral("return false, 'x', {unit = '%1'}").arg(QString(30, u'u')));
    QVERIFY(!verdict.error && !verdict.passed);
    QVERIFY(!verdict.time && !verdict.expected && !verdict.observed);
    QCOMPARE(verdict.unit, QString(20, u'u'));
    QVERIFY(answer(QStringLiteral("return false, 'x'")).unit.isEmpty());
}

QTEST_GUILESS_MAIN(TestCheckVerdicts)
#include "test_check_verdicts.moc"
