// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_class.h"

#include "tasks/grading/raw_folder.h"

#include <QTest>

#include <functional>

using namespace cradle;
using namespace cradle::classes;

/// What is understood of odd works that a class handed in: tests/approved/handed/odd.txt.
class TestApprovedOddWorks : public QObject
{
    Q_OBJECT
private slots:
    void oddWorksAreReadAsApproved();
};

/// What is just as much as is looked at and one more, what is there twice, and what is no work.
void TestApprovedOddWorks::oddWorksAreReadAsApproved()
{
    QString all;
    const auto add = [&](const char *name, const std::function<void(const Made &)> &fill,
                         const std::vector<RosterRow> &roster = {}) {
        const Made made;
        fill(made);
        all += QStringLiteral("== %1\n").arg(text(name)) + understood(made, roster);
    };
    add("noise", [](const Made &made) {
        for (const char *name : {"Thumbs.db", "desktop.ini", "index.html", "__MACOSX/ada/L1.lua",
                                 "old~", ".x", "lab/Thumbs.db", "lab/ada/L1.lua", "lab/bob/L1.lua"})
            made.file(name);
    });
    add("one folder with Moodle's name", [](const Made &made) {
        made.file("Ada_1_assignsubmission_file_/L1.lua");
        made.file("index.html");
    });
    for (const int files : {2000, 2001})
        add("many files", [&](const Made &made) {
            made.file("ada/a/L1.lua");
            for (int i = 1; i < files; ++i)
                made.file("ada/b/" + QByteArray::number(i) + ".txt", "");
            made.file("ada/steps/L2.lua");
        });
    for (const int files : {2001, 2002})
        add("many files in a zip", [&](const Made &made) {
            ZipMaker zip;
            for (int i = 1; i < files; ++i)
                zip.add({.name = QByteArray::number(i) + ".txt"});
            zip.add({.name = "steps/L2.lua", .content = "x = 2\n"});
            made.file("ada/work.zip", zip.toBytes());
            made.file("bob/L1.lua");
        });
    add("twice in a zip, in no order", [](const Made &made) {
        ZipMaker zip;
        for (const char *content : {"-- first\n", "-- second\n", "-- third\n"}) {
            zip.add({.name = "steps/L2.lua", .content = content});
            zip.add({.name = "steps/L1.lua", .content = content});
        }
        made.file("ada/work.zip", zip.toBytes());
    });
    for (const int folders : {5, 6, 7})
        add("deep", [&](const Made &made) {
            const QByteArray deep = QByteArray("d/").repeated(folders) + "L1.lua";
            made.file("ada/" + deep);
            made.file("bob/work.zip", ZipMaker().add({.name = deep, .content = "1"}).toBytes());
        });
    add("two workspaces", [](const Made &made) {
        made.file("ada/old/lab/steps/L1.lua", "-- old\n");
        made.file("ada/lab/steps/L1.lua", "-- new\n");
        made.file("bob/a/steps/L1.lua", "-- a\n");
        made.file("bob/b/c/steps/L1.lua", "-- c\n");
        made.file("bob/b/steps/L2.lua", "-- b\n");
    });
    add("loose files", [](const Made &made) {
        for (const char *name : {"ada/lab.lua", "ada/mine.lua", "bob/lab (2).lua", "bob/zz.lua",
                                 "cy/work.7z", "dan/work.tar.gz", "eve/L1 (1).LUA", "eve/L1.lua"})
            made.file(name, QByteArray("-- ") + name + '\n');
    });
    add("of a class in a zip", [](const Made &made) {
        made.file("ada/one.zip", zipped({"Ada_1_assignsubmission_file_/L1.lua"}));
        made.file("bob/two.zip", zipped({"Ada_1_assignsubmission_file_/L1.lua",
                                         "Bob_2_assignsubmission_file_/L1.lua"}));
        made.file("cy/files.zip", zipped({"ada_1_2_L1.lua", "bob_3_4_L1.lua"}));
    });
    add("with histories", [](const Made &made) {
        made.file("ada/lab/steps/L1.lua");
        made.file("ada/lab/.git/HEAD", "ref: refs/heads/main\n");
        made.file("ada/lab/.git/packed-refs", "# none\n");
        made.file("ada/lab/.git/objects/ab/" + QByteArray(38, 'c'), "x");
        made.file("ada/lab/.git/a/b/c/d/e/f/g/h", "x");
        made.file("bob/work.zip", zipped({"lab/steps/L1.lua", "lab/.git/HEAD", "lab/.git/config",
                                          "lab/.git/refs/heads/main"}));
        made.file("cy/steps/L1.lua");
        made.file("cy/.git", "gitdir: elsewhere\n");
    });
    const std::vector<RosterRow> names{
        {.id = text("o1"), .name = text("Mary O'Neil"), .number = text("7")},
        {.id = text("o2"), .name = text("Jean-Luc Picard"), .number = text("12")},
        {.id = text("o3"), .name = text("Mary O'Neil"), .number = text("9")}};
    add(
        "names with marks, numbers of the platform",
        [](const Made &made) {
            made.file("oneilmary_7_20_L1.lua");
            made.file("picardjeanluc_11_21_L1.lua");
        },
        names);
    {
        const Made made;
        made.file("in/x.lua");
        made.file("in more/x.lua");
        for (const char *place : {"in/x.lua", "nowhere", "in"}) {
            const auto entries = entriesOf(made.root() + '/' + place, 10);
            all += entries ? QStringLiteral("%1 entries\n").arg(entries->size())
                           : placed(entries.error().toString(), made.root()) + u'\n';
        }
        const auto bytes = readBelow(made.root() + "/in", made.root() + "/in more/x.lua", 10);
        all += bytes ? text("read\n") : placed(bytes.error().toString(), made.root()) + u'\n';
    }
    compare("odd.txt", all);
}

QTEST_GUILESS_MAIN(TestApprovedOddWorks)
#include "test_approved_odd_works.moc"
