// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"
#include "tests/test_paths.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

namespace cradle {

// A process in which somebody types until it is killed, and who kills it.

inline constexpr int keyPause = 10; ///< ms: nobody types faster
inline constexpr int mostLost = 50; ///< keys: 0.5 s of them

/// Types without a pause, and tells of every key on standard output; the process never ends.
/// \param type  the key of that number, from 1
template <typename Type>
int typeForEver(const Type &type)
{
    int keys = 0;
    QTimer typing;
    QObject::connect(&typing, &QTimer::timeout, &typing, [&] {
        type(++keys);
        std::printf("%d\n", keys);
        std::fflush(stdout);
    });
    typing.start(keyPause);
    return QCoreApplication::exec();
}

/// Processes of this program that type, each in one of \p folders, side by side: most of what they
/// do is to wait for the next key.
inline std::vector<std::unique_ptr<QProcess>> typistsIn(const QStringList &folders)
{
    std::vector<std::unique_ptr<QProcess>> typists;
    for (const QString &folder : folders) {
        typists.push_back(std::make_unique<QProcess>());
        typists.back()->start(ownProgram(), {QStringLiteral("--type"), folder});
    }
    return typists;
}

/// Kills \p process, which types, after \p most keys or a few more.
/// \return how many it had typed; 0 if none within a minute
inline int keysUntilKilled(QProcess &process, int most)
{
    int keys = 0;
    while (keys < most && process.waitForReadyRead(patience)) {
        while (process.canReadLine())
            keys = process.readLine().trimmed().toInt();
    }
    process.kill();
    if (!process.waitForFinished(patience))
        return 0;
    for (const QByteArray &line : process.readAll().split('\n'))
        keys = std::max(keys, line.trimmed().toInt());
    return keys;
}

} // namespace cradle
