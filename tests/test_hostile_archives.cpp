// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hostile_labs.h"
#include "tests/cli/program_run.h"

#include "tests/lab_breakers.h"
#include "tests/zip_maker.h"

#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_reader.h"

#include <unistd.h>

using namespace cradle;
using namespace cradle::authoring;
using namespace cradle::programs;

/// Archives of labs that are hostile or broken.
class TestHostileArchives : public QObject
{
    Q_OBJECT
private slots:
    void labWithoutAnIndexIsRefused_data();
    void labWithoutAnIndexIsRefused();
    void verifyRefusesHostileArchives_data();
    void verifyRefusesHostileArchives();
    void archiveIsAsGoodAsItsFolder();
};

void TestHostileArchives::labWithoutAnIndexIsRefused_data()
{
    QTest::addColumn<Breaker>("breakIt");
    QTest::addColumn<QByteArray>("place");
    const auto row = [](const char *name, const Breaker &breakIt, const char *place) {
        QTest::newRow(name) << breakIt << QByteArray(place);
    };
    row("newer format",
        put("lab.json", "{\"format\": 2, \"id\": \"x\", \"title\": \"x\", \"acts\": []}"),
        "/lab.json: /format: needs a newer Cradle: format 2, this one reads 1");
    row("step with a path", replace("lab.json", "\"S2\"", "\"../S2\""), "/lab.json: /steps/1: ");
    row("step that is a number", replace("lab.json", "\"S2\"", "2"), "/lab.json: /steps/1: ");
    row("1 GB", sparse("lab.json", 1024 * 1024 * 1024), "/lab.json: the file is too large");
    row("pipe", pipe("lab.json"), "/lab.json: this is neither");
    row("folder", folderInPlaceOf("lab.json"), "/lab.json: this is a folder");
    row("link", link("lab.json", text("/etc/passwd")), "/lab.json: this is a link");
    row("nothing", removed("lab.json"), "/lab.json: cannot be read");
    row("empty", put("lab.json", ""), "/lab.json:1: this is not JSON");
    row("list", put("lab.json", "[]"), "/lab.json: a list");
}

void TestHostileArchives::labWithoutAnIndexIsRefused()
{
    QFETCH(Breaker, breakIt);
    QFETCH(QByteArray, place);
    const QTemporaryDir temporary;
    const QString folder = temporary.filePath(text("lab"));
    makeLab(folder);
    breakIt(folder);
    const Outcome outcome = runCli({text("verify"), folder});
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(folder + QString::fromUtf8(place)),
             outcome.toText().constData());
}

void TestHostileArchives::verifyRefusesHostileArchives_data()
{
    QTest::addColumn<QByteArray>("archive");
    QTest::addColumn<QString>("word");
    const LabFiles lab = newLab(text("one"), text("One step"), text("en"));
    const auto with = [&](const ZipMaker::Entry &entry) {
        ZipMaker zip;
        for (auto it = lab.contents.begin(); it != lab.contents.end(); ++it)
            zip.add({.name = it.key().toUtf8(), .content = *it});
        return zip.add(entry).toBytes();
    };
    QTest::newRow("zip bomb") << with(
        {.name = "S1/x.md", .content = QByteArray(30'000'000, ' '), .deflate = true})
                              << text("S1/x.md: this unpacks to more than 200 times its size");
    QTest::newRow("path out of the lab")
        << with({.name = "../../x.lua", .content = "x"}) << text("../../x.lua: ");
    QTest::newRow("link") << with({.name = "S1/x.lua", .content = "/etc/passwd", .mode = 0120777})
                          << text("S1/x.lua: this is a link");
    QTest::newRow("no archive") << QByteArray("text") << text("this is no archive");
}

void TestHostileArchives::verifyRefusesHostileArchives()
{
    QFETCH(QByteArray, archive);
    QFETCH(QString, word);
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("evil.cradle"));
    writeTo(path, archive);
    const Outcome outcome = runCli({text("verify"), path});
    VERIFY_CODE(outcome, 2);
    QVERIFY2(outcome.error.startsWith(path + text(": ") + word), outcome.toText().constData());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{text("evil.cradle")});
}

void TestHostileArchives::archiveIsAsGoodAsItsFolder()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(text("one.cradle"));
    const LabFiles lab = newLab(text("one"), text("One step"), text("en"));
    QVERIFY(!exportLab(lab, path));
    const Outcome verified = runCli({text("verify"), path});
    VERIFY_CODE(verified, 0);
    QVERIFY2(verified.out.contains(text("1 steps, 1 mistakes, 0 problems")),
             verified.toText().constData());
    const QString program = folder.filePath(text("lab.lua"));
    writeTo(program, lab.contents[text("S1/solution.lua")]);
    VERIFY_CODE(runCli({text("check"), text("S1"), program, text("--lab"), path}), 0);
    writeTo(program, lab.contents[text("S1/mistakes/upward.lua")]);
    const Outcome failed = runCli({text("check"), text("S1"), program, text("--lab"), path});
    VERIFY_CODE(failed, 1);
    QVERIFY2(failed.out.contains(text("The circle falls upward")), failed.toText().constData());
}

QTEST_GUILESS_MAIN(TestHostileArchives)
#include "test_hostile_archives.moc"
