// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/platform_names.h"

#include <QRegularExpression>

namespace cradle {

namespace {

const auto withAnything = QRegularExpression::DotMatchesEverythingOption;

std::optional<PlatformName> moodleName(const QString &name)
{
    static const QRegularExpression form(
        QStringLiteral("^(.+)_([0-9]+)_assignsubmission_(file|onlinetext)(?:_(.*))?$"),
        withAnything);
    const auto match = form.match(name);
    if (!match.hasMatch())
        return std::nullopt;
    const bool isWork = match.captured(3) == QLatin1String("file");
    return PlatformName{.platform = Platform::Moodle,
                        .student = match.captured(1),
                        .number = match.captured(2),
                        .file = isWork ? match.captured(4) : QString()};
}

std::optional<PlatformName> blackboardName(const QString &name)
{
    static const QRegularExpression form(
        QStringLiteral("^(.*)_([^_]+)_attempt_([0-9]{4}(?:-[0-9]{2}){5})(?:_(.+)|\\.txt)?$"),
        withAnything);
    const auto match = form.match(name);
    if (!match.hasMatch())
        return std::nullopt;
    return PlatformName{.platform = Platform::Blackboard,
                        .student = match.captured(2),
                        .number = match.captured(2),
                        .assignment = match.captured(1),
                        .attempt = match.captured(3),
                        .file = match.captured(4)};
}

std::optional<PlatformName> canvasName(const QString &name)
{
    static const QRegularExpression form(QStringLiteral("^([^_]+)_(LATE_)?([0-9]+)_([0-9]+)_(.+)$"),
                                         withAnything);
    const auto match = form.match(name);
    if (!match.hasMatch())
        return std::nullopt;
    return PlatformName{.platform = Platform::Canvas,
                        .student = match.captured(1),
                        .number = match.captured(3),
                        .file = match.captured(5),
                        .late = !match.captured(2).isEmpty()};
}

/// The words before a `_`, with it, that all have in front and that leave something of each.
QString commonWords(const QStringList &heads)
{
    QString common = heads.front().left(heads.front().lastIndexOf(u'_') + 1);
    for (const QString &head : heads) {
        while (!common.isEmpty() && !head.startsWith(common))
            common = common.left(common.chopped(1).lastIndexOf(u'_') + 1);
    }
    return common;
}

/// The longest end of \p head after a `_` that is \p known; empty if there is none.
QString knownEnd(const QString &head, const QSet<QString> &known)
{
    for (auto at = head.indexOf(u'_'); at >= 0; at = head.indexOf(u'_', at + 1)) {
        const QString end = head.mid(at + 1);
        if (known.contains(end.toCaseFolded()))
            return end;
    }
    return {};
}

} // namespace

BlackboardAccounts blackboardAccounts(const QStringList &heads, const QSet<QString> &known)
{
    BlackboardAccounts accounts;
    QStringList each = heads;
    if (each.removeDuplicates(); each.size() > 1)
        accounts.common = commonWords(each);
    for (const QString &head : each) {
        QString &account = accounts.byHead[head];
        account = knownEnd(head, known);
        if (!account.isEmpty())
            continue;
        const auto from =
            accounts.common.isEmpty() ? head.lastIndexOf(u'_') + 1 : accounts.common.size();
        account = head.mid(from);
        accounts.isGuess = accounts.isGuess || head.count(u'_') > 1;
    }
    return accounts;
}

std::optional<PlatformName> platformName(const QString &name, bool isFolder)
{
    if (auto found = moodleName(name))
        return found;
    if (isFolder)
        return std::nullopt;
    auto found = blackboardName(name);
    return found ? found : canvasName(name);
}

QString platformText(Platform platform)
{
    switch (platform) {
    case Platform::Moodle:
        return QStringLiteral("Moodle");
    case Platform::Canvas:
        return QStringLiteral("Canvas");
    case Platform::Blackboard:
        return QStringLiteral("Blackboard");
    case Platform::GitHub:
        return QStringLiteral("GitHub");
    case Platform::None:
        break;
    }
    return {};
}

Platform platformFrom(const QString &text)
{
    for (const Platform each :
         {Platform::Moodle, Platform::Canvas, Platform::Blackboard, Platform::GitHub}) {
        if (platformText(each) == text)
            return each;
    }
    return Platform::None;
}

} // namespace cradle
