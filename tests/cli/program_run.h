// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"
#include "tests/test_paths.h"
#include "tests/text.h"

#include <QFile>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include <vector>

namespace cradle::programs {

using cradle::patience;
using cradle::text;

/// What a program that ended has left behind.
struct Outcome {
    bool ended = false; ///< by itself: neither crashed nor hung
    int code = -1;
    QString out{};
    QString error{};

    [[nodiscard]] QByteArray toText() const
    {
        return QStringLiteral("ended: %1, code: %2\nout: %3\nerror: %4")
            .arg(ended)
            .arg(code)
            .arg(out.left(2000), error.left(2000))
            .toUtf8();
    }
};

/// Runs \p program to its end. Its home is \p home (a temporary folder): nothing is left behind.
inline Outcome
run(const QString &program, const QStringList &arguments, const QString &home = {},
    const QProcessEnvironment &environment = QProcessEnvironment::systemEnvironment())
{
    QProcess process;
    QProcessEnvironment env = environment;
    // Asan would look for leaks in Mesa and fontconfig, too; of two settings alike the last counts.
    const QString asan = QStringLiteral("ASAN_OPTIONS");
    env.insert(asan, env.value(asan) + QStringLiteral(":detect_leaks=0:malloc_context_size=5"));
    env.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    if (!home.isEmpty()) {
        for (const char *name :
             {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
            env.insert(QString::fromLatin1(name), home);
    }
    process.setProcessEnvironment(env);
    process.start(program, arguments);
    const bool ended = process.waitForFinished(patience);
    return {.ended = ended && process.exitStatus() == QProcess::NormalExit,
            .code = ended ? process.exitCode() : -1,
            .out = QString::fromUtf8(process.readAllStandardOutput()),
            .error = QString::fromUtf8(process.readAllStandardError())};
}

inline Outcome runCli(const QStringList &arguments)
{
    return run(cliProgram(), arguments);
}

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline QString written(const QTemporaryDir &folder, const char *name, const QByteArray &text)
{
    const QString path = folder.filePath(QString::fromUtf8(name));
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? path : QString();
}

/// A table as rows of cells, without its header.
struct Table {
    QString header{};
    std::vector<QStringList> rows{};
    bool complete = false; ///< ends with a line end and holds no empty line

    [[nodiscard]] double number(std::size_t row, int column) const
    {
        return rows.at(row).at(column).toDouble();
    }
};

inline Table readTable(const QString &path)
{
    QStringList lines = QString::fromUtf8(contentOf(path)).split(QLatin1Char('\n'));
    Table table;
    table.complete = lines.size() > 1 && lines.takeLast().isEmpty();
    table.header = lines.takeFirst();
    for (const QString &line : lines) {
        table.complete = table.complete && !line.isEmpty();
        table.rows.push_back(line.split(QLatin1Char(',')));
    }
    return table;
}

} // namespace cradle::programs

/// The program must have ended by itself with this code.
#define VERIFY_CODE(outcome, wanted)                                                               \
    do {                                                                                           \
        const cradle::programs::Outcome &outcome_ = (outcome);                                     \
        QVERIFY2(outcome_.ended &&outcome_.code == (wanted), outcome_.toText().constData());       \
    } while (false)
