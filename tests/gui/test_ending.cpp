// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hand_in_dialog.h"
#include "app/report_dialog.h"
#include "keeping_fixture.h"
#include "tests/patience.h"

#include "views/notes_pane.h"

#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QTimer>

using namespace cradle;
using namespace cradle::windows;

/// The end of the lab: the story that git tells, the page that looks back, the report.
class TestEnding final : public QObject, private KeepingFixture
{
    Q_OBJECT
private slots:
    void init();
    void passingAllStepsTellsTheStory();
    void reportIsWritten();

private:
    static constexpr int hard = 1; ///< the step that is not passed at once
    static void looksBack(OpenWindow &open, ReportDialog &dialog);
};

void TestEnding::init()
{
    begin();
}

void TestEnding::passingAllStepsTellsTheStory()
{
    OpenWindow open(folder());
    inCode(open);
    QStringList story;
    int endings = 0;
    connect(&open.bench.check(), &WorkCheck::labFinished, this, [&endings] { ++endings; });
    const int last = static_cast<int>(open.bench.lab().tasks.size()) - 1;
    for (int i = 0; i <= last; ++i) {
        open.bench.openTaskAt(i);
        const Preset scene = open.solution();
        open.bench.document().edit(QStringLiteral("Scene"), scene);
        if (i == hard) {
            type(open, open.bench.task()->mistakes.front().source);
            check(open);
            QVERIFY(!open.bench.check().report()->passed);
        }
        type(open, open.bench.task()->solution);
        check(open);
        QVERIFY2(open.bench.check().report()->passed, qPrintable(open.bench.task()->id));
        story.prepend(open.bench.check().report()->commit);
        QCOMPARE(open.window.findChild<ReportDialog *>() != nullptr, i == last);
    }
    QCOMPARE(endings, 1);
    auto *dialog = open.window.findChild<ReportDialog *>();
    QTRY_VERIFY(dialog->isReady());
    looksBack(open, *dialog);
    story.append(QStringLiteral("Begin lab-4.2"));
    QCOMPARE(GitHome::git(work(), {QStringLiteral("log"), QStringLiteral("--format=%s")})
                 .split(QLatin1Char('\n')),
             story);
    QVERIFY(story.contains(QStringLiteral("L42T11 Calculated correct collision response for a "
                                          "collision with a glancing angle")));
    QVERIFY(GitHome::git(work(), {QStringLiteral("fsck"), QStringLiteral("--strict")}).isEmpty());
}

/// What the page at the end shows, and where its buttons lead.
void TestEnding::looksBack(OpenWindow &open, ReportDialog &dialog)
{
    const auto *page = dialog.findChild<QTextBrowser *>();
    const QString text = page->toPlainText();
    QVERIFY(text.contains(QStringLiteral("You have written a physics engine")));
    QVERIFY(text.contains(QStringLiteral("17 of 17 steps pass")));
    for (const Task &task : open.bench.lab().tasks)
        QVERIFY2(text.contains(task.id + QStringLiteral(" ✓")), qPrintable(task.id));
    // A picture of each run, and the energy of all of them.
    QCOMPARE(page->toHtml().count(QStringLiteral("<img ")), 18);
    QVERIFY(text.contains(QStringLiteral("The energy of all runs")));
    // What was hard: two checks, and what the first of them found.
    const Task &task = open.bench.lab().tasks[hard];
    QVERIFY2(text.contains(task.title + QStringLiteral(" – Checks: 2")), qPrintable(text));
    QVERIFY(!text.contains(open.bench.lab().tasks[hard + 1].title));
    QSignalSpy handIn(&dialog, &ReportDialog::handInRequested);
    for (auto *button : dialog.findChildren<QPushButton *>()) {
        if (button->text() == QStringLiteral("&Report…"))
            QVERIFY(button->isEnabled());
        if (button->text() == QStringLiteral("&Hand in…"))
            QTimer::singleShot(0, button, &QPushButton::click);
    }
    QTRY_VERIFY(open.window.findChild<HandInDialog *>());
    QCOMPARE(handIn.size(), 1);
    open.window.findChild<HandInDialog *>()->reject();
}

void TestEnding::reportIsWritten()
{
    OpenWindow open(folder());
    inCode(open);
    type(open, open.bench.task()->solution);
    open.window.notes().findChild<QPlainTextEdit *>()->setPlainText(QStringLiteral("$v^2$"));
    open.bench.openTaskAt(1);
    ReportDialog dialog(open.bench, false);
    dialog.show();
    QTRY_VERIFY(dialog.isReady());
    QVERIFY(!dialog.writeTo(path("r.pdf")));
    QVERIFY(content(path("r.pdf")).startsWith("%PDF-1."));
    QVERIFY(!dialog.writeTo(path("r.html")));
    QVERIFY(content(path("r.html")).contains("<svg "));
    if (QFile::exists(QStringLiteral(":/mathjax/mathjax.js")))
        QVERIFY(content(path("r.html")).contains("aria-label=\"v^2\""));
    QVERIFY(dialog.writeTo(path("none/r.html")));
}

QTEST_MAIN(TestEnding)
#include "test_ending.moc"
