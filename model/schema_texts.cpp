// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtGlobal>

namespace cradle {

// The descriptions of resources/schemas, named here so that they are translated; what is wrong
// in a file is explained with them. A test compares the two.
// clang-format off
[[maybe_unused]] static const char *const schemaTexts[] = {
    QT_TRANSLATE_NOOP("Schema", "1, the format that this version reads"),
    QT_TRANSLATE_NOOP("Schema", "a circle number from 1"),
    QT_TRANSLATE_NOOP("Schema", "a colour like #1e90ff"),
    QT_TRANSLATE_NOOP("Schema", "a language code like en or de"),
    QT_TRANSLATE_NOOP("Schema", "a list of checks"),
    QT_TRANSLATE_NOOP("Schema", "a list of circle numbers from 1"),
    QT_TRANSLATE_NOOP("Schema", "a list of circles, or an object with fill"),
    QT_TRANSLATE_NOOP("Schema", "a list of folder names, in order"),
    QT_TRANSLATE_NOOP("Schema", "a list of remarks"),
    QT_TRANSLATE_NOOP("Schema", "a list of texts"),
    QT_TRANSLATE_NOOP("Schema", "a number in m from -10000 to 10000"),
    QT_TRANSLATE_NOOP("Schema", "a number in m/s from -1e7 to 1e7"),
    QT_TRANSLATE_NOOP("Schema", "a number in m/s² from -10000 to 10000"),
    QT_TRANSLATE_NOOP("Schema", "a short name of letters, digits, dots and dashes"),
    QT_TRANSLATE_NOOP("Schema", "a text of at most 200 characters"),
    QT_TRANSLATE_NOOP("Schema", "a text of at most 2000 characters"),
    QT_TRANSLATE_NOOP("Schema", "a whole number from 0 to 2147483647"),
    QT_TRANSLATE_NOOP("Schema", "an object that says which scenes the check runs: kind, count, duration, timesteps and what they vary"),
    QT_TRANSLATE_NOOP("Schema", "an object with count and radius, and if wanted rms_speed, density, seed"),
    QT_TRANSLATE_NOOP("Schema", "an object with format, id, title, commit, preset, hints, code_hints, remarks, checks, extra and locked"),
    QT_TRANSLATE_NOOP("Schema", "a list of fields of the scene that the student may not change"),
    QT_TRANSLATE_NOOP("Schema", "a field as gravity, restitution, timestep, half_width, circles, laws/walls, laws/circles, laws/timing or circles/1/velocity"),
    QT_TRANSLATE_NOOP("Schema", "an object with format, id, title, version, language and steps"),
    QT_TRANSLATE_NOOP("Schema", "an object with format, name, square, gravity, restitution, timestep, laws and circles"),
    QT_TRANSLATE_NOOP("Schema", "an object with half_width"),
    QT_TRANSLATE_NOOP("Schema", "an object with id, compare and scene"),
    QT_TRANSLATE_NOOP("Schema", "an object with id, kind, title, points, parameters and scene"),
    QT_TRANSLATE_NOOP("Schema", "an object with position, and if wanted name, velocity, radius, density, colour, integrator"),
    QT_TRANSLATE_NOOP("Schema", "an object with the parameters of the kind"),
    QT_TRANSLATE_NOOP("Schema", "an object with the texts of the mistakes by their name"),
    QT_TRANSLATE_NOOP("Schema", "an object with the texts of the remarks by their name"),
    QT_TRANSLATE_NOOP("Schema", "an object with the titles of the checks by their id"),
    QT_TRANSLATE_NOOP("Schema", "an object with title, hints, code_hints, checks, mistakes and remarks"),
    QT_TRANSLATE_NOOP("Schema", "an object with walls, circles and timing"),
    QT_TRANSLATE_NOOP("Schema", "half the side of the square in m, a number from 1e-6 to 10000"),
    QT_TRANSLATE_NOOP("Schema", "how many circles, a whole number from 1 to 100000"),
    QT_TRANSLATE_NOOP("Schema", "one of discrete, continuous, exact"),
    QT_TRANSLATE_NOOP("Schema", "one of euler, symplectic_euler, verlet, rk4"),
    QT_TRANSLATE_NOOP("Schema", "one of none, reflect"),
    QT_TRANSLATE_NOOP("Schema", "one of none, stop, swap_velocities, swap_normal, impulse"),
    QT_TRANSLATE_NOOP("Schema", "one of velocities, positions, fields"),
    QT_TRANSLATE_NOOP("Schema", "the coefficient of restitution e, a number from 0 to 1"),
    QT_TRANSLATE_NOOP("Schema", "the density in 1000 kg/m³, a number from 1e-9 to 1e9"),
    QT_TRANSLATE_NOOP("Schema", "the name of a file beside task.json"),
    QT_TRANSLATE_NOOP("Schema", "the name of a folder beside lab.json: letters, digits, dashes and underscores"),
    QT_TRANSLATE_NOOP("Schema", "the name of a kind of check"),
    QT_TRANSLATE_NOOP("Schema", "the radius in m, a number from 1e-6 to 10000"),
    QT_TRANSLATE_NOOP("Schema", "the root mean square speed in m/s, a number from 0 to 1e6"),
    QT_TRANSLATE_NOOP("Schema", "the timestep in s, a number from 1e-6 to 0.1"),
    QT_TRANSLATE_NOOP("Schema", "true or false"),
    QT_TRANSLATE_NOOP("Schema", "two numbers [x, y] in m, each from -10000 to 10000"),
    QT_TRANSLATE_NOOP("Schema", "two numbers [x, y] in m/s, each from -1e7 to 1e7"),
    QT_TRANSLATE_NOOP("Schema", "two numbers [x, y] in m/s², each from -10000 to 10000"),
    QT_TRANSLATE_NOOP("Schema", "what passing the check is worth, a number from 0 to 1000"),
};
// clang-format on

} // namespace cradle
