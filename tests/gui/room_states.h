// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/gui/calm.h"
#include "tests/gui/open_window.h"
#include "tests/gui/spoken_language.h"
#include "tests/patience.h"
#include "tests/sanitized.h"
#include "views/values/values_table.h"

#include <QHash>
#include <QTabWidget>

#include <array>
#include <optional>

namespace cradle::windows {

/// How somebody may have the window.
struct RoomState {
    Mode mode = Mode::Explore;
    QSize size{1440, 900};
    ThemeChoice theme = ThemeChoice::Light;
    QString language = QStringLiteral("en");
    int percent = 100; ///< size of texts
};

/// Both modes at three sizes in three themes; in every language, with large texts, too.
inline std::vector<RoomState> roomStates()
{
    constexpr std::array<QSize, 3> sizes{{{1280, 720}, {1440, 900}, {1920, 1080}}};
    std::vector<RoomState> all;
    for (const Mode mode : {Mode::Explore, Mode::Code}) {
        for (const ThemeChoice theme :
             {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::HighContrast}) {
            for (const QSize size : sizes)
                all.push_back({.mode = mode, .size = size, .theme = theme});
        }
        for (const int percent : {150, 200}) {
            for (const char *language : {"en", "de", "fr", "ar", "pseudo"}) {
                for (const QSize size : {sizes[1], sizes[2]})
                    all.push_back({.mode = mode,
                                   .size = size,
                                   .language = QLatin1String(language),
                                   .percent = percent});
            }
        }
        for (const char *language : {"de", "fr", "ar", "pseudo"})
            all.push_back({.mode = mode, .language = QLatin1String(language)});
    }
    return all;
}

/// Each theme, each language, and each that is spoken with large texts.
inline std::vector<RoomState> fewStates()
{
    std::vector<RoomState> all;
    for (const ThemeChoice theme :
         {ThemeChoice::Light, ThemeChoice::Dark, ThemeChoice::HighContrast})
        all.push_back({.theme = theme});
    for (const char *language : {"de", "fr", "ar", "pseudo"})
        all.push_back({.language = QLatin1String(language)});
    for (const char *language : {"en", "de", "fr", "ar", "pseudo"})
        all.push_back({.language = QLatin1String(language), .percent = 150});
    return all;
}

/// A row of test data for each of them; under sanitizers for one of three.
inline void addStates(const std::vector<RoomState> &states)
{
    QTest::addColumn<RoomState>("state");
    static const QHash<ThemeChoice, const char *> themes{{ThemeChoice::Light, "light"},
                                                         {ThemeChoice::Dark, "dark"},
                                                         {ThemeChoice::HighContrast, "contrast"}};
    for (std::size_t i = 0; i < states.size(); i += std::size_t{oneOf(3)}) {
        const RoomState &state = states[i];
        QTest::addRow("%s %dx%d %s %s %d %%", state.mode == Mode::Code ? "code" : "explore",
                      state.size.width(), state.size.height(), themes[state.theme],
                      qPrintable(state.language), state.percent)
            << state;
    }
}

/// One window that goes from state to state, with a step that was checked and is not yet right.
class StatefulRoom
{
public:
    explicit StatefulRoom(const QTemporaryDir &folder)
        : m_open(folder)
    {
        applyTheme(ThemeChoice::Light);
        m_open.bench.openTask(QStringLiteral("L42T11"));
        m_open.window.choices().chooseRenderer(Renderer::Raster);
        m_open.window.show();
    }
    ~StatefulRoom() { setTextScale(1.0); }
    StatefulRoom(const StatefulRoom &) = delete;
    StatefulRoom &operator=(const StatefulRoom &) = delete;

    [[nodiscard]] MainWindow &window() { return m_open.window; }
    [[nodiscard]] OpenWindow &open() { return m_open; }

    void take(const RoomState &state)
    {
        m_language.speak(state.language,
                         [this](const QString &code) { window().choices().chooseLanguage(code); });
        if (window().choices().theme() != state.theme)
            window().choices().chooseTheme(state.theme);
        if (textScale() != state.percent / 100.0)
            window().choices().chooseTextSize(state.percent);
        m_open.bench.setMode(state.mode);
        check();
        window().resize(state.size);
        calm();
        window().room().resetLayout();
        m_open.simulation().goTo(30);
        calm();
        QCOMPARE(window().size(), state.size); // no larger than the screen that it is for
    }

    static constexpr int turns = 4;
    /// What stands behind other panes comes to the front, in so many turns.
    void showBehind(int turn)
    {
        const std::array<std::vector<const char *>, turns> fronts{
            {{}, {"energy", "versions"}, {"values", "notes"}, {"values", "inspector"}}};
        for (const char *name : fronts[static_cast<std::size_t>(turn)]) {
            auto *pane = window().findChild<QDockWidget *>(QLatin1String(name));
            if (!pane->isHidden())
                pane->raise();
        }
        window().findChild<ValuesPane *>()->tabs().setCurrentIndex(turn == 3 ? 1 : 0);
        calm();
    }

    /// Waits until no text is still to come and every widget has its place.
    void calm() { cradle::calm(window()); }

private:
    /// What was found is told anew in another language, and is of its own in each mode.
    void check()
    {
        if (!m_open.bench.check().report() && !window().transportBar().isChecking())
            m_open.bench.check().start();
        QTRY_VERIFY(m_open.bench.check().report() && !window().transportBar().isChecking());
    }

    SpokenLanguage m_language;
    OpenWindow m_open;
};

} // namespace cradle::windows
