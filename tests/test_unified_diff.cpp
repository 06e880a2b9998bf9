// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/text/unified_diff.h"

#include <QTest>

using namespace cradle;

/// Differences of programs: written, and applied to a text that has changed since.
class TestUnifiedDiff : public QObject
{
    Q_OBJECT
private slots:
    void differenceIsWrittenAsDiffWritesIt();
    void whatIsWrittenAppliesAgain_data();
    void whatIsWrittenAppliesAgain();
    void movedLinesAreFound();
    void otherLinesAroundAreAllowedOnce();
    void noMoreThanTheLinesAroundMayBeOthers_data();
    void noMoreThanTheLinesAroundMayBeOthers();
    void laterChangesFollowEarlierOnes();
    void changedLinesAreRefusedByTheirHunk();
    void otherTextsAreNoDifferences();
};

namespace {

QString text(const char *latin)
{
    return QString::fromLatin1(latin);
}

} // namespace

void TestUnifiedDiff::differenceIsWrittenAsDiffWritesIt()
{
    // As `diff -u` does, worked out with it.
    QCOMPARE(unifiedDiff(text("a\nb\nc\nd\ne\n"), text("a\nb\nC\nd\ne\n"), 1),
             text("@@ -2,3 +2,3 @@\n b\n-c\n+C\n d\n"));
    QCOMPARE(unifiedDiff(text("a\n"), text("a\nb\n")), text("@@ -1 +1,2 @@\n a\n+b\n"));
    QCOMPARE(unifiedDiff(text("a\n"), text("a\n")), QString());
    QCOMPARE(unifiedDiff(text("a\nb\nc\nd\n"), text("x\ny\na\nc\nd\nz\n"), 0),
             text("@@ -0,0 +1,2 @@\n+x\n+y\n@@ -2 +3,0 @@\n-b\n@@ -4,0 +6 @@\n+z\n"));
    QCOMPARE(unifiedDiff(text("a\nb\n"), QString()), text("@@ -1,2 +0,0 @@\n-a\n-b\n"));
}

void TestUnifiedDiff::whatIsWrittenAppliesAgain_data()
{
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    const auto row = [](const char *name, const char *before, const char *after) {
        QTest::newRow(name) << text(before) << text(after);
    };
    row("one line", "a\nb\nc\n", "a\nx\nc\n");
    row("two places", "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n", "1\nx\n3\n4\n5\n6\n7\n8\n9\ny\n11\n");
    row("first line", "a\nb\n", "x\na\nb\n");
    row("last line", "a\nb\n", "a\nb\nx\n");
    row("first line goes", "a\nb\n", "b\n");
    row("all else", "a\nb\n", "x\n");
    row("the same line twice", "a\na\na\na\na\na\na\na\n", "a\na\na\na\na\na\nx\na\na\n");
    row("empty lines", "\n\na\n\n", "\na\n\n\n");
    row("nothing", "a\n", "a\n");
}

void TestUnifiedDiff::whatIsWrittenAppliesAgain()
{
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    for (const int context : {0, 1, 3}) {
        const Result<QString> made = withDiff(before, unifiedDiff(before, after, context));
        QVERIFY2(made.ok(), qPrintable(unifiedDiff(before, after, context)));
        QCOMPARE(*made, after);
    }
}

void TestUnifiedDiff::movedLinesAreFound()
{
    const QString diff = unifiedDiff(text("a\nb\nc\nd\ne\n"), text("a\nb\nx\nd\ne\n"), 1);
    QCOMPARE(*withDiff(text("new\nnew\na\nb\nc\nd\ne\n"), diff), text("new\nnew\na\nb\nx\nd\ne\n"));
    QCOMPARE(*withDiff(text("b\nc\nd\n"), diff), text("b\nx\nd\n"));
}

void TestUnifiedDiff::otherLinesAroundAreAllowedOnce()
{
    const QString diff = unifiedDiff(text("a\nb\nc\nd\ne\n"), text("a\nb\nx\nd\ne\n"), 2);
    QCOMPARE(*withDiff(text("A\nb\nc\nd\nE\n"), diff), text("A\nb\nx\nd\nE\n"));
    QVERIFY(!withDiff(text("A\nb\nc\nd\nE\nb\nc\nd\n"), diff).ok()); // which of the two?
}

void TestUnifiedDiff::noMoreThanTheLinesAroundMayBeOthers_data()
{
    QTest::addColumn<QString>("diff");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after"); // nothing where it is refused
    const auto row = [](const char *name, const char *diff, const char *before, const char *after) {
        QTest::newRow(name) << text(diff) << text(before) << text(after);
    };
    const char *const five = "@@ -1,5 +1,5 @@\n a\n b\n-c\n+x\n d\n e\n";
    row("two at both ends", five, "A\nB\nc\nD\nE\n", "A\nB\nx\nD\nE\n");
    row("two before", five, "A\nB\nc\nd\ne\n", "A\nB\nx\nd\ne\n");
    row("two after", five, "a\nb\nc\nD\nE\n", "a\nb\nx\nD\nE\n");
    row("one, as c alone stands twice", five, "A\nb\nc\nd\nE\nc\n", "A\nb\nx\nd\nE\nc\n");
    row("three", "@@ -1,4 +1,4 @@\n a\n b\n c\n-d\n+x\n", "A\nB\nC\nd\n", "");
    row("two of three", "@@ -1,4 +1,4 @@\n a\n b\n c\n-d\n+x\n", "A\nB\nc\nd\n", "A\nB\nc\nx\n");
    row("no line before it", "@@ -1,3 +1,2 @@\n-a\n b\n c\n", "a\nB\nC\n", "B\nC\n");
    row("one line before it", "@@ -1,4 +1,3 @@\n a\n-b\n c\n d\n", "a\nb\nC\nD\n", "a\nC\nD\n");
    row("no line after it", "@@ -1,3 +1,3 @@\n a\n b\n-c\n+x\n", "A\nB\nc\n", "A\nB\nx\n");
    row("one line after it", "@@ -1,4 +1,4 @@\n a\n b\n-c\n+x\n d\n", "A\nB\nc\nd\n",
        "A\nB\nx\nd\n");
    row("what goes is another", five, "a\nb\nC\nd\ne\n", "");
    row("only added", "@@ -1,2 +1,3 @@\n a\n+x\n b\n", "A\nB\n", "");
}

void TestUnifiedDiff::noMoreThanTheLinesAroundMayBeOthers()
{
    QFETCH(const QString, diff);
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    const Result<QString> made = withDiff(before, diff);
    QCOMPARE(made.ok(), !after.isEmpty());
    if (made.ok())
        QCOMPARE(*made, after);
}

void TestUnifiedDiff::laterChangesFollowEarlierOnes()
{
    // "b" stands twice around where it is sought: four lines further on, as "a" was.
    const QString moved = text("@@ -1 +1 @@\n-a\n+A\n@@ -4 +4 @@\n-b\n+B\n");
    QCOMPARE(*withDiff(text("1\n2\n3\n4\na\nb\n7\nb\nb\nb\n"), moved),
             text("1\n2\n3\n4\nA\nb\n7\nB\nb\nb\n"));
    // The same, where lines around were others; and where what is first has become longer.
    const QString around = text("@@ -1,2 +1,2 @@\n z\n-a\n+A\n@@ -5 +5 @@\n-b\n+B\n");
    QCOMPARE(*withDiff(text("1\n2\n3\n4\na\nb\n7\nb\nb\nb\n"), around),
             text("1\n2\n3\n4\nA\nb\n7\nB\nb\nb\n"));
    const QString longer = text("@@ -1 +1,3 @@\n-a\n+A\n+A\n+A\n@@ -3 +5 @@\n-b\n+B\n");
    QCOMPARE(*withDiff(text("a\nb\nb\nb\nb\n"), longer), text("A\nA\nA\nb\nB\nb\nb\n"));
    // What an earlier one made is not changed again, nor what stands before it.
    QVERIFY(!withDiff(text("b\na\n"), text("@@ -2 +2 @@\n-a\n+A\n@@ -3 +3 @@\n-b\n+B\n")).ok());
    QVERIFY(!withDiff(text("a\n"), text("@@ -1 +1 @@\n-a\n+b\n@@ -1 +1 @@\n-b\n+B\n")).ok());
}

void TestUnifiedDiff::changedLinesAreRefusedByTheirHunk()
{
    const QString before = text("1\n2\n3\n4\n5\n6\n7\n8\n9\n");
    const QString diff = unifiedDiff(before, text("1\nx\n3\n4\n5\n6\n7\ny\n9\n"), 1);
    const Result<QString> made = withDiff(text("1\n2\n3\n4\n5\n6\n7\neight\n9\n"), diff);
    QVERIFY(!made.ok());
    QCOMPARE(made.error().line, 6); // the second "@@"
}

void TestUnifiedDiff::otherTextsAreNoDifferences()
{
    for (const char *diff : {"a\n", "@@ -1 +1 @@\n*b\n", "@@ -x +1 @@\n-a\n", "-a\n"}) {
        const Result<QString> made = withDiff(text("a\n"), text(diff));
        QVERIFY2(!made.ok(), diff);
        QVERIFY2(made.error().line >= 1, diff);
    }
}

QTEST_MAIN(TestUnifiedDiff)
#include "test_unified_diff.moc"
