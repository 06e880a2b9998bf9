// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/nearest_name.h"

#include <algorithm>
#include <vector>

namespace cradle {

namespace {

/// Of so many letters one may be wrong; at least one, at most three.
constexpr int lettersPerSlip = 3;
/// Longer ones are no names that a person writes; comparing them would take long.
constexpr qsizetype longestName = 64;
/// The shortest beginning of a name that is taken for it ("pos" for "position").
constexpr int shortestAbbreviation = 3;

bool abbreviates(const QString &name, const QString &known)
{
    return name.size() >= shortestAbbreviation && known.startsWith(name, Qt::CaseInsensitive);
}

} // namespace

int editDistance(const QString &a, const QString &b)
{
    if (std::max(a.size(), b.size()) > longestName)
        return static_cast<int>(std::max(a.size(), b.size()));
    const auto columns = static_cast<std::size_t>(b.size()) + 1;
    std::vector<int> before(columns);
    std::vector<int> last(columns);
    std::vector<int> row(columns);
    for (std::size_t j = 0; j < columns; ++j)
        last[j] = static_cast<int>(j);
    for (qsizetype i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (qsizetype j = 1; j <= b.size(); ++j) {
            const auto c = static_cast<std::size_t>(j);
            const int change = a[i - 1] == b[j - 1] ? 0 : 1;
            row[c] = std::min({last[c] + 1, row[c - 1] + 1, last[c - 1] + change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[c] = std::min(row[c], before[c - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[columns - 1];
}

QString nearestName(const QString &name, const QStringList &known)
{
    if (name.size() > longestName)
        return {};
    const int slips = std::clamp(static_cast<int>(name.size()) / lettersPerSlip, 1, 3);
    QString nearest;
    int best = slips + 1;
    for (const QString &candidate : known) {
        // A slip of the shift key is no slip at all.
        const int distance = std::min(editDistance(name, candidate),
                                      editDistance(name.toLower(), candidate.toLower()) + 1);
        // One letter for another in a name of one letter is another name.
        const bool alike =
            distance < candidate.size() || name.compare(candidate, Qt::CaseInsensitive) == 0;
        if (distance < best && alike) {
            best = distance;
            nearest = candidate;
        }
    }
    if (!nearest.isEmpty())
        return nearest;
    const auto found = std::find_if(known.begin(), known.end(), [&](const QString &candidate) {
        return abbreviates(name, candidate);
    });
    return found == known.end() ? QString() : *found;
}

} // namespace cradle
