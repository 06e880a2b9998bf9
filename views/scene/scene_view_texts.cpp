// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_view.h"

#include "model/world/measurements.h"

#include <algorithm>
#include <cmath>

namespace cradle {

// What the scene says in words: over the picture, and to those who do not see it.

namespace {

constexpr std::size_t mostDescribed = 20; ///< circles; a longer list helps nobody

QString metres(double length)
{
    return QString::number(length, length < 1000.0 ? 'f' : 'g', 3);
}

QString seconds(double time)
{
    return QString::number(time, 'f', 2);
}

} // namespace

QString SceneView::ghostText(const SceneMoment &moment) const
{
    if (moment.ghost.empty())
        return {};
    const auto circles = moment.recording.circles(moment.current);
    return tr("ghost: %1 · %2 m apart")
        .arg(m_ghostLabel, metres(greatestDistance(circles, moment.ghost)));
}

QString SceneView::exactText(const SceneMoment &moment) const
{
    const ShadowRun *shadow = m_document.simulation().shadow();
    const auto circles = moment.recording.circles(moment.current);
    if (!shadow || circles.empty())
        return {};
    if (circles.size() > ShadowRun::mostCircles)
        return tr("No exact motion beside more than %1 circles").arg(ShadowRun::mostCircles);
    if (!shadow->isPossible())
        return tr("No exact motion: the circles overlap or lie outside at the start");
    return tr("Exact motion; the run is %1 m off")
        .arg(metres(greatestDistance(circles, moment.exact)));
}

/// That the run is not exact any longer, though its timing says so.
QString SceneView::mergedText(const SceneMoment &moment) const
{
    const auto from = m_document.simulation().mergedFrom();
    return from && moment.recording.time(moment.current) >= *from
               ? tr("contacts merged from %1 s on").arg(seconds(*from))
               : QString();
}

std::vector<Chip> SceneView::chips(const SceneMoment &moment) const
{
    std::vector<Chip> chips;
    const Recording &recording = moment.recording;
    for (const QString &text : {mergedText(moment), exactText(moment), ghostText(moment)}) {
        if (!text.isEmpty())
            chips.push_back({.text = text, .row = static_cast<int>(chips.size())});
    }
    if (recording.hasDropped()) {
        const int seconds = static_cast<int>(std::lround(recording.time(recording.first())));
        chips.push_back({.text = seconds < 60 ? tr("first %1 s dropped").arg(seconds)
                                              : tr("first %1 min dropped").arg(seconds / 60),
                         .row = static_cast<int>(chips.size())});
    }
    if (m_editor.circleCount() == 0)
        chips.push_back({Chip::Place::Centre, m_emptyHint.isEmpty() ? tr(
                                                  "Add a circle: Edit → Add circle (Ctrl+Shift+N)")
                                                                    : m_emptyHint});
    if (!m_dragValue.isEmpty())
        chips.push_back({.place = Chip::Place::Pointer,
                         .text = m_dragValue,
                         .detail = m_refusal,
                         .warning = !m_refused.empty(),
                         .pointer = m_press.last});
    if (!m_notice.isEmpty())
        chips.push_back({.place = Chip::Place::Bottom,
                         .text = m_notice,
                         .warning = true,
                         .pointer = m_press.last});
    return chips;
}

void SceneView::describe()
{
    const Simulation &simulation = m_document.simulation();
    if (simulation.isRunning())
        return;
    const auto circles = simulation.recording().circles(simulation.current());
    QStringList parts;
    for (std::size_t i = 0; i < std::min(circles.size(), mostDescribed); ++i)
        parts << tr("%1 at %2 m with %3 m/s, radius %4 m")
                     .arg(circleName(m_document.preset(), static_cast<int>(i)),
                          pairText(circles[i].position), pairText(circles[i].velocity))
                     .arg(circles[i].radius);
    if (circles.size() > mostDescribed)
        parts << tr("and %n more", nullptr, static_cast<int>(circles.size() - mostDescribed));
    if (m_editor.selection().size() > 1)
        parts << tr("%n selected", nullptr, static_cast<int>(m_editor.selection().size()));
    else if (m_editor.selected() >= 0)
        parts << tr("selected: %1").arg(circleName(m_document.preset(), m_editor.selected()));
    const SceneMoment seen = moment();
    for (const QString &text : {mergedText(seen), exactText(seen), ghostText(seen)}) {
        if (!text.isEmpty())
            parts << text;
    }
    if (!m_notice.isEmpty())
        parts << m_notice;
    const QString all = circles.empty() ? tr("No circles") : parts.join(QStringLiteral("; "));
    if (all != accessibleDescription())
        setAccessibleDescription(all);
}

} // namespace cradle
