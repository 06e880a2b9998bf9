// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_author.h"
#include "tests/gui/open_window.h"
#include "views/menu.h"

#include <QKeySequence>
#include <QMenuBar>
#include <QSet>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// The letters that two of \p actions share, with the texts that do.
QStringList sharedLetters(const QString &name, const QList<QAction *> &actions)
{
    QHash<QKeySequence, QString> met;
    QStringList shared;
    for (const QAction *action : actions) {
        const QString text = action->text().section(QLatin1Char('\t'), 0, 0);
        const QKeySequence letter = QKeySequence::mnemonic(text);
        if (letter.isEmpty() || !action->isVisible())
            continue;
        if (met.contains(letter))
            shared.append(QStringLiteral("%1: %2 | %3").arg(name, met.value(letter), text));
        met.insert(letter, text);
    }
    return shared;
}

/// Opens every menu of \p window in thought: some are filled when they are.
void fillMenus(const QWidget &window)
{
    QSet<const QMenu *> filled;
    for (bool isNew = true; isNew;) {
        isNew = false;
        for (QMenu *menu : window.findChildren<QMenu *>()) {
            if (filled.contains(menu))
                continue;
            filled.insert(menu);
            isNew = true;
            emit menu->aboutToShow();
            emit menu->aboutToHide();
            break; // others may be gone
        }
    }
}

} // namespace

/// The menus of both windows, also those of buttons.
class TestMenus final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void cleanup() { setLanguage(QStringLiteral("en")); }
    void lettersAreUnderlinedOnce_data() { addLanguages(); }
    void lettersAreUnderlinedOnce();
    void lettersOfAuthorsAreUnderlinedOnce_data() { addLanguages(); }
    void lettersOfAuthorsAreUnderlinedOnce();

private:
    static void addLanguages()
    {
        QTest::addColumn<QString>("language");
        for (const QString &language : languages())
            QTest::newRow(qPrintable(language)) << language;
    }
    static void compareLetters(const QMainWindow &window);

    QTemporaryDir m_folder;
};

void TestMenus::compareLetters(const QMainWindow &window)
{
    fillMenus(window);
    const QList<QAction *> titles = window.menuBar()->actions();
    QVERIFY(titles.size() >= 5);
    QStringList found = sharedLetters(QStringLiteral("bar"), titles);
    const auto menus = window.findChildren<QMenu *>();
    QVERIFY2(menus.size() >= 10, qPrintable(QString::number(menus.size())));
    for (const QMenu *menu : menus) {
        found += sharedLetters(menu->title(), menu->actions());
        // A bar that is too narrow has one of its own for what does not fit.
        const bool isOfBar = menu->parent() == window.menuBar() && menu->title().isEmpty();
        QVERIFY2(isOfBar || qobject_cast<const Menu *>(menu), qPrintable(menu->title()));
    }
    QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    for (const QAction *title : titles)
        QVERIFY2(!QKeySequence::mnemonic(title->text()).isEmpty(), qPrintable(title->text()));
}

void TestMenus::lettersAreUnderlinedOnce()
{
    QFETCH(QString, language);
    setLanguage(language);
    OpenWindow open(m_folder);
    open.window.scene().setFocus();
    for (const Mode mode : {Mode::Explore, Mode::Code}) {
        open.bench.setMode(mode);
        calm(open.window);
        compareLetters(open.window);
    }
    open.window.stepDesk().focusCode(); // the menu Edit names other things
    calm(open.window);
    compareLetters(open.window);
}

void TestMenus::lettersOfAuthorsAreUnderlinedOnce()
{
    QFETCH(QString, language);
    setLanguage(language);
    OpenAuthor author(m_folder);
    QVERIFY(!author.window.files().open(sourcePath("tasks/labs/bouncing-ball")));
    compareLetters(author.window);
}

QTEST_MAIN(TestMenus)

#include "test_menus.moc"
