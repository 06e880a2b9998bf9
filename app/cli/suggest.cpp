// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lab_at_hand.h"
#include "app/cli/subcommand.h"

#include "tasks/authoring/mutations.h"
#include "tasks/reading/lab_archive.h"

#include <QCoreApplication>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct SuggestText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

QString describe(const Suggestion &suggestion)
{
    const Mutant &mutant = suggestion.mutant;
    QString text = QStringLiteral("  %1 %2\n").arg(mutant.name, -28).arg(mutant.change);
    switch (suggestion.kind) {
    case Suggestion::Kind::Passes:
        return text + SuggestText::tr("      passes every check\n");
    case Suggestion::Kind::ToldByLaw:
        return text
               + SuggestText::tr("      fails %1; what is measured tells: %2\n")
                     .arg(suggestion.check, suggestion.finding);
    case Suggestion::Kind::NotDiagnosed:
        break;
    }
    return text
           + SuggestText::tr("      fails %1 without a diagnosis: %2\n")
                 .arg(suggestion.check, suggestion.finding);
}

} // namespace

ExitCode suggest(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(SuggestText::tr(
        "Makes mistakes that students make out of the solutions of a lab, and names those that "
        "pass every check (a check may be missing), those that fail without a diagnosis (a mistake "
        "may be missing), and those of which a law that is measured tells."));
    parser.addPositionalArgument(QStringLiteral("LAB"),
                                 SuggestText::tr("the lab's folder, or NAME.cradle"));
    parser.addPositionalArgument(QStringLiteral("STEP"), SuggestText::tr("this step alone"),
                                 QStringLiteral("[STEP]"));
    if (const auto code = parse(parser, arguments, 1, 2))
        return *code;
    const Result<Lab> lab = readLabOrArchive(parser.positionalArguments().first());
    if (!lab)
        return complain(lab.error());
    for (const Error &finding : lab->findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    const QString only = parser.positionalArguments().value(1);
    if (!only.isEmpty() && lab->indexOf(only) < 0)
        return complain(noStep(*lab, only));
    int passing = 0;
    for (const Task &task : lab->tasks) {
        if (!only.isEmpty() && task.id != only)
            continue;
        QString text = QStringLiteral("%1  %2\n").arg(task.id, task.title);
        for (const Suggestion &suggestion : suggestMistakes(*lab, task).list) {
            text += describe(suggestion);
            passing += suggestion.kind == Suggestion::Kind::Passes ? 1 : 0;
        }
        // Each step as soon as it is known: a lab takes minutes.
        if (const auto error = writeText({}, text.toUtf8()))
            return complainUnwritten(*error);
    }
    return passing == 0 && lab->findings.empty() ? Done : NotPassed;
}

} // namespace cradle::cli
