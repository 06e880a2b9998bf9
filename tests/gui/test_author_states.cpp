// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"
#include "tests/gui/legible.h"
#include "tests/gui/named_controls.h"
#include "tests/gui/open_author.h"
#include "tests/gui/room_states.h"
#include "tests/gui/tab_round.h"
#include "tests/patience.h"
#include "views/author/arrangement_dialog.h"
#include "views/author/lab_dialog.h"
#include "views/theme.h"

#include <algorithm>

using namespace cradle;
using namespace cradle::windows;

/// The author's window with each of its tabs and its dialogs: whole, legible, named and passed by
/// Tab.
class TestAuthorStates final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase();
    void init() { m_found.clear(); }
    void everyTabCanBeUsed_data() { addStates(fewStates()); }
    void everyTabCanBeUsed();
    void everyDialogCanBeUsed_data() { addStates(fewStates()); }
    void everyDialogCanBeUsed();

private:
    void take(const RoomState &state);
    void lookInto(const QString &name, QWidget &window);
    void compareFound()
    {
        m_found.removeDuplicates();
        for (const QString &each : m_found)
            qWarning("%s", qPrintable(each));
        QVERIFY2(m_found.isEmpty(), qPrintable(m_found.join(QLatin1Char('\n'))));
    }

    QTemporaryDir m_folder;
    SpokenLanguage m_language;
    std::unique_ptr<OpenAuthor> m_author;
    QStringList m_found;
};

/// A step that is verified, so that there are findings.
void TestAuthorStates::initTestCase()
{
    applyTheme(ThemeChoice::Light);
    m_author = std::make_unique<OpenAuthor>(m_folder);
    openBall(*m_author, m_folder);
    m_author->window.panes().showTab(AuthorWindow::Proof);
    m_author->window.proofTab().verifyStep();
    QTRY_VERIFY(!m_author->window.proofTab().isRunning());
    QVERIFY(m_author->window.proofTab().result());
}

void TestAuthorStates::cleanupTestCase()
{
    m_author.reset();
    setTextScale(1.0);
    applyTheme(ThemeChoice::Light);
}

void TestAuthorStates::take(const RoomState &state)
{
    m_language.speak(state.language, setLanguage);
    setTextScale(state.percent / 100.0);
    applyTheme(state.theme);
    calm(m_author->window); // it may have had to be larger
    m_author->window.resize(state.size + QSize(40, 0));
    calm(m_author->window);
    m_author->window.resize(state.size);
    calm(m_author->window);
    QCOMPARE(m_author->window.size(), state.size);
}

void TestAuthorStates::lookInto(const QString &name, QWidget &window)
{
    calm(window);
    QStringList faults = illegibleTexts(window, 3);
    int met = 0;
    findNameless(QAccessible::queryAccessibleInterface(&window), faults, met);
    faults += missedByTab(window);
    for (const QString &fault : faults)
        m_found << name + QStringLiteral(": ") + fault;
    if (const QString folder = qEnvironmentVariable("CRADLE_TEST_PICTURES"); !folder.isEmpty())
        window.grab().save(QStringLiteral("%1/%2 %3.png")
                               .arg(folder, name, QString::fromUtf8(QTest::currentDataTag())));
}

void TestAuthorStates::everyTabCanBeUsed()
{
    QFETCH(RoomState, state);
    take(state);
    const char *const names[] = {"scene", "text", "checks", "programs", "proof"};
    for (int tab = 0; tab < m_author->window.tabs().count(); ++tab) {
        m_author->window.panes().showTab(tab);
        lookInto(QLatin1String(names[tab]), m_author->window);
    }
    // Once the window has turned, the inspector may be wider than its room, and Qt scrolls sideways
    // to what has the focus only where one reads from the left.
    if (QGuiApplication::isRightToLeft())
        m_found.erase(std::remove_if(m_found.begin(), m_found.end(),
                                     [](const QString &fault) {
                                         return fault.contains(QLatin1String("CirclesGroup"));
                                     }),
                      m_found.end());
    compareFound();
}

void TestAuthorStates::everyDialogCanBeUsed()
{
    QFETCH(RoomState, state);
    take(state);
    LabDialog lab(m_author->document(), LabDialog::Purpose::Edit, &m_author->window);
    lab.show();
    lookInto(QStringLiteral("properties"), lab);
    lab.close();
    ArrangementDialog grid(Arrangement::Pattern::Grid, &m_author->window);
    grid.show();
    lookInto(QStringLiteral("grid"), grid);
    grid.close();
    compareFound();
}

QTEST_MAIN(TestAuthorStates)

#include "test_author_states.moc"
