// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/other_values.h"

#include <QTest>

using namespace cradle;

/// Values in which a mistake differs from its solution beside what it is about.
class TestOtherValues : public QObject
{
    Q_OBJECT
private slots:
    void valueThatWasNotFollowedIsFound();
    void mistakesAreNoOtherValues_data();
    void mistakesAreNoOtherValues();
};

namespace {

const QString solution = QStringLiteral("function on_load()\n  restitution = 0.8\n"
                                        "  circle1.position = vec(-2, 2)\n"
                                        "  circle2.position = vec(2, -2)\n"
                                        "  circle2.velocity = vec(0, 2)\nend\n\n"
                                        "function on_update(dt)\n  walls(circle1)\n"
                                        "  walls(circle2)\nend\n");

} // namespace

/// The solution was given e = 0.8, and the mistake, which is about walls, still has 0.5.
void TestOtherValues::valueThatWasNotFollowedIsFound()
{
    QString program = QStringLiteral("-- Circle 2 knows no walls\n\n") + solution;
    program.remove(QStringLiteral("  walls(circle2)\n"))
        .replace(QStringLiteral("= 0.8"), QStringLiteral("= 0.5  -- as before"));
    const std::vector<OtherValue> others = otherValues(program, solution);
    QCOMPARE(others.size(), std::size_t{1});
    QCOMPARE(others[0].here, QStringLiteral("restitution = 0.5"));
    QCOMPARE(others[0].solution, QStringLiteral("restitution = 0.8"));
}

void TestOtherValues::mistakesAreNoOtherValues_data()
{
    QTest::addColumn<QString>("program");
    const auto row = [](const char *name, const QString &from, const QString &to) {
        QTest::newRow(name) << QStringLiteral("-- One\n\n") + QString(solution).replace(from, to);
    };
    row("a number", QStringLiteral("0.8"), QStringLiteral("0.5"));
    row("a line less", QStringLiteral("  walls(circle2)\n"), QString());
    row("a comment more", QStringLiteral("  walls(circle2)\n"),
        QStringLiteral("  -- both\n  walls(circle2)\n"));
    row("the numbers of several lines",
        QStringLiteral("vec(-2, 2)\n  circle2.position = vec(2, -2)\n  circle2.velocity = vec(0, "
                       "2)\n"),
        QStringLiteral("vec(-2, 2.3)\n  circle2.position = vec(2, 2)\n  circle2.velocity = vec(0, "
                       "0)\n"));
    QTest::newRow("nothing") << solution;
    // A number with a sign and one without are numbers both.
    QTest::newRow("numbers in two places")
        << QString(solution)
               .replace(QStringLiteral("vec(2, -2)"), QStringLiteral("vec(2, 2)"))
               .replace(QStringLiteral("0.8"), QStringLiteral("-0.5"));
}

void TestOtherValues::mistakesAreNoOtherValues()
{
    QFETCH(const QString, program);
    const std::vector<OtherValue> others = otherValues(program, solution);
    QVERIFY2(others.empty(), others.empty() ? "" : qPrintable(others[0].here));
}

QTEST_MAIN(TestOtherValues)
#include "test_other_values.moc"
