// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/made_class.h"

#include "tasks/grading/class_roster.h"
#include "tasks/grading/roster.h"

using namespace cradle;
using namespace cradle::classes;

/// Who is in the class, as a table says, beside what was handed in.
class TestClassRoster : public QObject
{
    Q_OBJECT
private slots:
    void rosterTellsBlackboardAccounts();
    void rosterNamesStudentsAndTheMissing();
    void onlyTheRosterGivesNumbersForValues();
    void whatTheRosterHasTwiceIsTold();
    void brokenRosterIsRefused_data();
    void brokenRosterIsRefused();
    void tableCellsMayBeQuoted();
    void lateDaysAreNumbers();
    void olderSpreadsheetsAreRead();
    void idsArePlainAndTellNamesApart_data();
    void idsArePlainAndTellNamesApart();
};

/// Also where all accounts begin alike, and where there is but one.
void TestClassRoster::rosterTellsBlackboardAccounts()
{
    const Made made;
    const QByteArray end = "_attempt_2026-11-02-10-15-30_lab.lua";
    made.file("Lab_st_1" + end);
    const RosterRow one{.id = text("ST_1")};
    QCOMPARE(idsOf(made.read({one})), QStringList{text("ST_1")});
    made.file("Lab_st_2" + end);
    const ClassFolder both = made.read({one, {.id = text("st_2")}});
    QCOMPARE(idsOf(both), (QStringList{text("ST_1"), text("st_2")}));
    QVERIFY(both.missing.empty());
    QCOMPARE(both.remarks, QStringList());
}

void TestClassRoster::rosterNamesStudentsAndTheMissing()
{
    const Made made;
    made.file("folder7/steps/L1.lua");
    made.file("bob/steps/L1.lua");
    made.file("lovelaceada_10_20_lab.lua");
    made.file("stranger/steps/L1.lua");
    const auto roster = rosterFrom(text("Student ID;Folder;First name;Last name;Email;Late days\n"
                                        "s1;folder7;Cy;Young;cy@example.org;1,5\n"
                                        "BOB;;Bob;Boole;;\n"
                                        "s3;;Ada;Lovelace;;\n"
                                        "s4;;Zed;Zero;z@example.org;\n"),
                                   {});
    QVERIFY(roster.ok());
    const ClassFolder found = made.read(*roster);
    QCOMPARE(idsOf(found), (QStringList{text("BOB"), text("s1"), text("s3"), text("stranger")}));
    QCOMPARE(found.students[1].name, text("Cy Young"));
    QCOMPARE(found.students[1].lateDays, 1.5);
    QCOMPARE(found.students[1].email, text("cy@example.org"));
    QCOMPARE(found.missing.size(), std::size_t(1));
    QCOMPARE(found.missing[0].id, text("s4"));
    QCOMPARE(found.remarks.size(), 1); // the stranger
}

/// Values are drawn by the number of the roster, never by that of a platform, which is left only
/// where the roster has the same or none.
void TestClassRoster::onlyTheRosterGivesNumbersForValues()
{
    const Made made;
    made.file("Ada Lovelace_1234567_assignsubmission_file_/lab.lua");
    made.file("Bob Boole_1234568_assignsubmission_file_/lab.lua");
    made.file("Cy Young_1234569_assignsubmission_file_/lab.lua");
    made.file("Di Doe_1234570_assignsubmission_file_/lab.lua");
    const auto roster = rosterFrom(text("id,folder,name,number\n"
                                        "ada,,Ada Lovelace,00417\n"
                                        "bob,,Bob Boole,\n"
                                        ",Cy Young_1234569_assignsubmission_file_,,23\n"
                                        ",Di Doe_1234570_assignsubmission_file_,,1234570\n"),
                                   {});
    QVERIFY(roster.ok());
    const ClassFolder found = made.read(*roster);
    QCOMPARE(idsOf(found),
             (QStringList{text("1234569"), text("1234570"), text("ada"), text("bob")}));
    const auto is = [&](int student, const char *number, Platform platform,
                        const QStringList &all) {
        const FoundStudent &one = found.students[static_cast<std::size_t>(student)];
        return one.number == text(number) && one.platform == platform && one.rosterNumbers == all;
    };
    QVERIFY(is(0, "23", Platform::None, {text("23")}));
    QVERIFY(is(1, "1234570", Platform::Moodle, {text("1234570")}));
    QVERIFY(is(2, "00417", Platform::None, {text("00417"), text("ada")}));
    QVERIFY(is(3, "1234568", Platform::Moodle, {}));
}

void TestClassRoster::whatTheRosterHasTwiceIsTold()
{
    const Made made;
    made.file("a/steps/L1.lua");
    made.file("b/steps/L1.lua");
    const auto roster =
        rosterFrom(text("id,folder,number\nada,a,7\nADA,b,8\nzed,,7\ncy,,\ndi,,\n"), {});
    QVERIFY(roster.ok());
    QCOMPARE(made.read(*roster).remarks, (QStringList{text("the roster has ADA more than once"),
                                                      text("the roster has 7 more than once")}));
}

void TestClassRoster::brokenRosterIsRefused_data()
{
    QTest::addColumn<QString>("roster");
    QTest::newRow("empty") << QString();
    QTest::newRow("no columns") << text("a,b\n1,2\n");
    QTest::newRow("nobody") << text("id,name\n,Ada\n");
    QTest::newRow("late") << text("id,late days\nada,soon\n");
    QTest::newRow("early") << text("id,late days\nada,-1\n");
    QTest::newRow("later than any") << text("id,late days\nada,10001\n");
}

void TestClassRoster::brokenRosterIsRefused()
{
    QFETCH(QString, roster);
    QVERIFY(!rosterFrom(roster, {}));
}

void TestClassRoster::tableCellsMayBeQuoted()
{
    const auto table = tableFrom(text("a,b\r\n\"x, \"\"y\"\"\n2\",z\r\n\n"));
    QCOMPARE(table.size(), std::size_t(2));
    QCOMPARE(table[1], (QStringList{text("x, \"y\"\n2"), text("z")}));
}

/// From 0 to ten thousand, with a point or a comma.
void TestClassRoster::lateDaysAreNumbers()
{
    for (const auto &[written, days] :
         {std::pair("", 0.0), std::pair("0", 0.0), std::pair("2.5", 2.5), std::pair("\"2,5\"", 2.5),
          std::pair("10000", 10000.0)}) {
        const auto roster = rosterFrom(text("id,late days\nada,%1\n").arg(text(written)), {});
        QVERIFY2(roster.ok(), written);
        QCOMPARE(roster->front().lateDays, days);
    }
}

/// In UTF-8 with a mark or without, or in Latin-1, also where its last byte alone tells.
void TestClassRoster::olderSpreadsheetsAreRead()
{
    const QTemporaryDir folder;
    for (const QByteArray &bytes :
         {QByteArray("id,name\nada,Jos\xc3\xa9"),
          QByteArray("\xef\xbb\xbfid,name\nada,Jos\xc3\xa9"), QByteArray("id,name\nada,Jos\xe9\n"),
          QByteArray("id,name\nada,Jos\xe9")}) {
        QFile file(folder.filePath(text("roster.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        file.close();
        const auto roster = readRoster(file.fileName());
        QVERIFY(roster.ok());
        QCOMPARE(roster->at(0).name, text("José"));
    }
}

void TestClassRoster::idsArePlainAndTellNamesApart_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("id");
    const auto row = [](const char *name, const char *id) {
        QTest::newRow(name) << text(name) << text(id);
    };
    // Behind what is left of a name that is not plain: the begin of its SHA-256, by `sha256sum`.
    row("ada", "ada");
    row("Ada Lovelace", "Ada-Lovelace");
    row("ada_l.7+x@y-z", "ada_l.7+x@y-z");
    row("..hidden", "hidden");
    row("-.x", "x");
    row("Müller", "Muller-a7842989");
    row("a/b", "a-b-c14cddc0");
    row("a//b", "a-b-7a9acf33");
    row("a\\b:c", "a-b-c-c4b70e9a");
    row("李", "c16667ca");
    row("/", "8a5edab2");
    const QString long80(80, QLatin1Char('n'));
    QTest::newRow("80 letters") << long80 << long80;
    QTest::newRow("81 letters") << long80 + QLatin1Char('n')
                                << long80.left(71) + QStringLiteral("-30ed7cca");
}

/// They are names of files and folders.
void TestClassRoster::idsArePlainAndTellNamesApart()
{
    QFETCH(QString, name);
    QFETCH(QString, id);
    QCOMPARE(studentIdFrom(name), id);
}

QTEST_GUILESS_MAIN(TestClassRoster)
#include "test_class_roster.moc"
