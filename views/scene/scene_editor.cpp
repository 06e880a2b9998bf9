// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_editor.h"

#include "views/circle_edits.h"
#include "views/circle_name.h"
#include "views/scene/handles.h"

#include <cmath>

namespace cradle {

SceneEditor::SceneEditor(PresetDocument &document, QObject *parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document.simulation(), &Simulation::presetChanged, this,
            &SceneEditor::keepSelectionValid);
}

int SceneEditor::circleCount() const
{
    return static_cast<int>(preset().circles.size());
}

bool SceneEditor::commit(const QString &text, const Preset &changed, const QString &mergeKey)
{
    if (const std::optional<Error> fault = m_document.faultOf(changed)) {
        emit noticed(fault->message);
        return false;
    }
    const Preset before = preset();
    if (!m_document.edit(text, changed, mergeKey))
        return false;
    noticeOverruled(before);
    return true;
}

/// A program may set in on_load what was just edited.
void SceneEditor::noticeOverruled(const Preset &before)
{
    const Preset &runs = m_document.simulation().preset();
    for (std::size_t i = 0; i < runs.circles.size() && i < before.circles.size(); ++i) {
        const Circle &edited = preset().circles[i].body;
        if (edited == before.circles[i].body || edited == runs.circles[i].body)
            continue;
        emit noticed(tr("Your program sets this circle in on_load; change it there"));
        return;
    }
}

void SceneEditor::select(int index)
{
    const int valid = index >= 0 && index < circleCount() ? index : -1;
    if (valid == m_selected)
        return;
    m_selected = valid;
    emit selectionChanged(valid);
}

void SceneEditor::keepSelectionValid()
{
    if (m_selected >= circleCount())
        select(-1);
}

void SceneEditor::addCircle(Vec2 at)
{
    const Preset changed = withAddedCircle(preset(), at);
    if (commit(tr("Add %1").arg(shownCircleName(changed.circles.back().name)), changed))
        select(circleCount() - 1);
}

void SceneEditor::duplicateSelected()
{
    if (m_selected < 0)
        return;
    if (commit(tr("Duplicate %1").arg(circleName(preset(), m_selected)),
               withDuplicate(preset(), m_selected)))
        select(circleCount() - 1);
}

void SceneEditor::removeSelected()
{
    if (m_selected < 0)
        return;
    const int removed = m_selected;
    commit(tr("Remove %1").arg(circleName(preset(), removed)), withoutCircle(preset(), removed));
    select(-1);
}

void SceneEditor::stopSelected()
{
    if (m_selected < 0)
        return;
    Preset changed = preset();
    changed.fill.reset();
    changed.circles[static_cast<std::size_t>(m_selected)].body.velocity = {};
    commit(tr("Set velocity of %1 to zero").arg(circleName(preset(), m_selected)), changed);
}

void SceneEditor::nudgeSelected(Vec2 by)
{
    if (m_selected < 0)
        return;
    if (!m_document.simulation().atStart()) {
        emit noticed(tr("Press Restart (R) to change the start"));
        return;
    }
    Preset changed = preset();
    changed.fill.reset();
    Vec2 &position = changed.circles[static_cast<std::size_t>(m_selected)].body.position;
    // Hundredths stay hundredths however often they are added up.
    const auto added = [](double value, double step) {
        const double sum = value + step;
        const double rounded = std::round(sum * 1e6) / 1e6;
        return step == 0.0 ? value : rounded;
    };
    position = {added(position.x, by.x), added(position.y, by.y)};
    position = withinWalls(changed, m_selected);
    commit(tr("Move %1").arg(circleName(preset(), m_selected)), changed,
           QStringLiteral("scene nudge %1").arg(m_selected));
}

} // namespace cradle
