// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_class.h"

#include "tasks/grading/handed_repository.h"
#include "tasks/grading/judging_request.h"
#include "tasks/grading/platform_names.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/lab_files/lab_files.h"

#include <QTest>

using namespace cradle;
using namespace cradle::classes;

/// What is understood of folders, files and zips that a class handed in, and the requests that
/// become of them: tests/approved/handed.
class TestApprovedHanded : public QObject
{
    Q_OBJECT
private slots:
    void classesAreUnderstoodAsApproved();
    void platformsAreReadAsApproved();
    void foldersAreReadAsApproved();
    void requestsAreReadWholeOrNotAtAll();
};

namespace {

void addFolders(const Made &made)
{
    made.file("ada/steps/L1.lua", "-- one\n");
    made.file("ada/steps/L9.lua");
    made.file("ada/notes/L1.md", "a note");
    made.file("ada/presets/L2.json", "{}");
    made.file("ada/cradle.json", "{\"format\": 1}");
    made.file("ada/answers.json", "{}");
    made.file("ada/predictions.json", "{}");
    made.file("ada/.git/HEAD", "ref: refs/heads/main\n");
    made.file("ada/.git/refs/heads/main", QByteArray(40, 'a'));
    made.file("ada/.git/config", "[core]");
    made.file("bob/down/deep/steps/l2.LUA");
    made.file("bob/.hidden/steps/L1.lua");
    made.file("cy/__MACOSX/steps/L1.lua");
    made.file("cy/mine.lua");
    made.file("dan/one.lua", "-- 1\n");
    made.file("dan/two.lua", "-- 2\n");
    made.file("don/lab (1).lua", "-- lab\n");
    made.file("don/zed.lua", "-- zed\n");
    made.file("eve/L1.lua");
    made.file("eve/L2 (3).lua");
    made.file("eve/work.cradle-work", "an archive");
    made.file("eve/older.cradle-work", "another");
    made.file("fay/1/2/3/4/5/6/7/8/9/steps/L1.lua");
    made.file("gus/only.txt");
    made.file("hal/work.zip", zipped({"steps/L1.lua", "__MACOSX/steps/L2.lua", ".x/L2.lua"}));
    made.file("ida/work.zip", zipped({"../L1.lua", "/L2.lua", "a/../../L2.lua"}));
    made.file("jo/work.zip", zipped({"down/steps/L1.lua", "inner.zip"}));
    made.file("kim/work.zip", "no zip");
    made.file("lee/long.lua", QByteArray(300'000, ' '));
    made.file("max/L1.lua");
    ::symlink("/etc/passwd", (made.root() + "/max/L2.lua").constData());
    made.file("ned/kept/L2.lua", "-- kept\n");
    ::symlink("kept/L2.lua", (made.root() + "/ned/L2.lua").constData());
    made.file("pat\x01\n/L1.lua");
    ::mkfifo((made.root() + "/pat\x01\n/L2.lua").constData(), 0600);
    made.file("Quinn-lab.cradle-work", "an archive");
    made.file("rob.lua");
    made.file("rob-2.lua");
    made.file("notes.txt");
    made.file(".hidden/steps/L1.lua");
}

void addDownloads(const Made &made)
{
    made.file("Ada Lovelace_1234567_assignsubmission_file_/L1 (1).lua");
    made.file("Ada Lovelace_1234567_assignsubmission_onlinetext_/onlinetext.html");
    made.file("Bob_13_assignsubmission_file_lab.lua");
    made.file("Cy_14_assignsubmission_onlinetext_/onlinetext.html");
    made.file("lovelaceada_10_20_L1-2.lua");
    made.file("boole_LATE_11_21_a_b.lua");
    made.file("boole_LATE_11_22_L2-13.lua");
    made.file("Lab_x_ada1_attempt_2026-05-01-12-30-00_lab.lua", "-- old\n");
    made.file("Lab_x_ada1_attempt_2026-05-02-12-30-00_lab.lua", "-- new\n");
    made.file("Lab_x_ada1_attempt_2026-05-02-12-30-00.txt", "Name: Ada\nDate Submitted: later\n");
    made.file("Lab_bob_attempt_2026-05-02-12-30-00.txt", "Name: Bob");
    made.file("Lab_x_cyd_attempt_2026-05-02-12-30-00_L1.lua");
    made.file("Lab_x_cyd_attempt_2026-05-02-12-30-00_L2.lua");
}

void addClones(const Made &made)
{
    for (const char *name : {"lab-4-ada", "lab-4-bob", "lab-4-cy-d"}) {
        made.file(QByteArray(name) + "/steps/L1.lua");
        made.file(QByteArray(name) + "/.git/HEAD", "ref: refs/heads/main\n");
    }
}

} // namespace

void TestApprovedHanded::classesAreUnderstoodAsApproved()
{
    QString all;
    const auto add = [&](const char *name, void (*fill)(const Made &),
                         const std::vector<RosterRow> &roster = {}) {
        const Made made;
        fill(made);
        all += QStringLiteral("== %1\n").arg(text(name)) + understood(made, roster);
    };
    add("folders", addFolders);
    add("downloads", addDownloads);
    add("clones", addClones);
    add("one student's work", [](const Made &made) {
        made.file("steps/L1.lua");
        made.file("lab.lua");
    });
    const auto row = [](const char *folder, const char *id, const char *name, const char *number,
                        double lateDays = 0.0) {
        return RosterRow{.folder = text(folder),
                         .id = text(id),
                         .name = text(name),
                         .number = text(number),
                         .email = text(name) + text("@school.org"),
                         .lateDays = lateDays};
    };
    const std::vector<RosterRow> roster{
        row("ada", "a1", "Ada Lovelace", "0042"), row("bob", "", "Bob", "1", 2.5),
        row("", "ada1", "Ada", "1234567"),        row("", "Cy", "", "14"),
        row("nowhere", "zed", "Zed", ""),         row("", "boole", "George", "11", 1.0),
        row("max/", "max", "Max", "7"),           row("rob.lua", "rob", "Rob", "0042")};
    add("folders, with a roster", addFolders, roster);
    add("downloads, with a roster", addDownloads, roster);
    add("clones, with a roster", addClones, roster);
    for (const int others : {1, 2, 3}) {
        const Made made;
        addDownloads(made);
        made.file("Lab_4_ada_l_attempt_2026-11-02-10-15-30_lab.lua");
        made.file("Lab_4_bob_attempt_2026-11-02-10-15-30_lab.lua");
        for (int i = 0; i < others; ++i)
            made.file("other" + QByteArray::number(i) + "/L1.lua");
        all += QStringLiteral("== downloads and %1 folders\n").arg(others)
               + understood(made, {row("", "ada_l", "Ada", "3")});
    }
    for (const int others : {0, 1, 2}) {
        const Made made;
        made.file("1/Ada_1_assignsubmission_file_/L1.lua");
        made.file("1/Bob_2_assignsubmission_file_/L2.lua");
        for (int i = 0; i < others; ++i)
            made.file("1/other" + QByteArray::number(i) + "/L1.lua");
        all += QStringLiteral("== two of Moodle and %1\n").arg(others) + understood(made);
    }
    add("GitHub Classroom", [](const Made &made) {
        made.file("lab-submissions/lab-ada/steps/L1.lua");
        made.file("lab-submissions/lab-/steps/L1.lua");
        made.file("lab-submissions/other/steps/L2.lua");
    });
    add("nobody", [](const Made &made) { made.file("readme.txt"); });
    add("one folder in another", [](const Made &made) {
        made.file("down/further/ada/L1.lua");
        made.file("down/further/bob/L2.lua");
    });
    compare("classes.txt", all);
}

void TestApprovedHanded::platformsAreReadAsApproved()
{
    QString all;
    for (const char *name : {"Ada_1_assignsubmission_file_",
                             "Ada_1_assignsubmission_file_L1.lua",
                             "Ada_1_assignsubmission_file",
                             "Ada_1_assignsubmission_onlinetext_x.html",
                             "_1_assignsubmission_file_",
                             "Ada_x_assignsubmission_file_",
                             "ada_10_20_L1.lua",
                             "ada_LATE_10_20_L1.lua",
                             "ada_late_10_20_L1.lua",
                             "ada_10_20_",
                             "ada_10_L1.lua",
                             "a_b_10_20_L1.lua",
                             "_10_20_L1.lua",
                             "Lab_ada_attempt_2026-05-01-12-30-00_lab.lua",
                             "Lab_ada_attempt_2026-05-01-12-30-00.txt",
                             "Lab_ada_attempt_2026-05-01-12-30-00.lua",
                             "Lab_ada_attempt_2026-05-01-12-30_lab.lua",
                             "_ada_attempt_2026-05-01-12-30-00",
                             "ada_attempt_2026-05-01-12-30-00_lab.lua",
                             "lab-ada",
                             ""}) {
        for (const bool isFolder : {false, true}) {
            const auto read = platformName(text(name), isFolder);
            all += QStringLiteral("%1, folder %2: ").arg(text(name)).arg(isFolder);
            all += read ? QStringLiteral("%1 | %2 | %3 | %4 | %5 | %6 | late %7\n")
                              .arg(platformText(read->platform), read->student, read->number,
                                   read->assignment, read->attempt, read->file)
                              .arg(read->late)
                        : text("–\n");
        }
    }
    const QStringList classes[] = {{text("Lab_4_ada")},
                                   {text("Lab 4_ada")},
                                   {text("Lab_4_ada_l"), text("Lab_4_bob"), text("Lab_4_bob")},
                                   {text("Lab_ada_l"), text("Lab_ada_m")},
                                   {text("a_b"), text("c_d_e")},
                                   {text("Lab_"), text("Lab_x")},
                                   {text("ada"), text("bob")}};
    for (const QStringList &heads : classes) {
        for (const QSet<QString> &known :
             {QSet<QString>{}, {text("ada"), text("ada_l")}, {text("bob"), text("l"), text("e")}}) {
            const BlackboardAccounts found = blackboardAccounts(heads, known);
            all += heads.join(u' ')
                   + QStringLiteral(" of %1: \"%2\", guess %3")
                         .arg(known.size())
                         .arg(found.common)
                         .arg(found.isGuess);
            for (const QString &head : heads)
                all += u' ' + found.byHead.value(head);
            all += u'\n';
        }
    }
    for (const char *name : {"Moodle", "Canvas", "Blackboard", "GitHub", "moodle", ""})
        all += QStringLiteral("%1 %2\n").arg(text(name)).arg(int(platformFrom(text(name))));
    compare("platforms.txt", all);
}

void TestApprovedHanded::foldersAreReadAsApproved()
{
    const Made made;
    addFolders(made);
    ::symlink("ada", (made.root() + "/link").constData());
    ::symlink("..", (made.root() + "/eve/out").constData());
    QString all;
    const auto entries = entriesOf(made.root(), 1000);
    QVERIFY(entries.ok());
    for (const FolderEntry &entry : *entries)
        all += QStringLiteral("%1 %2\n").arg(shownName(entry.name)).arg(int(entry.kind));
    const auto count = entries->size();
    for (const std::size_t most : {count, count - 1, std::size_t(1), std::size_t(0)}) {
        const auto some = entriesOf(made.root(), most);
        all +=
            some ? QStringLiteral("%1 fit\n").arg(some->size()) : some.error().toString() + u'\n';
    }
    for (const char *path :
         {"rob.lua", "link/steps/L1.lua", "max/L2.lua", "ned/L2.lua", "eve/out/rob.lua",
          "eve/out/../rob.lua", "ada", "pat\x01\n/L2.lua", "nowhere", "lee/long.lua"}) {
        for (const qint64 most : {0, 1, 5, 6, 7, 1'000'000}) {
            const auto bytes = readBelow(made.root(), made.root() + '/' + path, most);
            all += QStringLiteral("%1, %2: ").arg(shownName(path)).arg(most);
            all += bytes ? QStringLiteral("%1 bytes\n").arg(bytes->size())
                         : bytes.error().toString() + u'\n';
        }
    }
    for (const char *name : {"a", "a/b", "/a", "a/", "", "a\tb", "\xc3\xa4", "\xe4", "a\x7f"})
        all += QStringLiteral("%1 | %2\n").arg(shownName(name), shownName(lastName(name)));
    compare("folders.txt", placed(all, made.root()));
}

void TestApprovedHanded::requestsAreReadWholeOrNotAtAll()
{
    const JudgingRequest request{.seed = 7,
                                 .steps = {text("L1"), text("L2")},
                                 .files = {{text("steps/L1.lua"), "x = 1"}},
                                 .archive = "zip",
                                 .repository = {{text("HEAD"), "ref: refs/heads/main"}},
                                 .numbers = {text("0042"), text("a1")},
                                 .moments = false};
    const QByteArray bytes = bytesOf(request);
    QVERIFY(requestFrom(bytes) == request);
    for (qsizetype size = 0; size < bytes.size(); ++size)
        QVERIFY(!requestFrom(bytes.left(size)));
}

QTEST_GUILESS_MAIN(TestApprovedHanded)
#include "test_approved_handed.moc"
