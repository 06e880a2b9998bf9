// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_folder.h"
#include "tasks/grading/handed_in.h"
#include "tasks/grading/platform_names.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/grading/student_seed.h"
#include "tests/test_paths.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace cradle;

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
    void rosterTellsBlackboardAccounts();
    void blackboardAccountsThatAreGuessedAreTold();
    void classroomClonesLoseTheAssignment();
    void oneStudentsWorkIsNoClass();
    void zipInsideIsTold();
    void linksThatLeadOutAreNotFollowed();
    void namesThatAreNoTextWork();
    void idsAreUnlikeEachOther();
    void rosterNamesStudentsAndTheMissing();
    void onlyTheRosterGivesNumbersForValues();
    void whatTheRosterHasTwiceIsTold();
    void brokenRosterIsRefused_data();
    void brokenRosterIsRefused();
    void tableCellsMayBeQuoted();
    void everyStudentIsInOneShard();
    void seedFollowsFromSecretAndId();
};

namespace {

Lab lab()
{
    Lab made;
    made.id = QStringLiteral("lab");
    for (const char *id : {"L1", "L2"}) {
        Task task;
        task.id = QString::fromLatin1(id);
        made.tasks.push_back(task);
    }
    return made;
}

/// A class that is made file by file.
class Made
{
public:
    void file(const QByteArray &path, const QByteArray &content = "x = 1\n") const
    {
        const QByteArray whole = root() + '/' + path;
        for (auto slash = whole.indexOf('/', root().size() + 1); slash > 0;
             slash = whole.indexOf('/', slash + 1))
            ::mkdir(whole.left(slash).constData(), 0700);
        const int number = ::open(whole.constData(), O_WRONLY | O_CREAT, 0600);
        QVERIFY(number >= 0);
        QCOMPARE(::write(number, content.constData(), std::size_t(content.size())),
                 ssize_t(content.size()));
        ::close(number);
    }
    [[nodiscard]] QByteArray root() const { return QFile::encodeName(m_folder.path()); }
    [[nodiscard]] ClassFolder read(const std::vector<RosterRow> &roster = {}) const
    {
        const auto found = readClassFolder(root(), QStringLiteral("lab"), roster);
        return found ? *found : ClassFolder{.remarks = {found.error().toString()}};
    }

private:
    QTemporaryDir m_folder;
};

QStringList idsOf(const ClassFolder &found)
{
    QStringList ids;
    for (const FoundStudent &student : found.students)
        ids.append(student.id);
    return ids;
}

QStringList filesOf(const ClassFolder &found, int index)
{
    return readHandedIn(found.students.at(std::size_t(index)), found.root, lab())
        .request.files.keys();
}

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace

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
    QCOMPARE(readHandedIn(found.students[0], found.root, lab()).request.archive,
             QByteArray("no archive"));
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
    const HandedIn handedIn = readHandedIn(found.students[0], found.root, lab());
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
        QCOMPARE(
            readHandedIn(found.students[i], found.root, lab()).request.files.value(text("lab.lua")),
            found.students[i].id.toUtf8());
    QCOMPARE(found.remarks.size(), 1);
    QVERIFY(found.remarks.front().contains(text("Lab_4_")));
}

/// Also where all accounts begin alike, and where there is but one.
void TestClassFolder::rosterTellsBlackboardAccounts()
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

/// Else it would look as if the student had handed in nothing.
void TestClassFolder::zipInsideIsTold()
{
    const Made made;
    made.file("Ada Lovelace_1234567_assignsubmission_file_/my work.ZIP");
    made.file("Bob Boole_1234568_assignsubmission_file_/lab.lua");
    const ClassFolder found = made.read();
    QCOMPARE(found.students.size(), std::size_t(2));
    const HandedIn handedIn = readHandedIn(found.students[0], found.root, lab());
    QVERIFY(handedIn.request.files.isEmpty());
    QVERIFY(handedIn.remark.contains(text("my work.ZIP is not looked into")));
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
    const HandedIn handedIn = readHandedIn(found.students[0], found.root, lab());
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

void TestClassFolder::rosterNamesStudentsAndTheMissing()
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

/// Values are drawn by the number of the roster, never by that of a platform.
void TestClassFolder::onlyTheRosterGivesNumbersForValues()
{
    const Made made;
    made.file("Ada Lovelace_1234567_assignsubmission_file_/lab.lua");
    made.file("Bob Boole_1234568_assignsubmission_file_/lab.lua");
    const auto roster =
        rosterFrom(text("id,name,number\nada,Ada Lovelace,00417\nbob,Bob Boole,\n"), {});
    QVERIFY(roster.ok());
    const ClassFolder found = made.read(*roster);
    QCOMPARE(idsOf(found), (QStringList{text("ada"), text("bob")}));
    QCOMPARE(found.students[0].rosterNumbers, (QStringList{text("00417"), text("ada")}));
    QCOMPARE(found.students[1].rosterNumbers, QStringList());
}

void TestClassFolder::whatTheRosterHasTwiceIsTold()
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

void TestClassFolder::brokenRosterIsRefused_data()
{
    QTest::addColumn<QString>("roster");
    QTest::newRow("empty") << QString();
    QTest::newRow("no columns") << text("a,b\n1,2\n");
    QTest::newRow("nobody") << text("id,name\n,Ada\n");
    QTest::newRow("late") << text("id,late days\nada,soon\n");
    QTest::newRow("early") << text("id,late days\nada,-1\n");
}

void TestClassFolder::brokenRosterIsRefused()
{
    QFETCH(QString, roster);
    QVERIFY(!rosterFrom(roster, {}));
}

void TestClassFolder::tableCellsMayBeQuoted()
{
    const auto table = tableFrom(text("a,b\r\n\"x, \"\"y\"\"\n2\",z\r\n\n"));
    QCOMPARE(table.size(), std::size_t(2));
    QCOMPARE(table[1], (QStringList{text("x, \"y\"\n2"), text("z")}));
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

QTEST_GUILESS_MAIN(TestClassFolder)
#include "test_class_folder.moc"
