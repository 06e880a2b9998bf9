// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_reader.h"
#include "tasks/reading/lab_source.h"
#include "tests/lab_with_values.h"
#include "tests/text.h"

#include <QTest>

using namespace cradle;

/// The files of a lab, some of which cannot be read.
class TestLabSource : public QObject
{
    Q_OBJECT
private slots:
    void textsAreReadAsFarAsTheyCanBe_data();
    void textsAreReadAsFarAsTheyCanBe();
    void filesAreAsLargeAsIsAsked();
    void whatCannotBeReadIsThereAndToldOnce();
    void valuesOfStepsThatAreNotListedAreNobodysConcern();
    void labKnowsHowItWasRead();
};

void TestLabSource::textsAreReadAsFarAsTheyCanBe_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("read");
    QTest::addColumn<QList<int>>("lines"); ///< of what is said of it
    QTest::newRow("plain") << QByteArray("a\n\xc3\xa4") << text("a\nä") << QList<int>{};
    QTest::newRow("not in UTF-8, cut in a letter")
        << QByteArray("a\n\xe4") << text("a\n\xef\xbf\xbd") << QList<int>{0};
    QTest::newRow("NUL in the first line") << QByteArray("\0ab", 3) << text("ab") << QList<int>{1};
    QTest::newRow("NUL in the third line")
        << QByteArray("a\nb\nc\0d\0\n", 9) << text("a\nb\ncd\n") << QList<int>{3};
    QTest::newRow("as long as may be") << QByteArray(20, 'x') << QString(20, u'x') << QList<int>{};
    QTest::newRow("longer") << QByteArray(21, 'x') << QString() << QList<int>{0};
}

void TestLabSource::textsAreReadAsFarAsTheyCanBe()
{
    QFETCH(QByteArray, bytes);
    QFETCH(QList<int>, lines);
    const LabFiles files{.contents = {{text("a.md"), bytes}}};
    std::vector<Error> findings;
    QTEST(LabSource(files, text("lab"), {}).readText(text("a.md"), 20, findings), "read");
    QCOMPARE(findings.size(), std::size_t(lines.size()));
    for (const Error &finding : findings) {
        QCOMPARE(finding.file, text("lab/a.md"));
        QCOMPARE(finding.line, lines.front());
    }
}

/// A text no larger than 2 MiB, whatever is asked.
void TestLabSource::filesAreAsLargeAsIsAsked()
{
    constexpr qint64 most = 2 * 1024 * 1024;
    const LabFiles files{.contents = {{text("fits"), QByteArray(most, ' ')},
                                      {text("no"), QByteArray(most + 1, ' ')}}};
    const LabSource source(files, text("lab"), {});
    std::vector<Error> findings;
    QCOMPARE(source.readText(text("fits"), most * 2, findings).size(), most);
    QVERIFY(findings.empty());
    QVERIFY(source.readText(text("no"), most * 2, findings).isEmpty());
    QCOMPARE(findings.size(), std::size_t(1));
    QVERIFY(source.read(text("no"), most + 1).ok());
    QVERIFY(!source.read(text("no"), most).ok());
    QCOMPARE(source.read(text("nowhere"), most).error().file, text("lab/nowhere"));
}

void TestLabSource::whatCannotBeReadIsThereAndToldOnce()
{
    const LabFiles files{.contents = {{text("a"), "1"}}};
    const Error first{.message = text("one"), .file = text("lab/b")};
    const Error second{.message = text("two"), .file = text("lab/c")};
    const LabSource source(files, text("lab"), {first, second});
    QVERIFY(source.has(text("a")) && source.has(text("b")) && source.has(text("c")));
    QVERIFY(!source.has(text("d")));
    QCOMPARE(source.read(text("c"), 10).error(), second);
    QCOMPARE(source.untold({first}), std::vector<Error>{second});
    QCOMPARE(source.untold({}), (std::vector<Error>{first, second}));
    QVERIFY(source.untold({second, first}).empty());
}

void TestLabSource::valuesOfStepsThatAreNotListedAreNobodysConcern()
{
    const QByteArray wrong = R"({"format": 1, "title": "{{nobody}}"})";
    LabFiles files = labWith(values({{text("k"), 2}}));
    files.contents[text("old/task.json")] = wrong;
    const auto fine = readLab(files, text("lab"));
    QVERIFY(fine.ok());
    QCOMPARE(fine->findings.size(), std::size_t(0));
    files.contents[text("S1/instructions.md")] = "It is {{nobody}} here.";
    const auto lab = readLab(files, text("lab"));
    QVERIFY(lab.ok());
    QCOMPARE(lab->findings.size(), std::size_t(1));
    QCOMPARE(lab->findings[0].file, text("lab/S1/instructions.md"));
}

void TestLabSource::labKnowsHowItWasRead()
{
    const auto plain = readLab(labWith(values({{text("k"), 2}})), text("lab"), text("de"));
    QVERIFY(plain.ok());
    QVERIFY(!plain->drawsValues && !plain->forStudents);
    QCOMPARE(plain->readIn, text("de"));
    LabFiles files = labWith(values({{text("k"), range}}));
    edit(files, "lab.json", [](QJsonObject &json) { json[text("edition")] = QString(64, u'a'); });
    const auto drawn = readLab(files, text("lab"), text("fr"));
    QVERIFY(drawn.ok());
    QVERIFY(drawn->drawsValues && drawn->forStudents);
    QCOMPARE(drawn->readIn, text("fr"));
    QCOMPARE(drawn->hash, QString(64, u'a'));
}

QTEST_GUILESS_MAIN(TestLabSource)
#include "test_lab_source.moc"
