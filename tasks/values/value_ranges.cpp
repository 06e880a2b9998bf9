// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/values/value_ranges.h"

#include "tasks/values/lab_values.h"

#include <QJsonDocument>
#include <QSet>

#include <algorithm>

namespace cradle {

namespace {

constexpr int mostCandidates = 500; ///< numbers of students that are looked at

/// A range as it is written, and what was drawn of it.
struct Range {
    QString step;
    QString name;
    int count = 0;
    double last = 0.0; ///< the value at its end
    QSet<double> drawn{};
};

/// The ranges of the file "lab.json" or "STEP/task.json".
void addRanges(const LabFiles &files, const QString &path, std::vector<Range> &ranges)
{
    const QJsonObject values = QJsonDocument::fromJson(files.contents.value(path))
                                   .object()
                                   .value(QStringLiteral("values"))
                                   .toObject();
    const auto slash = path.indexOf(QLatin1Char('/'));
    for (auto it = values.begin(); it != values.end(); ++it) {
        if (const int count = countOfRange(it->toObject()); count > 0)
            ranges.push_back({.step = slash < 0 ? QString() : path.left(slash),
                              .name = it.key(),
                              .count = count,
                              .last = numberOfRange(it->toObject(), count - 1)});
    }
}

std::vector<Range> rangesOf(const LabFiles &files)
{
    std::vector<Range> ranges;
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        if (it.key() == QLatin1String("lab.json") || it.key().endsWith(QLatin1String("/task.json")))
            addRanges(files, it.key(), ranges);
    }
    return ranges;
}

/// What the student draws of each range. A step that names a value of the lab anew hides it there.
std::vector<double> drawnBy(const LabFiles &files, const std::vector<Range> &ranges,
                            const QString &student)
{
    QMap<QString, Values> steps;
    std::vector<double> drawn;
    for (const Range &range : ranges) {
        if (!steps.contains(range.step))
            steps.insert(range.step, valuesOf(files, range.step, student));
        drawn.push_back(steps.value(range.step).value(range.name));
    }
    return drawn;
}

void take(std::vector<Range> &ranges, const std::vector<double> &drawn)
{
    for (std::size_t i = 0; i < ranges.size(); ++i)
        ranges[i].drawn.insert(drawn[i]);
}

} // namespace

std::vector<TriedRange> triedRanges(const LabFiles &files, const QStringList &students)
{
    std::vector<Range> ranges = rangesOf(files);
    for (const QString &student : QStringList{QString()} + students)
        take(ranges, drawnBy(files, ranges, student));
    std::vector<TriedRange> tried;
    for (const Range &range : ranges) {
        const auto [least, most] = std::minmax_element(range.drawn.begin(), range.drawn.end());
        tried.push_back({range.step, range.name, range.count, static_cast<int>(range.drawn.size()),
                         *least, *most});
    }
    return tried;
}

QStringList studentsToTry(const LabFiles &files, int least, int most)
{
    std::vector<Range> ranges = rangesOf(files);
    if (ranges.empty())
        return {};
    take(ranges, drawnBy(files, ranges, {}));
    QList<std::vector<double>> candidates;
    for (int i = 1; i <= mostCandidates; ++i)
        candidates.append(drawnBy(files, ranges, QString::number(i)));
    QList<int> chosen;
    // Takes whoever brings something that \p counts, and that nobody has brought yet.
    const auto choose = [&](auto counts) {
        for (int i = 0; i < candidates.size() && chosen.size() < most; ++i) {
            bool isNew = false;
            for (std::size_t r = 0; r < ranges.size(); ++r)
                isNew = isNew
                        || (counts(ranges[r], candidates[i][r])
                            && !ranges[r].drawn.contains(candidates[i][r]));
            if (!isNew)
                continue;
            chosen.append(i);
            take(ranges, candidates[i]);
        }
    };
    choose([](const Range &range, double value) { return value == range.last; });
    choose([](const Range &, double) { return true; });
    for (int i = 0; i < candidates.size() && chosen.size() < least; ++i) {
        if (!chosen.contains(i))
            chosen.append(i);
    }
    std::sort(chosen.begin(), chosen.end());
    QStringList students;
    for (const int i : chosen)
        students.append(QString::number(i + 1));
    return students;
}

} // namespace cradle
