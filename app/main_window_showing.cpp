// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the window is shown to many: the scene alone, a presentation, the scene on another screen.
#include "app/main_window.h"

#include "app/presentation.h"
#include "app/tour.h"
#include "views/code/code_pane.h"
#include "views/inspector/inspector.h"
#include "views/markdown_view.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"

#include <QDockWidget>
#include <QFile>
#include <QGuiApplication>
#include <QScopedValueRollback>
#include <QScreen>
#include <QShortcut>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

constexpr double presentedText = 1.5; ///< of the usual size, at least

} // namespace

void MainWindow::showFullScreen(bool full)
{
    setWindowState(windowState().setFlag(Qt::WindowFullScreen, full));
}

/// The panes come back as they were; meanwhile nothing of this is kept as an arrangement.
void MainWindow::showSceneAlone(bool alone)
{
    if (alone == m_beforeAlone.has_value())
        return;
    const QScopedValueRollback arranging(m_arranging, true);
    if (alone) {
        keepArrangement();
        std::vector<QDockWidget *> seen;
        for (QDockWidget *pane : m_docks) {
            if (pane->isHidden())
                continue;
            seen.push_back(pane);
            pane->hide();
        }
        m_beforeAlone = std::move(seen);
        m_scene->setFocus();
    } else {
        const std::vector<QDockWidget *> seen = *m_beforeAlone;
        m_beforeAlone.reset();
        for (QDockWidget *pane : seen)
            pane->show();
        for (const char *front : {"values", "momentum"})
            dock(front)->raise();
        dock(m_workbench.mode() == Mode::Code ? "code" : "inspector")->raise();
        if (!m_keepsSizes)
            arrangePanes();
    }
    emit showingChanged();
}

/// What is chosen for it is not kept for later.
void MainWindow::present(bool presents)
{
    if (presents == (m_layer != nullptr))
        return;
    if (presents) {
        m_beforePresenting = {m_theme, textScale(), isFullScreen()};
        applyTheme(ThemeChoice::HighContrast);
        setTextScale(std::max(presentedText, textScale()));
        showSceneAlone(true);
        showFullScreen(true);
        m_layer = new PresentationLayer(this);
        const auto key = [this](int code, auto slot) {
            auto *shortcut = new QShortcut(QKeySequence(code), m_layer);
            connect(shortcut, &QShortcut::activated, this, slot);
        };
        key(Qt::Key_PageDown, [this] { m_workbench.simulation().seekNextHit(); });
        key(Qt::Key_PageUp, [this] { m_workbench.simulation().seekPreviousHit(); });
        key(Qt::Key_B, [this] { m_layer->setBlack(!m_layer->isBlack()); });
        key(Qt::Key_Escape, [this] { present(false); });
    } else {
        delete std::exchange(m_layer, nullptr);
        applyTheme(m_beforePresenting.theme);
        setTextScale(m_beforePresenting.textScale);
        showSceneAlone(false);
        showFullScreen(m_beforePresenting.fullScreen);
    }
    emit showingChanged();
}

void MainWindow::showTour()
{
    showSceneAlone(false);
    const bool code = m_workbench.mode() == Mode::Code;
    dock("momentum")->raise();
    dock(code ? "code" : "inspector")->raise();
    new Tour(
        this,
        {{m_taskPane, tr("The step"),
          tr("Here stands what to do and why. The dots are the steps of the lab; hints wait below "
             "the text.")},
         {code ? static_cast<QWidget *>(m_code) : m_inspector,
          code ? tr("Your program") : tr("The scene in numbers"),
          code ? tr("You keep one program through all steps. It is saved and runs as you type; "
                    "F1 explains the word under the cursor.")
               : tr("World, laws and circles: what you change here or by dragging in the scene "
                    "starts the run anew.")},
         {m_scene, tr("The scene"),
          tr("What your circles do. At a hit, arrows show the parts of the velocities along and "
             "across the normal.")},
         {dock("momentum"), tr("Charts"),
          tr("Momentum and energy of the same run. Click where you want the numbers of that "
             "moment; every hit is marked.")},
         {m_timeline, tr("Any moment again"),
          tr("Drag to any moment of the run, or press Next hit. Space runs and pauses.")},
         {m_transport, tr("Run and check"),
          tr("Run to watch; Check when you are done: it says what is right, what is not, and "
             "why.")}});
}

void MainWindow::showCSharpSheet()
{
    if (!m_sheet) {
        m_sheet = new MarkdownView(this);
        m_sheet->setWindowFlag(Qt::Window);
        m_sheet->setAttribute(Qt::WA_DeleteOnClose);
        m_sheet->resize(QSize(scaledByText(760), scaledByText(640)).boundedTo(size()));
    }
    //: The file of the page in your language: docs/lua-for-csharp.LANGUAGE.md, if there is one
    QFile page(tr(":/help/lua-for-csharp.md"));
    if (page.open(QIODevice::ReadOnly))
        m_sheet->setMarkdown(QString::fromUtf8(page.readAll()), {});
    m_sheet->setWindowTitle(tr("Lua for C# people"));
    m_sheet->setAccessibleName(m_sheet->windowTitle());
    m_sheet->moveCursor(QTextCursor::Start);
    m_sheet->show();
    m_sheet->raise();
    m_sheet->activateWindow();
}

SceneView *MainWindow::secondScene() const
{
    return m_secondScene;
}

/// On another screen, where there is one. It follows the same run.
void MainWindow::openSceneWindow()
{
    if (!m_secondScene) {
        m_secondScene = new SceneView(m_workbench.document());
        m_secondScene->setAttribute(Qt::WA_DeleteOnClose);
        m_secondScene->setWindowTitle(tr("Scene"));
        m_secondScene->setRenderer(m_scene->renderer());
        m_secondScene->setOptions(m_scene->options());
        for (QScreen *other : QGuiApplication::screens()) {
            if (other == screen())
                continue;
            m_secondScene->setGeometry(other->geometry());
            m_secondScene->setWindowState(Qt::WindowFullScreen);
        }
    }
    m_secondScene->show();
    m_secondScene->raise();
}

} // namespace cradle
