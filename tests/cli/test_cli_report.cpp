// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "worked_folder.h"

#include "model/files/file_io.h"
#include "tasks/work/work_archive.h"

#include <QRegularExpression>

using namespace cradle;
using namespace cradle::programs;

/// cradle-cli report: a student's folder becomes a document.
class TestCliReport final : public WorkedFolderTest
{
    Q_OBJECT
private slots:
    void initTestCase() { solveTwoSteps(); }
    void writesOneSelfContainedPage();
    void printsADocument();
    void worksWithoutGit();
    void speaksTheLanguageThatIsAskedFor();
    void formulasOfNotesAreSet();
    void namesAreTextEverywhere();
    void hangingProgramIsToldAsSuch();
};

namespace {

/// What a program says that knows the format; "failed: …" where it is displeased.
QString tool(const char *program, const QStringList &arguments)
{
    const Outcome outcome = run(QString::fromLatin1(program), arguments);
    return outcome.code == 0 ? outcome.out : QStringLiteral("failed: ") + outcome.error;
}

} // namespace

void TestCliReport::writesOneSelfContainedPage()
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

void TestCliReport::printsADocument()
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
void TestCliReport::worksWithoutGit()
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

void TestCliReport::speaksTheLanguageThatIsAskedFor()
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

void TestCliReport::formulasOfNotesAreSet()
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

void TestCliReport::namesAreTextEverywhere()
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

void TestCliReport::hangingProgramIsToldAsSuch()
{
    QVERIFY(!makeFolder(path("h/steps")));
    QVERIFY(!writeFile(path("h/steps/BALL1.lua"), "function on_update() while true do end end\n"));
    QVERIFY(!writeFile(path("h/cradle.json"), R"({"format": 1, "lab": "bouncing-ball"})"));
    VERIFY_CODE(
        runCli({QStringLiteral("report"), path("h"), QStringLiteral("--output"), path("h.html")}),
        1);
    QVERIFY(contentOf(path("h.html")).contains("stops with an error"));
}

QTEST_GUILESS_MAIN(TestCliReport)
#include "test_cli_report.moc"
