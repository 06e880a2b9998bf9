// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_request.h"

#include "app/cli/spoken.h"

#include <QCoreApplication>

#include <algorithm>
#include <thread>

namespace cradle::cli {

namespace {

struct AskedText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr int mostJobs = 512;
constexpr int mostShards = 100'000;

/// All options, with what they are for.
struct GradeOptions {
    QCommandLineOption lab{
        QStringLiteral("lab"),
        AskedText::tr("the lab's folder or NAME.cradle; without it the shipped lab"),
        QStringLiteral("LAB")};
    QCommandLineOption out{QStringLiteral("out"), AskedText::tr("the folder of the results"),
                           QStringLiteral("RESULTS")};
    QCommandLineOption secret{
        QStringLiteral("secret"),
        AskedText::tr("from which, with the id, each student's scenes follow; without it one is "
                      "made and kept in RESULTS/secret.txt"),
        QStringLiteral("FILE")};
    QCommandLineOption jobs{QStringLiteral("jobs"),
                            AskedText::tr("students at a time; without it as many as processors"),
                            QStringLiteral("N")};
    QCommandLineOption roster{
        QStringLiteral("roster"),
        AskedText::tr("who is in the class: a table with columns id, folder, name, number, email, "
                      "late days"),
        QStringLiteral("F.csv")};
    QCommandLineOption late{QStringLiteral("late-percent"),
                            AskedText::tr("what each late day takes of the points; 0 without it"),
                            QStringLiteral("P"), QStringLiteral("0")};
    QCommandLineOption lateMost{QStringLiteral("late-most"),
                                AskedText::tr("more percent are never taken; 100 without it"),
                                QStringLiteral("P"), QStringLiteral("100")};
    QCommandLineOption shard{QStringLiteral("shard"),
                             AskedText::tr("judge part I of N of the class, for --merge"),
                             QStringLiteral("I/N")};
    QCommandLineOption merge{
        QStringLiteral("merge"),
        AskedText::tr("judge nothing; put together the results of shards, each a folder")};
    QCommandLineOption language{
        QStringLiteral("language"),
        AskedText::tr(
            "of the pages and of what students are told, such as en or de; en without it"),
        QStringLiteral("CODE")};
    QCommandLineOption isolation{
        QStringLiteral("require-isolation"),
        AskedText::tr("judge only where rlimits, seccomp and namespaces are to be had")};
    QCommandLineOption dryRun{
        QStringLiteral("dry-run"),
        AskedText::tr("tell how the folder was understood, and judge nothing")};
    QCommandLineOption again{
        QStringLiteral("again"),
        AskedText::tr("begin anew where RESULTS holds those of another version")};
    QCommandLineOption format{QStringLiteral("format"),
                              AskedText::tr("text, or json: events on standard output, one a line"),
                              QStringLiteral("NAME"), QStringLiteral("text")};
    QCommandLineOption exitZero{
        QStringLiteral("exit-zero"),
        AskedText::tr("exit with 0 also if somebody did not pass, if only all are graded")};
};

std::optional<Shard> shardFrom(const QString &text)
{
    bool first = false;
    bool second = false;
    const Shard shard{text.section(u'/', 0, 0).toInt(&first), text.section(u'/', 1).toInt(&second)};
    const bool right = first && second && shard.index >= 1 && shard.index <= shard.count
                       && shard.count <= mostShards;
    return right ? std::optional(shard) : std::nullopt;
}

std::optional<double> percentFrom(const QString &text)
{
    bool isNumber = false;
    const double percent = text.toDouble(&isNumber);
    return isNumber && percent >= 0.0 && percent <= 100.0 ? std::optional(percent) : std::nullopt;
}

/// The values that can be wrong. \return what is
std::optional<QString> readValues(const QCommandLineParser &parser, const GradeOptions &options,
                                  GradeRequest &request)
{
    request.jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    if (parser.isSet(options.jobs)) {
        bool isNumber = false;
        request.jobs = parser.value(options.jobs).toInt(&isNumber);
        if (!isNumber || request.jobs < 1 || request.jobs > mostJobs)
            return AskedText::tr("--jobs %1: a number from 1 to %2 is right")
                .arg(parser.value(options.jobs))
                .arg(mostJobs);
    }
    if (parser.isSet(options.shard)) {
        const auto shard = shardFrom(parser.value(options.shard));
        if (!shard)
            return AskedText::tr("--shard %1: I/N is right, with I from 1 to N")
                .arg(parser.value(options.shard));
        request.shard = *shard;
        if (request.shard.count > 1 && !parser.isSet(options.secret)
            && !parser.isSet(options.dryRun))
            return AskedText::tr("--shard needs --secret FILE, the same for every shard");
    }
    request.language = parser.value(options.language);
    if (const QString fault = languageFault(request.language); !fault.isEmpty())
        return fault;
    const auto late = percentFrom(parser.value(options.late));
    const auto most = percentFrom(parser.value(options.lateMost));
    if (!late || !most)
        return AskedText::tr("--late-percent and --late-most are numbers from 0 to 100");
    request.late = {*late, *most};
    const QString format = parser.value(options.format);
    if (format != QLatin1String("text") && format != QLatin1String("json"))
        return AskedText::tr("unknown format %1; one of %2 is right")
            .arg(format, QStringLiteral("text, json"));
    request.events = format == QLatin1String("json");
    return std::nullopt;
}

} // namespace

std::variant<GradeRequest, ExitCode> parseGradeRequest(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(AskedText::tr(
        "Judges a class: every step of every student, each in a process of its own that can do "
        "nothing else. SUBMISSIONS is a folder of folders or of .cradle-work files, a download of "
        "Moodle, Canvas or Blackboard, clones of GitHub Classroom, or a zip of any of these; "
        "nothing in it is written. Stopped at any time it goes on where it was. Exit status: 1 if "
        "not all passed."));
    parser.addPositionalArgument(QStringLiteral("SUBMISSIONS"),
                                 AskedText::tr("what was handed in; with --merge: results"),
                                 QStringLiteral("SUBMISSIONS..."));
    const GradeOptions options;
    parser.addOptions({options.lab, options.out, options.secret, options.jobs, options.roster,
                       options.late, options.lateMost, options.shard, options.merge,
                       options.language, options.isolation, options.dryRun, options.again,
                       options.format, options.exitZero});
    constexpr int mostMerged = 100'000;
    if (const auto code = parse(parser, arguments, 1, mostMerged))
        return *code;
    GradeRequest request{.labPath = parser.value(options.lab),
                         .results = parser.value(options.out),
                         .secretPath = parser.value(options.secret),
                         .rosterPath = parser.value(options.roster),
                         .requireIsolation = parser.isSet(options.isolation),
                         .dryRun = parser.isSet(options.dryRun),
                         .again = parser.isSet(options.again),
                         .exitZero = parser.isSet(options.exitZero)};
    const QStringList positional = parser.positionalArguments();
    if (parser.isSet(options.merge))
        request.merged = positional;
    else if (positional.size() == 1)
        request.submissions = positional.first();
    else
        return complain(AskedText::tr("unexpected argument %1; see %2 --help")
                            .arg(positional.at(1), arguments.first()));
    if (request.results.isEmpty() && !request.dryRun)
        return complain(AskedText::tr("--out RESULTS is missing: where are the results to go?"));
    if (const auto fault = readValues(parser, options, request))
        return complain(*fault);
    return request;
}

} // namespace cradle::cli
