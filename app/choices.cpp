// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/choices.h"

#include "app/announcer.h"
#include "app/language.h"
#include "app/notice_bar.h"
#include "app/panes.h"
#include "app/room.h"
#include "app/sounds.h"
#include "app/workbench.h"
#include "views/scene/scene_view.h"

#include <QSettings>

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

Choices::Choices(Workbench &workbench, Panes &panes, Room &room, Sounds &sounds,
                 QSettings &settings, ThemeChoice theme)
    : m_workbench(workbench)
    , m_simulation(workbench.simulation())
    , m_panes(panes)
    , m_room(room)
    , m_sounds(sounds)
    , m_settings(settings)
    , m_theme(theme)
{
    panes.scene->setRenderer(
        static_cast<Renderer>(settings.value(QStringLiteral("renderer"), 0).toInt()));
    m_simulation.setShadowed(settings.value(exactKey).toBool());
    m_simulation.setPausesAtHits(settings.value(pauseKey).toBool());
    m_simulation.setSlowsAtHits(settings.value(slowKey).toBool());
    panes.scene->followCentreOfMass(settings.value(followKey).toBool());
    panes.announcer->setSaysHits(settings.value(announceKey, true).toBool());
    sounds.hits().setOn(settings.value(soundKey).toBool());
    SceneOptions options;
    for (const auto &[key, option] : optionKeys)
        options.*option = settings.value(QLatin1String(key), options.*option).toBool();
    panes.scene->setOptions(options);
}

void Choices::chooseTheme(ThemeChoice choice)
{
    m_theme = choice;
    m_settings.setValue(QStringLiteral("theme"), static_cast<int>(choice));
    applyTheme(choice);
}

void Choices::chooseTextSize(int percent)
{
    m_settings.setValue(QStringLiteral("textSize"), percent);
    setTextScale(percent / 100.0);
    m_room.refit();
}

void Choices::chooseLanguage(const QString &code)
{
    m_settings.setValue(QStringLiteral("language"), code);
    setLanguage(code);
    m_workbench.setLanguage(code);
}

void Choices::chooseRenderer(Renderer renderer)
{
    m_settings.setValue(QStringLiteral("renderer"), static_cast<int>(renderer));
    m_panes.scene->setRenderer(renderer);
    if (!m_panes.scene->fallbackReason().isEmpty())
        m_panes.notice->showNotice(m_panes.scene->fallbackReason());
}

void Choices::showExactMotion(bool shown)
{
    m_settings.setValue(exactKey, shown);
    m_simulation.setShadowed(shown);
}

void Choices::pauseAtHits(bool on)
{
    m_settings.setValue(pauseKey, on);
    m_simulation.setPausesAtHits(on);
}

void Choices::slowAtHits(bool on)
{
    m_settings.setValue(slowKey, on);
    m_simulation.setSlowsAtHits(on);
}

void Choices::announceHits(bool on)
{
    m_settings.setValue(announceKey, on);
    m_panes.announcer->setSaysHits(on);
}

void Choices::soundHits(bool on)
{
    m_settings.setValue(soundKey, on);
    m_sounds.hits().setOn(on);
}

void Choices::followCentreOfMass(bool on)
{
    m_settings.setValue(followKey, on);
    m_panes.scene->followCentreOfMass(on);
}

void Choices::showInScene(const SceneOptions &options)
{
    for (const auto &[key, option] : optionKeys)
        m_settings.setValue(QLatin1String(key), options.*option);
    m_panes.scene->setOptions(options);
}

} // namespace cradle
