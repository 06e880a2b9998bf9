// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_editor.h"

#include "views/circle_clipboard.h"
#include "views/circle_edits.h"
#include "views/circle_name.h"
#include "views/scene/handles.h"

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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

void SceneEditor::setSelection(std::vector<int> selection, int selected)
{
    if (selection == m_selection && selected == m_selected)
        return;
    m_selection = std::move(selection);
    m_selected = selected;
    emit selectionChanged(selected);
}

bool SceneEditor::isSelected(int index) const
{
    return std::binary_search(m_selection.begin(), m_selection.end(), index);
}

void SceneEditor::select(int index)
{
    if (index >= 0 && index < circleCount())
        setSelection({index}, index);
    else
        setSelection({}, -1);
}

void SceneEditor::toggle(int index)
{
    if (!isSelected(index)) {
        addToSelection({index});
        return;
    }
    std::vector<int> rest = m_selection;
    rest.erase(std::find(rest.begin(), rest.end(), index));
    const int last = rest.empty() ? -1 : rest.back();
    setSelection(std::move(rest), m_selected == index ? last : m_selected);
}

void SceneEditor::addToSelection(const std::vector<int> &indices)
{
    std::set<int> all(m_selection.begin(), m_selection.end());
    int last = m_selected;
    for (const int index : indices) {
        if (index < 0 || index >= circleCount())
            continue;
        all.insert(index);
        last = index;
    }
    setSelection({all.begin(), all.end()}, last);
}

void SceneEditor::selectAll()
{
    selectFrom(0);
}

void SceneEditor::selectFrom(int first)
{
    std::vector<int> all;
    for (int i = first; i < circleCount(); ++i)
        all.push_back(i);
    const int last = all.empty() ? -1 : all.back();
    setSelection(std::move(all), last);
}

void SceneEditor::keepSelectionValid()
{
    std::vector<int> valid = m_selection;
    valid.erase(std::lower_bound(valid.begin(), valid.end(), circleCount()), valid.end());
    const int last = valid.empty() ? -1 : valid.back();
    setSelection(std::move(valid), m_selected < circleCount() ? m_selected : last);
}

QString SceneEditor::subject() const
{
    const auto count = static_cast<int>(m_selection.size());
    return count == 1 ? circleName(preset(), m_selected) : tr("%n circles", nullptr, count);
}

void SceneEditor::addCircle(Vec2 at)
{
    const Preset changed = withAddedCircle(preset(), at);
    if (commit(tr("Add %1").arg(shownCircleName(changed.circles.back().name)), changed))
        select(circleCount() - 1);
}

void SceneEditor::duplicateSelected()
{
    if (m_selection.empty())
        return;
    const int first = circleCount();
    if (commit(tr("Duplicate %1").arg(subject()), withDuplicates(preset(), m_selection)))
        selectFrom(first);
}

void SceneEditor::removeSelected()
{
    if (m_selection.empty())
        return;
    commit(tr("Remove %1").arg(subject()), withoutCircles(preset(), m_selection));
    select(-1);
}

void SceneEditor::stopSelected()
{
    if (m_selection.empty())
        return;
    Preset changed = preset();
    changed.fill.reset();
    for (const int index : m_selection)
        changed.circles[static_cast<std::size_t>(index)].body.velocity = {};
    commit(tr("Set velocity of %1 to zero").arg(subject()), changed);
}

void SceneEditor::nudgeSelected(Vec2 by)
{
    if (m_selection.empty())
        return;
    if (!m_document.simulation().atStart()) {
        emit noticed(tr("Press Restart (R) to change the start"));
        return;
    }
    Preset changed = preset();
    changed.fill.reset();
    // Hundredths stay hundredths however often they are added up.
    const auto added = [](double value, double step) {
        const double rounded = std::round((value + step) * 1e6) / 1e6;
        return step == 0.0 ? value : rounded;
    };
    const Vec2 way = withinReach(changed, m_selection, by);
    for (const int index : m_selection) {
        Vec2 &position = changed.circles[static_cast<std::size_t>(index)].body.position;
        position = {added(position.x, way.x), added(position.y, way.y)};
        position = withinWalls(changed, index);
    }
    commit(tr("Move %1").arg(subject()), changed,
           QStringLiteral("scene nudge %1 of %2").arg(m_selected).arg(m_selection.size()));
}

void SceneEditor::copySelected()
{
    if (!m_selection.empty())
        QGuiApplication::clipboard()->setText(circlesText(preset(), m_selection));
}

void SceneEditor::cutSelected()
{
    copySelected();
    removeSelected();
}

void SceneEditor::paste()
{
    const auto circles = circlesFromText(QGuiApplication::clipboard()->text());
    if (!circles) {
        emit noticed(circles.error().message);
        return;
    }
    const int first = circleCount();
    const auto count = static_cast<int>(circles->size());
    const QString text = count == 1 ? tr("Paste a circle") : tr("Paste %n circles", nullptr, count);
    if (commit(text, withPasted(preset(), *circles)))
        selectFrom(first);
}

} // namespace cradle
