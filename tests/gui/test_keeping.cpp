// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hand_in_dialog.h"
#include "app/main_window.h"
#include "app/named_opening.h"
#include "app/report_dialog.h"
#include "open_window.h"
#include "tests/full_disk.h"
#include "tests/git_home.h"

#include "model/files/file_io.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/code/versions_pane.h"
#include "views/drawing_object.h"
#include "views/notes_pane.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

#include <algorithm>

using namespace cradle;

/// What the window says and offers about the student's files, and the way from the first program
/// to what is handed in.
class TestKeeping final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void secondWindowSaysWhoWorks();
    void foreignFileIsExplained();
    void damagedProgramComesBackFromItsVersions();
    void outsideEditIsSaid();
    void brokenProgressIsSaidWithAStep();
    void jumpingAheadShowsNoSolution();
    void versionsComeAndGoBack();
    void undoOutlivesAStep();
    void notesAreKeptForEachStep();
    void passingAllStepsTellsTheStory();
    void handedInWorkIsLookedAt();
    void whatWasExpectedIsHandedIn();
    void clonedWorkOpens();
    void nothingOlderIsHandedIn();
    void nameIsAskedOnce();
    void foreignLabFileIsSaid();
    void notesHaveVersions();
    void reportIsWritten();

private:
    [[nodiscard]] QString path(const char *name) const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    [[nodiscard]] QString work() const { return path("programs/lab-4.2"); }
    void type(windows::OpenWindow &open, const QString &text)
    {
        open.window.codePane().editor().exchangeText(text);
        open.bench.code().edit(text);
        open.bench.code().save();
    }
    static QByteArray content(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

constexpr int patience = 60'000; ///< ms

void inCode(windows::OpenWindow &open)
{
    open.bench.setMode(Mode::Code);
}

/// Judges the program that is open and waits for the verdict.
void check(windows::OpenWindow &open)
{
    QSignalSpy ended(&open.bench, &Workbench::checkEnded);
    open.bench.check();
    QVERIFY(ended.wait(patience));
    QTRY_VERIFY(!open.bench.awaitsRun());
}

} // namespace

void TestKeeping::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestKeeping::secondWindowSaysWhoWorks()
{
    windows::OpenWindow first(*m_folder);
    inCode(first);
    type(first, QStringLiteral("-- first\n"));
    windows::OpenWindow second(*m_folder);
    inCode(second);
    QVERIFY(second.window.notice().text().contains(QStringLiteral("Another window")));
    QVERIFY(second.window.codePane().editor().isReadOnly());
    second.click(QStringLiteral("Take over"));
    QVERIFY(!second.window.codePane().editor().isReadOnly());
    type(second, QStringLiteral("-- second\n"));
    QCOMPARE(content(work() + QStringLiteral("/lab.lua")), QByteArray("-- second\n"));
    // The first finds out when it would save, and loses nothing.
    type(first, QStringLiteral("-- too late\n"));
    QVERIFY(first.window.notice().text().contains(QStringLiteral("another window")));
    QVERIFY(first.window.codePane().editor().isReadOnly());
    QCOMPARE(content(work() + QStringLiteral("/lab.lua")), QByteArray("-- second\n"));
}

void TestKeeping::foreignFileIsExplained()
{
    const QByteArray bytes("\xff\xfex\0=\0"
                           "1\0\n\0",
                           10);
    QVERIFY(!makeFolder(work() + QStringLiteral("/steps")));
    QVERIFY(!writeFile(work() + QStringLiteral("/steps/L42T1.lua"), bytes));
    windows::OpenWindow open(*m_folder);
    inCode(open);
    open.bench.openTaskAt(0);
    QVERIFY2(open.window.notice().text().contains(QStringLiteral("UTF-16")),
             qPrintable(open.window.notice().text()));
    QVERIFY(open.window.codePane().editor().isReadOnly());
    type(open, QStringLiteral("-- a key\n"));
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua")), bytes);
    open.click(QStringLiteral("Make a program of it"));
    QCOMPARE(open.window.codePane().editor().text(), QStringLiteral("x=1\n"));
    QVERIFY(!open.window.codePane().editor().isReadOnly());
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua.original")), bytes);
}

/// A crash of the machine left zeros where the program was.
void TestKeeping::damagedProgramComesBackFromItsVersions()
{
    {
        windows::OpenWindow open(*m_folder);
        inCode(open);
        type(open, QStringLiteral("-- mine\n"));
        check(open);
    }
    for (const char *file : {"/steps/L42T1.lua", "/lab.lua"})
        QVERIFY(!writeFile(work() + QLatin1String(file), QByteArray(8, '\0')));
    windows::OpenWindow open(*m_folder);
    inCode(open);
    open.bench.openTaskAt(0);
    open.click(QStringLiteral("Back to the newest version"));
    QCOMPARE(open.window.codePane().editor().text(), QStringLiteral("-- mine\n"));
    QVERIFY(!open.window.codePane().editor().isReadOnly());
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua")), QByteArray("-- mine\n"));
    QCOMPARE(content(work() + QStringLiteral("/steps/L42T1.lua.original")), QByteArray(8, '\0'));
}

void TestKeeping::outsideEditIsSaid()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    type(open, QStringLiteral("-- mine\n"));
    QVERIFY(!writeFile(work() + QStringLiteral("/lab.lua"), "-- theirs\n"));
    QTRY_VERIFY_WITH_TIMEOUT(
        open.window.notice().text().contains(QStringLiteral("Another program has changed")),
        20'000);
    QCOMPARE(open.window.codePane().editor().text(), QStringLiteral("-- theirs\n"));
    auto *list = open.window.versions().findChild<QTreeWidget *>();
    QCOMPARE(list->topLevelItemCount(), 2);
    QCOMPARE(list->topLevelItem(0)->text(1), QStringLiteral("By another program"));
}

void TestKeeping::brokenProgressIsSaidWithAStep()
{
    QVERIFY(!writeFile(path("progress.json"), "no progress"));
    QSettings settings(path("settings.ini"), QSettings::IniFormat);
    Workbench bench(path("progress.json"));
    MainWindow window(bench, settings, ThemeChoice::Light);
    QVERIFY(!openNamed(bench, {}, QStringLiteral("L42T1"), path("labs")));
    window.show();
    QVERIFY2(window.notice().text().contains(QStringLiteral("progress")),
             qPrintable(window.notice().text()));
}

void TestKeeping::jumpingAheadShowsNoSolution()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    const QString starter = open.bench.code().text();
    for (int i = 0; i < 4; ++i)
        open.bench.openNextTask();
    QCOMPARE(open.bench.current(), 4);
    QCOMPARE(open.bench.code().text(), starter);
    QVERIFY(open.window.notice().text().contains(QStringLiteral("your own program")));
    // Who wants the solution of the step before asks for it.
    open.click(QStringLiteral("Begin with the solution of"));
    QCOMPARE(open.bench.code().text(), open.bench.task()->starter);
    QVERIFY(open.bench.code().text() != starter);
}

void TestKeeping::versionsComeAndGoBack()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    const QString solution = open.bench.task()->solution;
    type(open, solution);
    check(open);
    QVERIFY(open.bench.report()->passed);
    type(open, solution + QStringLiteral("\nerror('broken')\n"));
    check(open);
    QVERIFY(!open.bench.report()->passed);
    auto *list = open.window.versions().findChild<QTreeWidget *>();
    QCOMPARE(list->topLevelItemCount(), 2);
    QVERIFY(list->topLevelItem(0)->text(1).contains(QStringLiteral("not passed")));
    QVERIFY(list->topLevelItem(0)->text(2).contains(QStringLiteral("error('broken')")));
    open.window.versions().parentWidget()->raise();
    auto *back = open.window.versions().findChildren<QPushButton *>().last();
    QCOMPARE(back->text(), QStringLiteral("Back to what &passed"));
    QVERIFY(back->isEnabled());
    back->click();
    QCOMPARE(open.bench.code().text(), solution);
    QCOMPARE(open.window.codePane().editor().text(), solution);
    QVERIFY(!back->isEnabled());
    // Going back can be undone.
    open.window.codePane().editor().undo();
    QTRY_VERIFY(open.bench.code().text().contains(QStringLiteral("broken")));
}

void TestKeeping::undoOutlivesAStep()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    CodeEditor &editor = open.window.codePane().editor();
    const QString before = editor.text();
    type(open, QStringLiteral("-- mine\n"));
    open.bench.openTaskAt(1);
    QVERIFY(!editor.canUndo());
    open.bench.openTaskAt(0);
    QCOMPARE(editor.text(), QStringLiteral("-- mine\n"));
    QVERIFY(editor.canUndo());
    editor.undo();
    QCOMPARE(editor.text(), before);
}

void TestKeeping::notesAreKeptForEachStep()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    auto *field = open.window.notes().findChild<QPlainTextEdit *>();
    field->setPlainText(QStringLiteral("It *moves*."));
    open.bench.openTaskAt(1);
    QCOMPARE(field->toPlainText(), QString());
    QCOMPARE(content(work() + QStringLiteral("/notes/L42T1.md")), QByteArray("It *moves*."));
    open.bench.openTaskAt(0);
    QCOMPARE(field->toPlainText(), QStringLiteral("It *moves*."));
}

/// The whole lab, as a student does it: git tells its story.
void TestKeeping::passingAllStepsTellsTheStory()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    QStringList story;
    int endings = 0;
    connect(&open.bench, &Workbench::labFinished, this, [&endings] { ++endings; });
    for (int i = 0; i < static_cast<int>(open.bench.lab().tasks.size()); ++i) {
        open.bench.openTaskAt(i);
        const Preset scene = open.solution();
        open.bench.document().edit(QStringLiteral("Scene"), scene);
        type(open, open.bench.task()->solution);
        check(open);
        QVERIFY2(open.bench.report()->passed, qPrintable(open.bench.task()->id));
        story.prepend(open.bench.report()->commit);
        if (auto *dialog = open.window.findChild<ReportDialog *>())
            QTRY_VERIFY_WITH_TIMEOUT(dialog->isReady(), patience);
    }
    QCOMPARE(endings, 1);
    QVERIFY(open.window.findChild<ReportDialog *>());
    story.append(QStringLiteral("Begin lab-4.2"));
    QCOMPARE(GitHome::git(work(), {QStringLiteral("log"), QStringLiteral("--format=%s")})
                 .split(QLatin1Char('\n')),
             story);
    QVERIFY(story.contains(QStringLiteral("L42T11 Calculated correct collision response for a "
                                          "collision with a glancing angle")));
    QVERIFY(GitHome::git(work(), {QStringLiteral("fsck"), QStringLiteral("--strict")}).isEmpty());
}

void TestKeeping::handedInWorkIsLookedAt()
{
    {
        windows::OpenWindow student(*m_folder);
        inCode(student);
        type(student, QStringLiteral("-- mine\n"));
        check(student);
        HandInDialog dialog(student.bench);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
        dialog.findChild<QLineEdit *>()->setText(QStringLiteral("Ada"));
        const auto error = dialog.writeTo(path("ada.cradle-work"));
        QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
        QCOMPARE(student.bench.code().workspace().info().student, QStringLiteral("Ada"));
    }
    const QTemporaryDir teachersHome;
    windows::OpenWindow teacher(teachersHome);
    const auto error = openNamed(teacher.bench, path("ada.cradle-work"), {},
                                 teachersHome.filePath(QStringLiteral("labs")));
    QVERIFY2(!error, error ? qPrintable(error->toString()) : "");
    inCode(teacher);
    QCOMPARE(teacher.bench.code().text(), QStringLiteral("-- mine\n"));
    QVERIFY(!teacher.bench.mayWrite());
    QCOMPARE(teacher.window.versions().findChild<QTreeWidget *>()->topLevelItemCount(), 1);
    QVERIFY(teacher.window.codePane().editor().isReadOnly());
    QVERIFY(teacher.window.notice().text().contains(QStringLiteral("Work that Ada handed in")));
    check(teacher);
    QVERIFY(!teacher.bench.report()->passed);
    QCOMPARE(teacher.window.versions().findChild<QTreeWidget *>()->topLevelItemCount(), 1);
    // Nothing of the teacher's own was touched by that.
    QVERIFY(!QFile::exists(teachersHome.filePath(QStringLiteral("programs/lab-4.2/steps"))));
}

void TestKeeping::clonedWorkOpens()
{
    {
        windows::OpenWindow open(*m_folder);
        inCode(open);
        type(open, open.bench.task()->solution);
        check(open);
    }
    const QString said =
        GitHome::git(m_folder->path(), {QStringLiteral("clone"), QStringLiteral("-q"), work(),
                                        QStringLiteral("cloned")});
    QVERIFY2(said.isEmpty(), qPrintable(said));
    const QTemporaryDir other;
    windows::OpenWindow open(other);
    QVERIFY(!openNamed(open.bench, path("cloned"), {}, other.filePath(QStringLiteral("labs"))));
    inCode(open);
    QCOMPARE(open.bench.code().text(), open.bench.task()->solution);
    QVERIFY(open.isTicked(0)); // as the history tells
    type(open, QStringLiteral("-- on another machine\n"));
    QCOMPARE(content(path("cloned/lab.lua")), QByteArray("-- on another machine\n"));
}

/// The teacher sees what the student expected and which scene was made, and reads the note.
void TestKeeping::whatWasExpectedIsHandedIn()
{
    QString asked;
    Preset scene;
    {
        windows::OpenWindow student(*m_folder);
        const auto &tasks = student.bench.lab().tasks;
        const auto found = std::find_if(tasks.begin(), tasks.end(),
                                        [](const Task &each) { return each.prediction; });
        QVERIFY(found != tasks.end());
        asked = found->id;
        inCode(student);
        student.bench.openTask(asked);
        type(student, QStringLiteral("-- mine\n"));
        student.bench.predict(1);
        student.bench.setMode(Mode::Explore);
        student.bench.openTaskAt(0);
        student.bench.document().edit(QStringLiteral("Scene"), student.solution());
        scene = student.preset();
        check(student);
        QVERIFY(student.bench.report()->passed);
        HandInDialog dialog(student.bench);
        QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
        dialog.findChild<QPlainTextEdit *>()->setPlainText(QStringLiteral("It was\nhard."));
        QVERIFY(!dialog.writeTo(path("ada.cradle-work")));
    }
    const QTemporaryDir teachersHome;
    windows::OpenWindow teacher(teachersHome);
    QVERIFY(!openNamed(teacher.bench, path("ada.cradle-work"), {},
                       teachersHome.filePath(QStringLiteral("labs"))));
    QVERIFY2(teacher.window.notice().text().contains(QStringLiteral("It was hard.")),
             qPrintable(teacher.window.notice().text()));
    teacher.bench.openTaskAt(0);
    QVERIFY(teacher.preset() == scene);
    QVERIFY(!teacher.isTicked(0)); // what it says of itself is not believed
    teacher.bench.openTask(asked);
    QCOMPARE(teacher.bench.guess().answer, std::optional(1));
    QVERIFY(teacher.bench.guess().revealed);
}

/// What could not be saved is newer than what would be handed in.
void TestKeeping::nothingOlderIsHandedIn()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    type(open, QStringLiteral("-- older\n"));
    const FullDisk full(64);
    type(open, QStringLiteral("-- newer\n").repeated(100));
    HandInDialog handIn(open.bench);
    ReportDialog report(open.bench, false);
    QTest::qWait(1000);
    QVERIFY(!handIn.isReady() && !report.isReady());
    for (const QDialog *dialog : std::initializer_list<const QDialog *>{&handIn, &report}) {
        const auto labels = dialog->findChildren<QLabel *>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->text().contains(QStringLiteral("could not be saved"));
        }));
    }
}

void TestKeeping::nameIsAskedOnce()
{
    const QString offer = QStringLiteral("Give your name");
    windows::OpenWindow open(*m_folder);
    inCode(open);
    type(open, open.bench.task()->solution);
    check(open);
    QVERIFY(open.bench.report()->passed);
    QVERIFY(open.button(offer));
    QTimer::singleShot(0, &open.window, [&open] {
        auto *dialog = open.window.findChild<QInputDialog *>();
        QVERIFY(dialog);
        dialog->setTextValue(QStringLiteral("Ada"));
        dialog->accept();
    });
    open.click(offer);
    QCOMPARE(open.bench.code().workspace().info().student, QStringLiteral("Ada"));
    QVERIFY(!open.button(offer));
    check(open);
    QCOMPARE(GitHome::git(work(), {QStringLiteral("log"), QStringLiteral("-1"),
                                   QStringLiteral("--format=%an")}),
             QStringLiteral("Ada"));
    QVERIFY(!open.bench.code().workspace().setStudent({}, {}));
    check(open);
    QVERIFY(!open.button(offer));
}

/// Written in UTF-16 while no window was open.
void TestKeeping::foreignLabFileIsSaid()
{
    {
        windows::OpenWindow open(*m_folder);
        inCode(open);
        type(open, QStringLiteral("-- mine\n"));
    }
    const QByteArray bytes("\xff\xfex\0=\0"
                           "1\0\n\0",
                           10);
    QVERIFY(!writeFile(work() + QStringLiteral("/lab.lua"), bytes));
    windows::OpenWindow open(*m_folder);
    inCode(open);
    type(open, QStringLiteral("-- mine, and a key\n"));
    QVERIFY2(open.window.notice().text().contains(QStringLiteral("lab.lua.original")),
             qPrintable(open.window.notice().text()));
    QCOMPARE(content(work() + QStringLiteral("/lab.lua.original")), bytes);
}

void TestKeeping::notesHaveVersions()
{
    {
        windows::OpenWindow open(*m_folder);
        inCode(open);
        auto *field = open.window.notes().findChild<QPlainTextEdit *>();
        field->setPlainText(QStringLiteral("It moves."));
        open.bench.openTaskAt(1);
        open.bench.openTaskAt(0);
        field->setPlainText(QStringLiteral("It *moves*."));
        QVERIFY(open.window.close());
    }
    QCOMPARE(GitHome::git(work(), {QStringLiteral("log"), QStringLiteral("--format=%s"),
                                   QStringLiteral("refs/cradle/notes/L42T1")}),
             QStringLiteral("L42T1: notes\nL42T1: notes"));
}

void TestKeeping::reportIsWritten()
{
    windows::OpenWindow open(*m_folder);
    inCode(open);
    type(open, open.bench.task()->solution);
    open.window.notes().findChild<QPlainTextEdit *>()->setPlainText(QStringLiteral("$v^2$"));
    open.bench.openTaskAt(1);
    ReportDialog dialog(open.bench, false);
    dialog.show();
    QTRY_VERIFY_WITH_TIMEOUT(dialog.isReady(), patience);
    QVERIFY(!dialog.writeTo(path("r.pdf")));
    QVERIFY(content(path("r.pdf")).startsWith("%PDF-1."));
    QVERIFY(!dialog.writeTo(path("r.html")));
    QVERIFY(content(path("r.html")).contains("<svg "));
    if (QFile::exists(QStringLiteral(":/mathjax/mathjax.js")))
        QVERIFY(content(path("r.html")).contains("aria-label=\"v^2\""));
    QVERIFY(dialog.writeTo(path("none/r.html")));
}

QTEST_MAIN(TestKeeping)
#include "test_keeping.moc"
