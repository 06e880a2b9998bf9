// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/theme.h"

#include <QObject>

class QSettings;

namespace cradle {

class Room;
class Simulation;
class Sounds;
class Workbench;
enum class Renderer;
struct Panes;
struct SceneOptions;

/// What the student has chosen to see, kept from one session to the next.
class Choices final : public QObject
{
    Q_OBJECT
public:
    /// Chooses what \p settings keep. \param theme  the choice in force
    Choices(Workbench &workbench, Panes &panes, Room &room, Sounds &sounds, QSettings &settings,
            ThemeChoice theme);

    [[nodiscard]] ThemeChoice theme() const { return m_theme; }

public slots:
    void chooseTheme(cradle::ThemeChoice choice);
    void chooseTextSize(int percent); ///< 100 to 200
    void chooseLanguage(const QString &code);
    void chooseRenderer(cradle::Renderer renderer);
    void showExactMotion(bool shown); ///< beside the run
    void pauseAtHits(bool on);
    void slowAtHits(bool on);
    void announceHits(bool on); ///< to screen readers
    void soundHits(bool on);    ///< pitch by mass, loudness by impulse
    void followCentreOfMass(bool on);
    void showInScene(const cradle::SceneOptions &options);

private:
    Workbench &m_workbench;
    Simulation &m_simulation;
    Panes &m_panes;
    Room &m_room;
    Sounds &m_sounds;
    QSettings &m_settings;
    ThemeChoice m_theme;
};

} // namespace cradle
