// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/script/student_script.h"

#include <QTest>

/// Students' programs, run as the application and the checks run them.
namespace cradle::programs {

/// Source text of a program; line 1 is the first line of \p text.
inline QString lua(const char *text)
{
    return QString::fromUtf8(text);
}

/// Circle 1 in (-2, 2) with v = (2, 0), circle 2 at rest in (2, -1), gravity, e = 0.5.
inline Preset scriptScene()
{
    Preset preset;
    preset.gravity = {0.0, -9.81};
    preset.restitution = 0.5;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    preset.circles.resize(2);
    preset.circles[0].body = {.position = {-2.0, 2.0}, .velocity = {2.0, 0.0}};
    preset.circles[1].body = {.position = {2.0, -1.0}, .radius = 0.25, .density = 2.0};
    return preset;
}

/// A program after so many steps.
struct ScriptRun {
    Preset scene{}; ///< as the program left it when it was loaded
    World world{};  ///< the last that was reached
    ProgramOutput output{};
    std::optional<ProgramError> error{};
    bool moves = false;

    [[nodiscard]] const Circle &circle(int number) const
    {
        return world.circles.at(static_cast<std::size_t>(number - 1));
    }
    [[nodiscard]] QByteArray say() const
    {
        return error ? QStringLiteral("line %1, step %2: %3")
                           .arg(error->line)
                           .arg(error->step)
                           .arg(error->message)
                           .toUtf8()
                     : QByteArray("no error");
    }
};

/// Loads \p source and makes \p steps steps, until one fails.
inline ScriptRun runScript(const QString &source, int steps = 0,
                           StudentScript::Options options = {},
                           const Preset &preset = scriptScene())
{
    StudentScript program(source, options);
    ScriptRun run;
    run.scene = preset;
    run.error = program.begin(run.scene);
    run.world = initialWorld(run.scene);
    run.moves = program.moves();
    const double dt = preset.timestep;
    for (int i = 0; i < steps && !run.error && run.moves; ++i) {
        World next = run.world;
        run.error = program.advance(next, dt);
        if (run.error)
            break;
        run.world = next;
        ++run.world.step;
        run.world.time = static_cast<double>(run.world.step) * dt;
    }
    run.output = program.takeOutput();
    return run;
}

} // namespace cradle::programs

/// The run must have no error.
#define VERIFY_RUNS(run)                                                                           \
    do {                                                                                           \
        QVERIFY2(!(run).error, (run).say().constData());                                           \
    } while (false)

/// The run must have stopped at this line, with words like these.
#define VERIFY_STOPS(run, wantedLine, words)                                                       \
    do {                                                                                           \
        QVERIFY2((run).error, "no error");                                                         \
        QVERIFY2((run).error->line == (wantedLine), (run).say().constData());                      \
        QVERIFY2((run).error->message.contains(words), (run).say().constData());                   \
    } while (false)
