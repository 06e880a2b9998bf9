// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_window.h"
#include "tests/gui/calm.h"
#include "tests/gui/open_author.h"
#include "tests/gui/open_window.h"
#include "tests/gui/tab_round.h"
#include "tests/patience.h"
#include "views/theme.h"

#include <QImage>

using namespace cradle;
using namespace cradle::windows;

/// Who goes through a window by Tab sees where they are: every control looks different then.
class TestFocusIsSeen final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(ThemeChoice::Light); }
    void inTheWindow_data();
    void inTheWindow();
    void inTheAuthorsWindow();

private:
    static void addUnseen(QWidget &window, const QString &where, QStringList &unseen);
};

/// What of \p window the focus of each control does not change.
void TestFocusIsSeen::addUnseen(QWidget &window, const QString &where, QStringList &unseen)
{
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window, patience));
    calm(window);
    const std::vector<QWidget *> stops = controlsIn(window);
    QVERIFY(stops.size() > 5);
    for (QWidget *stop : stops) {
        stop->setFocus(Qt::TabFocusReason);
        settle();
        if (QApplication::focusWidget() != stop || !isInSight(*stop))
            continue;
        const QImage with = window.grab().toImage();
        stop->clearFocus();
        settle();
        if (window.grab().toImage() == with)
            unseen << where + describe(*stop);
    }
}

void TestFocusIsSeen::inTheWindow_data()
{
    QTest::addColumn<Mode>("mode");
    QTest::newRow("explore") << Mode::Explore;
    QTest::newRow("code") << Mode::Code;
}

void TestFocusIsSeen::inTheWindow()
{
    QFETCH(Mode, mode);
    const QTemporaryDir folder;
    OpenWindow open(folder);
    open.bench.openTask(QStringLiteral("L42T11"));
    open.bench.setMode(mode);
    open.window.choices().chooseRenderer(Renderer::Raster);
    open.window.resize(1440, 900);
    open.bench.check().start();
    QTRY_VERIFY(open.bench.check().report());
    QStringList unseen;
    addUnseen(open.window, {}, unseen);
    QVERIFY2(unseen.isEmpty(), qPrintable(unseen.join(QLatin1Char('\n'))));
}

void TestFocusIsSeen::inTheAuthorsWindow()
{
    QTemporaryDir folder;
    OpenAuthor author(folder);
    openBall(author, folder);
    author.window.resize(1440, 900);
    QStringList unseen;
    for (int tab = 0; tab < author.window.tabs().count(); ++tab) {
        author.window.panes().showTab(tab);
        addUnseen(author.window, QStringLiteral("tab %1: ").arg(tab), unseen);
    }
    QVERIFY2(unseen.isEmpty(), qPrintable(unseen.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestFocusIsSeen)

#include "test_focus_is_seen.moc"
