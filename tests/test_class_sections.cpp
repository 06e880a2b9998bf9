// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_of_three.h"
#include "tasks/grading/class_page_parts.h"

#include <QRegularExpression>
#include <QTest>

using namespace cradle;
using namespace cradle::classes;

/// The sections of a class page, each from a class that is just so.
class TestClassSections : public QObject
{
    Q_OBJECT
private slots:
    void headsAreWithoutWhatAllHave_data();
    void headsAreWithoutWhatAllHave();
    void barsAreAsLongAsManyPass();
    void misunderstandingsAreListedUpToTwelve();
    void medianIsThatOfTheMiddle_data();
    void medianIsThatOfTheMiddle();
    void sharedLinesAreShownFromTheFirst();
    void longProgramsAreShownInPart();

private:
    Lab m_lab = smallLab();
    ClassFacts m_facts = facts();
};

namespace {

/// A program no run of whose tokens is another's: of so many lines, each with a number of its own.
QString statements(int lines)
{
    QString program;
    for (int i = 0; i < lines; ++i)
        program += QStringLiteral("a%1 = b + 1%1 * (c - %1)\n").arg(i);
    return program;
}

/// The two of a class who share \p lines, and what is shown of the first.
QString shownOf(const Lab &lab, const ClassFacts &facts, int lines)
{
    StudentResult first = ada(lab);
    StudentResult second = bob(lab);
    first.steps[0].program = second.steps[0].program = statements(lines);
    ClassSummary summary(lab, facts);
    summary.add(first);
    summary.add(second);
    const auto failed =
        summary.finish([&](int i) { return Result<StudentResult>(i == 0 ? first : second); });
    return failed || summary.alike().size() != 1 ? QString() : summary.alike().front().firstCode;
}

} // namespace

void TestClassSections::headsAreWithoutWhatAllHave_data()
{
    QTest::addColumn<QStringList>("ids");
    QTest::addColumn<QStringList>("heads");
    const auto row = [](const char *name, const char *ids, const char *heads) {
        QTest::newRow(name) << QString::fromLatin1(ids).split(QLatin1Char(' '))
                            << QString::fromLatin1(heads).split(QLatin1Char(' '));
    };
    row("a lab's name", "L42T1 L42T12", "T1 T12");
    row("nothing in common", "1a 2a", "1a 2a");
    row("only the second letter in common", "1-a 2-a 3-b", "1-a 2-a 3-b");
    row("the last has less in common", "4-1a 4-1b 4-2a", "1a 1b 2a");
    row("one is all that is common", "4-1 4-12", "1 12");
    row("one alone", "L42T1", "L42T1");
    row("letters only", "fall fan", "fall fan");
}

void TestClassSections::headsAreWithoutWhatAllHave()
{
    QFETCH(QStringList, ids);
    QFETCH(QStringList, heads);
    std::vector<ClassSummary::Step> steps;
    for (const QString &id : ids)
        steps.push_back({.id = id, .title = QStringLiteral("<%1>").arg(id)});
    QString wanted;
    for (qsizetype i = 0; i < ids.size(); ++i)
        wanted +=
            QStringLiteral("<th scope=\"col\" title=\"&lt;%1&gt;\">%2</th>").arg(ids[i], heads[i]);
    QCOMPARE(headCells(steps), wanted);
}

/// Of 640 px from 300 on; step 1: two of three pass, one does not; step 2: one of each other sort.
void TestClassSections::barsAreAsLongAsManyPass()
{
    ClassSummary summary(m_lab, m_facts);
    for (const StudentResult &student : {ada(m_lab), mallory(m_lab), bob(m_lab)})
        summary.add(student);
    QString html;
    writeStand(html, summary);
    static const QRegularExpression bar(
        QStringLiteral("<rect class=\"(\\w)\" x=\"([\\d.]+)\" y=\"(\\d+)\" width=\"([\\d.]+)\""));
    QStringList bars;
    for (auto found = bar.globalMatch(html); found.hasNext();)
        bars.append(found.next().capturedTexts().mid(1).join(QLatin1Char(' ')));
    QCOMPARE(bars.join(QStringLiteral(", ")),
             QStringLiteral("p 300.0 2 426.7, f 726.7 2 213.3, p 300.0 28 213.3, "
                            "n 513.3 28 213.3, m 726.7 28 213.3"));
    QVERIFY(html.contains(QStringLiteral("<text x=\"0\" y=\"17\">S1 · Step S1</text>")));
    QVERIFY(html.contains(QStringLiteral("<text x=\"0\" y=\"43\">S2 · Step S2</text>")));
    QVERIFY(html.contains(QStringLiteral("viewBox=\"0 0 940 52\"")));
    QVERIFY(html.contains(QStringLiteral("<text class=\"in\" x=\"513.3\" y=\"16.5\">2</text>")));
}

/// What most met comes first, and how many sorts are not listed is said.
void TestClassSections::misunderstandingsAreListedUpToTwelve()
{
    for (const int sorts : {1, 12, 13, 15}) {
        ClassSummary summary(m_lab, m_facts);
        StudentResult student = mallory(m_lab);
        Finding finding = student.steps[0].report->findings[0];
        student.steps[0].report->findings.clear();
        for (int i = 0; i < sorts; ++i) {
            finding.mistake = QStringLiteral("sort %1").arg(i);
            finding.message = QStringLiteral("It is of sort %1").arg(i);
            student.steps[0].report->findings.push_back(finding);
        }
        summary.add(student);
        student.steps[0].report->findings = {finding}; // the last sort is met twice
        summary.add(student);
        QString html;
        writeMisunderstandings(html, summary);
        // The second step, which nobody handed in, has no list.
        QCOMPARE(html.count(QStringLiteral("<details class=\"printed\"")), 1);
        QVERIFY(html.contains(QStringLiteral("<summary>S1 · ")));
        const QString last = QStringLiteral("It is of sort %1").arg(sorts - 1);
        QVERIFY(html.contains(QStringLiteral("<li><span class=\"count\">2 ×</span>") + last));
        QCOMPARE(html.count(QStringLiteral("<li><span class=\"count\">1 ×</span>")),
                 std::min(sorts, 12) - 1);
        QCOMPARE(html.contains(QStringLiteral("more.")), sorts > 12);
        QCOMPARE(html.contains(QStringLiteral("And %1 more.").arg(sorts - 12)), sorts > 12);
    }
}

void TestClassSections::medianIsThatOfTheMiddle_data()
{
    QTest::addColumn<QList<int>>("attempts");
    QTest::addColumn<QString>("median");
    QTest::addColumn<QString>("most");
    QTest::newRow("one") << QList<int>{4} << "4"
                         << "4";
    QTest::newRow("two") << QList<int>{7, 4} << "5.5"
                         << "7";
    QTest::newRow("three") << QList<int>{30, 2, 5} << "5"
                           << "30";
    QTest::newRow("four") << QList<int>{9, 1, 2, 4} << "3"
                          << "9";
}

void TestClassSections::medianIsThatOfTheMiddle()
{
    QFETCH(QList<int>, attempts);
    QFETCH(QString, median);
    QFETCH(QString, most);
    ClassSummary summary(m_lab, m_facts);
    for (const int count : attempts) {
        StudentResult student = ada(m_lab);
        student.steps[1].attempts = count;
        student.steps[1].minutes = 6.0;
        summary.add(student);
    }
    QString html;
    writeEffort(html, summary);
    const QString row = QStringLiteral("<tr><td>S2 · Step S2</td><td class=\"number\">%1</td>"
                                       "<td class=\"number\">%2</td><td class=\"number\">%3</td>"
                                       "<td class=\"number\">6</td></tr>\n")
                            .arg(QString::number(attempts.size()), median, most);
    QVERIFY2(html.contains(row), qPrintable(html));
    QVERIFY(!html.contains(QStringLiteral("S1 ·"))); // of which nobody's history tells
}

void TestClassSections::sharedLinesAreShownFromTheFirst()
{
    QString wanted;
    for (int i = 0; i < 20; ++i)
        wanted += QStringLiteral("%1  a%2 = b + 1%2 * (c - %2)\n").arg(i + 1, 4).arg(i);
    QCOMPARE(shownOf(m_lab, m_facts, 20), wanted);
}

/// Thirty lines, and a sign that there are more.
void TestClassSections::longProgramsAreShownInPart()
{
    QCOMPARE(shownOf(m_lab, m_facts, 30).count(QLatin1Char('\n')), 30);
    QVERIFY(!shownOf(m_lab, m_facts, 30).contains(QStringLiteral("⋮")));
    const QString shown = shownOf(m_lab, m_facts, 40);
    QCOMPARE(shown.count(QLatin1Char('\n')), 31);
    QVERIFY(shown.endsWith(QStringLiteral("  30  a29 = b + 129 * (c - 29)\n   ⋮\n")));
}

QTEST_GUILESS_MAIN(TestClassSections)
#include "test_class_sections.moc"
