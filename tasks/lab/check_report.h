// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/program.h"

#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// What one check found.
struct CheckOutcome {
    QString id;
    QString title;
    bool passed = false;
    QString message{};                ///< what was observed and what was expected, with units
    std::optional<double> expected{}; ///< in \c unit
    std::optional<double> observed{}; ///< in \c unit
    QString unit{};
    qint64 step = -1;  ///< where it first went wrong; −1 if it passed or nothing can be shown
    QString variant{}; ///< the scene where it first went wrong: "preset" is the student's own
    std::optional<Preset> scene{}; ///< that scene, to be shown
    bool pinned = false;           ///< that scene keeps its values whatever a program sets
    int line = 0;              ///< of the program: what assigned last in that step; 0 if unknown
    bool checkStopped = false; ///< the check itself has an error: nothing is said of the work
    double points = 1.0;       ///< what passing it is worth
    bool question = false;     ///< it judges an answer, not the work
    bool forTeacher = false; ///< what is in the message is read by the teacher; passed: it is there

    friend bool operator==(const CheckOutcome &, const CheckOutcome &) = default;
};

/// What of a program can be right or wrong, in the order in which a teacher takes them.
enum class Aspect {
    Start,    ///< what the circles start with
    Motion,   ///< how they move freely
    Walls,    ///< how walls turn them
    Contact,  ///< when two count as touching, and who answers
    Response, ///< what a hit does to both
    Course    ///< what becomes of them in the long run
};

/// One thing that is wrong with a program, by a known mistake or a measured law.
struct Finding {
    Aspect aspect = Aspect::Motion;
    QString mistake{};        ///< its name in the lab; empty for a measured law
    QString message{};        ///< a headline, an empty line, what was seen and where to look;
                              ///< CommonMark
    QString check{};          ///< id of a failed check in which it shows
    int line = 0;             ///< of the program; 0 if unknown
    std::vector<int> calls{}; ///< the lines of the calls that led there, the first in on_update

    friend bool operator==(const Finding &, const Finding &) = default;
};

/// A word about work that passes.
struct Remark {
    QString id;
    QString message; ///< CommonMark

    friend bool operator==(const Remark &, const Remark &) = default;
};

/// The verdict on one submission of one step.
struct CheckReport {
    QString labId;
    QString labHash; ///< sha256 of the lab's files
    QString taskId;
    qint64 seed = 1;
    bool passed = false;
    bool byProgram = false; ///< a program moved the circles; else the laws of the scene did
    std::vector<CheckOutcome> checks{};
    std::vector<Finding> findings{}; ///< in the order in which to mend them
    std::vector<Remark> remarks{};
    std::optional<ProgramError> error{}; ///< the program did not load or stopped
    QString commit{};                    ///< the commit message of the step; filled in as observed
    qint64 elapsedMs = 0;

    /// The first finding; null if there is none.
    [[nodiscard]] const Finding *diagnosis() const
    {
        return findings.empty() ? nullptr : &findings.front();
    }

    friend bool operator==(const CheckReport &, const CheckReport &) = default;
};

} // namespace cradle
