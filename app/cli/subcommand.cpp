// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommand.h"

#include "model/files/file_io.h"

#include <QCoreApplication>
#include <QTextStream>

#include <cstdio>

namespace cradle::cli {

namespace {

struct CliText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

} // namespace

ExitCode complain(const QString &message)
{
    QTextStream(stderr) << QStringLiteral("cradle-cli: ") << message << Qt::endl;
    return BadInput;
}

ExitCode complain(const Error &error)
{
    if (error.file.isEmpty())
        return complain(error.toString());
    QTextStream(stderr) << error.toString() << Qt::endl;
    return BadInput;
}

ExitCode complainUnwritten(const Error &error)
{
    complain(error);
    return Defect;
}

std::optional<ExitCode> parse(QCommandLineParser &parser, const QStringList &arguments,
                              int leastPositional, int mostPositional)
{
    const QCommandLineOption help = parser.addHelpOption();
    if (!parser.parse(arguments))
        return complain(parser.errorText());
    if (parser.isSet(help)) {
        QTextStream(stdout) << parser.helpText();
        return Done;
    }
    const auto count = parser.positionalArguments().size();
    if (count < leastPositional)
        return complain(
            CliText::tr("an argument is missing; see %1 --help").arg(arguments.first()));
    if (count > mostPositional) {
        return complain(
            CliText::tr("unexpected argument %1; see %2 --help")
                .arg(parser.positionalArguments().at(mostPositional), arguments.first()));
    }
    return std::nullopt;
}

std::optional<Error> writeText(const QString &path, const QByteArray &text)
{
    if (path.isEmpty() || path == QLatin1String("-"))
        return writeStandardOutput(text);
    return writeFile(path, text);
}

} // namespace cradle::cli
