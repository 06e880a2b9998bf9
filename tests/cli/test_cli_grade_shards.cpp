// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/graded_class.h"

using namespace cradle::programs;

/// cradle-cli grade in parts, and parts that died or were done twice.
class TestCliGradeShards : public QObject
{
    Q_OBJECT
private slots:
    void shardsMakeOneClass();
    void doublesAndTheMissingAreTold();
    void differingResultsAreRefused();
};

namespace {

void fill(const GradedClass &made, int count)
{
    for (int i = 0; i < count; ++i)
        made.putStudent(QStringLiteral("student%1").arg(i, 2, 10, QLatin1Char('0')));
}

} // namespace

void TestCliGradeShards::shardsMakeOneClass()
{
    const GradedClass made;
    fill(made, 7);
    VERIFY_CODE(made.grade(text("whole")), 1);
    QStringList merge{text("grade"), text("--merge")};
    for (int i = 1; i <= 3; ++i) {
        const QString out = QStringLiteral("shard%1").arg(i);
        VERIFY_CODE(made.grade(out, {text("--shard"), QStringLiteral("%1/3").arg(i)}), 1);
        merge.append(made.at(out));
    }
    VERIFY_CODE(runCli(merge + QStringList{text("--out"), made.at(text("merged"))}), 1);
    QCOMPARE(made.differing(text("merged"), text("whole")), QStringList());
}

void TestCliGradeShards::doublesAndTheMissingAreTold()
{
    const GradedClass made;
    fill(made, 4);
    for (int i = 1; i <= 2; ++i)
        VERIFY_CODE(made.grade(QStringLiteral("shard%1").arg(i),
                               {text("--shard"), QStringLiteral("%1/3").arg(i)}),
                    1);
    const QStringList merge{text("grade"),           text("--merge"),
                            made.at(text("shard1")), made.at(text("shard2")),
                            made.at(text("shard2")), made.at(text("never")),
                            text("--out"),           made.at(text("merged"))};
    const Outcome lacking = runCli(merge);
    VERIFY_CODE(lacking, 1);
    for (const char *word :
         {"student01", "more than once", "missing of 3 shards: 3", "student02", "never began"})
        QVERIFY2(lacking.error.contains(text(word)), lacking.toText());
    QVERIFY(!made.json(text("merged/manifest.json")).value(text("complete")).toBool(true));
    // The shard is run after all, and put to the others.
    VERIFY_CODE(made.grade(text("never"), {text("--shard"), text("3/3")}), 1);
    VERIFY_CODE(runCli(merge), 1);
    VERIFY_CODE(made.grade(text("whole")), 1);
    QCOMPARE(made.differing(text("merged"), text("whole")), QStringList());
}

void TestCliGradeShards::differingResultsAreRefused()
{
    const GradedClass made;
    fill(made, 2);
    VERIFY_CODE(made.grade(text("one")), 1);
    made.putProgram(text("student00"), text("BALL3"), GradedClass::solution("BALL3"));
    VERIFY_CODE(made.grade(text("two")), 1);
    const auto merge = [&](const char *other) {
        return runCli({text("grade"), text("--merge"), made.at(text("one")), made.at(text(other)),
                       text("--out"), made.at(text("merged"))});
    };
    const Outcome differing = merge("two");
    VERIFY_CODE(differing, 2);
    QVERIFY2(differing.error.contains(text("student00")), differing.toText());
    made.put(text("secret"), "another secret of this class");
    VERIFY_CODE(made.grade(text("three")), 1);
    VERIFY_CODE(merge("three"), 2);
}

QTEST_GUILESS_MAIN(TestCliGradeShards)
#include "test_cli_grade_shards.moc"
