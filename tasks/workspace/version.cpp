// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/version.h"

#include <array>

namespace cradle {

namespace {

struct ReasonName {
    VersionReason reason;
    const char *name;    ///< in a trailer
    const char *subject; ///< what git log says
};

// In English whatever the window speaks: a history is read on other machines, too.
constexpr std::array reasons{
    ReasonName{VersionReason::Typed, "typed", "work in progress"},
    ReasonName{VersionReason::Checked, "check", "checked"},
    ReasonName{VersionReason::Before, "before", "before it was replaced"},
    ReasonName{VersionReason::Outside, "outside", "changed by another program"},
    ReasonName{VersionReason::Unsaved, "unsaved", "typed in a window that does not save"}};

const ReasonName &named(VersionReason reason)
{
    for (const ReasonName &each : reasons) {
        if (each.reason == reason)
            return each;
    }
    return reasons.front();
}

QString trailersOf(const QString &taskId, const VersionNote &note)
{
    QString text = QStringLiteral("Cradle-Step: %1\n").arg(taskId);
    text += QStringLiteral("Cradle-Reason: %1\n").arg(QLatin1String(named(note.reason).name));
    if (note.passed) {
        text += QStringLiteral("Cradle-Verdict: %1\nCradle-Seed: %2\nCradle-Lab-Hash: %3\n")
                    .arg(*note.passed ? QStringLiteral("passed") : QStringLiteral("not passed"))
                    .arg(note.seed)
                    .arg(note.labHash);
    }
    for (const QString &finding : note.findings)
        text += QStringLiteral("Cradle-Finding: %1\n").arg(finding.simplified());
    return text;
}

QStringList trailers(const QString &message, const QString &key)
{
    QStringList values;
    const QString start = key + QStringLiteral(": ");
    for (const QString &line : message.split(QLatin1Char('\n'))) {
        if (line.startsWith(start))
            values.append(line.mid(start.size()).trimmed());
    }
    return values;
}

} // namespace

QString trailerOf(const QString &message, const QString &key)
{
    const QStringList values = trailers(message, key);
    return values.isEmpty() ? QString() : values.last();
}

QString versionMessage(const QString &taskId, const VersionNote &note)
{
    QString subject = QLatin1String(named(note.reason).subject);
    if (note.passed)
        subject += *note.passed ? QStringLiteral(", passed") : QStringLiteral(", not passed");
    return QStringLiteral("%1: %2\n\n%3").arg(taskId, subject, trailersOf(taskId, note));
}

QString passMessage(const QString &taskId, const QString &subject, const VersionNote &note)
{
    return subject.simplified() + QStringLiteral("\n\n") + trailersOf(taskId, note);
}

VersionNote versionNote(const QString &message)
{
    VersionNote note;
    const QString reason = trailerOf(message, QStringLiteral("Cradle-Reason"));
    for (const ReasonName &each : reasons) {
        if (reason == QLatin1String(each.name))
            note.reason = each.reason;
    }
    const QString verdict = trailerOf(message, QStringLiteral("Cradle-Verdict"));
    if (verdict == QLatin1String("passed") || verdict == QLatin1String("not passed"))
        note.passed = verdict == QLatin1String("passed");
    note.seed = trailerOf(message, QStringLiteral("Cradle-Seed")).toLongLong();
    note.labHash = trailerOf(message, QStringLiteral("Cradle-Lab-Hash"));
    note.findings = trailers(message, QStringLiteral("Cradle-Finding"));
    return note;
}

} // namespace cradle
