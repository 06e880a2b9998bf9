// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/program_run.h"
#include "tests/scenes.h"

namespace cradle::programs {

/// The lab's glancing hit.
inline const QByteArray glancing = R"([{"position": [-2, 2.3], "velocity": [2, 0], "radius": 0.2},
                                {"position": [2, 2], "radius": 0.2}])";

/// Runs cradle-cli simulate in a folder of its own.
class SimulateTest
{
public:
    [[nodiscard]] QString preset(const QByteArray &circles, const QByteArray &laws = "{}",
                                 const QByteArray &more = {}) const
    {
        return written(m_folder, "preset.json",
                       R"({"format": 1, "laws": )" + laws + more + R"(, "circles": )" + circles
                           + "}");
    }

    /// \param options  may name tables as STATES, TOTALS and EVENTS
    [[nodiscard]] Outcome simulate(const QString &preset, const QString &options) const
    {
        QStringList arguments{text("simulate"), preset};
        for (QString word : options.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            for (const char *name : {"STATES", "TOTALS", "EVENTS"}) {
                if (word == QLatin1String(name))
                    word = m_folder.filePath(word);
            }
            arguments.append(word);
        }
        return runCli(arguments);
    }

    [[nodiscard]] Table table(const char *name) const
    {
        return readTable(m_folder.filePath(text(name)));
    }

    [[nodiscard]] const QTemporaryDir &folder() const { return m_folder; }

private:
    QTemporaryDir m_folder;
};

} // namespace cradle::programs
