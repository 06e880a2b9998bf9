// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_of_three.h"
#include "page_faults.h"
#include "tasks/grading/class_page.h"
#include "tasks/grading/page.h"
#include "tasks/grading/student_page.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <utility>

using namespace cradle;
using namespace cradle::classes;
using cradle::pages::faultsOf;

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
    void classPageTellsWhoIsWhere();
    void numbersThatAreNotClearAreTold();
    void examplesAreWithoutNames();
    void namesAreFoundAsWholeWords();
    void oneAttemptIsItsOwnMedian();
    void sameResultsSameBytes();
    void emptyClassHasAPage();
    void resultsOfAnotherNameAreRefused();
    void brokenResultIsNamed();

private:
    [[nodiscard]] QByteArray page(const char *name) const;
    void addPages();

    QTemporaryDir m_folder;
    Lab m_lab = smallLab();
    ClassFacts m_facts = facts();
};

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
    // One of three who were judged: 12 % and a third of the 58 % up to 70 %.
    QVERIFY(html.contains(QStringLiteral("<td style=\"--part: 31.3%\">1</td>")));
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
    QVERIFY(!html.contains("And ") && !html.contains(" more.")); // all are told
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

QTEST_APPLESS_MAIN(TestClassPage)
#include "test_class_page.moc"
