// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"

#include <QLabel>

using namespace cradle;
using namespace cradle::windows;

/// One check of a step, tried on one of its programs.
class TestAuthorTrial : public QObject
{
    Q_OBJECT
private slots:
    void solutionPassesAndMistakeFails();
    void programOpenIsOffered();
    void whatIsSaidGoesWithTheNextEdit();
    void programThatStopsIsTold();
    void refusedFieldIsTold();
    void expressionIsThereWhenTheLabIsOpenedAgain();
};

namespace {

/// Opens the second check of the first step: that the ball falls by symplectic Euler.
void openCheck(OpenAuthor &author, const QTemporaryDir &folder)
{
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Checks);
    author.find<QListWidget>("checks")->setCurrentRow(1);
}

QString tried(OpenAuthor &author, const QString &program)
{
    author.find<QComboBox>("trialProgram")->setCurrentText(program);
    author.click(QStringLiteral("Try this check"));
    auto *result = author.find<QLabel>("trialResult");
    if (!QTest::qWaitFor([&] { return result->text() != QStringLiteral("Running…"); }, patience))
        return QStringLiteral("nothing came");
    return result->text();
}

} // namespace

void TestAuthorTrial::solutionPassesAndMistakeFails()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openCheck(author, folder);
    QCOMPARE(tried(author, QStringLiteral("solution.lua")), QStringLiteral("solution.lua passes."));
    QVERIFY(tried(author, QStringLiteral("starter.lua"))
                .startsWith(QLatin1String("starter.lua fails: ")));
    const QString said = tried(author, QStringLiteral("mistakes/gravity-upward.lua"));
    QVERIFY2(said.startsWith(QLatin1String("mistakes/gravity-upward.lua fails: ")),
             qPrintable(said));
    // That mistake is of gravity in the student's own scene; the Moon has its own.
    author.find<QListWidget>("checks")->setCurrentRow(2);
    QVERIFY(author.find<QLabel>("trialResult")->text().isEmpty());
    QCOMPARE(tried(author, QStringLiteral("mistakes/gravity-upward.lua")),
             QStringLiteral("mistakes/gravity-upward.lua passes."));
}

void TestAuthorTrial::programOpenIsOffered()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openCheck(author, folder);
    author.window.panes().showTab(AuthorWindow::Programs);
    author.window.programsTab().openProgram(QStringLiteral("mistakes/thrown.lua"));
    author.window.panes().showTab(AuthorWindow::Checks);
    QCOMPARE(author.find<QComboBox>("trialProgram")->currentText(),
             QStringLiteral("mistakes/thrown.lua"));
}

void TestAuthorTrial::whatIsSaidGoesWithTheNextEdit()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openCheck(author, folder);
    QVERIFY(!tried(author, QStringLiteral("solution.lua")).isEmpty());
    author.window.checksTab().duplicateCheck();
    QVERIFY(author.find<QLabel>("trialResult")->text().isEmpty());
}

void TestAuthorTrial::programThatStopsIsTold()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openCheck(author, folder);
    QVERIFY(author.document().edit({}, withProgramText(author.files(),
                                                       QStringLiteral("BALL1/starter.lua"),
                                                       QStringLiteral("\nlocal a = nil + 1\n"))));
    const QString said = tried(author, QStringLiteral("starter.lua"));
    QVERIFY2(said.startsWith(QLatin1String("starter.lua stops in line 2: ")), qPrintable(said));
}

/// What is tried is the check before what is typed in a field and is no value.
void TestAuthorTrial::refusedFieldIsTold()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openCheck(author, folder);
    auto *gravity = author.find<QLineEdit>("gravity");
    QVERIFY(gravity);
    gravity->setFocus();
    gravity->selectAll();
    QTest::keyClicks(gravity, QStringLiteral("0, down"));
    QTest::keyClick(gravity, Qt::Key_Tab);
    const QString said = tried(author, QStringLiteral("solution.lua"));
    QVERIFY2(said.startsWith(QStringLiteral("solution.lua passes.\nThis is the check as it was")),
             qPrintable(said));
    gravity->selectAll();
    QTest::keyClicks(gravity, QStringLiteral("0, -9.81 m/s^2"));
    QTest::keyClick(gravity, Qt::Key_Tab);
    QCOMPARE(tried(author, QStringLiteral("solution.lua")), QStringLiteral("solution.lua passes."));
}

/// As it was typed, and judged as the number that it comes to.
void TestAuthorTrial::expressionIsThereWhenTheLabIsOpenedAgain()
{
    const QTemporaryDir folder;
    const QString typed = QStringLiteral("0, -9.81*(1/20)*20");
    QString place;
    {
        OpenAuthor author(folder);
        openCheck(author, folder);
        auto *gravity = author.find<QLineEdit>("gravity");
        gravity->setFocus();
        gravity->selectAll();
        QTest::keyClicks(gravity, typed);
        QTest::keyClick(gravity, Qt::Key_Tab);
        QCOMPARE(gravity->text(), typed);
        QCOMPARE(tried(author, QStringLiteral("solution.lua")),
                 QStringLiteral("solution.lua passes."));
        QVERIFY(author.window.files().save());
        place = author.document().folder();
    }
    OpenAuthor author(folder);
    QVERIFY(!author.window.files().open(place));
    author.window.panes().showTab(AuthorWindow::Checks);
    author.find<QListWidget>("checks")->setCurrentRow(1);
    QCOMPARE(author.find<QLineEdit>("gravity")->text(), typed);
    QCOMPARE(tried(author, QStringLiteral("solution.lua")), QStringLiteral("solution.lua passes."));
}

QTEST_MAIN(TestAuthorTrial)

#include "test_author_trial.moc"
