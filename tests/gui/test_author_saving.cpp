// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"
#include "tests/patience.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_reader.h"
#include "views/author/difference_dialog.h"
#include "views/author/lab_dialog.h"
#include "views/inspector/inspector.h"

using namespace cradle;
using namespace cradle::windows;

/// Where a lab is kept: the copy of a shipped one, an empty folder, a folder that others write
/// into, and what is not saved when the window closes.
class TestAuthorSaving : public QObject
{
    Q_OBJECT
private slots:
    void labIsSavedIntoAnEmptyFolder();
    void shippedLabIsReadOnlyUntilCopied();
    void otherProgramsAreNoticed();
    void closingAsksForWhatIsNotSaved();
};

namespace {

void write(const QString &path, const QByteArray &content)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

} // namespace

void TestAuthorSaving::labIsSavedIntoAnEmptyFolder()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Empty"));
    const QString place = folder.filePath(QStringLiteral("made-before"));
    QVERIFY(QDir().mkpath(place));
    OpenAuthor::answerDialog(place);
    author.choose(QStringLiteral("Save as…"));
    QCOMPARE(author.document().folder(), place);
    QCOMPARE(*readLabFiles(place), author.files());

    // One in which something is stays as it is.
    const QString full = folder.filePath(QStringLiteral("full"));
    QVERIFY(QDir().mkpath(full + QStringLiteral("/inside")));
    const auto error = author.document().saveAs(full);
    QVERIFY(error);
    QVERIFY(error->message.contains(QStringLiteral("not empty")));
    QCOMPARE(author.document().folder(), place);
}

void TestAuthorSaving::shippedLabIsReadOnlyUntilCopied()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    QVERIFY(!author.window.files().open(QLatin1String(shippedLab)));
    QVERIFY(author.document().isReadOnly());
    QVERIFY(author.window.notice().isVisible());
    const LabFiles before = author.files();
    author.window.steps().addStep();
    QCOMPARE(author.files(), before);
    QVERIFY(author.find<MarkdownEditor>("markdown")->isReadOnly());
    // The numbers of the scene are to be seen, not edited; nor is there a scene to go back to.
    const auto *inspector = author.window.sceneTab().findChild<Inspector *>();
    QVERIFY(!inspector->findChildren<QLineEdit *>().isEmpty());
    for (const QLineEdit *field : inspector->findChildren<QLineEdit *>())
        QVERIFY(!field->isEnabled());
    QVERIFY(!author.button(QStringLiteral("Add circle"))->isEnabled());
    QVERIFY(!author.button(QStringLiteral("Reset to the step's scene")));

    const QString place = folder.filePath(QStringLiteral("copy"));
    OpenAuthor::inDialog<LabDialog>([place](LabDialog *dialog) {
        OpenAuthor::answerDialog(place);
        dialog->accept();
        return true;
    });
    author.click(QStringLiteral("Copy to a folder…"));
    QVERIFY2(!author.document().isReadOnly(), qPrintable(author.window.notice().text()));
    LabFiles copy = *readLabFiles(place);
    QVERIFY(labForm(copy)->id != labForm(before)->id); // its progress is its own
    for (const QString &name : before.contents.keys()) {
        if (!name.contains(QLatin1Char('/')) && name.startsWith(QLatin1String("lab.")))
            copy.contents[name] = before.contents.value(name); // with the id, of every language
    }
    QCOMPARE(copy, before);
    for (const QLineEdit *field : inspector->findChildren<QLineEdit *>())
        QVERIFY(field->isEnabled());
    QVERIFY(author.button(QStringLiteral("Add circle"))->isEnabled());
    QVERIFY(!author.find<MarkdownEditor>("markdown")->isReadOnly());
    author.window.steps().addStep();
    QVERIFY(author.files() != before);
}

void TestAuthorSaving::otherProgramsAreNoticed()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Shared"));
    const QString place = folder.filePath(QStringLiteral("shared"));
    QVERIFY(!author.document().saveAs(place));
    const QString step = author.document().step();
    const QString text = instructionsPath(author.files(), step);
    QTest::qWait(600); // for the watcher to tell of our own save, which is no news
    QVERIFY(!author.window.notice().isVisible());

    write(place + QLatin1Char('/') + text, "# Theirs\n");
    QTRY_VERIFY(author.window.notice().isVisible());
    QVERIFY(author.window.notice().text().contains(text));
    author.click(QStringLiteral("Reload"));
    QCOMPARE(textOf(author.files(), text), QStringLiteral("# Theirs\n"));
    author.undo();
    QVERIFY(textOf(author.files(), text) != QStringLiteral("# Theirs\n"));
    author.redo();

    // Both changed the same file: saving asks.
    write(place + QLatin1Char('/') + text, "# Theirs again\n");
    QVERIFY(author.document().edit(QStringLiteral("edit"),
                                   withText(author.files(), text, QStringLiteral("# Mine\n"))));
    OpenAuthor::inDialog<DifferenceDialog>([](DifferenceDialog *dialog) {
        dialog->reject();
        return true;
    });
    QVERIFY(!author.window.files().save());
    QCOMPARE(textOf(*readLabFiles(place), text), QStringLiteral("# Theirs again\n"));
    OpenAuthor::inDialog<DifferenceDialog>([](DifferenceDialog *dialog) {
        for (auto *button : dialog->findChildren<QPushButton *>()) {
            if (button->text() == QStringLiteral("Replace with mine"))
                button->click();
        }
        return true;
    });
    QVERIFY(author.window.files().save());
    QCOMPARE(textOf(*readLabFiles(place), text), QStringLiteral("# Mine\n"));
}

void TestAuthorSaving::closingAsksForWhatIsNotSaved()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    beginLab(author, QStringLiteral("Close"));
    OpenAuthor::answerQuestion(QStringLiteral("Cancel"));
    QVERIFY(!author.window.close());
    QVERIFY(author.window.isVisible());
    OpenAuthor::answerQuestion(QStringLiteral("Discard"));
    QVERIFY(author.window.close());
}

QTEST_MAIN(TestAuthorSaving)
#include "test_author_saving.moc"
