// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// How SceneView is looked at: the part of the scene that it shows.
#include "views/scene/scene_view.h"

#include "model/measurements.h"

namespace cradle {

namespace {

constexpr double zoomStep = 1.25;

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

} // namespace cradle
