// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/theme.h"

#include <QObject>
#include <QPointer>

#include <vector>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class Choices;
class PresentationLayer;
class Room;
class SceneView;
class TransportBar;
class Workbench;

/// Shows the scene to many.
class Presenter final : public QObject
{
    Q_OBJECT
public:
    Presenter(Workbench &workbench, SceneView &scene, const TransportBar &transport, Room &room,
              const Choices &choices, QWidget &window);
    ~Presenter() override;

    /// Over the window, if it presents.
    [[nodiscard]] PresentationLayer *layer() const;
    [[nodiscard]] SceneView *secondScene() const; ///< if it is open

public slots:
    void showFullScreen(bool full);
    /// Larger texts, high contrast, the scene alone on the full screen, keys of presenters (Page Up
    /// and Down from hit to hit, B for black, Esc ends it), and a trail behind the pointer.
    void present(bool presents);
    /// The same scene once more, on another screen if there is one. It shows what the first is
    /// told to show, keys that run the scene do so there, too, and F11 fills the screen.
    void openSceneWindow();

signals:
    void presentingChanged();

private:
    void cover(QWidget &window);
    void setBlack(bool black);
    void addKeys(SceneView &second);

    Workbench &m_workbench;
    SceneView &m_scene;
    const TransportBar &m_transport;
    Room &m_room;
    const Choices &m_choices;
    QWidget &m_window;
    QPointer<SceneView> m_secondScene;
    std::vector<QPointer<PresentationLayer>> m_layers; ///< while it presents; the window's first
    struct {
        ThemeChoice theme = ThemeChoice::System;
        double textScale = 1.0;
        bool fullScreen = false;
    } m_before;
};

} // namespace cradle
