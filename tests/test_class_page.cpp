// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_of_three.h"
#include "tasks/grading/class_page.h"
#include "tasks/grading/page.h"
#include "tasks/grading/student_page.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <utility>

using namespace cradle;
using namespace cradle::classes;

/// The pages of a class and of a student: valid, harmless, true, and silent about others.
class TestClassPage : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void pagesAreValid_data();
    void pagesAreValid();
    void pagesNeedNothingElse_data();
    void pagesNeedNothingElse();
    void nothingOfAStudentBecomesAnElement_data();
    void nothingOfAStudentBecomesAnElement();
    void studentPageTellsVerdictLineAndMoment();
    void studentPageHoldsNothingOfOthers();
    void latenessIsToldWithTheSum();
    void whatIsNotGradedIsNeitherPassedNorFailed();
    void classPageTellsWhoIsWhere();
    void numbersThatAreNotClearAreTold();
    void examplesAreWithoutNames();
    void namesAreFoundAsWholeWords();
    void oneAttemptIsItsOwnMedian();
    void sameResultsSameBytes();
    void emptyClassHasAPage();
    void resultsOfAnotherNameAreRefused();
    void brokenResultIsNamed();
    void codeAroundMarksItsLine();

private:
    [[nodiscard]] QByteArray page(const char *name) const;
    void addPages();

    QTemporaryDir m_folder;
    Lab m_lab = smallLab();
    ClassFacts m_facts = facts();
};

namespace {

/// Whether Python's parser finds every element closed and no other than we write; and whether Tidy
/// has nothing to say, where it is installed.
QByteArray faultsOf(const QByteArray &html)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("page.html"));
    if (writeFile(path, html))
        return "cannot be written";
    const QString script = QStringLiteral(R"py(
import html.parser, sys
VOID = {'meta', 'br', 'rect', 'circle', 'polyline', 'polygon'}
OPTIONAL = {'td', 'th', 'tr'}
KNOWN = VOID | OPTIONAL | set('''html head title style body header main footer h1 h2 h3 h4 p ul ol li
    a b i bdi code pre span div section table caption thead tbody details summary figure figcaption
    svg text'''.split())
class Reader(html.parser.HTMLParser):
    stack, faults, ids = [], [], set()
    def handle_starttag(self, tag, attributes):
        if tag not in KNOWN: self.faults.append('unknown ' + tag)
        for name, value in attributes:
            if name.startswith('on'): self.faults.append('script in ' + name)
            if name == 'id' and value in self.ids: self.faults.append('twice ' + value)
            if name == 'id': self.ids.add(value)
        if tag in ('td', 'th', 'tr'):
            while self.stack and self.stack[-1] in OPTIONAL and (tag == 'tr' or self.stack[-1] != 'tr'):
                self.stack.pop()
        if tag not in VOID: self.stack.append(tag)
    def handle_startendtag(self, tag, attributes):
        if tag not in VOID: self.faults.append('empty ' + tag)
    def handle_endtag(self, tag):
        while self.stack and self.stack[-1] != tag and self.stack[-1] in OPTIONAL: self.stack.pop()
        if not self.stack or self.stack[-1] != tag: self.faults.append('stray end of ' + tag)
        else: self.stack.pop()
reader = Reader()
reader.feed(open(sys.argv[1], encoding='utf-8').read())
reader.close()
print('\n'.join(reader.faults + ['open ' + tag for tag in reader.stack]), end='')
)py");
    const auto run = [](const QString &program, const QStringList &arguments) {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(program, arguments);
        if (!process.waitForFinished(60'000))
            return QByteArray("does not run");
        return process.readAll();
    };
    QByteArray faults = run(QStringLiteral("python3"), {QStringLiteral("-c"), script, path});
    if (!QStandardPaths::findExecutable(QStringLiteral("tidy")).isEmpty())
        faults += run(QStringLiteral("tidy"),
                      {QStringLiteral("-q"), QStringLiteral("-e"),
                       QStringLiteral("--drop-empty-elements"), QStringLiteral("no"), path});
    return faults;
}

} // namespace

void TestClassPage::init()
{
    const std::vector<StudentResult> students{mallory(m_lab), ada(m_lab), bob(m_lab)};
    QVERIFY(keep(m_folder.path(), students, m_lab));
    const auto fault = writeClassResults(m_folder.path(), m_lab, m_facts);
    QVERIFY2(!fault, fault ? qPrintable(fault->toString()) : "");
}

QByteArray TestClassPage::page(const char *name) const
{
    QFile file(m_folder.filePath(QString::fromLatin1(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestClassPage::addPages()
{
    QTest::addColumn<QByteArray>("html");
    init();
    for (const char *name :
         {"class.html", "students/ada.html", "students/bob.html", "students/mallory.html"})
        QTest::newRow(name) << page(name);
}

void TestClassPage::pagesAreValid_data()
{
    addPages();
}

void TestClassPage::pagesAreValid()
{
    QFETCH(QByteArray, html);
    QVERIFY(html.startsWith("<!DOCTYPE html>\n<html lang=\"en\">"));
    QCOMPARE(faultsOf(html), QByteArray());
}

void TestClassPage::pagesNeedNothingElse_data()
{
    addPages();
}

void TestClassPage::pagesNeedNothingElse()
{
    QFETCH(QByteArray, html);
    // The name of SVG's space is the only address, and nothing loads.
    QByteArray rest = html;
    rest.replace("xmlns=\"http://www.w3.org/2000/svg\"", "");
    for (const char *word : {"http:", "https:", "src=", "url(", "@import", "<link", "<iframe"})
        QVERIFY2(!rest.contains(word) || rest.contains("&lt;img src=x"), word);
    QVERIFY(html.contains("default-src 'none'"));
    QVERIFY(html.contains("prefers-color-scheme: dark"));
    QVERIFY(html.contains("@media print"));
}

void TestClassPage::nothingOfAStudentBecomesAnElement_data()
{
    addPages();
}

void TestClassPage::nothingOfAStudentBecomesAnElement()
{
    QFETCH(QByteArray, html);
    QVERIFY(!html.contains("<script"));
    QVERIFY(!html.contains("<img"));
    QVERIFY(!html.contains("<b>the sign"));
}

void TestClassPage::studentPageTellsVerdictLineAndMoment()
{
    const QString html = QString::fromUtf8(page("students/mallory.html"));
    QVERIFY(html.contains(QStringLiteral("It goes backwards</summary>")));
    QVERIFY(html.contains(QStringLiteral("<code>v * t</code>")));
    QVERIFY(html.contains(QStringLiteral("<details class=\"printed\" open>")));
    QVERIFY(html.contains(QStringLiteral("<span data-line=\"2\" class=\"marked\">local mallory = "
                                         "&quot;&lt;!--&quot; ]]&gt; &amp; Mallory")));
    QVERIFY(html.contains(QStringLiteral("first goes wrong here, at 0.50 s.")));
    QVERIFY(html.contains(QStringLiteral("<polyline points=")));
    QVERIFY(html.contains(QStringLiteral("0 of 2 steps pass · 1 of 5.5 points")));
    QVERIFY(html.contains(QStringLiteral("Nothing was handed in for this step.")));
}

void TestClassPage::studentPageHoldsNothingOfOthers()
{
    for (const auto &[own, others] :
         {std::pair{"students/ada.html", QList<QByteArray>{"Bob", "Mallory", "alert", "backwards"}},
          std::pair{"students/bob.html", QList<QByteArray>{"Ada", "Mallory", "alert"}},
          std::pair{"students/mallory.html", QList<QByteArray>{"Ada", "Bob", "Eve"}}}) {
        const QByteArray html = page(own);
        QVERIFY(!html.isEmpty());
        for (const QByteArray &other : others)
            QVERIFY2(!html.contains(other), other);
    }
}

void TestClassPage::latenessIsToldWithTheSum()
{
    const QByteArray html = page("students/ada.html");
    QVERIFY(html.contains("2 of 2 steps pass · 4.4 of 5.5 points"));
    QVERIFY(html.contains("That takes 20 % of the points"));
    QVERIFY(!page("students/bob.html").contains("taken off already"));
}

void TestClassPage::whatIsNotGradedIsNeitherPassedNorFailed()
{
    const QByteArray html = page("students/bob.html");
    QVERIFY(html.contains("? not graded"));
    QVERIFY(html.contains("the machine &amp; all failed"));
    QVERIFY(html.contains("<p class=\"sum\">1 of 2 steps pass</p>"));
    QVERIFY(html.contains("– of 2.5"));
    QVERIFY(page("class.html").contains("<bdi>Bob Dobbs</bdi>, S2: the machine &amp; all failed"));
}

void TestClassPage::classPageTellsWhoIsWhere()
{
    const QString html = QString::fromUtf8(page("class.html"));
    const auto rowOf = [&](const char *id) {
        const auto start =
            html.indexOf(QStringLiteral("<a href=\"students/%1.html\">").arg(QLatin1String(id)));
        return html.mid(start, html.indexOf(QLatin1Char('\n'), start) - start);
    };
    QVERIFY(rowOf("ada").endsWith(QStringLiteral("<td class=p>✓<td class=p>✓<td class=number>2"
                                                 "<td class=number>4.4")));
    QVERIFY(rowOf("bob").endsWith(QStringLiteral("<td class=p>✓<td class=n>?<td class=number>1"
                                                 "<td class=number>–")));
    QVERIFY(rowOf("mallory").endsWith(QStringLiteral("<td class=f>○<td class=m>·"
                                                     "<td class=number>0<td class=number>1")));
    QVERIFY(html.contains(QStringLiteral("<bdi>Eve, Nobody</bdi>")));
    QVERIFY(html.contains(QStringLiteral("<li>a remark &amp; more</li>")));
    QVERIFY(html.contains(QStringLiteral("Programs were kept apart by: rlimits.")));
}

void TestClassPage::numbersThatAreNotClearAreTold()
{
    QVERIFY(!page("class.html").contains("Numbers that are not clear"));
    std::vector<StudentResult> students{mallory(m_lab), ada(m_lab), bob(m_lab)};
    for (StepResult &step : students[0].steps) {
        step.drawnBy = QStringLiteral("<13>");
        step.ownNumber = QStringLiteral("0012");
    }
    for (StepResult &step : students[1].steps)
        step.drawnBy = step.ownNumber = QStringLiteral("12");
    for (StepResult &step : students[2].steps)
        step.drawnBy = QStringLiteral("14");
    const QTemporaryDir folder;
    QVERIFY(keep(folder.path(), students, m_lab));
    const auto fault = writeClassResults(folder.path(), m_lab, m_facts);
    QVERIFY2(!fault, fault ? qPrintable(fault->toString()) : "");
    const auto textOf = [&](const char *name) {
        QFile file(folder.filePath(QString::fromLatin1(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray html = textOf("class.html");
    QCOMPARE(faultsOf(html), QByteArray());
    QVERIFY(html.contains("the roster has <bdi>&lt;13&gt;</bdi>, what was handed in has "
                          "<bdi>0012</bdi>; judged with the values of <bdi>&lt;13&gt;</bdi>."));
    QVERIFY(html.contains("<bdi>12</bdi> stands in what several handed in: "));
    QCOMPARE(html.count("the roster has <bdi>"), 1);
    const QByteArray mallorys = textOf("students/mallory.html");
    QVERIFY(mallorys.contains("judged with the values that are drawn by the number &lt;13&gt;."));
    QVERIFY(textOf("students/bob.html").contains("drawn by the number 14."));
    QVERIFY(textOf("students/mallory.json").contains("\"number_differs\":true"));
}

void TestClassPage::examplesAreWithoutNames()
{
    const QString html = QString::fromUtf8(page("class.html"));
    const auto start = html.indexOf(QStringLiteral("What the class misunderstood</h2>"));
    const auto end = html.indexOf(QStringLiteral("<h2>"), start);
    const QString section = html.mid(start, end - start);
    QVERIFY(section.contains(QStringLiteral("1 ×")));
    QVERIFY(section.contains(QStringLiteral("It goes backwards")));
    QVERIFY(section.contains(QStringLiteral("class=\"marked\">local …")));
    for (const char *word : {"Mallory", "mallory", "again", "-77"})
        QVERIFY2(!section.contains(QLatin1String(word)), word);
}

void TestClassPage::namesAreFoundAsWholeWords()
{
    StudentResult student{.id = QStringLiteral("ann-lee")};
    student.name = QStringLiteral("Ann Lee Ü. Çelik");
    QCOMPARE(withoutNames(QStringLiteral("ANN planned, fleet of ÇELIK; U"), student),
             QStringLiteral("… planned, fleet of …; U"));
    QCOMPARE(withoutComments(QStringLiteral("a = 1 -- Ann\n--[[ Lee\nLee ]] b = '--'")),
             QStringLiteral("a = 1       \n        \n       b = '--'"));
}

void TestClassPage::oneAttemptIsItsOwnMedian()
{
    QVERIFY(page("class.html")
                .contains("<td class=\"number\">1</td><td class=\"number\">4</td>"
                          "<td class=\"number\">4</td><td class=\"number\">12</td>"));
}

void TestClassPage::sameResultsSameBytes()
{
    const QByteArray before = page("class.html");
    QVERIFY(!writeClassResults(m_folder.path(), m_lab, m_facts));
    QCOMPARE(page("class.html"), before);
}

void TestClassPage::emptyClassHasAPage()
{
    const QTemporaryDir folder;
    QVERIFY(!writeClassResults(folder.path(), m_lab, m_facts));
    QFile file(folder.filePath(QStringLiteral("class.html")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(faultsOf(file.readAll()), QByteArray());
}

void TestClassPage::resultsOfAnotherNameAreRefused()
{
    const QTemporaryDir folder;
    StudentResult student = ada(m_lab);
    QVERIFY(keep(folder.path(), {student}, m_lab));
    QVERIFY(QFile::rename(folder.filePath(QStringLiteral("students/ada.json")),
                          folder.filePath(QStringLiteral("students/eve.json"))));
    const auto fault = writeClassResults(folder.path(), m_lab, m_facts);
    QVERIFY(fault && fault->message.contains(QStringLiteral("ada")));
}

void TestClassPage::brokenResultIsNamed()
{
    const QTemporaryDir folder;
    QVERIFY(keep(folder.path(), {ada(m_lab)}, m_lab));
    QVERIFY(!writeFile(folder.filePath(QStringLiteral("students/bob.json")), "{\"format\": 1"));
    const auto fault = writeClassResults(folder.path(), m_lab, m_facts);
    QVERIFY(fault && fault->file.endsWith(QStringLiteral("students/bob.json")));
}

void TestClassPage::codeAroundMarksItsLine()
{
    const QString program = QStringLiteral("one\ntwo\nthree\nfour\nfive");
    const QString code = codeAround(program, 4, 1);
    QVERIFY(code.contains(QStringLiteral(
        "<span data-line=\"3\">three</span><span data-line=\"4\" class=\"marked\">four</span>"
        "<span data-line=\"5\">five</span></pre>")));
    QVERIFY(!code.contains(QStringLiteral("two")));
    QVERIFY(codeAround(program, 0).isEmpty());
    QVERIFY(codeAround(program, 6).isEmpty());
    QVERIFY(codeAround({}, 3).isEmpty());
}

QTEST_APPLESS_MAIN(TestClassPage)
#include "test_class_page.moc"
