// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program_notes.h"
#include "model/run/run_ahead.h"
#include "model/run/runner.h"
#include "model/run/shadow_run.h"
#include "model/run/simulation_clock.h"

#include <QObject>
#include <QTimer>

namespace cradle {

/// A run of a preset, under its laws or by a student's program: advances it as the clock asks,
/// records every step, and shows any moment of the recording. The one place that the views read
/// from.
class Simulation final : public QObject
{
    Q_OBJECT
public:
    static constexpr double slowest = 1.0 / 16.0; ///< times real time
    static constexpr double fastest = 8.0;
    static constexpr double slowMotion = 1.0 / 8.0; ///< times real time, around hits
    static constexpr double slowReach = 0.12;       ///< s of the run before and after a hit

    explicit Simulation(const Preset &preset, QObject *parent = nullptr);

    /// The scene that runs: the preset, with what the program set when it was loaded.
    [[nodiscard]] const Preset &preset() const { return m_run.scene(); }
    /// The preset as it was set.
    [[nodiscard]] const Preset &basePreset() const { return m_preset; }
    /// Why the program cannot go on from the newest step, if it cannot.
    [[nodiscard]] const std::optional<ProgramError> &programError() const { return m_error; }
    [[nodiscard]] const ProgramNotes &notes() const { return m_notes; }
    /// Whether a program moves the circles, not the laws.
    [[nodiscard]] bool isProgrammed() const { return m_run.isProgrammed(); }
    [[nodiscard]] const Recording &recording() const { return m_recording; }
    /// The moment that is shown: an index into the recording.
    [[nodiscard]] qint64 current() const { return m_current; }
    [[nodiscard]] double time() const { return m_recording.time(m_current); } ///< s
    [[nodiscard]] bool isRunning() const { return m_clock.isRunning(); }
    [[nodiscard]] bool atStart() const { return m_recording.step(m_current) == 0; }
    [[nodiscard]] double speed() const { return m_speed; }        ///< as set
    [[nodiscard]] double pace() const { return m_clock.speed(); } ///< now: less around a hit
    [[nodiscard]] bool slowsAtHits() const { return m_slowsAtHits; }
    [[nodiscard]] bool usesFrameTime() const { return m_frameTime; }
    [[nodiscard]] bool pausesAtHits() const { return m_pausesAtHits; }
    /// Since when the contacts of a run of exact timing are merged, as it could not follow each of
    /// them any longer, s; none as long as it is exact.
    [[nodiscard]] std::optional<double> mergedFrom() const { return m_mergedFrom; }
    /// Whether seekNextHit() still looks.
    [[nodiscard]] bool isSearching() const { return m_search.has_value(); }
    /// How much of the minute that seekNextHit() may look through it has seen, 0 to 1.
    [[nodiscard]] double searchedShare() const;
    /// The exact motion beside the run; null if it is not wanted.
    [[nodiscard]] const ShadowRun *shadow() const { return m_shadow ? &*m_shadow : nullptr; }

    /// Starts again from \p preset, which must have no fault; runs on if it was running.
    void setPreset(const Preset &preset);
    /// Lets \p program move the circles, or the laws if it is null, and starts again. It is
    /// borrowed, and must outlive the run.
    void setProgram(Program *program);
    /// Both at once.
    void setRun(const Preset &preset, Program *program);
    /// The laws that programs are asked to follow, from the next start on: the exact motion beside
    /// one obeys them. With none, and where no program moves the circles, it obeys the scene's.
    void setProgramLaws(const std::optional<Laws> &laws) { m_programLaws = laws; }

public slots:
    void start();
    void pause(); ///< ends a search, too, and goes back to where it began
    void setRunning(bool running);
    void restart();          ///< back to the preset, paused
    void stepForward();      ///< pauses; one recorded or one new step
    void stepBack();         ///< pauses; one recorded step
    void seek(qint64 index); ///< shows a moment of the recording, the nearest that is kept
    void goTo(qint64 step);  ///< pauses; shows that step, computed if it is yet to come
    /// Pauses; runs on to the next hit, or stays if none comes in a minute. What takes long is done
    /// on another thread while events are handled; whatever else is asked for ends it.
    void seekNextHit();
    void seekPreviousHit(); ///< pauses; back to the last recorded hit before, else to the start
    void setPausesAtHits(bool on); ///< a run pauses at the step of every hit
    /// A run goes no faster than slowMotion around the beginning of every contact: after it, and
    /// before it where that is recorded already. Its steps stay as they are; frames that are steps
    /// as well (setFrameTime()) go on as they do.
    void setSlowsAtHits(bool on);
    void setSpeed(double speed); ///< bounded to slowest … fastest
    void setFrameTime(bool on);  ///< steps as long as the frames took, as the original lab did
    void setShadowed(bool on);   ///< runs the exact motion beside the run, from its start

signals:
    void searchingChanged(bool searching);
    void noHitFound();    ///< seekNextHit() looked in vain and stays where it was
    void frameReady();    ///< the moment shown or the recording changed: repaint once
    void restarted();     ///< the recording was begun anew; frameReady follows
    void presetChanged(); ///< restarted and frameReady follow
    void shadowChanged(); ///< there is a shadow now, or none any more; frameReady follows
    /// The program cannot go on; the run is paused on the state before. After restarted.
    void programFailed(const cradle::ProgramError &error);
    void runningChanged(bool running);
    void paceChanged();

private:
    /// A search for the next hit.
    struct Search {
        qint64 begin = 0;       ///< the moment that was shown
        double beginTime = 0.0; ///< s
        double end = 0.0;       ///< s
    };

    void advance(double dt);
    void advanceWholly();
    void stopClock();
    void endSearch();
    void endSearchAt(qint64 index);
    void searchOn();
    bool searchStep();
    void takeAhead(const RunAhead::Step &step);
    void stopAhead();
    void endSearchUnless(bool found);
    [[nodiscard]] bool showsHit() const; ///< the moment shown is the step of a hit
    [[nodiscard]] bool isNearHit() const;
    void followPace();
    bool appendStep(double dt);
    void begin();
    void beginShadow();
    void fail(const ProgramError &error);

    Preset m_preset;
    Program *m_program = nullptr;
    ProgramNotes m_notes;
    Recording m_recording;
    Runner m_run; ///< stands at the end of the recording, or ahead of it while m_ahead has it
    RunAhead m_ahead;
    std::optional<ProgramError> m_error{}; ///< of the newest step that is recorded, or the next
    std::optional<double> m_mergedFrom{};  ///< s
    std::optional<Laws> m_programLaws;
    std::optional<ShadowRun> m_shadow; ///< follows the recording
    SimulationClock m_clock;
    qint64 m_current = 0;
    std::optional<Search> m_search{};
    QTimer m_searchTimer;
    bool m_frameTime = false;
    bool m_pausesAtHits = false;
    bool m_slowsAtHits = false;
    double m_speed = 1.0; ///< as set
};

} // namespace cradle
