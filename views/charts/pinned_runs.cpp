// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/pinned_runs.h"

#include "views/number_text.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

constexpr qsizetype toldDifferences = 2; ///< the rest is counted

} // namespace

QString PinnedRun::name() const
{
    return PinnedRuns::tr("pinned %1", "a run").arg(number);
}

QString PinnedRun::text(const RunSource &now) const
{
    if (branch > 0.0)
        return PinnedRuns::tr("%1: how it went on after %2 s", "kept run, moment")
            .arg(name(), shortNumber(branch));
    const QStringList all = differences(source, now);
    if (all.isEmpty())
        return PinnedRuns::tr("%1: the same scene and program").arg(name());
    QString told = all.mid(0, toldDifferences).join(QStringLiteral(", "));
    if (all.size() > toldDifferences)
        told =
            PinnedRuns::tr("%1 and %n more", nullptr, static_cast<int>(all.size()) - 2).arg(told);
    return QStringLiteral("%1: %2").arg(name(), told);
}

QString PinnedRun::details(const RunSource &now) const
{
    const QStringList all = differences(source, now);
    return branch > 0.0 || all.isEmpty() ? text(now) : all.join(QLatin1Char('\n'));
}

double PinnedRuns::end() const
{
    double end = 0.0;
    for (const PinnedRun &run : m_runs)
        end = std::max(end, run.curves.total().lastTime() - run.branch);
    return end;
}

PinnedRun PinnedRuns::keep(const CurveSet &curves, const Recording &recording,
                           const RunSource &source, double branch)
{
    return {.source = source,
            .branch = branch,
            .curves = curves.within(curveBytes),
            .recording = newestPart(recording, recordingBytes)};
}

void PinnedRuns::add(PinnedRun run)
{
    if (isFull())
        m_runs.erase(m_runs.begin());
    run.number = freeNumber();
    m_runs.push_back(std::move(run));
    emit changed();
}

void PinnedRuns::setNow(const RunSource &source)
{
    m_now = source;
    if (!m_runs.empty())
        emit changed();
}

void PinnedRuns::remove(int number)
{
    std::erase_if(m_runs, [number](const PinnedRun &run) { return run.number == number; });
    emit changed();
}

void PinnedRuns::clear()
{
    m_runs.clear();
    emit changed();
}

int PinnedRuns::freeNumber() const
{
    int number = 1;
    while (std::any_of(m_runs.begin(), m_runs.end(),
                       [number](const PinnedRun &run) { return run.number == number; }))
        ++number;
    return number;
}

Qt::PenStyle pinDash(int number)
{
    constexpr std::array dashes{Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    return dashes[static_cast<std::size_t>(std::max(1, number) - 1) % dashes.size()];
}

Recording newestPart(const Recording &recording, qint64 maxBytes)
{
    Recording part(maxBytes);
    std::size_t hit = 0;
    std::vector<Hit> hits;
    for (qint64 i = recording.first(); i <= recording.last(); ++i) {
        hits.clear();
        const auto &all = recording.hits();
        for (; hit < all.size() && all[hit].step <= recording.step(i); ++hit)
            hits.push_back(all[hit]);
        part.append(recording.world(i), hits);
    }
    return part;
}

} // namespace cradle
