// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"
#include "views/frame_throttle.h"

#include <QApplication>
#include <QTest>

namespace cradle {

/// Waits until every view that is seen shows the newest state, and what was posted is done.
inline void settle()
{
    const auto isSettled = [] {
        for (const QWidget *widget : QApplication::allWidgets()) {
            const auto throttles =
                widget->findChildren<FrameThrottle *>(QString(), Qt::FindDirectChildrenOnly);
            for (const FrameThrottle *throttle : throttles) {
                if (throttle->isHoldingBack())
                    return false;
            }
        }
        return true;
    };
    QCoreApplication::processEvents();
    QVERIFY(QTest::qWaitFor(isSettled, patience));
    QCoreApplication::processEvents();
}

} // namespace cradle
