// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_desk.h"
#include "app/grade_dialog.h"
#include "app/hand_in_dialog.h"
#include "app/main_window.h"
#include "app/new_folder_dialog.h"
#include "app/report_dialog.h"
#include "app/tour.h"
#include "tests/gui/legible.h"
#include "tests/gui/named_controls.h"
#include "tests/gui/room_states.h"
#include "tests/gui/tab_round.h"
#include "tests/patience.h"
#include "views/code/api_page.h"

#include <QFrame>
#include <QRegularExpression>

#include <functional>

using namespace cradle;
using namespace cradle::windows;

/// The dialogs, sheets and callouts of the window: whole, legible, named and passed by Tab.
class TestDialogs final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        m_room = std::make_unique<StatefulRoom>(m_folder);
        QVERIFY(QTest::qWaitForWindowActive(&m_room->window(), patience));
    }
    void cleanupTestCase() { m_room.reset(); }
    void init() { m_found.clear(); }
    void everyDialogCanBeUsed_data() { addStates(fewStates()); }
    void everyDialogCanBeUsed();

private:
    using Act = std::function<void()>;
    /// Opens a dialog, readies it, looks at it, and closes it.
    void lookAt(
        const char *name, const Act &open,
        const std::function<void(QWidget &)> &ready = [](QWidget &) {});
    void lookInto(const QString &name, QWidget &dialog);
    void lookAtSheets();
    void lookAtTour();
    void note(const QString &name, const QStringList &faults)
    {
        for (const QString &fault : faults)
            m_found << name + QStringLiteral(": ") + fault;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<StatefulRoom> m_room;
    QStringList m_found;
};

void TestDialogs::lookInto(const QString &name, QWidget &dialog)
{
    calm(dialog);
    QStringList faults = illegibleTexts(dialog, 2);
    int met = 0;
    findNameless(QAccessible::queryAccessibleInterface(&dialog), faults, met);
    if (qobject_cast<QFileDialog *>(&dialog)) { // its lists are Qt's, of what is on the disk
        static const QRegularExpression lists(QStringLiteral("QTreeView|QSidebar|QComboBox|^role"));
        erase_if(faults, [](const QString &fault) { return fault.contains(lists); });
    }
    note(name, faults);
    note(name, missedByTab(dialog));
    if (dialog.width() > m_room->window().width() || dialog.height() > m_room->window().height())
        note(name, {QStringLiteral("is %1x%2").arg(dialog.width()).arg(dialog.height())});
    if (const QString folder = qEnvironmentVariable("CRADLE_TEST_PICTURES"); !folder.isEmpty())
        dialog.grab().save(QStringLiteral("%1/%2 %3.png")
                               .arg(folder, name, QString::fromUtf8(QTest::currentDataTag())));
}

void TestDialogs::lookAt(const char *name, const Act &open,
                         const std::function<void(QWidget &)> &ready)
{
    bool isSeen = false;
    QTimer timer; // a dialog may have an event loop of its own
    connect(&timer, &QTimer::timeout, this, [&] {
        QWidget *dialog = QApplication::activeModalWidget();
        if (!dialog || !dialog->isVisible())
            return;
        timer.stop();
        ready(*dialog);
        lookInto(QLatin1String(name), *dialog);
        dialog->close();
        isSeen = true;
    });
    timer.start(20);
    open();
    QTRY_VERIFY2(isSeen, name);
    QTRY_VERIFY(!QApplication::activeModalWidget());
}

void TestDialogs::lookAtSheets()
{
    MainWindow &window = m_room->window();
    window.help().showCSharpSheet();
    for (auto *sheet : window.findChildren<MarkdownView *>()) {
        if (!sheet->isWindow())
            continue;
        lookInto(QStringLiteral("sheet"), *sheet);
        sheet->close();
    }
    window.codeDesk().showReference({});
    auto *page = window.findChild<ApiPage *>();
    QVERIFY(page && page->isWindow());
    lookInto(QStringLiteral("reference"), *page);
    page->close();
}

/// It says its text beside a part of the window that it darkens: the card alone is looked at.
void TestDialogs::lookAtTour()
{
    MainWindow &window = m_room->window();
    window.activateWindow();
    window.help().showTour();
    const QPointer<Tour> tour = window.findChild<Tour *>();
    QVERIFY(tour);
    auto *card = tour->findChild<QFrame *>(QString(), Qt::FindDirectChildrenOnly);
    for (int stop = 1; tour && tour->isVisible(); ++stop) {
        settle();
        const QString name = QStringLiteral("tour %1").arg(stop);
        note(name, illegibleTexts(*card, 3));
        if (!window.rect().contains(card->geometry()))
            note(name, {QStringLiteral("is not within the window")});
        QVERIFY(stop <= 6);
        tour->next();
    }
    QTRY_VERIFY(!tour);
}

void TestDialogs::everyDialogCanBeUsed()
{
    QFETCH(RoomState, state);
    m_room->take(state);
    MainWindow &window = m_room->window();
    lookAt(
        "grading", [&] { window.dialogs().openGrading(); },
        [](QWidget &dialog) {
            auto &grading = static_cast<GradeDialog &>(dialog);
            grading.setFolders(QStringLiteral("class"), QStringLiteral("results"));
            emit grading.run().remarked(QStringLiteral("ada: 1 / 2"));
        });
    lookAt(
        "handing in", [&] { window.dialogs().openHandIn(); },
        [](QWidget &dialog) {
            auto &handIn = static_cast<HandInDialog &>(dialog);
            QTRY_VERIFY(handIn.isReady());
        });
    lookAt(
        "report", [&] { window.dialogs().openReport(); },
        [](QWidget &dialog) {
            auto &report = static_cast<ReportDialog &>(dialog);
            QTRY_VERIFY(report.isReady());
        });
    lookAt("sharing", [&] { window.dialogs().shareWork(); });
    lookAt("new folder", [&] {
        NewFolderDialog dialog(&window, QStringLiteral("…"));
        dialog.exec();
    });
    lookAt("keys", [&] { window.help().showShortcuts(); });
    lookAt("about", [&] { window.help().showAbout(); });
    lookAtSheets();
    lookAtTour();
    m_found.removeDuplicates();
    for (const QString &each : m_found)
        qWarning("%s", qPrintable(each));
    QVERIFY2(m_found.isEmpty(), qPrintable(m_found.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestDialogs)

#include "test_dialogs.moc"
