// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/made_class.h"

#include "tasks/grading/platform_names.h"
#include "tasks/grading/student_seed.h"

#include <QCryptographicHash>
#include <QSet>

using namespace cradle;
using namespace cradle::classes;

/// How a folder of what was handed in is understood.
class TestClassFolder : public QObject
{
    Q_OBJECT
private slots:
    void platformNamesAreRead_data();
    void platformNamesAreRead();
    void foldersAndFilesAreStudents();
    void moodleIsUnderstood();
    void canvasFilesAreGathered();
    void lastBlackboardAttemptCounts();
    void blackboardAccountsMayHaveUnderscores();
    void blackboardAccountsThatAreGuessedAreTold();
    void classroomClonesLoseTheAssignment();
    void oneStudentsWorkIsNoClass();
    void linksThatLeadOutAreNotFollowed();
    void namesThatAreNoTextWork();
    void idsAreUnlikeEachOther();
    void everyStudentIsInOneShard();
    void seedFollowsFromSecretAndId();
    void secretIsReadFromItsFile();
};

void TestClassFolder::platformNamesAreRead_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isFolder");
    QTest::addColumn<int>("platform");
    QTest::addColumn<QStringList>("parts"); ///< student, number, attempt, file
    const auto row = [](const char *label, const char *name, bool isFolder, Platform platform,
                        const QStringList &parts) {
        QTest::newRow(label) << text(name) << isFolder << int(platform) << parts;
    };
    row("Moodle folder", "Ada Lovelace_1234567_assignsubmission_file_", true, Platform::Moodle,
        {text("Ada Lovelace"), text("1234567"), {}, {}});
    row("Moodle file", "Ada Love_lace_12_assignsubmission_file_my_lab.lua", false, Platform::Moodle,
        {text("Ada Love_lace"), text("12"), {}, text("my_lab.lua")});
    row("Canvas", "lovelaceada_10_20_L1-2.lua", false, Platform::Canvas,
        {text("lovelaceada"), text("10"), {}, text("L1-2.lua")});
    row("Canvas, late", "boole_LATE_11_21_a_b.lua", false, Platform::Canvas,
        {text("boole"), text("11"), {}, text("a_b.lua")});
    row("Blackboard", "Lab 4.2_x_ada1_attempt_2026-05-01-12-30-00_lab.lua", false,
        Platform::Blackboard,
        {text("ada1"), text("ada1"), text("2026-05-01-12-30-00"), text("lab.lua")});
    row("Blackboard's note", "Lab_ada1_attempt_2026-05-01-12-30-00.txt", false,
        Platform::Blackboard, {text("ada1"), text("ada1"), text("2026-05-01-12-30-00"), {}});
    row("none", "ada_lovelace.lua", false, Platform::None, {{}, {}, {}, {}});
}

void TestClassFolder::platformNamesAreRead()
{
    QFETCH(QString, name);
    QFETCH(bool, isFolder);
    QFETCH(int, platform);
    QFETCH(QStringList, parts);
    const auto read = platformName(name, isFolder).value_or(PlatformName{});
    QCOMPARE(int(read.platform), platform);
    QCOMPARE((QStringList{read.student, read.number, read.attempt, read.file}), parts);
}

void TestClassFolder::foldersAndFilesAreStudents()
{
    const Made made;
    made.file("ada/steps/L1.lua");
    made.file("ada/steps/L9.lua");
    made.file("ada/lab.lua");
    made.file("bob/inner/deep/steps/l2.LUA");
    made.file("cy/anything.lua");
    made.file("cy/.steps/L1.lua");
    made.file("cy/__MACOSX/steps/L2.lua");
    made.file("dot.lua");
    made.file("Eve-lab.cradle-work", "no archive");
    made.file("notes.txt");
    made.file(".hidden/steps/L1.lua");
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found),
             (QStringList{text("Eve"), text("ada"), text("bob"), text("cy"), text("dot")}));
    QCOMPARE(found.remarks.size(), 1);
    QCOMPARE(filesOf(found, 1), (QStringList{text("lab.lua"), text("steps/L1.lua")}));
    QCOMPARE(filesOf(found, 2), QStringList{text("steps/L2.lua")});
    QCOMPARE(filesOf(found, 3), QStringList{text("lab.lua")});
    QCOMPARE(filesOf(found, 4), QStringList{text("lab.lua")});
    QCOMPARE(handedInBy(found, 0).request.archive, QByteArray("no archive"));
}

void TestClassFolder::moodleIsUnderstood()
{
    const Made made;
    made.file("down/Ada Lovelace_12_assignsubmission_file_/L1 (1).lua");
    made.file("down/Bob_13_assignsubmission_file_lab.lua");
    made.file("down/Cy_14_assignsubmission_onlinetext_/onlinetext.html");
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found), (QStringList{text("12"), text("13")}));
    QCOMPARE(found.students[0].name, text("Ada Lovelace"));
    QCOMPARE(found.platform, Platform::Moodle);
    QCOMPARE(filesOf(found, 0), QStringList{text("steps/L1.lua")});
    QCOMPARE(filesOf(found, 1), QStringList{text("lab.lua")});
    QCOMPARE(found.remarks.size(), 1); // Cy handed in no file
}

void TestClassFolder::canvasFilesAreGathered()
{
    const Made made;
    made.file("ada_10_20_L1.lua");
    made.file("ada_10_21_L2-3.lua");
    made.file("bob_LATE_11_22_lab.lua");
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found), (QStringList{text("10"), text("11")}));
    QCOMPARE(filesOf(found, 0), (QStringList{text("steps/L1.lua"), text("steps/L2.lua")}));
    QVERIFY(found.students[1].remark.contains(text("late")));
}

void TestClassFolder::lastBlackboardAttemptCounts()
{
    const Made made;
    made.file("Lab_ada_attempt_2026-05-01-12-00-00_lab.lua", "old");
    made.file("Lab_ada_attempt_2026-05-02-12-00-00_lab.lua", "new");
    made.file("Lab_ada_attempt_2026-05-02-12-00-00.txt", "Name: Ada");
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found), QStringList{text("ada")});
    const HandedIn handedIn = handedInBy(found, 0);
    QCOMPARE(handedIn.request.files.value(text("lab.lua")), QByteArray("new"));
    QVERIFY(!handedIn.remark.isEmpty());
}

/// Cut at the last `_` the first two would be one student, of whom one work counts.
void TestClassFolder::blackboardAccountsMayHaveUnderscores()
{
    const Made made;
    const QByteArray when = "_attempt_2026-11-02-10-15-30";
    for (const char *account : {"ada_l", "bob_l", "cy"}) {
        made.file(QByteArray("Lab_4_") + account + when + "_lab.lua", account);
        made.file(QByteArray("Lab_4_") + account + when + ".txt");
    }
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found), (QStringList{text("ada_l"), text("bob_l"), text("cy")}));
    for (std::size_t i = 0; i < found.students.size(); ++i)
        QCOMPARE(readHandedIn(found.students[i], found.root, labOfTwo())
                     .request.files.value(text("lab.lua")),
                 found.students[i].id.toUtf8());
    QCOMPARE(found.remarks.size(), 1);
    QVERIFY(found.remarks.front().contains(text("Lab_4_")));
}

void TestClassFolder::blackboardAccountsThatAreGuessedAreTold()
{
    const Made made;
    const QByteArray end = "_attempt_2026-11-02-10-15-30_lab.lua";
    made.file("Lab_4_ada" + end);
    const ClassFolder one = made.read();
    QCOMPARE(idsOf(one), QStringList{text("ada")});
    QCOMPARE(one.remarks.size(), 1);
    const Made plain;
    plain.file("Lab 4_ada" + end);
    plain.file("Lab 4_bob" + end);
    QCOMPARE(idsOf(plain.read()), (QStringList{text("ada"), text("bob")}));
    QCOMPARE(plain.read().remarks, QStringList());
}

void TestClassFolder::classroomClonesLoseTheAssignment()
{
    const Made made;
    made.file("lab-one-submissions/lab-one-octocat/.git/HEAD");
    made.file("lab-one-submissions/lab-one-octocat/steps/L1.lua");
    made.file("lab-one-submissions/lab-one-hubot/steps/L1.lua");
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found), (QStringList{text("hubot"), text("octocat")}));
    QCOMPARE(found.platform, Platform::GitHub);
}

void TestClassFolder::oneStudentsWorkIsNoClass()
{
    const Made made;
    made.file("steps/L1.lua");
    QVERIFY(!readClassFolder(made.root(), text("lab")));
    QVERIFY(!readClassFolder(made.root() + "/nowhere", text("lab")));
}

void TestClassFolder::linksThatLeadOutAreNotFollowed()
{
    const Made outside;
    outside.file("secret.lua");
    const Made made;
    made.file("ada/steps/L2.lua");
    made.file("bob/steps/L1.lua", "bob's");
    const QByteArray ada = made.root() + "/ada/steps/";
    // Out of the class, to a neighbour, and within what she handed in.
    QCOMPARE(symlink((outside.root() + "/secret.lua").constData(), (ada + "L1.lua").constData()),
             0);
    QCOMPARE(symlink("../bob", (made.root() + "/ada/other").constData()), 0);
    QCOMPARE(symlink("../../bob/steps/L1.lua", (made.root() + "/ada/lab.lua").constData()), 0);
    QCOMPARE(symlink("ada", (made.root() + "/zoe").constData()), 0);
    QCOMPARE(mkfifo((made.root() + "/pipe.lua").constData(), 0600), 0);
    const ClassFolder found = made.read();
    QCOMPARE(idsOf(found), (QStringList{text("ada"), text("bob")}));
    QCOMPARE(found.remarks.size(), 2); // zoe, pipe.lua
    const HandedIn handedIn = handedInBy(found, 0);
    QCOMPARE(handedIn.request.files.keys(), QStringList{text("steps/L2.lua")});
    QVERIFY(handedIn.remark.contains(text("steps/L1.lua")));
    QVERIFY(handedIn.remark.contains(text("lab.lua")));
    const Made inner;
    inner.file("cy/steps/L2.lua");
    inner.file("dot/steps/L2.lua");
    QCOMPARE(symlink("L2.lua", (inner.root() + "/cy/steps/L1.lua").constData()), 0);
    QCOMPARE(filesOf(inner.read(), 0), (QStringList{text("steps/L1.lua"), text("steps/L2.lua")}));
}

void TestClassFolder::namesThatAreNoTextWork()
{
    const Made made;
    made.file("caf\xe9/steps/L1.lua");
    made.file("esc\x1b[31m/steps/L1.lua");
    const ClassFolder found = made.read();
    QCOMPARE(found.students.size(), std::size_t(2));
    QCOMPARE(found.students[0].name, text("café"));
    QVERIFY(!found.students[1].name.contains(QChar(0x1b)));
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(filesOf(found, i), QStringList{text("steps/L1.lua")});
        for (const QChar letter : found.students[std::size_t(i)].id)
            QVERIFY(letter.unicode() > 32 && letter.unicode() < 127 && letter != u'/');
    }
}

void TestClassFolder::idsAreUnlikeEachOther()
{
    const Made made;
    for (const char *name : {"Ada", "ada", "M\xc3\xbcller", "Muller", "(("})
        made.file(QByteArray(name) + "/steps/L1.lua");
    const QStringList ids = idsOf(made.read());
    QCOMPARE(QSet<QString>(ids.begin(), ids.end()).size(), 5);
    for (const QString &id : ids)
        QVERIFY(!id.startsWith(u'.') && !id.isEmpty());
}

void TestClassFolder::everyStudentIsInOneShard()
{
    std::vector<FoundStudent> students(10);
    for (std::size_t i = 0; i < students.size(); ++i)
        students[i].id = QString::number(i);
    QStringList all;
    for (int i = 1; i <= 4; ++i) {
        const auto shard = shardOf(students, i, 4);
        QVERIFY(shard.size() == 2 || shard.size() == 3);
        for (const FoundStudent &student : shard)
            all.append(student.id);
    }
    all.sort();
    QCOMPARE(all.size(), 10);
    QCOMPARE(all.removeDuplicates(), 0);
}

/// HMAC by its definition: H((K ^ 5c…) H((K ^ 36…) id)).
void TestClassFolder::seedFollowsFromSecretAndId()
{
    const QByteArray secret = "a secret of sixteen";
    const auto padded = [&](char with) {
        QByteArray key = secret + QByteArray(64 - secret.size(), '\0');
        for (char &letter : key)
            letter = char(letter ^ with);
        return key;
    };
    const auto hash = [](const QByteArray &bytes) {
        return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    };
    const QByteArray code = hash(padded(0x5c) + hash(padded(0x36) + "ada"));
    qint64 expected = 0;
    for (int i = 0; i < 7; ++i)
        expected = expected * 256 + quint8(code[i]);
    QCOMPARE(studentSeed(secret, text("ada")), (expected >> 4) + 1);
    QVERIFY(studentSeed(secret, text("ada")) != studentSeed(secret, text("bob")));
    QVERIFY(studentSeed(newSecret(), text("ada")) != studentSeed(newSecret(), text("ada")));
}

void TestClassFolder::secretIsReadFromItsFile()
{
    const Made made;
    made.file("secret", " \n0123456789abcdef\n");
    made.file("short", "0123456789abcde\n");
    made.file("long", QByteArray(4097, 'x'));
    const auto read = [&](const char *name) {
        return readSecret(QFile::decodeName(made.root() + '/' + name));
    };
    QVERIFY(read("secret").ok());
    QCOMPARE(*read("secret"), QByteArray("0123456789abcdef"));
    QVERIFY(read("short").error().message.contains(text("at least 16")));
    QVERIFY(!read("long").ok());
    QVERIFY(!read("nobody").ok());
    QVERIFY(!read("nobody").error().message.contains(text("at least 16")));
    QCOMPARE(newSecret().size(), 64);
}

QTEST_GUILESS_MAIN(TestClassFolder)
#include "test_class_folder.moc"
