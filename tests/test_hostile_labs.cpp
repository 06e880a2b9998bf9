// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hostile_labs.h"
#include "tests/cli/program_run.h"

#include "tests/lab_breakers.h"
#include "tests/zip_maker.h"

#include "tasks/reading/lab_reader.h"

#include <unistd.h>

using namespace cradle;
using namespace cradle::authoring;
using namespace cradle::programs;

/// Labs with broken and hostile files: what is wrong is said with its file, and the rest opens.
class TestHostileLabs : public QObject
{
    Q_OBJECT
private slots:
    void restOfTheLabOpens_data();
    void restOfTheLabOpens();
    void verifySaysTheSame_data();
    void verifySaysTheSame();
};

namespace {

struct Case {
    const char *name;
    Breaker breakIt;
    const char *finding; ///< begins it, after the folder
    int steps;           ///< that open all the same
};

std::vector<Case> cases()
{
    constexpr qint64 gigabyte = 1024 * 1024 * 1024;
    const QByteArray nested = QByteArray(200'000, '[');
    std::vector<Case> list{
        {"unknown key in a task", replace("S2/task.json", "\"hints\"", "\"tips\": [], \"hints\""),
         "/S2/task.json: /tips: unknown key", 1},
        {"wrong type in a task", replace("S2/task.json", "\"Second\"", "[\"Second\"]"),
         "/S2/task.json: /title: ", 1},
        {"broken syntax", put("S2/task.json", "{\n\"format\": 1,\n}\n"),
         "/S2/task.json:3: this is not JSON", 1},
        {"JSON nested too deeply", put("S2/task.json", nested), "/S2/task.json:1: this is not JSON",
         1},
        {"objects nested too deeply",
         put("S2/preset.json", QByteArray("{\"a\":").repeated(100'000)),
         "/S2/preset.json:1: this is not JSON", 1},
        {"task of a newer format", replace("S2/task.json", "\"format\": 1", "\"format\": 3"),
         "/S2/task.json: /format: needs a newer Cradle: format 3, this one reads 1", 1},
        {"preset of a newer format", replace("S2/preset.json", "\"format\": 1", "\"format\": 2"),
         "/S2/preset.json: /format: needs a newer Cradle: format 2, this one reads 1", 1},
        {"same id twice", replace("S2/task.json", "\"S2\"", "\"S1\""),
         "/S2/task.json: /id: another step has the id S1", 1},
        {"step that is not there", replace("lab.json", "\"S2\"", "\"S3\""),
         "/S3/task.json: cannot be read", 1},
        {"step that is listed twice", replace("lab.json", "\"S2\"", "\"S2\", \"S2\""),
         "/lab.json: /steps/2: the step S2 is listed already", 2},
        {"no preset", removed("S2/preset.json"), "/S2/preset.json: cannot be read", 1},
        {"no instructions", removed("S2/instructions.md"), "/S2/instructions.md: cannot be read",
         2},
        {"preset that cannot be", replace("S2/preset.json", "0.2", "-0.2"),
         "/S2/preset.json: /circles/0/radius: -0.2", 1},
        {"crowd that does not fit",
         put("S2/preset.json", "{\"format\": 1, \"circles\": {\"fill\": {\"count\": 100000, "
                               "\"radius\": 3}}}"),
         "/S2/preset.json: /circles/fill", 1},
        {"translation that is broken", put("S2/task.en.json", "{\"title\": 5}"),
         "/S2/task.en.json: /title: ", 2},
        {"mistake without a word", put("S2/mistakes/mute.lua", "function on_update(dt)\nend\n"),
         "/S2/mistakes/mute.lua:1: ", 2},
        {"program that is too large", put("S2/solution.lua", QByteArray(5'000'000, '-')),
         "/S2/solution.lua: the file is too large", 2},
        {"text of 1 GB", sparse("S2/instructions.md", gigabyte),
         "/S2/instructions.md: the file is too large", 2},
        {"task of 1 GB", sparse("S2/task.json", gigabyte), "/S2/task.json: the file is too large",
         1},
        {"picture of 1 GB", sparse("S2/large.png", gigabyte),
         "/S2/large.png: the file is too large", 2},
        {"many large files",
         [](const QString &folder) {
             for (int i = 0; i < 9; ++i)
                 sparse(qPrintable(text("S2/large%1.bin").arg(i)), 16 * 1024 * 1024)(folder);
         },
         "/S2/large7.bin: the lab is too large", 2},
        {"picture that is a bomb", put("S2/bomb.png", pngOf(60'000, 60'000)),
         "/S2/bomb.png: the picture has 60000 × 60000 pixels", 2},
        {"text in Latin-1",
         put("S2/instructions.md", "# Gr\xf6\xdf"
                                   "e\n"),
         "/S2/instructions.md: the text is not in UTF-8", 2},
        {"program in Latin-1", replace("S2/solution.lua", "-- Lengths", "-- L\xe4ngen"),
         "/S2/solution.lua: the text is not in UTF-8", 2},
        {"task in UTF-16", put("S2/task.json", QByteArray("\xff\xfe{\0\n\0", 6)),
         "/S2/task.json:1: this is not JSON", 1},
        {"NUL in a text", put("S2/instructions.md", QByteArray("# Title\n\nA\0B\n", 12)),
         "/S2/instructions.md:3: the text has characters that are none", 2},
        {"NUL in a program", put("S2/mistakes/zeros.lua", QByteArray("-- A\n\nx = '\0'\n", 14)),
         "/S2/mistakes/zeros.lua:3: the text has characters that are none", 2},
        {"NUL in a task", put("S2/task.json", QByteArray("{\0}", 3)),
         "/S2/task.json:1: this is not JSON", 1},
        {"folder named like a task", folderInPlaceOf("S2/task.json"),
         "/S2/task.json: this is a folder; a file is right", 1},
        {"folder named like a text", folderInPlaceOf("S2/instructions.md"),
         "/S2/instructions.md: this is a folder; a file is right", 2},
        {"folder named like a mistake", folderInPlaceOf("S2/mistakes/more.lua"),
         "/S2/mistakes/more.lua: this is a folder; a file is right", 2},
        {"file named like a step",
         [](const QString &folder) {
             QVERIFY(QDir(folder + text("/S2")).removeRecursively());
             writeTo(folder + text("/S2"), "text");
         },
         "/S2/task.json: cannot be read", 1},
        {"link out of the lab", link("S2/instructions.md", text("/etc/passwd")),
         "/S2/instructions.md: this is a link", 2},
        {"link out of the lab, relative", link("S2/solution.lua", text("../../../../etc/passwd")),
         "/S2/solution.lua: this is a link", 2},
        {"link to nowhere", link("S2/task.json", text("nowhere.json")),
         "/S2/task.json: this is a link", 1},
        {"link to itself", link("S2/task.json", text("task.json")), "/S2/task.json: this is a link",
         1},
        {"link to the folder above", link("S2/loop", text("..")), "/S2/loop: this is a link", 2},
        {"link to all files there are", link("S2/all", text("/")), "/S2/all: this is a link", 2},
        {"endless device", link("S2/instructions.md", text("/dev/zero")),
         "/S2/instructions.md: this is a link", 2},
        {"pipe", pipe("S2/instructions.md"), "/S2/instructions.md: this is neither", 2},
        {"pipe that is a task", pipe("S2/task.json"), "/S2/task.json: this is neither", 1},
        {"name with a line end", put("S2/a\nb.md", "text"), "/S2/a\nb.md: a name without", 2},
        {"name of another system", put("S2/a\\evil.md", "text"), "/S2/a\\evil.md: ", 2},
        {"folders nested too deeply", deepFolders(60), "/S2/d/d/d/d/d: folders are nested", 2},
        {"too many files", manyFiles(10'050), "/S2/z/", 2},
    };
    if (geteuid() != 0) // for whom no file is locked
        list.push_back({"file that may not be read", locked("S2/task.json"),
                        "/S2/task.json: cannot be read", 1});
    return list;
}

void addCases()
{
    QTest::addColumn<Breaker>("breakIt");
    QTest::addColumn<QByteArray>("finding");
    QTest::addColumn<int>("steps");
    for (const Case &each : cases())
        QTest::newRow(each.name) << each.breakIt << QByteArray(each.finding) << each.steps;
}

/// Whether a line of \p said begins so.
bool says(const QStringList &said, const QString &start)
{
    for (const QString &line : said) {
        if (line.startsWith(start))
            return true;
    }
    return false;
}

} // namespace

void TestHostileLabs::restOfTheLabOpens_data()
{
    addCases();
}

void TestHostileLabs::restOfTheLabOpens()
{
    QFETCH(Breaker, breakIt);
    QFETCH(QByteArray, finding);
    QFETCH(int, steps);
    const QTemporaryDir temporary;
    const QString folder = temporary.filePath(text("lab"));
    makeLab(folder);
    QVERIFY(readLab(folder)->findings.empty());
    breakIt(folder);
    const Result<Lab> lab = readLab(folder);
    QVERIFY2(lab.ok(), lab ? "" : qPrintable(lab.error().toString()));
    QCOMPARE(lab->tasks.size(), static_cast<std::size_t>(steps));
    QCOMPARE(lab->tasks[0].id, text("S1"));
    QStringList said;
    for (const Error &each : lab->findings)
        said.append(each.toString());
    QVERIFY2(says(said, folder + QString::fromUtf8(finding)),
             qPrintable(said.join(QLatin1Char('\n'))));
    QCOMPARE(QSet<QString>(said.begin(), said.end()).size(), said.size()); // nothing twice
}

void TestHostileLabs::verifySaysTheSame_data()
{
    addCases();
    QTest::newRow("no solution") << removed("S2/solution.lua") << QByteArray() << 2;
}

void TestHostileLabs::verifySaysTheSame()
{
    QFETCH(Breaker, breakIt);
    QFETCH(QByteArray, finding);
    const QTemporaryDir temporary;
    const QString folder = temporary.filePath(text("lab"));
    makeLab(folder);
    breakIt(folder);
    const Outcome outcome = runCli({text("verify"), folder});
    VERIFY_CODE(outcome, 1);
    if (finding.isEmpty())
        QVERIFY2(outcome.out.contains(text("! there is no solution.lua")),
                 outcome.toText().constData());
    else
        QVERIFY2(outcome.error.contains(folder + QString::fromUtf8(finding)),
                 outcome.toText().constData());
    QVERIFY2(outcome.out.contains(text("S1  Make it fall")), outcome.toText().constData());
}

QTEST_GUILESS_MAIN(TestHostileLabs)
#include "test_hostile_labs.moc"
