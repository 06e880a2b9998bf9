// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_reader.h"

#include <QLabel>

using namespace cradle;
using namespace cradle::windows;

/// Find and replace over the whole lab, and the ways from a place to where it is edited.
class TestAuthorFind : public QObject
{
    Q_OBJECT
private slots:
    void placesAreListedAndOpened();
    void replacingIsOneEdit();
    void shippedLabIsOnlySearched();
    void escapeClosesIt();
};

namespace {

void search(OpenAuthor &author, const QString &text)
{
    author.choose(QStringLiteral("Find and replace in the lab…"));
    author.find<QLineEdit>("findText")->clear();
    QTest::keyClicks(author.find<QLineEdit>("findText"), text);
    // As Return does, without waiting for more letters.
    QTest::keyClick(author.find<QLineEdit>("findText"), Qt::Key_Return);
}

/// Chooses the place that begins with \p start.
void open(OpenAuthor &author, const QString &start)
{
    auto *list = author.find<QListWidget>("findHits");
    for (int i = 0; i < list->count(); ++i) {
        if (list->item(i)->text().startsWith(start)) {
            emit list->itemClicked(list->item(i));
            return;
        }
    }
    QFAIL(qPrintable(start));
}

int shownTab(OpenAuthor &author)
{
    return author.window.findChild<QTabWidget *>()->currentIndex();
}

} // namespace

void TestAuthorFind::placesAreListedAndOpened()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.document().setStep(QStringLiteral("BALL3"));
    search(author, QStringLiteral("symplectic"));
    QTRY_VERIFY(author.find<QListWidget>("findHits")->count() > 5);
    open(author, QStringLiteral("BALL1/instructions.md:"));
    QCOMPARE(author.document().step(), QStringLiteral("BALL1"));
    QCOMPARE(shownTab(author), int(AuthorWindow::Text));
    const auto *editor = author.find<MarkdownEditor>("markdown");
    QVERIFY(editor->textCursor().selectedText().contains(QLatin1String("ymplectic")));
    open(author, QStringLiteral("BALL1/task.json checks/1/title"));
    QCOMPARE(shownTab(author), int(AuthorWindow::Checks));
    QCOMPARE(author.find<QListWidget>("checks")->currentRow(), 1);
    open(author, QStringLiteral("BALL1/task.json hints/2"));
    QCOMPARE(shownTab(author), int(AuthorWindow::Text));
    QVERIFY(editor->toPlainText().contains(QLatin1String("Gravity x = 0")));
    open(author, QStringLiteral("BALL1/mistakes/old-velocity.diff:"));
    QCOMPARE(shownTab(author), int(AuthorWindow::Programs));
    search(author, QStringLiteral("symplektisch"));
    open(author, QStringLiteral("BALL1/task.de.json checks/falls"));
    QCOMPARE(author.document().language(), QStringLiteral("de"));
    QCOMPARE(author.find<QListWidget>("checks")->currentRow(), 1);
}

void TestAuthorFind::replacingIsOneEdit()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    search(author, QStringLiteral("timestep"));
    auto *with = author.find<QLineEdit>("replaceText");
    with->setFocus();
    QTest::keyClicks(with, QStringLiteral("delta_t"));
    author.click(QStringLiteral("Replace all"));
    QVERIFY(author.window.notice().text().contains(QLatin1String("replaced")));
    QCOMPARE(author.find<QLabel>("findCount")->text(), QStringLiteral("Found nowhere"));
    for (const char *step : {"BALL1", "BALL2", "BALL3"})
        QVERIFY(!textOf(author.files(), QLatin1String(step) + QStringLiteral("/solution.lua"))
                     .contains(QLatin1String("timestep")));
    author.document().undoStack().undo();
    QCOMPARE(author.files(), before);
}

void TestAuthorFind::shippedLabIsOnlySearched()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    QVERIFY(!author.window.files().open(QLatin1String(shippedLab)));
    QVERIFY(author.document().isReadOnly());
    search(author, QStringLiteral("timestep"));
    QTRY_VERIFY(author.find<QListWidget>("findHits")->count() > 0);
    QVERIFY(!author.button(QStringLiteral("Replace all"))->isEnabled());
}

void TestAuthorFind::escapeClosesIt()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    search(author, QStringLiteral("floor"));
    auto *line = author.find<QLineEdit>("findText");
    QVERIFY(line->isVisible());
    for (const auto *each : line->parentWidget()->findChildren<QWidget *>()) {
        if (each->focusPolicy() & Qt::TabFocus
            && each->objectName().startsWith(QLatin1String("find")))
            QVERIFY2(!each->accessibleName().isEmpty()
                         || qobject_cast<const QAbstractButton *>(each),
                     qPrintable(each->objectName()));
    }
    QTest::keyClick(line, Qt::Key_Escape);
    QVERIFY(!line->isVisible());
}

QTEST_MAIN(TestAuthorFind)

#include "test_author_find.moc"
