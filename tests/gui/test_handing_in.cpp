// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hand_in_dialog.h"
#include "app/named_opening.h"
#include "app/report_dialog.h"
#include "keeping_fixture.h"
#include "tests/full_disk.h"
#include "tests/patience.h"

#include "views/code/versions_pane.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTreeWidget>

#include <algorithm>

using namespace cradle;
using namespace cradle::windows;

/// What leaves the student's machine, and how a teacher finds it.
class TestHandingIn final : public QObject, private KeepingFixture
{
    Q_OBJECT
private slots:
    void init();
    void handedInWorkIsLookedAt();
    void clonedWorkOpens();
    void whatWasExpectedIsHandedIn();
    void nothingOlderIsHandedIn();
};

void TestHandingIn::init()
{
    begin();
}

void TestHandingIn::handedInWorkIsLookedAt()
{
    {
        OpenWindow student(folder());
        inCode(student);
        type(student, QStringLiteral("-- mine\n"));
        check(student);
        HandInDialog dialog(student.bench);
        QTRY_VERIFY(dialog.isReady());
        dialog.findChild<QLineEdit *>()->setText(QStringLiteral("Ada"));
        const auto error = dialog.writeTo(path("ada.cradle-work"));
        QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
        QCOMPARE(student.bench.code().workspace().info().student, QStringLiteral("Ada"));
    }
    const QTemporaryDir teachersHome;
    OpenWindow teacher(teachersHome);
    const auto error = openNamed(teacher.bench, path("ada.cradle-work"), {},
                                 teachersHome.filePath(QStringLiteral("labs")));
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
    inCode(teacher);
    QCOMPARE(teacher.bench.code().text(), QStringLiteral("-- mine\n"));
    QVERIFY(!teacher.bench.code().workspace().mayWrite());
    QCOMPARE(teacher.window.versions().findChild<QTreeWidget *>()->topLevelItemCount(), 1);
    QVERIFY(teacher.window.codePane().editor().isReadOnly());
    QVERIFY(teacher.window.notice().text().contains(QStringLiteral("Work that Ada handed in")));
    check(teacher);
    QVERIFY(!teacher.bench.check().report()->passed);
    QCOMPARE(teacher.window.versions().findChild<QTreeWidget *>()->topLevelItemCount(), 1);
    // Nothing of the teacher's own was touched by that.
    QVERIFY(!QFile::exists(teachersHome.filePath(QStringLiteral("programs/lab-4.2/steps"))));
}

void TestHandingIn::clonedWorkOpens()
{
    {
        OpenWindow open(folder());
        inCode(open);
        type(open, open.bench.task()->solution);
        check(open);
    }
    const QString said =
        GitHome::git(folder().path(), {QStringLiteral("clone"), QStringLiteral("-q"), work(),
                                       QStringLiteral("cloned")});
    QVERIFY2(said.isEmpty(), qPrintable(said));
    const QTemporaryDir other;
    OpenWindow open(other);
    QVERIFY(!openNamed(open.bench, path("cloned"), {}, other.filePath(QStringLiteral("labs"))));
    inCode(open);
    QCOMPARE(open.bench.code().text(), open.bench.task()->solution);
    QVERIFY(open.isTicked(0)); // as the history tells
    type(open, QStringLiteral("-- on another machine\n"));
    QCOMPARE(content(path("cloned/lab.lua")), QByteArray("-- on another machine\n"));
}

void TestHandingIn::whatWasExpectedIsHandedIn()
{
    QString asked;
    Preset scene;
    {
        OpenWindow student(folder());
        const auto &tasks = student.bench.lab().tasks;
        const auto found = std::find_if(tasks.begin(), tasks.end(),
                                        [](const Task &each) { return each.prediction; });
        QVERIFY(found != tasks.end());
        asked = found->id;
        inCode(student);
        student.bench.openTask(asked);
        type(student, QStringLiteral("-- mine\n"));
        student.bench.progress().predict(1);
        student.bench.setMode(Mode::Explore);
        student.bench.openTaskAt(0);
        student.bench.document().edit(QStringLiteral("Scene"), student.solution());
        scene = student.preset();
        check(student);
        QVERIFY(student.bench.check().report()->passed);
        HandInDialog dialog(student.bench);
        QTRY_VERIFY(dialog.isReady());
        dialog.findChild<QPlainTextEdit *>()->setPlainText(QStringLiteral("It was\nhard."));
        QVERIFY(!dialog.writeTo(path("ada.cradle-work")));
    }
    const QTemporaryDir teachersHome;
    OpenWindow teacher(teachersHome);
    QVERIFY(!openNamed(teacher.bench, path("ada.cradle-work"), {},
                       teachersHome.filePath(QStringLiteral("labs"))));
    QVERIFY2(teacher.window.notice().text().contains(QStringLiteral("It was hard.")),
             qPrintable(teacher.window.notice().text()));
    teacher.bench.openTaskAt(0);
    QVERIFY(teacher.preset() == scene);
    QVERIFY(!teacher.isTicked(0)); // what it says of itself is not believed
    teacher.bench.openTask(asked);
    QCOMPARE(teacher.bench.progress().guess().answer, std::optional(1));
    QVERIFY(teacher.bench.progress().guess().revealed);
}

void TestHandingIn::nothingOlderIsHandedIn()
{
    OpenWindow open(folder());
    inCode(open);
    type(open, QStringLiteral("-- older\n"));
    const FullDisk full(64);
    type(open, QStringLiteral("-- newer\n").repeated(100));
    HandInDialog handIn(open.bench);
    ReportDialog report(open.bench, false);
    for (const QDialog *dialog : std::initializer_list<const QDialog *>{&handIn, &report}) {
        const auto labels = dialog->findChildren<QLabel *>();
        QTRY_VERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->text().contains(QStringLiteral("could not be saved"));
        }));
    }
    QVERIFY(!handIn.isReady() && !report.isReady());
}

QTEST_MAIN(TestHandingIn)
#include "test_handing_in.moc"
