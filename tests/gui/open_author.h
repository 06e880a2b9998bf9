// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/author_window.h"
#include "app/notice_bar.h"
#include "tests/patience.h"
#include "tests/test_paths.h"
#include "views/author/checks_tab.h"
#include "views/author/markdown_editor.h"
#include "views/author/programs_tab.h"
#include "views/author/proof_tab.h"
#include "views/author/scene_tab.h"
#include "views/author/steps_panel.h"
#include "views/author/text_tab.h"
#include "views/code/code_editor.h"
#include "views/markdown_view.h"
#include "views/task_pane/instructions_pane.h"

#include <Qsci/qsciscintilla.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <memory>

namespace cradle::windows {

/// What stands in the instructions that are shown, without the cards among them.
inline QString textShown(const InstructionsPane &pane)
{
    QString text;
    for (const auto *view : pane.findChildren<MarkdownView *>())
        text += view->toPlainText() + QLatin1Char('\n');
    return text;
}

/// The window in which a lab is written, as an author has it open.
class OpenAuthor
{
public:
    explicit OpenAuthor(const QTemporaryDir &folder)
        : settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat)
        , window(settings)
    {
        window.resize(1280, 720);
        window.show();
        window.activateWindow();
    }

    [[nodiscard]] AuthorDocument &document() { return window.document(); }
    [[nodiscard]] const LabFiles &files() { return window.document().files(); }

    /// The visible button that is called so.
    [[nodiscard]] QAbstractButton *button(const QString &name)
    {
        for (auto *each : window.findChildren<QAbstractButton *>()) {
            if (each->isVisible() && (each->accessibleName() == name || each->text() == name))
                return each;
        }
        return nullptr;
    }
    void click(const QString &name)
    {
        QAbstractButton *found = button(name);
        QVERIFY2(found && found->isEnabled(), qPrintable(name));
        QTest::mouseClick(found, Qt::LeftButton);
    }
    /// Triggers the entry of a menu, whose mnemonics do not count.
    void choose(const QString &entry)
    {
        for (QAction *action : window.findChildren<QAction *>()) {
            if (action->text().remove(QLatin1Char('&')) == entry) {
                QVERIFY2(action->isEnabled(), qPrintable(entry));
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable(entry));
    }
    /// The widget of that name; of several, the one that is seen.
    template <typename Widget>
    [[nodiscard]] Widget *find(const char *name)
    {
        const QList<Widget *> all = window.findChildren<Widget *>(QLatin1String(name));
        for (Widget *each : all) {
            if (each->isVisible())
                return each;
        }
        return all.value(0);
    }
    /// Types into the line of a form instead of what stands there, and leaves it.
    void fill(const char *name, const QString &text)
    {
        // The fields of a form are shown a little after they are made.
        QTRY_VERIFY2(find<QLineEdit>(name) && find<QLineEdit>(name)->isVisible(), name);
        auto *line = find<QLineEdit>(name);
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Return);
    }
    /// Chooses the entry of a list with that data.
    void pick(const char *name, const QString &data)
    {
        auto *list = find<QComboBox>(name);
        QVERIFY2(list && list->isVisible(), name);
        const int index = list->findData(data);
        QVERIFY2(index >= 0, qPrintable(data));
        list->setFocus();
        list->setCurrentIndex(index);
        emit list->activated(index);
    }
    /// Types a name into the field that a list has opened over a row.
    void typeInPlace(QListWidget *list, const QString &text)
    {
        QTRY_VERIFY(list->viewport()->findChild<QLineEdit *>());
        auto *line = list->viewport()->findChild<QLineEdit *>();
        line->selectAll();
        QTest::keyClicks(line, text);
        const QPointer<QLineEdit> watched(line);
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_VERIFY(!watched);
        QCoreApplication::processEvents(); // the edit follows
    }
    /// Does \p act to the next dialog of that class as soon as it is there, and again a little
    /// later as long as it answers false.
    template <typename Dialog, typename Act>
    static void inDialog(Act act)
    {
        auto *timer = new QTimer(qApp);
        QObject::connect(timer, &QTimer::timeout, timer, [timer, act] {
            auto *dialog = qobject_cast<Dialog *>(QApplication::activeModalWidget());
            if (!dialog || !dialog->isVisible() || !act(dialog))
                return;
            timer->stop();
            timer->deleteLater();
        });
        timer->start(50);
    }
    /// Types \p text into the next dialog and accepts it. A file dialog takes a name only when it
    /// has read its folder.
    static void answerDialog(const QString &text)
    {
        auto tries = std::make_shared<int>(0);
        inDialog<QDialog>([text, tries](QDialog *dialog) {
            auto *line = dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
            if (!line)
                line = dialog->findChild<QLineEdit *>();
            // Without the focus a file dialog takes a folder on the way for the one that is typed.
            dialog->activateWindow();
            line->setFocus();
            if (!line->hasFocus() && ++*tries < 40)
                return false;
            line->selectAll();
            QTest::keyClicks(line, text);
            QTest::keyClick(line, Qt::Key_Return);
            if (dialog->isVisible() && ++*tries == 40)
                dialog->reject(); // the test will tell
            return !dialog->isVisible();
        });
    }
    /// Presses the button of the next message box that is called so. What it returns becomes true
    /// then.
    static std::shared_ptr<const bool> answerQuestion(const QString &name)
    {
        auto answered = std::make_shared<bool>(false);
        inDialog<QMessageBox>([name, answered](QMessageBox *box) {
            *answered = true;
            for (QAbstractButton *each : box->buttons()) {
                if (each->text().remove(QLatin1Char('&')) == name) {
                    each->click();
                    return true;
                }
            }
            box->reject();
            QTest::qFail(qPrintable(name), __FILE__, __LINE__);
            return true;
        });
        return answered;
    }
    void undo() { QTest::keyClick(focus(), Qt::Key_Z, Qt::ControlModifier); }
    void redo() { QTest::keySequence(focus(), QKeySequence(QKeySequence::Redo)); }
    [[nodiscard]] QWidget *focus()
    {
        // A dialog was active until a moment ago, perhaps.
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window, patience))
            qWarning("the window does not become active");
        return QApplication::focusWidget() ? QApplication::focusWidget() : &window;
    }

    QSettings settings;
    AuthorWindow window;
};

/// Types a program into an editor in place of what is there.
inline void retype(CodeEditor &editor, const QString &program)
{
    QVERIFY(editor.isVisible());
    auto *area = editor.findChild<QsciScintilla *>();
    editor.selectAll();
    QTest::keyClick(area, Qt::Key_Delete);
    area->insert(program);
    QCoreApplication::processEvents(); // the editor tells of an edit when it is through with it
}

/// Begins a lab of that title by the menu.
inline void beginLab(OpenAuthor &author, const QString &title)
{
    OpenAuthor::answerDialog(title);
    author.choose(QStringLiteral("New lab…"));
    QCOMPARE(author.document().steps().size(), 1);
}

/// Opens a copy of the bouncing ball, which may be edited, in a folder "ball" of \p folder.
inline void openBall(OpenAuthor &author, const QTemporaryDir &folder)
{
    QVERIFY(!author.window.files().open(sourcePath("tasks/labs/bouncing-ball")));
    QVERIFY(!author.document().saveAs(folder.filePath(QStringLiteral("ball"))));
    QCOMPARE(author.document().steps().size(), 3);
}

} // namespace cradle::windows
