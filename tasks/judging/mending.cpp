// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/mending.h"

#include <QStringList>

#include <algorithm>

namespace cradle {

namespace {

/// What is wrong, and whose: a headline without the walls where it is, for each circle.
QStringList keysOf(const std::vector<LawDeviation> &deviations)
{
    QStringList keys;
    for (const LawDeviation &deviation : deviations) {
        const QString line = deviation.message.section(QLatin1Char('\n'), 0, 0);
        const bool both = line.contains(circleNames({0, 1}, 2), Qt::CaseInsensitive);
        QString stem = deviation.family.isEmpty() ? line : deviation.family;
        for (const std::vector<int> &circles : {std::vector{0, 1}, std::vector{0}, std::vector{1}})
            stem.remove(circleNames(circles, 2), Qt::CaseInsensitive);
        stem = stem.section(QLatin1Char(':'), 0, 0).section(QLatin1String(" ("), 0, 0);
        for (const int circle : {0, 1}) {
            const QString name = circleNames({circle}, 2);
            if (both || line.contains(name, Qt::CaseInsensitive))
                keys.append(stem + name);
        }
        if (!both && !line.contains(circleNames({0}, 2), Qt::CaseInsensitive)
            && !line.contains(circleNames({1}, 2), Qt::CaseInsensitive))
            keys.append(stem);
    }
    return keys;
}

int shownIn(const std::vector<LawDeviation> &deviations, const QStringList &keys)
{
    int shown = 0;
    for (const LawDeviation &deviation : deviations) {
        const QStringList own = keysOf({deviation});
        if (std::any_of(own.begin(), own.end(),
                        [&](const QString &key) { return keys.contains(key); }))
            shown += deviation.shown;
    }
    return shown;
}

} // namespace

Mending mendingOf(const LawDeviation &fault, const std::vector<LawDeviation> &before,
                  const std::vector<LawDeviation> &left)
{
    const QStringList known = keysOf(before);
    const QStringList now = keysOf(left);
    if (std::any_of(now.begin(), now.end(),
                    [&](const QString &key) { return !known.contains(key); }))
        return Mending::None;
    const QStringList own = keysOf({fault});
    if (std::none_of(own.begin(), own.end(), [&](const QString &key) { return now.contains(key); }))
        return Mending::All;
    return shownIn(left, own) < shownIn(before, own) ? Mending::Part : Mending::None;
}

} // namespace cradle
