// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"
#include "app/cli/subcommand.h"

#include "app/language.h"

#include "tasks/grading/worker_server.h"

#include <QCoreApplication>
#include <QTextStream>

#include <array>
#include <csignal>
#include <cstdio>
#include <exception>

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

namespace {

using namespace cradle::cli;

struct Entry {
    const char *name;
    const char *what;
    Subcommand run;
};

constexpr std::array subcommands{
    Entry{"check", "judges a program or a preset for one step of a lab", check},
    Entry{"export", "writes a lab into one file, for students, too", exportLab},
    Entry{"grade", "judges a class", grade},
    Entry{"hand-in", "writes a student's work into one file", handIn},
    Entry{"report", "writes the report of a student's work", report},
    Entry{"simulate", "runs a scene and writes what happens", simulate},
    Entry{"suggest", "suggests mistakes that a lab does not know", suggest},
    Entry{"verify", "judges a lab itself", verify},
};

void printUsage(FILE *where)
{
    QTextStream out(where);
    out << "Usage: cradle-cli SUBCOMMAND ...\n\n";
    for (const Entry &entry : subcommands)
        out << "  " << qSetFieldWidth(10) << Qt::left << entry.name << qSetFieldWidth(0)
            << entry.what << '\n';
    out << "\ncradle-cli SUBCOMMAND --help says more. Exit status: 0 done and all passed,\n"
           "1 something did not pass, 2 wrong usage or unreadable input, 3 a defect of ours.\n";
}

/// Where one of the standard streams is closed, the next file that is opened would take its place,
/// and what is meant for the stream would be written into it. So something has the place that can
/// only be used the wrong way round: that fails, and is told.
void guardStandardStreams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0)
            (void)!open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

/// Judging makes and drops some thousand states of Lua. What the system would get back between two
/// of them it would have to give, and to clear, again. What it forks does likewise.
void keepFreedMemory()
{
    mallopt(M_TRIM_THRESHOLD, 64 * 1024 * 1024);
    mallopt(M_TOP_PAD, 1024 * 1024);
}

} // namespace

int main(int argc, char **argv)
{
    guardStandardStreams();
    keepFreedMemory();
    // A file that may not grow is told by the write that fails, and in words.
    std::signal(SIGXFSZ, SIG_IGN);
    const QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("cradle-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(CRADLE_VERSION));
    const auto texts = textsOf(argc, argv);
    if (!texts)
        return complain(texts.error());
    QStringList arguments = *texts;
    const QString name = arguments.value(0);
    if (name == QLatin1String("--help") || name == QLatin1String("-h")) {
        printUsage(stdout);
        return Done;
    }
    if (name == QLatin1String("--version")) {
        QTextStream(stdout) << "cradle-cli " << CRADLE_VERSION << '\n';
        return Done;
    }
    if (name == QLatin1String("judge-server")) { // started by this program alone
        const QString language = arguments.value(1, QStringLiteral("en"));
        cradle::setLanguage(language);
        return cradle::runJudgingServer(language);
    }
    for (const Entry &entry : subcommands) {
        if (name != QLatin1String(entry.name))
            continue;
        arguments[0] = QStringLiteral("cradle-cli ") + name;
        try {
            return entry.run(arguments);
        } catch (const std::exception &e) {
            QTextStream(stderr) << "cradle-cli: this is a defect of ours: " << e.what() << '\n';
            return Defect;
        }
    }
    if (!name.isEmpty())
        QTextStream(stderr) << "cradle-cli: unknown subcommand " << name << "\n\n";
    printUsage(stderr);
    return BadInput;
}
