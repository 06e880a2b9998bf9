// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/difference_dialog.h"
#include "views/author/lab_dialog.h"
#include "views/code/code_editor.h"

#include <QJsonArray>
#include <QPlainTextEdit>
#include <Qsci/qsciscintilla.h>

using namespace cradle;
using namespace cradle::windows;

/// Nothing that an author typed is dropped, and nothing goes where it is not seen to go.
class TestAuthorLosses : public QObject
{
    Q_OBJECT
private slots:
    void languageStandsOnEveryTab();
    void invalidFieldStaysUntilItIsMended();
    void brokenStepIsBlockedAloneAndMendedHere();
    void exportAsksForWhatCannotBeRead();
    void copyGetsAnIdAndATitleOfItsOwn();
    void reloadAsksAndShowsTheDifference();
    void foreignFilesStayWhenAStepGoes();
    void copyOfACheckInLuaHasAProgramOfItsOwn();
};

namespace {

const QString ball1 = QStringLiteral("BALL1");

CheckForm checkOf(OpenAuthor &author, int index)
{
    return taskForm(author.files(), author.document().step())
        ->checks[static_cast<std::size_t>(index)];
}

/// Presses the button of the next dialog of that class; \p seen gets to look at it before.
template <typename Dialog>
void press(const QString &name, const std::function<void(Dialog *)> &seen = {})
{
    OpenAuthor::inDialog<Dialog>([name, seen](Dialog *dialog) {
        if (seen)
            seen(dialog);
        for (auto *button : dialog->template findChildren<QPushButton *>()) {
            if (button->text().remove(QLatin1Char('&')) == name) {
                button->click();
                return true;
            }
        }
        dialog->reject();
        QTest::qFail(qPrintable(name), __FILE__, __LINE__);
        return true;
    });
}

} // namespace

void TestAuthorLosses::languageStandsOnEveryTab()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Text);
    author.pick("textLanguage", QStringLiteral("de"));
    for (const int tab : {AuthorWindow::Scene, AuthorWindow::Text, AuthorWindow::Checks,
                          AuthorWindow::Programs, AuthorWindow::Proof}) {
        author.window.panes().showTab(tab);
        const auto *language = author.find<QComboBox>("textLanguage");
        QVERIFY(language->isVisible());
        QVERIFY(language->currentText().contains(QStringLiteral("Deutsch (de)")));
    }
    // A title that is typed in Checks goes where that says.
    author.window.panes().showTab(AuthorWindow::Checks);
    author.fill("checkTitle", QStringLiteral("Losgelassen"));
    QCOMPARE(taskForm(author.files(), ball1, QStringLiteral("de"))->checks[0].title,
             QStringLiteral("Losgelassen"));
    author.pick("textLanguage", QStringLiteral("en"));
    QVERIFY(author.find<QLineEdit>("checkTitle")->text() != QStringLiteral("Losgelassen"));
}

void TestAuthorLosses::invalidFieldStaysUntilItIsMended()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.panes().showTab(AuthorWindow::Checks);
    author.pick("checkKind", QStringLiteral("start"));
    const QString wrong = QStringLiteral("0.9, 0, 0.7, 0.4");
    author.fill("position", wrong);
    author.fill("checkTitle", QStringLiteral("Another field"));
    author.fill("velocity", QStringLiteral("1, 2"));
    const auto *field = author.find<QLineEdit>("position");
    QCOMPARE(field->text(), wrong);
    QVERIFY(field->property("refused").toBool());
    // Also after a look at another check and another step; and the list tells of it.
    auto *list = author.find<QListWidget>("checks");
    list->setCurrentRow(1);
    list->setCurrentRow(0);
    author.document().setStep(QStringLiteral("BALL2"));
    author.document().setStep(ball1);
    QCOMPARE(author.find<QLineEdit>("position")->text(), wrong);
    QVERIFY(!list->item(0)->icon().isNull());
    QVERIFY(list->item(1)->icon().isNull());
    QVERIFY(author.window.files().save());
    QVERIFY(author.window.notice().text().contains(ball1));

    author.fill("checkCircles", QStringLiteral("one"));
    author.fill("checkPoints", QStringLiteral("many"));
    QCOMPARE(author.find<QLineEdit>("checkCircles")->text(), QStringLiteral("one"));
    QCOMPARE(author.find<QLineEdit>("checkPoints")->text(), QStringLiteral("many"));
    author.fill("checkCircles", QStringLiteral("1"));
    author.fill("checkPoints", QStringLiteral("2"));
    author.fill("position", QStringLiteral("0.9, 0"));
    QCOMPARE(checkOf(author, 0).points, 2.0);
    QCOMPARE(checkOf(author, 0).parameters.value(QStringLiteral("position")).toArray().size(), 2);
    QVERIFY(author.window.checksTab().refusedChecks().isEmpty());
    QVERIFY(list->item(0)->icon().isNull());
}

void TestAuthorLosses::brokenStepIsBlockedAloneAndMendedHere()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const QString path = QStringLiteral("BALL2/task.json");
    const QString whole = textOf(author.files(), path);
    QVERIFY(author.document().edit(QStringLiteral("break"),
                                   withText(author.files(), path, QString(whole).remove(0, 1))));
    author.window.panes().showTab(AuthorWindow::Text);
    QVERIFY(author.find<QLineEdit>("stepTitle")->isVisible()); // of BALL1

    author.document().setStep(QStringLiteral("BALL2"));
    auto *text = author.find<QPlainTextEdit>("brokenText");
    QVERIFY(text->isVisible());
    QVERIFY(!author.find<QLineEdit>("stepTitle")->isVisible()); // else it had another's title
    QVERIFY(!author.find<QListWidget>("checks")->isVisible());
    text->setFocus();
    text->moveCursor(QTextCursor::Start);
    QTest::keyClicks(text, QStringLiteral("{"));
    QVERIFY(!text->isVisible());
    QCOMPARE(textOf(author.files(), path), whole);
    QVERIFY(author.find<QLineEdit>("stepTitle")->isVisible());
    QCOMPARE(author.find<QLineEdit>("stepTitle")->text(),
             taskForm(author.files(), QStringLiteral("BALL2"))->title);
    author.undo();
    QVERIFY(text->isVisible());
    QTest::keyClick(author.focus(), Qt::Key_Y, Qt::ControlModifier); // as well as Ctrl+Shift+Z
    QVERIFY(!text->isVisible());
}

void TestAuthorLosses::exportAsksForWhatCannotBeRead()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    QVERIFY(author.document().edit(
        QStringLiteral("break"),
        withText(author.files(), QStringLiteral("BALL2/task.json"), QStringLiteral("{"))));
    QString said;
    OpenAuthor::inDialog<QMessageBox>([&said](QMessageBox *box) {
        said = box->text();
        box->reject();
        return true;
    });
    author.choose(QStringLiteral("Export as one file…"));
    QVERIFY2(said.contains(QStringLiteral("BALL2/task.json")), qPrintable(said));
    QVERIFY(!author.window.notice().text().contains(QStringLiteral("Exported")));
}

void TestAuthorLosses::copyGetsAnIdAndATitleOfItsOwn()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const QString place = folder.filePath(QStringLiteral("mine"));
    // The id of the original is refused.
    auto tries = std::make_shared<int>(0);
    OpenAuthor::inDialog<LabDialog>([tries, place](LabDialog *dialog) {
        auto *id = dialog->findChild<QLineEdit *>(QStringLiteral("labId"));
        auto *title = dialog->findChild<QLineEdit *>(QStringLiteral("labTitle.en"));
        if ((*tries)++ == 0) {
            if (id->text() == QStringLiteral("bouncing-ball"))
                QTest::qFail("the id of the original is offered", __FILE__, __LINE__);
            id->setText(QStringLiteral("bouncing-ball"));
            dialog->accept();
            return false;
        }
        id->setText(QStringLiteral("my-ball"));
        title->setText(QStringLiteral("My ball"));
        OpenAuthor::answerDialog(place);
        dialog->accept();
        return true;
    });
    author.choose(QStringLiteral("Save as…"));
    QCOMPARE(*tries, 2);
    const Result<LabFiles> copy = readLabFiles(place);
    QVERIFY2(copy.ok(), qPrintable(author.window.notice().text()));
    QCOMPARE(labForm(*copy)->id, QStringLiteral("my-ball"));
    QCOMPARE(labForm(*copy)->title, QStringLiteral("My ball"));
    QCOMPARE(author.document().folder(), place);
    QCOMPARE(author.files(), *copy);
    QCOMPARE(labForm(*readLabFiles(folder.filePath(QStringLiteral("ball"))))->id,
             QStringLiteral("bouncing-ball"));
}

void TestAuthorLosses::reloadAsksAndShowsTheDifference()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const QString path = QStringLiteral("BALL1/instructions.md");
    QVERIFY(author.document().edit(QStringLiteral("edit"),
                                   withText(author.files(), path, QStringLiteral("# Mine\n"))));
    QFile file(folder.filePath(QStringLiteral("ball/BALL1/instructions.md")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("# Theirs\n") > 0);
    file.close();
    QTRY_VERIFY(author.window.notice().isVisible());
    QString shown;
    QString standard;
    const auto look = [&](DifferenceDialog *dialog) {
        shown = dialog->findChild<QPlainTextEdit *>()->toPlainText();
        for (const auto *button : dialog->findChildren<QPushButton *>())
            standard += button->isDefault() ? button->text().remove(QLatin1Char('&')) : QString();
    };
    press<DifferenceDialog>(QStringLiteral("Cancel"), look);
    author.click(QStringLiteral("Reload"));
    QVERIFY2(shown.contains(QStringLiteral("-# Mine")), qPrintable(shown));
    QVERIFY2(shown.contains(QStringLiteral("+# Theirs")), qPrintable(shown));
    QCOMPARE(standard, QStringLiteral("Cancel"));
    QCOMPARE(textOf(author.files(), path), QStringLiteral("# Mine\n"));

    // Saving over theirs asks the same way.
    standard.clear();
    press<DifferenceDialog>(QStringLiteral("Cancel"), look);
    QVERIFY(!author.window.files().save());
    QCOMPARE(standard, QStringLiteral("Cancel"));
    press<DifferenceDialog>(QStringLiteral("Take theirs"));
    author.click(QStringLiteral("Reload"));
    QCOMPARE(textOf(author.files(), path), QStringLiteral("# Theirs\n"));
    author.undo();
    QCOMPARE(textOf(author.files(), path), QStringLiteral("# Mine\n"));
}

void TestAuthorLosses::foreignFilesStayWhenAStepGoes()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const QString notes = QStringLiteral("BALL2/notes for next year.txt");
    QVERIFY(author.document().edit(QStringLiteral("notes"),
                                   withText(author.files(), notes, QStringLiteral("Later.\n"))));
    QVERIFY(author.window.files().save());
    author.document().setStep(QStringLiteral("BALL2"));
    author.window.steps().removeStep();
    QVERIFY(!author.document().steps().contains(QStringLiteral("BALL2")));
    QVERIFY(author.window.notice().text().contains(notes));
    QVERIFY(author.window.files().save());
    const LabFiles saved = *readLabFiles(folder.filePath(QStringLiteral("ball")));
    QStringList left;
    for (auto it = saved.contents.keyBegin(); it != saved.contents.keyEnd(); ++it) {
        if (it->startsWith(QStringLiteral("BALL2/")))
            left.append(*it);
    }
    QCOMPARE(left, QStringList(notes)); // floor.svg is a picture of the text, and is gone
}

void TestAuthorLosses::copyOfACheckInLuaHasAProgramOfItsOwn()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.document().setStep(QStringLiteral("BALL3"));
    author.window.panes().showTab(AuthorWindow::Checks);
    author.window.checksTab().showCheck(QStringLiteral("half"));
    const QString original = textOf(author.files(), QStringLiteral("BALL3/checks/half-height.lua"));
    author.window.checksTab().duplicateCheck();
    const int copy = author.find<QListWidget>("checks")->currentRow();
    QCOMPARE(checkOf(author, copy).parameters.value(QStringLiteral("script")).toString(),
             QStringLiteral("half-2.lua"));
    CodeEditor &editor = author.window.checksTab().scriptEditor();
    QCOMPARE(editor.text(), original);
    QTest::keyClicks(editor.findChild<QsciScintilla *>(), QStringLiteral("-- mine "));
    QCoreApplication::processEvents(); // the editor tells of an edit when it is through with it
    QCOMPARE(textOf(author.files(), QStringLiteral("BALL3/checks/half-height.lua")), original);
    QVERIFY(textOf(author.files(), QStringLiteral("BALL3/checks/half-2.lua"))
                .contains(QStringLiteral("-- mine")));
}

QTEST_MAIN(TestAuthorLosses)
#include "test_author_losses.moc"
