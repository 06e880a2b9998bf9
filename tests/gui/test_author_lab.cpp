// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gui/open_author.h"

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "tests/test_paths.h"
#include "views/author/lab_dialog.h"

#include <QLabel>

using namespace cradle;
using namespace cradle::windows;

/// The lab as a whole: its title, version and id, its language, its findings and the places that
/// they lead to, and how it opens as a student sees it.
class TestAuthorLab : public QObject
{
    Q_OBJECT
private slots:
    void labHasTitlesVersionAndId();
    void labWithoutATitleIsRefused();
    void findingsLeadToTheirFields();
    void labInAnotherLanguageOpensInIt();
    void stepThatIsWrittenOpensAsAStudentSeesIt();
    void everyLabHasAWindowOfItsOwn();
    void mistakeOfAnotherStepIsTakenOver();
};

void TestAuthorLab::labHasTitlesVersionAndId()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    OpenAuthor::inDialog<LabDialog>([](LabDialog *dialog) {
        const auto write = [dialog](const char *name, const QString &text) {
            auto *line = dialog->findChild<QLineEdit *>(QLatin1String(name));
            line->setFocus();
            line->selectAll();
            QTest::keyClicks(line, text);
        };
        write("labTitle.en", QStringLiteral("Super ball"));
        write("labTitle.de", QStringLiteral("Flummi"));
        write("labVersion", QStringLiteral("1.1"));
        write("labId", QStringLiteral("super-ball"));
        QTest::keyClick(dialog->findChild<QLineEdit *>(QStringLiteral("labId")), Qt::Key_Return);
        return true;
    });
    author.click(QStringLiteral("Title, version and id of the lab"));
    const LabForm own = *labForm(author.files());
    QCOMPARE(own.title, QStringLiteral("Super ball"));
    QCOMPARE(own.version, QStringLiteral("1.1"));
    QCOMPARE(own.id, QStringLiteral("super-ball"));
    QCOMPARE(labForm(author.files(), QStringLiteral("de"))->title, QStringLiteral("Flummi"));
    QTRY_VERIFY(author.window.windowTitle().startsWith(QStringLiteral("Super ball")));
    author.undo(); // all of it was one edit
    QCOMPARE(author.files(), before);
}

void TestAuthorLab::labWithoutATitleIsRefused()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    const LabFiles before = author.files();
    QString said;
    const auto tryOut = [&said](const char *name, const QString &text, const QString &language) {
        OpenAuthor::inDialog<LabDialog>([=, &said](LabDialog *dialog) {
            dialog->findChild<QLineEdit *>(QLatin1String(name))->setText(text);
            auto *list = dialog->findChild<QComboBox *>(QStringLiteral("labLanguage"));
            list->setCurrentIndex(list->findData(language));
            dialog->accept();
            for (const QLabel *label : dialog->findChildren<QLabel *>()) {
                if (label->isVisible() && label->property("kind") == QLatin1String("warning"))
                    said = label->text();
            }
            dialog->reject();
            return true;
        });
    };
    tryOut("labTitle.en", QString(), QStringLiteral("en"));
    author.choose(QStringLiteral("Properties…"));
    QVERIFY2(said.contains(QStringLiteral("A title of 1 to 200 characters")), qPrintable(said));
    tryOut("labId", QStringLiteral("two words"), QStringLiteral("en"));
    author.choose(QStringLiteral("Properties…"));
    QVERIFY2(said.contains(QStringLiteral("letters, digits, dots, dashes and underscores")),
             qPrintable(said));
    // German texts are there already, as translations.
    tryOut("labTitle.en", QStringLiteral("Ball"), QStringLiteral("de"));
    author.choose(QStringLiteral("Properties…"));
    QVERIFY2(said.contains(QStringLiteral("translations into this language")), qPrintable(said));
    QCOMPARE(author.files(), before);
}

void TestAuthorLab::findingsLeadToTheirFields()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    LabFiles files = author.files();
    QByteArray &task = files.contents[QStringLiteral("BALL2/task.json")];
    QVERIFY(task.contains("\"right\": 2"));
    task.replace("\"right\": 2", "\"right\": 4");
    QVERIFY(author.document().edit(QStringLiteral("edit"), files));
    author.document().readNow();
    auto *list = author.find<QListWidget>("authorFindings");
    QTRY_COMPARE(list->count(), 1);
    author.window.panes().showTab(AuthorWindow::Scene);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
    QCOMPARE(author.document().step(), QStringLiteral("BALL2"));
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Text});
    QVERIFY(author.find<QLineEdit>("predictionAnswer1")->isVisible());
    // One click on the right answer, and the file is as it was.
    QTest::mouseClick(author.button(QStringLiteral("Answer 2 comes true")), Qt::LeftButton);
    QCOMPARE(
        taskForm(author.files(), author.document().step(), QStringLiteral("en"))->prediction->right,
        1);
    author.document().readNow();
    QTRY_COMPARE(list->count(), 0);

    // A remark that looks at a circle that is not there.
    files = author.files();
    QByteArray &remarked = files.contents[QStringLiteral("BALL2/task.json")];
    const auto at = remarked.indexOf("\"compare\": \"velocities\", \"circles\": [1]");
    QVERIFY(at > 0);
    remarked.replace("\"compare\": \"velocities\", \"circles\": [1]",
                     "\"compare\": \"velocities\", \"circles\": [3]");
    QVERIFY(author.document().edit(QStringLiteral("edit"), files));
    author.document().readNow();
    QTRY_VERIFY(list->count() >= 1);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->item(0)).center());
    QCOMPARE(author.window.tabs().currentIndex(), int{AuthorWindow::Programs});
    QVERIFY(author.find<QLineEdit>("remarkCircles")->isVisible());
    QCOMPARE(author.find<QLineEdit>("remarkCircles")->text(), QStringLiteral("3"));
}

void TestAuthorLab::labInAnotherLanguageOpensInIt()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    const LabFiles german =
        newLab(QStringLiteral("fall"), QStringLiteral("Fall"), QStringLiteral("de"));
    author.document().begin(german);
    QCOMPARE(author.document().language(), QStringLiteral("de"));
    author.window.panes().showTab(AuthorWindow::Text);
    QVERIFY(!author.find<MarkdownEditor>("markdown")->toPlainText().isEmpty());
}

void TestAuthorLab::stepThatIsWrittenOpensAsAStudentSeesIt()
{
    const QTemporaryDir folder;
    OpenWindow student(folder);
    const QString place = folder.filePath(QStringLiteral("ball"));
    const Result<LabFiles> ball = readLabFiles(sourcePath("tasks/labs/bouncing-ball"));
    QVERIFY(ball && !saveLabFiles(*ball, {}, place));
    QVERIFY(!student.window.authors().open(place));
    AuthorWindow *author = student.window.authors().newest();
    author->show();
    AuthorDocument &document = author->document();
    document.setStep(QStringLiteral("BALL3"));
    TaskForm form = *taskForm(document.files(), document.step());
    form.title = QStringLiteral("Half as high");
    QVERIFY(
        document.edit(QStringLiteral("edit"), withTask(document.files(), document.step(), form)));
    author->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(author, patience));
    QTest::keyClick(author, Qt::Key_F5);
    // Saved, and open at the step that is written, as it is now.
    QVERIFY(!document.isModified());
    QCOMPARE(*readLabFiles(place), document.files());
    QVERIFY(student.bench.task());
    QCOMPARE(student.bench.task()->id, QStringLiteral("BALL3"));
    QCOMPARE(student.bench.task()->title, QStringLiteral("Half as high"));
}

/// "Author a lab…" opens the lab that is open, also while another is written.
void TestAuthorLab::everyLabHasAWindowOfItsOwn()
{
    const QTemporaryDir folder;
    OpenWindow student(folder);
    const QString place = folder.filePath(QStringLiteral("ball"));
    const Result<LabFiles> ball = readLabFiles(sourcePath("tasks/labs/bouncing-ball"));
    QVERIFY(ball && !saveLabFiles(*ball, {}, place));
    QVERIFY(!student.window.authors().open(place));
    const QPointer<AuthorWindow> first = student.window.authors().newest();
    first->show();

    student.window.authors().authorLab();
    const QPointer<AuthorWindow> second = student.window.authors().newest();
    QVERIFY(second && second != first && second->isVisible());
    QCOMPARE(second->document().folder(), student.bench.lab().folder);
    QCOMPARE(first->document().folder(), place);

    // What is open already comes to the front.
    student.window.authors().authorLab();
    QCOMPARE(student.window.authors().newest(), second.data());
    QVERIFY(!student.bench.openLab(place, QStringLiteral("en")));
    student.window.authors().authorLab();
    QCOMPARE(student.window.authors().newest(), second.data());
    const QWidgetList windows = QApplication::topLevelWidgets();
    QCOMPARE(std::count_if(windows.begin(), windows.end(),
                           [](QWidget *window) { return qobject_cast<AuthorWindow *>(window); }),
             2);

    QVERIFY(second->close());
    QTRY_VERIFY(!second);
    QCOMPARE(student.window.authors().newest(), first.data());
    QVERIFY(student.window.close());
    QTRY_VERIFY(!first);
}

/// From the menu of the plus: offered by step, taken over by one entry, and undone as one edit.
void TestAuthorLab::mistakeOfAnotherStepIsTakenOver()
{
    const QTemporaryDir folder;
    OpenAuthor author(folder);
    const Result<LabFiles> lab = readLabFiles(sourcePath("tasks/labs/lab-4.2"));
    QVERIFY(lab);
    author.document().begin(*lab);
    author.document().setStep(QStringLiteral("L42T10"));
    author.window.panes().showTab(AuthorWindow::Programs);
    auto *others = author.find<QMenu>("otherMistakes");
    auto *menu = qobject_cast<QMenu *>(others->parent());
    QVERIFY(menu);
    emit menu->aboutToShow();
    QVERIFY(others->menuAction()->isEnabled());
    QAction *chosen = nullptr;
    for (const QMenu *step : others->findChildren<QMenu *>()) {
        for (QAction *action : step->actions()) {
            if (action->toolTip() == QStringLiteral("ceiling-asks-downward"))
                chosen = action;
        }
    }
    QVERIFY(chosen);
    chosen->trigger();
    QCOMPARE(author.window.programsTab().program(),
             QStringLiteral("mistakes/ceiling-asks-downward.lua"));
    QVERIFY(author.window.programsTab().editor().text().contains(
        QStringLiteral("p.y + r > square.top and v.y < 0")));
    author.document().undoStack().undo();
    QCOMPARE(author.files(), *lab);
}

QTEST_MAIN(TestAuthorLab)
#include "test_author_lab.moc"
