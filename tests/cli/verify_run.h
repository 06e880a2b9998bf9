// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/program_run.h"

#include <QDir>
#include <QFileInfo>

#include <map>

namespace cradle::programs {

/// The files of a lab with their contents.
using Files = std::map<QByteArray, QByteArray>;

// Parts of its programs.
inline const QByteArray load = "function on_load()\n  circle1.velocity = vec(2, 0)\nend\n";
inline const QByteArray drift = "function on_update(dt)\n"
                                "  circle1.position = circle1.position + circle1.velocity * dt\n"
                                "end\n";
inline const QByteArray twice =
    "function on_update(dt)\n"
    "  circle1.position = circle1.position + 2 * circle1.velocity * dt\n"
    "end\n";
inline const QByteArray upward = "function on_load()\n  circle1.velocity = vec(0, 2)\nend\n";

/// A lab of one step that is as it should be.
inline Files soundLab()
{
    return {{"lab.json", R"({"format": 1, "id": "small", "title": "Small", "version": "1",
                             "language": "en", "steps": ["S1"]})"},
            {"S1/task.json", R"({"format": 1, "id": "S1", "title": "Drift", "commit": "Drifted",
                "preset": "preset.json", "hints": ["A nudge.", "More.", "Nearly all."],
                "checks": [{"id": "velocity", "kind": "start", "title": "It starts with (2, 0) m/s",
                            "parameters": {"velocity": [2, 0]},
                            "scene": {"kind": "own", "duration": 0.05}},
                           {"id": "drifts", "kind": "integrates", "title": "It drifts",
                            "scene": {"kind": "own", "duration": 1}}]})"},
            {"S1/preset.json", R"({"format": 1, "circles": [{"position": [-2, 2]}]})"},
            {"S1/instructions.md", "# Drift\n"},
            {"S1/starter.lua", "function on_update(dt)\nend\n"},
            {"S1/solution.lua", load + drift},
            {"S1/mistakes/upward.lua", "-- It moves up\n\n" + upward + drift},
            {"S1/mistakes/twice.lua", "-- It moves twice\n\n" + load + twice}};
}

/// Writes the files of a lab into a folder.
inline void write(const QTemporaryDir &folder, const Files &files)
{
    for (const auto &[name, content] : files) {
        const QString path = QString::fromUtf8(name);
        QDir().mkpath(QFileInfo(folder.filePath(path)).path());
        QVERIFY(!written(folder, name.constData(), content).isEmpty());
    }
}

/// cradle-cli verify with these arguments.
inline Outcome verify(const QStringList &arguments)
{
    return runCli(QStringList{text("verify")} + arguments);
}

} // namespace cradle::programs
