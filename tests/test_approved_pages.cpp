// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/class_of_many.h"
#include "tests/reports.h"
#include "tests/text.h"

#include "tasks/authoring/mutations.h"
#include "tasks/grading/class_results.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/proof/verified_text.h"
#include "tasks/report/report_formats.h"

#include <QCryptographicHash>
#include <QDirIterator>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;
using namespace cradle::classes;

/// Whole pages and files for teachers and graders, as they were when they last changed:
/// tests/approved/pages.
class TestApprovedPages : public QObject
{
    Q_OBJECT
private slots:
    void classIsAsApproved();
    void largeClassesAreAsApproved();
    void otherClassesAreAsApproved();
    void reportsOfEveryFormatAreAsApproved_data();
    void reportsOfEveryFormatAreAsApproved();
    void proofIsAsApproved();
    void suggestionsAreAsApproved();
};

namespace {

void compare(const QString &page, const QString &now)
{
    const QString difference = approved::compare(QStringLiteral("pages/") + page, now);
    QVERIFY2(difference.isEmpty(), qPrintable(page + QStringLiteral(": ") + difference));
}

} // namespace

void TestApprovedPages::classIsAsApproved()
{
    const QTemporaryDir folder;
    const Lab lab = smallLab();
    QVERIFY(keep(folder.path(), {mallory(lab), ada(lab), bob(lab)}, lab));
    QVERIFY(!writeClassResults(folder.path(), lab, facts()));
    QStringList names;
    QDirIterator files(folder.path(), QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext())
        names.append(QDir(folder.path()).relativeFilePath(files.next()));
    QVERIFY(names.size() > 6);
    for (const QString &name : names) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        compare(QStringLiteral("class/") + name, QString::fromUtf8(file.readAll()));
        if (QTest::currentTestFailed())
            return;
    }
}

/// The page of a class of 37, and hashes of all that is written of it and of one that is larger
/// than what is told one by one.
void TestApprovedPages::largeClassesAreAsApproved()
{
    const Lab lab = smallLab();
    QString all;
    for (const int count : {37, 330}) {
        const QTemporaryDir folder;
        std::vector<StudentResult> students;
        for (int i = 0; i < count; ++i)
            students.push_back(oneOfMany(lab, i));
        QVERIFY(keep(folder.path(), students, lab));
        QVERIFY(!writeClassResults(folder.path(), lab, facts()));
        QMap<QString, QByteArray> files;
        QDirIterator found(folder.path(), QDir::Files, QDirIterator::Subdirectories);
        while (found.hasNext()) {
            QFile file(found.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString name = QDir(folder.path()).relativeFilePath(file.fileName());
            // Those of students and of other graders are as in the class of three.
            if (name.count(QLatin1Char('/')) == 0 || name.startsWith(QLatin1String("gradebooks/")))
                files[name] = file.readAll();
        }
        QVERIFY(files.size() > 4);
        for (auto it = files.cbegin(); it != files.cend(); ++it) {
            all += QStringLiteral("%1 %2 %3\n")
                       .arg(count)
                       .arg(it.key(), QString::fromLatin1(
                                          QCryptographicHash::hash(*it, QCryptographicHash::Sha256)
                                              .toHex()
                                              .left(32)));
        }
        if (count == 37)
            compare(QStringLiteral("class-of-37.html"),
                    QString::fromUtf8(files.value(QStringLiteral("class.html"))));
    }
    compare(QStringLiteral("large-classes.txt"), all);
}

/// Classes of which little is known, most of whom handed in a number alone: of one whose program
/// stops and has no finding; of so many that the number of one fits into its bar, or just does not;
/// and of as many strange numbers as are told one by one.
void TestApprovedPages::otherClassesAreAsApproved()
{
    Lab lab = smallLab();
    lab.tasks[0].title = QString(35, u'x'); // forty letters with its id
    lab.tasks[1].title = QString(36, u'y');
    ClassFacts facts{.late = {.percentPerDay = 0.5}, .graderFiles = false};
    QString all;
    for (const int count : {1, 46, 52, 200, 201}) {
        std::vector<StudentResult> students;
        for (int i = 0; i < count; ++i) {
            StudentResult student{.id = QStringLiteral("s%1").arg(i, 4, 10, QLatin1Char('0')),
                                  .name = QStringLiteral(",Ada;x,Y Z;;Cy").split(u';').value(i % 5),
                                  .lateDays = i % 3 == 0 ? 1.5 : 0.0};
            for (const Task &task : lab.tasks)
                student.steps.push_back(
                    {.taskId = task.id, .drawnBy = text("7"), .ownNumber = QString::number(i + 8)});
            students.push_back(student);
        }
        students[0].steps[0] = judged(lab, 0, true, false);
        students[0].steps[0].report->findings.clear();
        students[0].steps[0].report->error = ProgramError{.message = text("stopped"), .line = 3};
        if (count > 2) {
            students[1] = mallory(lab);
            students[2] = ada(lab);
        }
        const QTemporaryDir folder;
        QVERIFY(keep(folder.path(), students, lab));
        const auto told = [&](int done, int total) {
            if (done % 50 == 1)
                all += QStringLiteral("%1 of %2\n").arg(done).arg(total);
        };
        QVERIFY(!writeClassResults(folder.path(), lab, facts, told));
        facts.late = {};
        for (const char *name :
             {"class.html", "gradebooks/canvas.csv", "gradebooks/blackboard.csv"}) {
            QFile file(folder.filePath(text(name)));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray content = file.readAll();
            if (count == 46 && name == QByteArray("class.html"))
                compare(text("other-class.html"), QString::fromUtf8(content));
            all += QStringLiteral("%1 %2 %3\n")
                       .arg(count)
                       .arg(text(name), QString::fromLatin1(QCryptographicHash::hash(
                                                                content, QCryptographicHash::Sha256)
                                                                .toHex()
                                                                .left(32)));
        }
        all += QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).join(u' ')
               + u'\n';
    }
    compare(text("other-classes.txt"), all);
}

void TestApprovedPages::reportsOfEveryFormatAreAsApproved_data()
{
    QTest::addColumn<QString>("format");
    for (const QString &name : reportFormatNames())
        QTest::newRow(qPrintable(name)) << name;
}

void TestApprovedPages::reportsOfEveryFormatAreAsApproved()
{
    QFETCH(QString, format);
    QString all;
    for (const CheckReport &report :
         {reports::passed(), reports::remarked(), reports::failed(), reports::diagnosed(),
          reports::unloadable(), reports::stopped(), reports::odd()})
        all += QString::fromUtf8(
                   writeReport(report, *reportFormatFromName(format), QStringLiteral("lab.lua")))
               + QLatin1Char('\n');
    compare(QStringLiteral("reports.") + format, all);
}

void TestApprovedPages::proofIsAsApproved()
{
    const Lab lab = *readLab(QLatin1String(bouncingBallLab));
    QString all;
    for (const VerifiedTask &task : verifyLab(lab, {}, {}, 2)) {
        all += describeVerified(task);
        for (qsizetype i = 0; i < task.checks.size(); ++i)
            all += wrongEnough(task, i) + QLatin1Char('\n');
    }
    // How small a fault a check of no tolerance sees is a matter of rounding.
    static const QRegularExpression tiny(QStringLiteral("[0-9.]+e-(?:[789]|[1-9][0-9])"));
    compare(QStringLiteral("proof.txt"),
            QString(all + describeTried(lab)).replace(tiny, QStringLiteral("tiny")));
}

void TestApprovedPages::suggestionsAreAsApproved()
{
    const Lab lab = *readLab(QLatin1String(bouncingBallLab));
    QString all;
    for (const Task &task : lab.tasks) {
        for (const Mutant &mutant : mutantsOf(task.solution))
            all += QStringLiteral("%1:%2: %3 | %4\n  %5\n")
                       .arg(task.id)
                       .arg(mutant.line)
                       .arg(mutant.name, mutant.change, mutant.message);
    }
    const Task &task = lab.tasks.front();
    const Suggestions suggestions = suggestMistakes(lab, task);
    for (const Suggestion &each : suggestions.list)
        all += QStringLiteral("%1 %2 %3 %4\n")
                   .arg(int(each.kind))
                   .arg(each.mutant.name, each.check, each.finding);
    compare(QStringLiteral("suggestions.txt"), all + suggestions.alone.join(QLatin1Char(' ')));
}

QTEST_GUILESS_MAIN(TestApprovedPages)
#include "test_approved_pages.moc"
