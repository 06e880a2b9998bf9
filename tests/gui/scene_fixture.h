// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/simulation.h"
#include "tests/patience.h"
#include "tests/scene_lists.h"
#include "views/preset_document.h"
#include "views/scene/scene_view.h"

#include <QMouseEvent>
#include <QTest>

namespace cradle::scenes {

/// A scene of two circles in a window of its own.
struct Scene {
    Simulation simulation{twoCircles()};
    PresetDocument document{simulation};
    SceneView view{document};

    Scene()
    {
        view.resize(700, 700);
        view.show();
        (void)QTest::qWaitForWindowExposed(&view, patience);
        view.activateWindow();
        view.setFocus();
        (void)QTest::qWaitForWindowActive(&view,
                                          patience); // shortcuts hold in the active window only
    }

    [[nodiscard]] const Circle &circle(int index) const
    {
        return document.preset().circles[static_cast<std::size_t>(index)].body;
    }
    [[nodiscard]] QPoint pixel(Vec2 place) const { return view.camera().toPixels(place).toPoint(); }

    /// QTest::mouseMove() tells no buttons.
    void moveTo(QPointF at, Qt::KeyboardModifiers keys = {})
    {
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                         keys);
        QCoreApplication::sendEvent(&view, &move);
    }
    void moveTo(Vec2 place, Qt::KeyboardModifiers keys = {})
    {
        moveTo(view.camera().toPixels(place), keys);
    }
    void press(Vec2 place) { QTest::mousePress(&view, Qt::LeftButton, {}, pixel(place)); }
    void release(Vec2 place) { QTest::mouseRelease(&view, Qt::LeftButton, {}, pixel(place)); }
    void drag(Vec2 from, Vec2 to)
    {
        press(from);
        moveTo(from + 0.5 * (to - from));
        moveTo(to);
        release(to);
    }
    [[nodiscard]] QStringList chips()
    {
        QStringList texts;
        for (const Chip &chip : view.picture().chips) {
            texts << chip.text;
            if (!chip.detail.isEmpty())
                texts << chip.detail;
        }
        return texts;
    }
};

} // namespace cradle::scenes
