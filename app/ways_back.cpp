// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ways_back.h"

namespace cradle {

WaysBack::WaysBack(const LabPlace &place, PresetDocument &document, CodeSession &code,
                   const KeptProgress &progress)
    : m_place(place)
    , m_document(document)
    , m_code(code)
    , m_progress(progress)
{
}

std::optional<QString> WaysBack::newestVersion() const
{
    const History *history = m_place.task() ? m_code.workspace().history() : nullptr;
    const auto newest = history ? history->versions(m_place.task()->id, 1) : std::vector<Version>();
    if (newest.empty())
        return std::nullopt;
    const auto text = history->textOf(newest.front());
    return text ? std::optional(QString::fromUtf8(*text)) : std::nullopt;
}

void WaysBack::takeNewestVersion()
{
    const auto text = newestVersion();
    if (!text)
        return;
    setProgramAside();
    m_code.replace(*text);
    m_code.save();
}

void WaysBack::convertProgram()
{
    if (m_place.task())
        m_code.replaceForeign(m_place.lab, m_place.current, true);
}

void WaysBack::setProgramAside()
{
    if (m_place.task())
        m_code.replaceForeign(m_place.lab, m_place.current, false);
}

std::optional<Preset> WaysBack::passedScene() const
{
    const Task *task = m_place.task();
    if (!task || m_code.run().isActive() || !m_progress.isPassed(*task))
        return std::nullopt;
    const std::optional<Preset> scene = m_code.workspace().passedScene(task->id);
    return scene && *scene != m_document.own() ? scene : std::nullopt;
}

void WaysBack::takePassedScene()
{
    if (const auto scene = passedScene())
        m_document.edit(tr("Back to the scene that passed"), *scene);
}

void WaysBack::startAfresh()
{
    if (m_place.task())
        m_code.replace(m_code.workspace().startOf(m_place.lab, m_place.current));
}

const Task *WaysBack::missedTask() const
{
    if (m_place.current <= 0 || !m_code.isEditable())
        return nullptr;
    const Task &before = m_place.lab.tasks[static_cast<std::size_t>(m_place.current) - 1];
    const Task &open = *m_place.task();
    const bool builds = !before.solution.isEmpty() && before.solution == open.starter;
    return builds && !m_progress.isPassed(before) && !m_code.workspace().has(before.id)
                   && !m_code.workspace().has(open.id)
               ? &before
               : nullptr;
}

void WaysBack::startFromSolution()
{
    if (const Task *before = missedTask())
        m_code.replace(before->solution);
}

} // namespace cradle
