// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/class_results.h"

#include "tasks/grading/class_merge.h"

#include <QFile>

using namespace cradle;
using namespace cradle::results;

/// How the results of several machines are put together.
class TestClassMerge : public ResultFolders
{
    Q_OBJECT
private slots:
    void shardsMakeAClass();
    void whatIsMissingIsTold();
    void otherResultsAreRefused_data();
    void otherResultsAreRefused();
    void betterVerdictIsTaken_data();
    void betterVerdictIsTaken();
    void changedFileIsLeftOut();
    void nothingIsNoClass();
};

void TestClassMerge::shardsMakeAClass()
{
    judge(folder(QStringLiteral("1")), manifestOf(1, 2), {{"ada", "1", {}}, {"bob", "2", {}}});
    judge(folder(QStringLiteral("2")), manifestOf(2, 2), {{"bob", "2", {}}, {"cy", "3", {}}});
    const auto merged = mergeResults({folder(QStringLiteral("1")), folder(QStringLiteral("2"))});
    QVERIFY(merged.ok());
    QCOMPARE(merged->files.size(), std::size_t{3});
    QCOMPARE(merged->files.at(QStringLiteral("ada")),
             folder(QStringLiteral("1")) + QStringLiteral("/students/ada.json"));
    QCOMPARE(merged->files.at(QStringLiteral("cy")),
             folder(QStringLiteral("2")) + QStringLiteral("/students/cy.json"));
    QVERIFY(merged->lacking.isEmpty());
    QCOMPARE(merged->remarks,
             (QStringList{QStringLiteral("judged more than once, with the same result: bob")}));
    QCOMPARE(merged->manifest.students.size(), std::size_t{3});
    QVERIFY(merged->manifest.shard == Shard{});
    QVERIFY(!merged->manifest.complete);
    QCOMPARE(merged->manifest.className, QStringLiteral("Physics 1"));
}

void TestClassMerge::whatIsMissingIsTold()
{
    const QString second = folder(QStringLiteral("2"));
    Manifest elsewhere = manifestOf(2, 14);
    judge(second, elsewhere, {{"ada", "1", {}}}, false);
    // Of ten all are told.
    const auto few = manifestOf(3, 12);
    judge(folder(QStringLiteral("few")), few, {});
    judge(folder(QStringLiteral("fewer")), manifestOf(4, 12), {});
    const auto told =
        mergeResults({folder(QStringLiteral("few")), folder(QStringLiteral("fewer"))});
    QVERIFY(told.ok());
    QCOMPARE(told->remarks.value(0),
             QStringLiteral("missing of 12 shards: 1, 2, 5, 6, 7, 8, 9, 10, "
                            "11, 12"));
    elsewhere.isolation = QStringLiteral("none");
    elsewhere.shard.index = 3;
    const QString third = folder(QStringLiteral("3"));
    judge(third, elsewhere, {});
    const QString none = folder(QStringLiteral("none"));
    const auto merged = mergeResults({second, none, third});
    QVERIFY(merged.ok());
    QCOMPARE(merged->lacking, (QStringList{QStringLiteral("bob"), QStringLiteral("cy")}));
    QCOMPARE(merged->remarks,
             (QStringList{second + QStringLiteral(": shard 2 of 14 did not come to its end"),
                          none + QStringLiteral(": there are no results; its shard never began"),
                          third + QStringLiteral(": other isolation: none"),
                          QStringLiteral("missing of 14 shards: 1, 4, 5, 6, 7, 8, 9, 10, 11, 12 "
                                         "and 2 more"),
                          QStringLiteral("without results: bob, cy")}));
}

void TestClassMerge::otherResultsAreRefused_data()
{
    QTest::addColumn<QString>("what");
    QTest::newRow("version") << "another version";
    QTest::newRow("class") << "another class";
    QTest::newRow("shards") << "another number of shards";
    QTest::newRow("result") << "the results of ada differ from those in";
}

void TestClassMerge::otherResultsAreRefused()
{
    QFETCH(QString, what);
    const QString first = folder(QStringLiteral("1"));
    const QString second = folder(QStringLiteral("2"));
    judge(first, manifestOf(1, 2), {{"ada", "1", {}}});
    Manifest other = manifestOf(2, 2);
    if (what.endsWith(QLatin1String("version")))
        other.version.secretHash = QStringLiteral("cc");
    else if (what.endsWith(QLatin1String("class")))
        other.classIds.append(QStringLiteral("dot"));
    else if (what.endsWith(QLatin1String("shards")))
        other.shard.count = 3;
    judge(second, other, {{"ada", what.startsWith(QLatin1String("the")) ? "2" : "1", {}}});
    const auto merged = mergeResults({first, second});
    QVERIFY(!merged.ok());
    QVERIFY2(merged.error().message.contains(what), qPrintable(merged.error().message));
    QVERIFY(merged.error().file.startsWith(second));
}

void TestClassMerge::betterVerdictIsTaken_data()
{
    QTest::addColumn<int>("first"); // steps without a verdict
    QTest::addColumn<int>("second");
    QTest::addColumn<bool>("sameWork");
    QTest::addColumn<int>("taken"); // of which of them; 0: none
    QTest::newRow("second is whole") << 2 << 0 << true << 2;
    QTest::newRow("first is whole") << 0 << 2 << true << 1;
    QTest::newRow("second is better") << 2 << 1 << true << 2;
    QTest::newRow("first is better") << 1 << 2 << true << 1;
    QTest::newRow("neither") << 2 << 2 << true << 1;
    QTest::newRow("neither, of one step") << 1 << 1 << true << 1;
    QTest::newRow("first is whole, second lacks one") << 0 << 1 << true << 1;
    QTest::newRow("both are whole") << 0 << 0 << true << 0;
    QTest::newRow("other work, better") << 2 << 0 << false << 0;
    QTest::newRow("other work, worse") << 0 << 2 << false << 0;
}

/// Of the same work with other results.
void TestClassMerge::betterVerdictIsTaken()
{
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(bool, sameWork);
    QFETCH(int, taken);
    const QStringList at{folder(QStringLiteral("1")), folder(QStringLiteral("2"))};
    const QString other = sameWork ? QStringLiteral("w") : QStringLiteral("v");
    judge(at[0], manifestOf(1, 2),
          {{"ada", "1", {.workHash = QStringLiteral("w"), .notGraded = first}}});
    judge(at[1], manifestOf(2, 2), {{"ada", "2", {.workHash = other, .notGraded = second}}});
    const auto merged = mergeResults(at);
    QCOMPARE(merged.ok(), taken > 0);
    if (taken == 0)
        return;
    const QString id = QStringLiteral("ada");
    QCOMPARE(merged->files.at(id), at[taken - 1] + QStringLiteral("/students/ada.json"));
    QCOMPARE(merged->manifest.students.at(id).notGraded, taken == 1 ? first : second);
    QVERIFY(!merged->remarks.join(QLatin1Char('\n')).contains(QLatin1String("more than once")));
}

void TestClassMerge::changedFileIsLeftOut()
{
    const QString at = folder({});
    judge(at, manifestOf(), {{"ada", "1", {}}, {"bob", "2", {}}});
    QFile changed(at + QStringLiteral("/students/bob.json"));
    QVERIFY(changed.open(QIODevice::WriteOnly));
    changed.write("3");
    changed.close();
    const auto merged = mergeResults({at});
    QVERIFY(merged.ok());
    QCOMPARE(merged->files.size(), std::size_t{1});
    QCOMPARE(merged->remarks.front(),
             changed.fileName() + QStringLiteral(" is not as its manifest says, and is left out"));
    QCOMPARE(merged->lacking, (QStringList{QStringLiteral("bob"), QStringLiteral("cy")}));
}

void TestClassMerge::nothingIsNoClass()
{
    QVERIFY(!mergeResults({}).ok());
    QVERIFY(!mergeResults({folder({})}).ok());
}

QTEST_GUILESS_MAIN(TestClassMerge)
#include "test_class_merge.moc"
