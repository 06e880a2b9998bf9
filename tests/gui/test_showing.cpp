// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"
#include "app/presentation.h"
#include "app/tour.h"
#include "tests/gui/open_window.h"
#include "tests/patience.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"

#include <QClipboard>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>

#include <map>

using namespace cradle;
using namespace cradle::windows;

/// The window as it is shown to many, its tour, and the Edit menu that follows the focus.
class TestShowing final : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        applyTheme(ThemeChoice::Light);
        QVERIFY(m_folder.isValid());
    }
    void init();
    void cleanup();
    void sceneAloneAndBack();
    void presentationAndBack();
    void secondWindowShowsTheSameRun();
    void secondWindowShowsWhatTheFirstDoes();
    void secondWindowHasTheKeysOfARun();
    void secondWindowIsBlackWithTheFirst();
    void tourGoesThroughSixParts();
    void tourIsEndedByEscape();
    void tourCardHoldsALongText();
    void editMenuFollowsTheFocus();

private:
    [[nodiscard]] int panesSeen() const
    {
        const auto &panes = m_open->window.panes().docks;
        return static_cast<int>(std::count_if(panes.begin(), panes.end(),
                                              [](const QDockWidget *p) { return !p->isHidden(); }));
    }
    [[nodiscard]] QAction *entry(const QString &begin) const
    {
        for (QMenu *menu : m_open->window.menuBar()->findChildren<QMenu *>(
                 QString(), Qt::FindDirectChildrenOnly)) {
            emit menu->aboutToShow(); // it is filled as it opens
            for (QAction *action : menu->actions()) {
                if (action->text().remove(QLatin1Char('&')).startsWith(begin))
                    return action;
            }
        }
        return nullptr;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<OpenWindow> m_open;
};

void TestShowing::init()
{
    m_open = std::make_unique<OpenWindow>(m_folder);
    m_open->bench.openTask(QStringLiteral("L42T11"));
    m_open->bench.setMode(Mode::Code);
    m_open->window.resize(1440, 900);
}

void TestShowing::cleanup()
{
    m_open.reset();
    setTextScale(1.0);
}

void TestShowing::sceneAloneAndBack()
{
    const int before = panesSeen();
    QVERIFY(before >= 5);
    QTest::keyClick(&m_open->window.scene(), Qt::Key_F11, Qt::ControlModifier);
    QVERIFY(m_open->window.room().isSceneAlone());
    QCOMPARE(panesSeen(), 0);
    QTRY_VERIFY(m_open->window.scene().width() > 1400);
    QTest::keyClick(&m_open->window.scene(), Qt::Key_F11, Qt::ControlModifier);
    QVERIFY(!m_open->window.room().isSceneAlone());
    QCOMPARE(panesSeen(), before);
    QVERIFY(!m_open->settings.contains(QStringLiteral("layout/code")));
}

void TestShowing::presentationAndBack()
{
    const QFont before = QApplication::font();
    std::map<const QLabel *, QFont> headings;
    for (const auto *label : m_open->window.findChildren<QLabel *>()) {
        if (label->property("kind") == QStringLiteral("heading"))
            headings[label] = label->font();
    }
    QVERIFY(headings.size() > 3);
    const auto *icon = m_open->window.transportBar().findChild<QPushButton *>();
    const QSize iconSize = icon->iconSize();
    m_open->window.presenter().present(true);
    QVERIFY(icon->iconSize().width() > iconSize.width());
    QVERIFY(m_open->window.isFullScreen());
    QVERIFY(m_open->window.room().isSceneAlone());
    QCOMPARE(QApplication::font().pointSizeF(), 1.5 * before.pointSizeF());
    QCOMPARE(&theme(), &Theme::highContrastTheme());
    for (const auto *label : m_open->window.transportBar().findChildren<QLabel *>())
        QTRY_COMPARE(label->font().pointSizeF(), QApplication::font().pointSizeF());
    PresentationLayer *layer = m_open->window.presenter().layer();
    QVERIFY(layer);
    QTest::keyClick(&m_open->window.scene(), Qt::Key_B);
    QVERIFY(layer->isBlack());
    QTest::keyClick(&m_open->window.scene(), Qt::Key_B);
    QVERIFY(!layer->isBlack());
    QTest::mouseMove(&m_open->window.scene(), {100, 100});
    QTest::mouseMove(&m_open->window.scene(), {160, 120});
    QTRY_VERIFY(layer->trailLength() > 0);
    QTRY_COMPARE(layer->trailLength(), std::size_t(0)); // it fades
    QTest::keyClick(&m_open->window.scene(), Qt::Key_Escape);
    QVERIFY(!m_open->window.presenter().layer());
    QVERIFY(!m_open->window.isFullScreen());
    QVERIFY(!m_open->window.room().isSceneAlone());
    QCOMPARE(QApplication::font().pointSizeF(), before.pointSizeF());
    QCOMPARE(&theme(), &Theme::lightTheme());
    QCOMPARE(icon->iconSize(), iconSize);
    for (const auto &[label, font] : headings)
        QVERIFY2(label->font() == font, qPrintable(label->text()));
    QVERIFY(!m_open->settings.contains(QStringLiteral("textSize")));
}

void TestShowing::secondWindowShowsTheSameRun()
{
    m_open->window.presenter().openSceneWindow();
    SceneView *second = m_open->window.presenter().secondScene();
    QVERIFY(second && second->isVisible() && second->isWindow());
    QVERIFY(!second->windowTitle().isEmpty());
    m_open->window.presenter().openSceneWindow();
    QCOMPARE(m_open->window.presenter().secondScene(), second);
    second->close();
    QTRY_VERIFY(!m_open->window.presenter().secondScene());
}

void TestShowing::secondWindowShowsWhatTheFirstDoes()
{
    m_open->window.presenter().openSceneWindow();
    SceneView *second = m_open->window.presenter().secondScene();
    SceneOptions options = m_open->window.scene().options();
    QVERIFY(second->options() == options);
    options.trails = !options.trails;
    m_open->window.choices().showInScene(options);
    QVERIFY(second->options() == options);
    m_open->window.choices().followCentreOfMass(true);
    QVERIFY(second->followsCentreOfMass());
    m_open->window.choices().chooseRenderer(Renderer::Raster);
    QCOMPARE(second->renderer(), Renderer::Raster);
}

void TestShowing::secondWindowHasTheKeysOfARun()
{
    m_open->window.presenter().openSceneWindow();
    SceneView *second = m_open->window.presenter().secondScene();
    second->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(second, patience));
    Simulation &simulation = m_open->simulation();
    const auto step = simulation.current();
    QTest::keyClick(second, Qt::Key_Right);
    QCOMPARE(simulation.current(), step + 1);
    QTest::keyClick(second, Qt::Key_Space);
    QVERIFY(simulation.isRunning());
    QTest::keyClick(second, Qt::Key_Space);
    QVERIFY(!simulation.isRunning());
    const Camera whole = second->camera();
    QTest::keyClick(second, Qt::Key_Plus, Qt::ControlModifier);
    QVERIFY(second->camera() != whole);
    QTest::keyClick(second, Qt::Key_0, Qt::ControlModifier);
    QVERIFY(second->camera() == whole);
    QTest::keyClick(second, Qt::Key_F11);
    QVERIFY(second->isFullScreen());
    QTest::keyClick(second, Qt::Key_F11);
    QVERIFY(!second->isFullScreen());
}

void TestShowing::secondWindowIsBlackWithTheFirst()
{
    m_open->window.presenter().openSceneWindow();
    m_open->window.presenter().present(true);
    SceneView *second = m_open->window.presenter().secondScene();
    second->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(second, patience));
    const auto middle = [second] {
        return second->grab().toImage().pixelColor(second->rect().center());
    };
    QVERIFY(middle() != QColor(Qt::black));
    QTest::keyClick(second, Qt::Key_B);
    QCOMPARE(middle(), QColor(Qt::black));
    QVERIFY(m_open->window.presenter().layer()->isBlack());
    QTest::keyClick(second, Qt::Key_B);
    QVERIFY(middle() != QColor(Qt::black));
    QTest::keyClick(second, Qt::Key_Escape);
    QVERIFY(!m_open->window.presenter().layer());
    QVERIFY(!second->findChild<PresentationLayer *>());
}

void TestShowing::tourGoesThroughSixParts()
{
    m_open->window.help().showTour();
    auto *tour = m_open->window.findChild<Tour *>();
    QVERIFY(tour);
    std::vector<QRect> parts;
    for (std::size_t i = 0; i < 6; ++i) {
        QCOMPARE(tour->at(), i);
        QVERIFY(m_open->window.rect().contains(tour->partRect()));
        QVERIFY(m_open->says(QStringLiteral("%1 of 6 · ").arg(i + 1)));
        const auto *card = tour->findChild<QFrame *>();
        QVERIFY(tour->rect().contains(card->geometry()));
        QVERIFY(std::find(parts.begin(), parts.end(), tour->partRect()) == parts.end());
        parts.push_back(tour->partRect());
        // The keyboard stays in the tour.
        QVERIFY(tour->isAncestorOf(QApplication::focusWidget()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(tour->isAncestorOf(QApplication::focusWidget()));
        tour->next();
    }
    QTRY_VERIFY(!m_open->window.findChild<Tour *>());
}

void TestShowing::tourIsEndedByEscape()
{
    m_open->window.help().showTour();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QTRY_VERIFY(!m_open->window.findChild<Tour *>());
}

void TestShowing::tourCardHoldsALongText()
{
    QWidget window;
    window.resize(1000, 600);
    auto *part = new QWidget(&window);
    part->setGeometry(0, 0, 100, 100);
    window.show();
    const QString text = QStringLiteral("Languages differ in length. ").repeated(12);
    const auto *tour = new Tour(&window, {{part, QStringLiteral("A part"), text}});
    QLabel *told = nullptr;
    for (QLabel *label : tour->findChildren<QLabel *>()) {
        if (label->text() == text)
            told = label;
    }
    QVERIFY(told);
    QTRY_VERIFY(told->height() >= told->heightForWidth(told->width()));
    QVERIFY(tour->rect().contains(told->parentWidget()->geometry()));
}

void TestShowing::editMenuFollowsTheFocus()
{
    m_open->bench.setMode(Mode::Code);
    CodeEditor &editor = m_open->window.codePane().editor();
    m_open->window.scene().setFocus();
    m_open->window.scene().select(0);
    QVERIFY(entry(QStringLiteral("Copy circles")));
    QVERIFY(entry(QStringLiteral("Cut circles"))->isEnabled());
    editor.setFocus();
    QVERIFY(!entry(QStringLiteral("Copy circles")));
    editor.selectAll();
    QGuiApplication::clipboard()->clear();
    entry(QStringLiteral("Copy"))->trigger();
    QVERIFY(QGuiApplication::clipboard()->text().contains(QStringLiteral("on_update")));
}

QTEST_MAIN(TestShowing)

#include "test_showing.moc"
