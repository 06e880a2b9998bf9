// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/line_diff.h"

#include <QStringList>
#include <QTest>

#include <rapidcheck.h>

using namespace cradle;

/// What has changed between two programs.
class TestLineDiff final : public QObject
{
    Q_OBJECT
private slots:
    void tellsFewestChanges_data();
    void tellsFewestChanges();
    void givesBothTextsBack();
    void textsWithNothingInCommonAreTold();
    void shortestWayIsLookedForUpToABound();
    void lastLineNeedsNoEnd();
    void hunksHaveLinesAround();
};

namespace {

/// "-a+b c": a removed, b added, c the same.
QString shortOf(const std::vector<DiffLine> &diff)
{
    QString text;
    for (const DiffLine &line : diff) {
        text += line.kind == DiffLine::Kind::Same      ? QLatin1Char(' ')
                : line.kind == DiffLine::Kind::Removed ? QLatin1Char('-')
                                                       : QLatin1Char('+');
        text += line.text;
    }
    return text;
}

QString spreadOut(const QString &letters)
{
    QString text;
    for (const QChar letter : letters)
        text += letter + QLatin1Char('\n');
    return text;
}

} // namespace

void TestLineDiff::tellsFewestChanges_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    QTest::addColumn<QString>("diff");
    QTest::newRow("nothing") << ""
                             << ""
                             << "";
    QTest::newRow("the same") << "ab"
                              << "ab"
                              << " a b";
    QTest::newRow("all new") << ""
                             << "ab"
                             << "+a+b";
    QTest::newRow("all gone") << "ab"
                              << ""
                              << "-a-b";
    QTest::newRow("in the middle") << "abc"
                                   << "axc"
                                   << " a-b+x c";
    QTest::newRow("inserted") << "abc"
                              << "abxc"
                              << " a b+x c";
    QTest::newRow("of the paper") << "abcabba"
                                  << "cbabac"
                                  << "-a-b c+b a b-b a+c";
}

void TestLineDiff::tellsFewestChanges()
{
    QFETCH(QString, before);
    QFETCH(QString, after);
    QFETCH(QString, diff);
    QCOMPARE(shortOf(lineDiff(spreadOut(before), spreadOut(after))), diff);
}

void TestLineDiff::givesBothTextsBack()
{
    const bool holds = rc::check("a difference holds both texts, in order", [] {
        const auto letters = rc::gen::container<std::string>(rc::gen::element('a', 'b', 'c'));
        const QString before = QString::fromStdString(*letters);
        const QString after = QString::fromStdString(*letters);
        QString old;
        QString now;
        int x = 0;
        int y = 0;
        for (const DiffLine &line : lineDiff(spreadOut(before), spreadOut(after))) {
            if (line.kind != DiffLine::Kind::Added) {
                old += line.text;
                RC_ASSERT(line.before == ++x);
            } else {
                RC_ASSERT(line.before == 0);
            }
            if (line.kind != DiffLine::Kind::Removed) {
                now += line.text;
                RC_ASSERT(line.after == ++y);
            } else {
                RC_ASSERT(line.after == 0);
            }
        }
        RC_ASSERT(old == before);
        RC_ASSERT(now == after);
    });
    QVERIFY(holds);
}

void TestLineDiff::textsWithNothingInCommonAreTold()
{
    QString before;
    QString after;
    for (int i = 0; i < 5000; ++i) {
        before += QStringLiteral("a%1\n").arg(i);
        after += QStringLiteral("b%1\n").arg(i);
    }
    QCOMPARE(lineDiff(before, after).size(), std::size_t(10'000));
}

void TestLineDiff::shortestWayIsLookedForUpToABound()
{
    const auto lines = [](char of, int count) {
        QString text;
        for (int i = 0; i < count; ++i)
            text += QStringLiteral("%1%2\n").arg(QLatin1Char(of)).arg(i);
        return text;
    };
    const QString both = QStringLiteral("both\n");
    const QString before = lines('a', 375) + both + lines('b', 375);
    // 1500 lines removed or added, and one that is the same; then 1501, and it is told as all
    // others.
    QCOMPARE(lineDiff(before, lines('c', 375) + both + lines('d', 375)).size(), std::size_t(1501));
    QCOMPARE(lineDiff(before, lines('c', 375) + both + lines('d', 376)).size(), std::size_t(1503));
}

void TestLineDiff::lastLineNeedsNoEnd()
{
    QCOMPARE(shortOf(lineDiff(QStringLiteral("a\nb"), QStringLiteral("a\nb\n"))),
             QStringLiteral(" a b"));
}

void TestLineDiff::hunksHaveLinesAround()
{
    const auto hunks = hunksOf(
        lineDiff(spreadOut(QStringLiteral("abcdefghij")), spreadOut(QStringLiteral("abXdefghYj"))),
        1);
    QCOMPARE(hunks.size(), std::size_t(2));
    QCOMPARE(shortOf(hunks[0].lines), QStringLiteral(" b-c+X d"));
    QCOMPARE(shortOf(hunks[1].lines), QStringLiteral(" h-i+Y j"));
    // What lies close together is one.
    const auto one =
        hunksOf(lineDiff(spreadOut(QStringLiteral("abc")), spreadOut(QStringLiteral("XbY"))), 1);
    QCOMPARE(one.size(), std::size_t(1));
    QCOMPARE(shortOf(one[0].lines), QStringLiteral("-a+X b-c+Y"));
    QVERIFY(hunksOf({}, 3).empty());
}

QTEST_APPLESS_MAIN(TestLineDiff)
#include "test_line_diff.moc"
