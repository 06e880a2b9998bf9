// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "program_run.h"

#include "model/files/file_io.h"
#include "tasks/work/work_archive.h"

#include <QDir>
#include <QProcess>
#include <QRegularExpression>

#include <unistd.h>

using namespace cradle;
using namespace cradle::programs;

/// cradle-cli hand-in and report: a student's folder becomes a file, or a document.
class TestCliHandIn final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void handsInAPlainFolder();
    void wrongUsageIsSaid_data();
    void wrongUsageIsSaid();
    void writesOneSelfContainedPage();
    void printsADocument();
    void worksWithoutGit();
    void reportsOnWhatWasHandedIn();
    void speaksTheLanguageThatIsAskedFor();
    void formulasOfNotesAreSet();
    void namesAreTextEverywhere();
    void programsRunInCells();
    void unwritableIsExitThree();
    void hangingProgramIsToldAsSuch();

private:
    [[nodiscard]] QString path(const char *name) const
    {
        return m_folder.filePath(QLatin1String(name));
    }
    /// What a program says that knows the format; "failed: …" where it is displeased.
    static QString tool(const char *program, const QStringList &arguments);

    QTemporaryDir m_folder;
};

void TestCliHandIn::initTestCase()
{
    QVERIFY(!makeFolder(path("w/steps")));
    for (const char *id : {"BALL1", "BALL2"}) {
        const QString from = sourcePath("tasks/bouncing-ball/") + QLatin1String(id)
                             + QStringLiteral("/solution.lua");
        QVERIFY(QFile::copy(from, path("w/steps/") + QLatin1String(id) + QStringLiteral(".lua")));
    }
    QVERIFY(!writeFile(path("w/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
}

QString TestCliHandIn::tool(const char *program, const QStringList &arguments)
{
    const Outcome outcome = run(QString::fromLatin1(program), arguments);
    return outcome.code == 0 ? outcome.out : QStringLiteral("failed: ") + outcome.error;
}

void TestCliHandIn::handsInAPlainFolder()
{
    const QString file = path("ada.cradle-work");
    const Outcome outcome = runCli({QStringLiteral("hand-in"), path("w"), QStringLiteral("--name"),
                                    QStringLiteral("Ada"), QStringLiteral("--id"),
                                    QStringLiteral("s1"), QStringLiteral("--output"), file});
    VERIFY_CODE(outcome, 1); // the third step is not done
    const auto files = readWorkArchive(file);
    QVERIFY2(files, files ? "" : qPrintable(files.error().toString()));
    const auto manifest = manifestOf(*files);
    QVERIFY(manifest);
    QCOMPARE(manifest->student, QStringLiteral("Ada"));
    QCOMPARE(manifest->studentId, QStringLiteral("s1"));
    QCOMPARE(manifest->steps.size(), std::size_t(3));
    QCOMPARE(manifest->steps[0].verdict, QStringLiteral("passed"));
    QCOMPARE(manifest->steps[2].verdict, QStringLiteral("not done"));
    QVERIFY(files->value(QStringLiteral("report.pdf")).startsWith("%PDF-1."));
}

void TestCliHandIn::wrongUsageIsSaid_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::newRow("no folder") << "hand-in --output x.cradle-work";
    QTest::newRow("no output") << "hand-in WORK";
    QTest::newRow("another name") << "hand-in WORK --output x.zip";
    QTest::newRow("nowhere") << "hand-in /nowhere --output x.cradle-work";
    QTest::newRow("report of nothing") << "report /nowhere --output x.html";
    QTest::newRow("report without a name") << "report WORK";
    QTest::newRow("report as a text") << "report WORK --output x.txt";
    QTest::newRow("no lab") << "report WORK --lab /nowhere --output x.html";
    QTest::newRow("no language") << "report WORK --language xx --output x.html";
}

void TestCliHandIn::wrongUsageIsSaid()
{
    QFETCH(QString, arguments);
    QStringList words = arguments.split(QLatin1Char(' '));
    words.replaceInStrings(QStringLiteral("WORK"), path("w"));
    const Outcome outcome = runCli(words);
    VERIFY_CODE(outcome, 2);
    QVERIFY(!outcome.error.isEmpty());
}

void TestCliHandIn::writesOneSelfContainedPage()
{
    const QString file = path("r.html");
    VERIFY_CODE(runCli({QStringLiteral("report"), path("w"), QStringLiteral("--output"), file}), 1);
    const QString html = QString::fromUtf8(contentOf(file));
    QVERIFY(html.contains(QStringLiteral("<svg ")));
    // Nothing is loaded from anywhere.
    for (const char *loading : {"src=", "href=", "url(", "<script", "@import"})
        QVERIFY2(!html.contains(QLatin1String(loading)), loading);
    const QString valid =
        tool("xmllint", {QStringLiteral("--html"), QStringLiteral("--noout"), file});
    QVERIFY2(!valid.startsWith(QLatin1String("failed")), qPrintable(valid));
}

void TestCliHandIn::printsADocument()
{
    const QString file = path("r.pdf");
    const Outcome outcome = runCli({QStringLiteral("report"), path("w"), QStringLiteral("--name"),
                                    QStringLiteral("Ada"), QStringLiteral("--output"), file});
    VERIFY_CODE(outcome, 1);
    QVERIFY(contentOf(file).startsWith("%PDF-1."));
    const QString text = tool("pdftotext", {file, QStringLiteral("-")});
    for (const char *words : {"Ada", "BALL1", "What changed in the program", "2 of 3 steps pass"})
        QVERIFY2(text.contains(QLatin1String(words)), qPrintable(text.left(500)));
    const QStringList pages = text.split(QLatin1Char('\f'), Qt::SkipEmptyParts);
    for (const QString &page : pages) // has more than its number and the title at its foot
        QVERIFY2(page.trimmed().count(QLatin1Char('\n')) > 4, qPrintable(page));
    const QString fonts = tool("pdffonts", {file});
    const QStringList lines = fonts.split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QVERIFY2(lines.size() > 3, qPrintable(fonts));
    // Embedded, and with the letters that its signs stand for, so that text can be selected.
    static const QRegularExpression whole(QStringLiteral(" yes +(yes|no) +yes +\\d+ +\\d+$"));
    for (const QString &font : lines.mid(2))
        QVERIFY2(font.contains(whole), qPrintable(font));
    // What was changed is to be read as it was written: a ligature would have no letters.
    QVERIFY2(text.contains(QStringLiteral("-- ")), qPrintable(text.left(2000)));
    const Outcome drawn = run(QStringLiteral("pdftotext"), {file, path("r.txt")});
    QVERIFY2(drawn.error.isEmpty(), qPrintable(drawn.error)); // no broken path on any page
    const QString sound = tool("qpdf", {QStringLiteral("--check"), file});
    QVERIFY2(!sound.startsWith(QLatin1String("failed")), qPrintable(sound));
}

/// Where no program is to be found, and git has no settings.
void TestCliHandIn::worksWithoutGit()
{
    const QTemporaryDir home;
    QProcessEnvironment bare = QProcessEnvironment::systemEnvironment();
    bare.insert(QStringLiteral("PATH"), home.path());
    const QString file = path("bare.cradle-work");
    const QStringList handIn{QStringLiteral("hand-in"), path("w"), QStringLiteral("--output"),
                             file};
    VERIFY_CODE(run(cliProgram(), handIn, home.path(), bare), 1);
    const auto files = readWorkArchive(file);
    QVERIFY2(files, files ? "" : qPrintable(files.error().toString()));
    QVERIFY(files->value(QStringLiteral("report.pdf")).startsWith("%PDF-1."));
    const QStringList report{QStringLiteral("report"), file, QStringLiteral("--output"),
                             path("bare.html")};
    VERIFY_CODE(run(cliProgram(), report, home.path(), bare), 1);
}

void TestCliHandIn::reportsOnWhatWasHandedIn()
{
    const QString file = path("again.cradle-work");
    VERIFY_CODE(runCli({QStringLiteral("hand-in"), path("w"), QStringLiteral("--name"),
                        QStringLiteral("Ada"), QStringLiteral("--output"), file}),
                1);
    VERIFY_CODE(
        runCli({QStringLiteral("report"), file, QStringLiteral("--output"), path("a.html")}), 1);
    QVERIFY(contentOf(path("a.html")).contains("Ada"));
    // What was changed after that is no work that was handed in.
    QByteArray bytes = contentOf(file);
    bytes.chop(30);
    QVERIFY(!writeFile(file, bytes));
    VERIFY_CODE(
        runCli({QStringLiteral("report"), file, QStringLiteral("--output"), path("a.html")}), 2);
}

void TestCliHandIn::speaksTheLanguageThatIsAskedFor()
{
    const QString html = path("de.html");
    const QString german = QStringLiteral("de");
    VERIFY_CODE(runCli({QStringLiteral("report"), path("w"), QStringLiteral("--language"), german,
                        QStringLiteral("--output"), html}),
                1);
    const QString page = QString::fromUtf8(contentOf(html));
    QVERIFY(page.contains(QStringLiteral("<html lang=\"de\">")));
    QVERIFY(page.contains(QStringLiteral("Was sich am Programm geändert hat")));
    QVERIFY(page.contains(QStringLiteral("2 von 3 Schritten")));
    QVERIFY(!page.contains(QStringLiteral("What changed")));
    // Seconds and joules are written as in the lab's texts and its code.
    static const QRegularExpression quantity(QStringLiteral("\\d([.,])\\d+ (s|J|m)\\b"));
    int points = 0;
    for (auto all = quantity.globalMatch(page); all.hasNext(); ++points)
        QCOMPARE(all.next().captured(1), QStringLiteral("."));
    QVERIFY(points > 0);
    const QString pdf = path("de.pdf");
    VERIFY_CODE(runCli({QStringLiteral("report"), path("w"), QStringLiteral("--language"), german,
                        QStringLiteral("--output"), pdf}),
                1);
    const QString text = tool("pdftotext", {pdf, QStringLiteral("-")});
    QVERIFY2(text.contains(QStringLiteral("1 von ")), qPrintable(text.left(500)));
}

void TestCliHandIn::formulasOfNotesAreSet()
{
    QVERIFY(!makeFolder(path("f/steps")) && !makeFolder(path("f/notes")));
    QVERIFY(QFile::copy(path("w/steps/BALL1.lua"), path("f/steps/BALL1.lua")));
    QVERIFY(!writeFile(path("f/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
    QVERIFY(!writeFile(path("f/notes/BALL1.md"),
                       "Here $v = \\frac{a}{2} t$, and\n\n$$E = m g h$$\n\nbut not $\\frac{$.\n"));
    VERIFY_CODE(
        runCli({QStringLiteral("report"), path("f"), QStringLiteral("--output"), path("f.html")}),
        1);
    const QString html = QString::fromUtf8(contentOf(path("f.html")));
    if (!html.contains(QStringLiteral("vertical-align: -")))
        QSKIP("built without MathJax");
    QVERIFY(html.contains(QStringLiteral("aria-label=\"v = \\frac{a}{2} t\"")));
    QVERIFY(html.contains(
        QStringLiteral("<p align=\"center\"><svg role=\"img\" aria-label=\"E = m g h\"")));
    QVERIFY(html.contains(QStringLiteral("but not ")));
    for (const char *loading : {"src=", "href=", "url(", "<script", "@import"})
        QVERIFY2(!html.contains(QLatin1String(loading)), loading);
    VERIFY_CODE(
        runCli({QStringLiteral("report"), path("f"), QStringLiteral("--output"), path("f.pdf")}),
        1);
    const Outcome read =
        run(QStringLiteral("pdftotext"), {QStringLiteral("-raw"), path("f.pdf"), path("f.txt")});
    QVERIFY2(read.error.isEmpty(), qPrintable(read.error)); // no broken path on any page
    const QString text = QString::fromUtf8(contentOf(path("f.txt")));
    // A drawing, with its TeX beneath for who selects it or has it read aloud.
    QVERIFY2(text.contains(QStringLiteral("E = m g h")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("Here v = \\frac{a}{2} t, and")), qPrintable(text));
}

void TestCliHandIn::namesAreTextEverywhere()
{
    const QString name = QStringLiteral("A & B <i>");
    VERIFY_CODE(runCli({QStringLiteral("report"), path("w"), QStringLiteral("--name"), name,
                        QStringLiteral("--output"), path("n.pdf")}),
                1);
    const QString text = tool("pdftotext", {path("n.pdf"), QStringLiteral("-")});
    QVERIFY2(!text.contains(QStringLiteral("&amp;")), qPrintable(text.left(1000)));
    QVERIFY(text.count(QStringLiteral("A & B <i>")) > 1); // at the head, and below each page
    QVERIFY(tool("pdfinfo", {path("n.pdf")}).contains(QStringLiteral("– A & B <i>")));
}

/// A program that takes its time is found in a process that may open no file.
void TestCliHandIn::programsRunInCells()
{
    QVERIFY(!makeFolder(path("c/steps")));
    QVERIFY(!writeFile(path("c/steps/BALL1.lua"),
                       "function on_update() for i = 1, 1000000 do local x = i end end\n"));
    QVERIFY(!writeFile(path("c/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
    QProcess process;
    process.start(cliProgram(), {QStringLiteral("report"), path("c"), QStringLiteral("--output"),
                                 path("c.html")});
    QVERIFY(process.waitForStarted());
    bool found = false;
    while (!found && !process.waitForFinished(1)) {
        const QByteArray group =
            QByteArray::number(getpgid(static_cast<pid_t>(process.processId())));
        for (const QString &each :
             QDir(QStringLiteral("/proc")).entryList({QStringLiteral("[0-9]*")})) {
            const QString of = QStringLiteral("/proc/") + each;
            found = found
                    || (contentOf(of + QStringLiteral("/comm")).startsWith("cradle-cli")
                        && getpgid(each.toInt()) == group.toInt()
                        && contentOf(of + QStringLiteral("/limits"))
                               .contains("Max processes             0 "));
        }
    }
    QVERIFY(found);
    QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(120'000));
}

void TestCliHandIn::unwritableIsExitThree()
{
    VERIFY_CODE(runCli({QStringLiteral("report"), path("w"), QStringLiteral("--output"),
                        path("none/r.html")}),
                3);
    VERIFY_CODE(runCli({QStringLiteral("hand-in"), path("w"), QStringLiteral("--output"),
                        path("none/a.cradle-work")}),
                3);
}

void TestCliHandIn::hangingProgramIsToldAsSuch()
{
    QVERIFY(!makeFolder(path("h/steps")));
    QVERIFY(!writeFile(path("h/steps/BALL1.lua"), "function on_update() while true do end end\n"));
    QVERIFY(!writeFile(path("h/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
    VERIFY_CODE(
        runCli({QStringLiteral("report"), path("h"), QStringLiteral("--output"), path("h.html")}),
        1);
    QVERIFY(contentOf(path("h.html")).contains("stops with an error"));
}

QTEST_GUILESS_MAIN(TestCliHandIn)
#include "test_cli_hand_in.moc"
