// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/other_mistakes.h"

#include "tasks/text/program_diff.h"

#include <QSet>

#include <algorithm>

namespace cradle {

namespace {

/// The other steps: from the one before back to the first, then those behind.
QStringList othersOf(const QStringList &steps, const QString &step)
{
    const auto at = steps.indexOf(step);
    QStringList others = steps.mid(0, std::max<qsizetype>(at, 0));
    std::reverse(others.begin(), others.end());
    return others + steps.mid(at + 1);
}

/// The difference that mistake \p name of step \p other is, however it is kept.
QString diffOf(const LabFiles &files, const QString &other, const QString &name)
{
    const QString path = knownPath(other, KnownKind::Mistake, name);
    if (isDiff(files, path))
        return textOf(files, diffPathOf(path));
    return diffOfProgram(textOf(files, path),
                         textOf(files, other + QStringLiteral("/solution.lua")), path);
}

} // namespace

std::vector<OtherMistake> mistakesOfOtherSteps(const LabFiles &files, const QString &step)
{
    const QString solution = textOf(files, step + QStringLiteral("/solution.lua"));
    std::vector<OtherMistake> found;
    if (solution.isEmpty())
        return found;
    QSet<QString> names;
    QSet<QString> codes{solution};
    for (const QString &name : knownNames(files, step, KnownKind::Mistake)) {
        names.insert(name);
        if (const auto own = programText(files, knownPath(step, KnownKind::Mistake, name)))
            codes.insert(withoutFirstComment(*own));
    }
    for (const QString &other : othersOf(stepsOf(files), step)) {
        for (const QString &name : knownNames(files, other, KnownKind::Mistake)) {
            if (names.contains(name))
                continue;
            const Result<QString> program = programFromDiff(diffOf(files, other, name), solution);
            if (!program || codes.contains(withoutFirstComment(*program)))
                continue;
            names.insert(name);
            codes.insert(withoutFirstComment(*program));
            const QString headline = firstCommentBlock(*program).section(QLatin1Char('\n'), 0, 0);
            found.push_back({other, name, headline, *program});
        }
    }
    return found;
}

Result<LabFiles> withOtherMistake(const LabFiles &files, const QString &step,
                                  const OtherMistake &mistake)
{
    Result<LabFiles> taken =
        withKnownAdded(files, step, KnownKind::Mistake, mistake.name, mistake.program);
    for (const QString &language : languagesOf(files).mid(1)) {
        const QString text =
            knownText(files, mistake.step, KnownKind::Mistake, mistake.name, language);
        if (taken && !text.isEmpty())
            taken = withKnownText(*taken, step, KnownKind::Mistake, mistake.name, language, text);
    }
    return taken;
}

} // namespace cradle
