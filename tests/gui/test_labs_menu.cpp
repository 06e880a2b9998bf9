// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "tests/gui/open_window.h"

#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QStandardPaths>

using namespace cradle;
using namespace cradle::windows;

namespace {

/// The submenu Lab → Labs as it stands when it is opened.
QMenu *labsMenu(MainWindow &window, const QString &title = QStringLiteral("&Labs"))
{
    for (QMenu *menu : window.menuBar()->findChildren<QMenu *>()) {
        if (menu->title() != title)
            continue;
        emit menu->aboutToShow();
        return menu;
    }
    return nullptr;
}

QAction *entryOf(MainWindow &window, const QString &text)
{
    QMenu *menu = labsMenu(window);
    for (QAction *action : menu ? menu->actions() : QList<QAction *>()) {
        if (action->text() == text)
            return action;
    }
    return nullptr;
}

const QString ball = QStringLiteral("Bouncing ball");

} // namespace

class TestLabsMenu final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init();
    void cleanup();
    void shippedLabsAreInTheMenu();
    void secondLabOpens();
    void secondLabIsPassedInTheWindow();
    void progressOfBothLabsIsKept();
    void entriesFollowTheLanguage();
    void labsOfTheUserAreThereAtOnce();
    void brokenLabSaysSo();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_userLabs;
};

void TestLabsMenu::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_userLabs =
        QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/labs");
    QDir(m_userLabs).removeRecursively();
}

void TestLabsMenu::cleanup()
{
    QDir(m_userLabs).removeRecursively();
    setLanguage(QStringLiteral("en"));
}

void TestLabsMenu::shippedLabsAreInTheMenu()
{
    OpenWindow open(*m_folder);
    QMenu *menu = labsMenu(open.window);
    QVERIFY(menu);
    QCOMPARE(menu->actions().size(), 2);
    QCOMPARE(menu->actions()[0]->text(), open.bench.lab().title);
    QVERIFY(menu->actions()[0]->isChecked());
    QCOMPARE(menu->actions()[1]->text(), ball);
    QVERIFY(!menu->actions()[1]->isChecked());
}

void TestLabsMenu::secondLabOpens()
{
    OpenWindow open(*m_folder);
    entryOf(open.window, ball)->trigger();
    QCOMPARE(open.bench.lab().id, QStringLiteral("bouncing-ball"));
    QCOMPARE(open.steps()->count(), 3);
    QVERIFY(entryOf(open.window, ball)->isChecked());
    entryOf(open.window, ball)->trigger();
    QCOMPARE(open.bench.lab().id, QStringLiteral("bouncing-ball"));
    labsMenu(open.window)->actions().front()->trigger();
    QCOMPARE(open.steps()->count(), 17);
}

void TestLabsMenu::secondLabIsPassedInTheWindow()
{
    OpenWindow open(*m_folder);
    entryOf(open.window, ball)->trigger();
    for (int step = 0; step < 3; ++step) {
        open.bench.openTaskAt(step);
        QVERIFY(open.bench.document().edit(QStringLiteral("solution"), open.solution()));
        open.check();
        QVERIFY(open.bench.check().report()->passed);
        QVERIFY(open.isTicked(step));
    }
}

void TestLabsMenu::progressOfBothLabsIsKept()
{
    OpenWindow open(*m_folder);
    entryOf(open.window, ball)->trigger();
    open.bench.openTaskAt(1);
    QVERIFY(open.bench.document().edit(QStringLiteral("solution"), open.solution()));
    open.check();
    labsMenu(open.window)->actions().front()->trigger();
    QVERIFY(!open.isTicked(1));
    entryOf(open.window, ball)->trigger();
    QVERIFY(open.isTicked(1));
    QCOMPARE(open.bench.current(), 1);
    QCOMPARE(open.preset(), open.solution());
}

void TestLabsMenu::entriesFollowTheLanguage()
{
    OpenWindow open(*m_folder);
    entryOf(open.window, ball)->trigger();
    open.window.choices().chooseLanguage(QStringLiteral("de"));
    QCOMPARE(open.bench.lab().title, QStringLiteral("Springender Ball"));
    QCOMPARE(open.bench.task()->title, QStringLiteral("Lass ihn fallen"));
}

void TestLabsMenu::labsOfTheUserAreThereAtOnce()
{
    OpenWindow open(*m_folder);
    QCOMPARE(labsMenu(open.window)->actions().size(), 2);
    const QString folder = m_userLabs + QStringLiteral("/mine");
    QVERIFY(QDir().mkpath(folder + QStringLiteral("/drop")));
    const QDir from(QStringLiteral(":/labs/bouncing-ball/BALL1"));
    for (const QString &name : from.entryList(QDir::Files))
        QVERIFY(QFile::copy(from.filePath(name), folder + QStringLiteral("/drop/") + name));
    QFile lab(folder + QStringLiteral("/lab.json"));
    QVERIFY(lab.open(QIODevice::WriteOnly));
    QVERIFY(lab.write(R"({"format": 1, "id": "mine", "title": "Drop & more", "version": "1.0",
                          "language": "en", "steps": ["drop"]})")
            > 0);
    lab.close();
    QAction *entry = entryOf(open.window, QStringLiteral("Drop && more · 1.0"));
    QVERIFY(entry);
    entry->trigger();
    QCOMPARE(open.bench.lab().id, QStringLiteral("mine"));
    QCOMPARE(open.steps()->count(), 1);
}

/// A lab that went away after the menu was opened.
void TestLabsMenu::brokenLabSaysSo()
{
    OpenWindow open(*m_folder);
    open.window.opening().openLab(m_userLabs + QStringLiteral("/gone"));
    QVERIFY(open.window.notice().isVisible());
    QCOMPARE(open.steps()->count(), 17);
}

QTEST_MAIN(TestLabsMenu)
#include "test_labs_menu.moc"
