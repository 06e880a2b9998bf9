// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/theme.h"

#include <QObject>
#include <QPointer>

QT_BEGIN_NAMESPACE
class QWidget;
QT_END_NAMESPACE

namespace cradle {

class Choices;
class PresentationLayer;
class Room;
class SceneView;
class Workbench;

/// Shows the scene to many.
class Presenter final : public QObject
{
    Q_OBJECT
public:
    Presenter(Workbench &workbench, SceneView &scene, Room &room, const Choices &choices,
              QWidget &window);
    ~Presenter() override;

    [[nodiscard]] PresentationLayer *layer() const { return m_layer; } ///< if it presents
    [[nodiscard]] SceneView *secondScene() const;                      ///< if it is open

public slots:
    void showFullScreen(bool full);
    /// Larger texts, high contrast, the scene alone on the full screen, keys of presenters (Page Up
    /// and Down from hit to hit, B for black, Esc ends it), and a trail behind the pointer.
    void present(bool presents);
    void openSceneWindow(); ///< the same scene once more, on another screen if there is one

signals:
    void presentingChanged();

private:
    void addKeys();

    Workbench &m_workbench;
    SceneView &m_scene;
    Room &m_room;
    const Choices &m_choices;
    QWidget &m_window;
    QPointer<SceneView> m_secondScene;
    PresentationLayer *m_layer = nullptr; ///< while it presents
    struct {
        ThemeChoice theme = ThemeChoice::System;
        double textScale = 1.0;
        bool fullScreen = false;
    } m_before;
};

} // namespace cradle
