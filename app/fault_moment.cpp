// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/fault_moment.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

/// How far the reference's run reaches beyond the moment shown, s of the scene.
constexpr double ghostSeconds = 10.0;

} // namespace

FaultMoment::FaultMoment(const LabPlace &place, PresetDocument &document, CodeSession &code)
    : m_place(place)
    , m_document(document)
    , m_code(code)
{
    connect(&document, &PresetDocument::visitingChanged, this, [this](bool visiting) {
        if (visiting)
            return;
        m_code.run().setPinned(false);
        forgetGhost();
    });
    connect(&m_reference, &ReferenceRun::finished, this, &FaultMoment::setGhost);
}

bool FaultMoment::isShown() const
{
    const Simulation &simulation = m_document.simulation();
    return m_document.isVisiting() && simulation.recording().step(simulation.current()) == m_step;
}

void FaultMoment::forgetGhost()
{
    setGhost(nullptr);
}

void FaultMoment::setGhost(std::shared_ptr<const Recording> ghost)
{
    m_reference.cancel();
    if (ghost == m_ghost)
        return;
    m_ghost = std::move(ghost);
    emit ghostChanged();
}

void FaultMoment::show(const CheckOutcome &outcome)
{
    if (!outcome.scene)
        return;
    m_step = std::max<qint64>(0, outcome.step);
    if (*outcome.scene == m_document.own() && !outcome.pinned) {
        m_document.leave();
    } else {
        m_code.run().setPinned(outcome.pinned);
        m_document.visit(*outcome.scene);
    }
    m_document.simulation().goTo(m_step);
    forgetGhost(); // of another moment
    if (!m_place.task() || m_place.task()->solution.isEmpty())
        return;
    const double seconds = static_cast<double>(m_step) * outcome.scene->timestep + ghostSeconds;
    m_reference.start({outcome.variant, *outcome.scene, seconds, outcome.pinned},
                      m_place.task()->solution);
}

} // namespace cradle
