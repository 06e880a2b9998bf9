// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How SceneView is looked at: the part of the scene that it shows.
#include "views/scene/scene_view.h"

#include "model/world/measurements.h"

namespace cradle {

namespace {

constexpr double zoomStep = 1.25;
constexpr double arrowsRoom = 2.0; ///< of what the loupe shows: the arrows of a hit are longer

} // namespace

void SceneView::followPreset()
{
    const double halfWidth = m_document.preset().halfWidth;
    if (halfWidth != m_camera.fittedTo()) {
        m_camera.fit(halfWidth);
        m_followed = {};
    }
    if (m_hovered.index >= m_editor.circleCount())
        m_hovered = {};
    refresh();
}

void SceneView::followCentreOfMass(bool on)
{
    m_follows = on;
    m_followed = m_camera.centre();
    refresh();
    emit toldToShow();
}

void SceneView::followCamera()
{
    const Simulation &simulation = m_document.simulation();
    const auto circles = simulation.recording().circles(simulation.current());
    // While a circle is dragged the scene under the pointer must not move.
    if (!m_follows || m_drag || circles.empty())
        return;
    const Vec2 centre = centreOfMass(circles);
    m_camera.moveBy(centre - m_followed);
    m_followed = centre;
}

void SceneView::fit()
{
    m_camera.fit(m_document.preset().halfWidth);
    m_followed = {};
    refresh();
}

void SceneView::zoomIn()
{
    m_camera.zoomAbout(m_camera.middle(), zoomStep);
    refresh();
}

void SceneView::zoomOut()
{
    m_camera.zoomAbout(m_camera.middle(), 1.0 / zoomStep);
    refresh();
}

void SceneView::zoomToHit()
{
    const auto camera = cameraAtHit(moment(), m_editor.selected(), size());
    if (!camera)
        return notice(tr("No hit at this moment: N goes on to the next one"));
    m_camera.zoomAbout(m_camera.middle(), m_camera.extent() / (arrowsRoom * camera->extent()));
    m_camera.moveBy(camera->centre() - m_camera.centre());
    const Simulation &simulation = m_document.simulation();
    m_followed = centreOfMass(simulation.recording().circles(simulation.current()));
    refresh();
}

} // namespace cradle
