// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/code/code_editor.h"

#include <Qsci/qsciscintilla.h>

using namespace cradle;
using namespace cradle::windows;

/// Mistakes that are kept as differences from the solution, in the author's window.
class TestAuthorDifferences : public QObject
{
    Q_OBJECT
private slots:
    void mistakeIsEditedAsAWholeProgram();
    void differenceThatNoLongerAppliesIsOpenedAndMended();
};

namespace {

const QString solution = QStringLiteral("BALL1/solution.lua");
const QString late = QStringLiteral("mistakes/old-velocity.lua");
const QString diff = QStringLiteral("BALL1/mistakes/old-velocity.diff");

} // namespace

void TestAuthorDifferences::mistakeIsEditedAsAWholeProgram()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Programs);
    author.window.programsTab().openProgram(late);
    CodeEditor &editor = author.window.programsTab().editor();
    QVERIFY(editor.text().startsWith(QStringLiteral("-- The old velocity moves the ball\n--\n")));
    QVERIFY(editor.text().contains(QStringLiteral("gravity = vec(0, -9.81)")));
    // Blanks that the difference does not keep are not taken away while somebody types.
    auto *area = editor.findChild<QsciScintilla *>();
    area->insertAt(QStringLiteral("-- \n"), 1, 0);
    QCoreApplication::processEvents();
    QVERIFY(editor.text().contains(QStringLiteral("ball\n-- \n")));
    area->insertAt(QStringLiteral("-- more\n"), area->lines() - 1, 0);
    QTRY_VERIFY(textOf(author.files(), diff).contains(QStringLiteral("+-- more\n")));
    QVERIFY(!author.files().contents.contains(QStringLiteral("BALL1/") + late));

    // A value that the solution changes is changed here, too.
    QString moon = textOf(author.files(), solution);
    moon.replace(QStringLiteral("-9.81"), QStringLiteral("-1.62"));
    QVERIFY(
        author.document().edit(QStringLiteral("moon"), withText(author.files(), solution, moon)));
    QVERIFY(editor.text().contains(QStringLiteral("gravity = vec(0, -1.62)")));
}

void TestAuthorDifferences::differenceThatNoLongerAppliesIsOpenedAndMended()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    QString other = textOf(author.files(), solution);
    other.replace(QStringLiteral("velocity + gravity * timestep"),
                  QStringLiteral("velocity + timestep * gravity"));
    QVERIFY(
        author.document().edit(QStringLiteral("turn"), withText(author.files(), solution, other)));
    author.document().readNow();
    auto *findings = author.find<QListWidget>("authorFindings");
    QListWidgetItem *found = nullptr;
    for (int i = 0; i < findings->count(); ++i) {
        if (findings->item(i)->text().startsWith(diff))
            found = findings->item(i);
    }
    QVERIFY(found);
    emit findings->itemClicked(found);
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Programs});
    QCOMPARE(author.window.programsTab().program(), late);
    CodeEditor &editor = author.window.programsTab().editor();
    QCOMPARE(editor.text(), textOf(author.files(), diff));
    QVERIFY(editor.errorLine() > 0);

    auto *area = editor.findChild<QsciScintilla *>();
    QString mended = editor.text();
    mended.replace(QStringLiteral("gravity * timestep"), QStringLiteral("timestep * gravity"));
    area->selectAll();
    area->replaceSelectedText(mended);
    QTRY_VERIFY(editor.text().startsWith(QStringLiteral("-- The old velocity")));
    QCOMPARE(editor.errorLine(), 0);
    author.document().readNow();
    for (int i = 0; i < findings->count(); ++i)
        QVERIFY(!findings->item(i)->text().startsWith(diff));
}

QTEST_MAIN(TestAuthorDifferences)
#include "test_author_differences.moc"
