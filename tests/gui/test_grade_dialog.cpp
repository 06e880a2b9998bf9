// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grade_dialog.h"
#include "model/files/file_io.h"
#include "tasks/reading/lab_reader.h"
#include "tests/patience.h"
#include "tests/test_paths.h"

#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace cradle;

/// Grading from the window: it runs the command, watches it, and opens what it has written.
class TestGradeDialog : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void orderBecomesArguments();
    void nothingIsGradedWithoutFolders();
    void classIsGradedAndCanBeOpened();
    void gradingAgainKeepsWhatIsThere();
    void faultOfTheCommandIsTold();
    void missingProgramIsTold();
    void manyRemarksScroll();
    void closingEndsTheCommand();
    void everyFieldHasANameAndAKey();
    void tabGoesDownTheForm();

private:
    static QPushButton *button(const GradeDialog &dialog, const char *text);
    static QString messageOf(const GradeDialog &dialog);
    bool wait(GradeDialog &dialog) const; ///< whether it ended completely

    Lab m_lab;
    QTemporaryDir m_folder;
    QString m_submissions;
};

QPushButton *TestGradeDialog::button(const GradeDialog &dialog, const char *text)
{
    for (QPushButton *each : dialog.findChildren<QPushButton *>()) {
        if (each->text().remove(QLatin1Char('&')) == QLatin1String(text))
            return each;
    }
    return nullptr;
}

QString TestGradeDialog::messageOf(const GradeDialog &dialog)
{
    for (const QLabel *label : dialog.findChildren<QLabel *>()) {
        if (label->accessibleName() == QLatin1String("How the grading goes"))
            return label->text();
    }
    return {};
}

bool TestGradeDialog::wait(GradeDialog &dialog) const
{
    QSignalSpy ended(&dialog.run(), &GradeRun::ended);
    dialog.grade();
    return (!ended.isEmpty() || ended.wait(patience)) && ended.first().at(0).toBool();
}

void TestGradeDialog::initTestCase()
{
    const auto lab = readLab(QStringLiteral(":/labs/bouncing-ball"));
    QVERIFY(lab.ok());
    m_lab = *lab;
    m_submissions = m_folder.filePath(QStringLiteral("class"));
    for (const char *student : {"ada", "bob"}) {
        const QString steps =
            QStringLiteral("%1/%2/steps").arg(m_submissions, QLatin1String(student));
        QVERIFY(QDir().mkpath(steps));
        const Task &task = m_lab.tasks.front();
        QVERIFY(!writeFile(QStringLiteral("%1/%2.lua").arg(steps, task.id),
                           (student[0] == 'a' ? task.solution : task.starter).toUtf8()));
    }
}

void TestGradeDialog::orderBecomesArguments()
{
    const GradeOrder order{.submissions = QStringLiteral("-in"),
                           .lab = QStringLiteral("lab"),
                           .results = QStringLiteral("out"),
                           .roster = QStringLiteral("r.csv"),
                           .latePercent = 2.5,
                           .language = QStringLiteral("de")};
    QCOMPARE(order.arguments().join(QLatin1Char(' ')),
             QStringLiteral("grade --lab lab --out out --format json --language de "
                            "--roster r.csv --late-percent 2.5 -- -in"));
}

void TestGradeDialog::nothingIsGradedWithoutFolders()
{
    GradeDialog dialog(m_lab);
    QVERIFY(!button(dialog, "Grade")->isEnabled());
    QVERIFY(!button(dialog, "Open the results")->isEnabled());
    dialog.setFolders(m_submissions, m_folder.filePath(QStringLiteral("new")));
    QVERIFY(button(dialog, "Grade")->isEnabled());
    QVERIFY(!button(dialog, "Stop")->isEnabled());
}

void TestGradeDialog::classIsGradedAndCanBeOpened()
{
    GradeDialog dialog(m_lab);
    dialog.run().setProgram(cliProgram());
    dialog.setFolders(m_submissions, m_folder.filePath(QStringLiteral("out")));
    dialog.show();
    QVERIFY2(wait(dialog), qPrintable(messageOf(dialog)));
    QVERIFY(QFile::exists(dialog.resultsPage()));
    QCOMPARE(dialog.run().state().students, 2);
    QCOMPARE(dialog.run().state().done, 2);
    QVERIFY(
        messageOf(dialog).startsWith(QStringLiteral("2 of 2 students: 1 steps pass, 1 do not")));
    QVERIFY(button(dialog, "Open the results")->isEnabled());
    QVERIFY(button(dialog, "Grade")->isEnabled());
    QVERIFY(!button(dialog, "Stop")->isEnabled());
    if (const QString picture = qEnvironmentVariable("CRADLE_TEST_PICTURE"); !picture.isEmpty())
        dialog.grab().save(picture);
}

void TestGradeDialog::gradingAgainKeepsWhatIsThere()
{
    GradeDialog dialog(m_lab);
    dialog.run().setProgram(cliProgram());
    dialog.setFolders(m_submissions, m_folder.filePath(QStringLiteral("out")));
    QVERIFY(button(dialog, "Open the results")->isEnabled());
    QVERIFY2(wait(dialog), qPrintable(messageOf(dialog)));
    QCOMPARE(dialog.run().state().kept, 2);
}

void TestGradeDialog::faultOfTheCommandIsTold()
{
    GradeDialog dialog(m_lab);
    dialog.run().setProgram(cliProgram());
    dialog.setFolders(m_folder.filePath(QStringLiteral("nowhere")),
                      m_folder.filePath(QStringLiteral("out2")));
    QVERIFY(!wait(dialog));
    QVERIFY2(messageOf(dialog).startsWith(QStringLiteral("There is no folder "))
                 && messageOf(dialog).endsWith(QStringLiteral("nowhere")),
             qPrintable(messageOf(dialog)));
    QVERIFY(button(dialog, "Grade")->isEnabled());
    QVERIFY(!button(dialog, "Open the results")->isEnabled());
}

void TestGradeDialog::missingProgramIsTold()
{
    GradeDialog dialog(m_lab);
    dialog.run().setProgram(QStringLiteral("/nowhere/cradle-cli"));
    dialog.setFolders(m_submissions, m_folder.filePath(QStringLiteral("out3")));
    QVERIFY(!wait(dialog));
    QVERIFY(messageOf(dialog).contains(QStringLiteral("/nowhere/cradle-cli cannot be started")));
}

/// A class has hundreds of them; the window stays as it was, and all can be read.
void TestGradeDialog::manyRemarksScroll()
{
    GradeDialog dialog(m_lab);
    const auto *remarks = dialog.findChild<QPlainTextEdit *>();
    QVERIFY(remarks && remarks->isReadOnly() && !remarks->accessibleName().isEmpty());
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog, patience));
    QVERIFY(!remarks->isVisible());
    const QSize before = dialog.size();
    for (int i = 0; i < 300; ++i)
        emit dialog.run().remarked(QStringLiteral("left out of the zip: file %1").arg(i));
    emit dialog.run().remarked(QStringLiteral("ada: passed over"));
    QCoreApplication::processEvents();
    QVERIFY(remarks->isVisible());
    QCOMPARE(dialog.size(), before);
    QVERIFY(remarks->toPlainText().startsWith(QStringLiteral("Left out of the zip: file 0\n")));
    QVERIFY(remarks->toPlainText().endsWith(QStringLiteral("\nada: passed over")));
    if (const QString picture = qEnvironmentVariable("CRADLE_TEST_PICTURE"); !picture.isEmpty())
        dialog.grab().save(picture + QStringLiteral(".remarks.png"));
}

void TestGradeDialog::closingEndsTheCommand()
{
    auto dialog = std::make_unique<GradeDialog>(m_lab);
    dialog->run().setProgram(cliProgram());
    dialog->setFolders(m_submissions, m_folder.filePath(QStringLiteral("out4")));
    dialog->grade();
    QVERIFY(dialog->run().isRunning());
    dialog.reset(); // waits for the command, which then is gone
    GradeDialog next(m_lab);
    next.run().setProgram(cliProgram());
    next.setFolders(m_submissions, m_folder.filePath(QStringLiteral("out4")));
    QVERIFY2(wait(next), qPrintable(messageOf(next)));
}

void TestGradeDialog::everyFieldHasANameAndAKey()
{
    GradeDialog dialog(m_lab);
    for (const QLineEdit *edit : dialog.findChildren<QLineEdit *>()) {
        if (edit->objectName() != QLatin1String("qt_spinbox_lineedit"))
            QVERIFY(!edit->accessibleName().isEmpty() && !edit->toolTip().isEmpty());
    }
    QStringList keys;
    for (const QLabel *label : dialog.findChildren<QLabel *>()) {
        if (label->buddy())
            keys.append(label->text().section(QLatin1Char('&'), 1).left(1).toLower());
    }
    for (const QPushButton *each : dialog.findChildren<QPushButton *>()) {
        if (each->text().contains(QLatin1Char('&')))
            keys.append(each->text().section(QLatin1Char('&'), 1).left(1).toLower());
    }
    QVERIFY(keys.size() >= 7);
    QCOMPARE(keys.removeDuplicates(), 0);
}

/// The first field has the keyboard when the window opens.
void TestGradeDialog::tabGoesDownTheForm()
{
    GradeDialog dialog(m_lab);
    QStringList names;
    for (const QWidget *at = dialog.nextInFocusChain(); at != &dialog;
         at = at->nextInFocusChain()) {
        if ((at->focusPolicy() & Qt::TabFocus) != 0 && !at->accessibleName().isEmpty())
            names.append(at->accessibleName());
    }
    const QStringList wanted{QStringLiteral("Handed in"), QStringLiteral("Choose: Handed in"),
                             QStringLiteral("Results"),   QStringLiteral("Choose: Results"),
                             QStringLiteral("Roster"),    QStringLiteral("Choose: Roster")};
    QCOMPARE(names.mid(0, wanted.size()), wanted);
}

QTEST_MAIN(TestGradeDialog)
#include "test_grade_dialog.moc"
