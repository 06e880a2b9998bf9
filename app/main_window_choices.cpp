// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the student has chosen to see, and keeps from one session to the next.
#include "app/main_window.h"

#include "app/notice_bar.h"
#include "app/workbench.h"
#include "views/announcer.h"
#include "views/scene/scene_view.h"
#include "views/sound/hit_sounds.h"
#include "views/sound/sound_output.h"

#include <QSettings>

#include <utility>

namespace cradle {

namespace {

constexpr QLatin1String exactKey("exactMotion");
constexpr QLatin1String pauseKey("pauseAtHits");
constexpr QLatin1String slowKey("slowAtHits");
constexpr QLatin1String soundKey("soundHits");
constexpr QLatin1String announceKey("announceHits");
constexpr QLatin1String followKey("followCentreOfMass");

struct OptionKey {
    const char *key;
    bool SceneOptions::*option;
};

constexpr OptionKey optionKeys[] = {{"scene/velocities", &SceneOptions::velocities},
                                    {"scene/trails", &SceneOptions::trails},
                                    {"scene/grid", &SceneOptions::grid},
                                    {"scene/names", &SceneOptions::names},
                                    {"scene/hitParts", &SceneOptions::hitParts},
                                    {"scene/programDrawings", &SceneOptions::programDrawings},
                                    {"scene/momenta", &SceneOptions::momenta},
                                    {"scene/centreOfMass", &SceneOptions::centreOfMass},
                                    {"scene/loupe", &SceneOptions::loupe}};

} // namespace

void MainWindow::restoreChoices()
{
    Simulation &simulation = m_workbench.simulation();
    simulation.setShadowed(m_settings.value(exactKey).toBool());
    simulation.setPausesAtHits(m_settings.value(pauseKey).toBool());
    simulation.setSlowsAtHits(m_settings.value(slowKey).toBool());
    m_scene->followCentreOfMass(m_settings.value(followKey).toBool());
    m_announcer->setSaysHits(m_settings.value(announceKey, true).toBool());
    m_hitSounds->setOn(m_settings.value(soundKey).toBool());
    SceneOptions options;
    for (const auto &[key, option] : optionKeys)
        options.*option = m_settings.value(QLatin1String(key), options.*option).toBool();
    m_scene->setOptions(options);
}

void MainWindow::showExactMotion(bool shown)
{
    m_settings.setValue(exactKey, shown);
    m_workbench.simulation().setShadowed(shown);
}

void MainWindow::pauseAtHits(bool on)
{
    m_settings.setValue(pauseKey, on);
    m_workbench.simulation().setPausesAtHits(on);
}

void MainWindow::slowAtHits(bool on)
{
    m_settings.setValue(slowKey, on);
    m_workbench.simulation().setSlowsAtHits(on);
}

void MainWindow::announceHits(bool on)
{
    m_settings.setValue(announceKey, on);
    m_announcer->setSaysHits(on);
}

void MainWindow::soundHits(bool on)
{
    m_settings.setValue(soundKey, on);
    m_hitSounds->setOn(on);
}

/// The device is asked for with the first sound; a machine without one is told of once.
void MainWindow::play(std::vector<float> samples)
{
    if (!m_soundOutput) {
        m_soundOutput = new SoundOutput(this);
        connect(m_soundOutput, &SoundOutput::failed, this, [this] {
            m_notice->warn(tr("There is no sound here: no sound server (PulseAudio or PipeWire) "
                              "could be reached. Everything else goes on."));
        });
    }
    m_soundOutput->play(std::move(samples));
}

void MainWindow::followCentreOfMass(bool on)
{
    m_settings.setValue(followKey, on);
    m_scene->followCentreOfMass(on);
}

void MainWindow::showInScene(const SceneOptions &options)
{
    for (const auto &[key, option] : optionKeys)
        m_settings.setValue(QLatin1String(key), options.*option);
    m_scene->setOptions(options);
}

} // namespace cradle
