// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "class_of_three.h"
#include "tasks/grading/page.h"
#include "tasks/grading/student_page.h"

#include <QFile>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>

#include <utility>

using namespace cradle;
using namespace cradle::classes;

/// What a student reads: the own verdicts, points and moments, and nothing of others. Whether the
/// page is valid and harmless: test_class_page.cpp.
class TestStudentPage : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void studentPageTellsVerdictLineAndMoment();
    void studentPageHoldsNothingOfOthers();
    void latenessIsToldWithTheSum();
    void whatIsNotGradedIsNeitherPassedNorFailed();
    void valuesAtAnErrorAreTold();
    void codeAroundMarksItsLine();
    void momentOfAnErrorIsShort();
    void momentIsShownOnce_data();
    void momentIsShownOnce();

private:
    [[nodiscard]] QByteArray page(const char *name) const;

    QTemporaryDir m_folder;
    Lab m_lab = smallLab();
};

void TestStudentPage::initTestCase()
{
    const std::vector<StudentResult> students{mallory(m_lab), ada(m_lab), bob(m_lab)};
    QVERIFY(keep(m_folder.path(), students, m_lab));
    const auto fault = writeClassResults(m_folder.path(), m_lab, facts());
    QVERIFY2(!fault, fault ? qPrintable(fault->toString()) : "");
}

QByteArray TestStudentPage::page(const char *name) const
{
    QFile file(m_folder.filePath(QString::fromLatin1(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void TestStudentPage::studentPageTellsVerdictLineAndMoment()
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

void TestStudentPage::studentPageHoldsNothingOfOthers()
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

void TestStudentPage::latenessIsToldWithTheSum()
{
    const QByteArray html = page("students/ada.html");
    QVERIFY(html.contains("2 of 2 steps pass · 4.4 of 5.5 points"));
    // A day and a half.
    QVERIFY(html.contains("counted whole: 2. That takes 20 % of the points"));
    QVERIFY(!page("students/bob.html").contains("taken off already"));
}

void TestStudentPage::whatIsNotGradedIsNeitherPassedNorFailed()
{
    const QByteArray html = page("students/bob.html");
    QVERIFY(html.contains("? not graded"));
    QVERIFY(html.contains("the machine &amp; all failed"));
    QVERIFY(html.contains("<p class=\"sum\">1 of 2 steps pass</p>"));
    QVERIFY(html.contains("– of 2.5"));
    QVERIFY(page("class.html").contains("<bdi>Bob Dobbs</bdi>, S2: the machine &amp; all failed"));
}

/// Six of them.
void TestStudentPage::valuesAtAnErrorAreTold()
{
    for (const int count : {0, 2, 6, 8}) {
        StudentResult student = mallory(m_lab);
        ProgramError error{.message = QStringLiteral("a < b"), .line = 2};
        if (count == 2)
            error.kind = ProgramError::Kind::Syntax;
        for (int i = 0; i < count; ++i)
            error.locals.push_back(
                {.name = QStringLiteral("v%1").arg(i), .value = QStringLiteral("<%1>").arg(i)});
        student.steps[0].report->error = error;
        const QTemporaryDir folder;
        QVERIFY(keep(folder.path(), {student}, m_lab));
        QVERIFY(!writeClassResults(folder.path(), m_lab, facts()));
        QFile file(folder.filePath(QStringLiteral("students/mallory.html")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray html = file.readAll();
        QVERIFY(html.contains(count == 2 ? "The program does not load."
                                         : "The program stopped before its first step."));
        QVERIFY(html.contains("line 2: a &lt; b"));
        QCOMPARE(html.contains("<p>There: <code>v0 = &lt;0&gt;</code>"), count > 0);
        QCOMPARE(html.contains(", <code>v5 = &lt;5&gt;</code></p>"), count > 5);
        QVERIFY(!html.contains("<code>v6 = "));
    }
}

void TestStudentPage::codeAroundMarksItsLine()
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

/// With a point, as in the program, though the page is German.
void TestStudentPage::momentOfAnErrorIsShort()
{
    StudentResult student = mallory(m_lab);
    student.steps[0].report->error =
        ProgramError{.message = QStringLiteral("stopped"), .step = 4, .time = 4.0 / 60.0};
    QLocale::setDefault(QLocale(QLocale::German));
    const QByteArray html = studentPage(student, m_lab, facts());
    QLocale::setDefault(QLocale::c());
    QVERIFY(html.contains("The program stopped in step 4 of a scene, at 0.06667 s."));
    QVERIFY(html.contains("1 of 5,5 points"));
}

void TestStudentPage::momentIsShownOnce_data()
{
    QTest::addColumn<bool>("found"); // something was found that tells of it
    QTest::addColumn<bool>("stopped");
    QTest::addColumn<int>("moments");
    QTest::newRow("with what was found") << true << false << 1;
    QTest::newRow("alone, where nothing was") << false << false << 1;
    QTest::newRow("not of a program that stopped") << false << true << 0;
    QTest::newRow("stopped, and found before") << true << true << 1;
}

void TestStudentPage::momentIsShownOnce()
{
    QFETCH(bool, found);
    QFETCH(bool, stopped);
    QFETCH(int, moments);
    StudentResult student = mallory(m_lab);
    if (!found)
        student.steps[0].report->findings.clear();
    if (stopped)
        student.steps[0].report->error =
            ProgramError{.message = QStringLiteral("stopped"), .step = 4, .time = 0.5};
    const QByteArray html = studentPage(student, m_lab, facts());
    QCOMPARE(html.count("stroke-opacity=\"0.45\""), moments); // the way of its circle
}

QTEST_APPLESS_MAIN(TestStudentPage)
#include "test_student_page.moc"
