// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/gui/settled.h"
#include "tests/patience.h"
#include "views/markdown_view.h"

#include <QDataStream>

#include <algorithm>

namespace cradle {

/// Whether every text with formulas that is seen in \p window has them.
inline bool areTextsComplete(const QWidget &window)
{
    const auto texts = window.findChildren<MarkdownView *>();
    return std::all_of(texts.begin(), texts.end(), [](const MarkdownView *each) {
        return !each->isVisible() || each->isComplete();
    });
}

/// Where everything in \p window is.
inline QByteArray placesIn(const QWidget &window)
{
    QByteArray all;
    QDataStream stream(&all, QIODevice::WriteOnly);
    for (const auto *each : window.findChildren<QWidget *>())
        stream << quintptr(each) << each->geometry() << each->isVisible();
    return all;
}

/// Waits until no text in \p window is still to come and every widget has its place.
inline void calm(const QWidget &window)
{
    int rounds = 0; // one layout asks for another
    QByteArray before;
    const auto isCalm = [&] {
        settle();
        QByteArray now = placesIn(window);
        rounds = now == before && areTextsComplete(window) ? rounds + 1 : 0;
        before.swap(now);
        return rounds >= 3;
    };
    QVERIFY(QTest::qWaitFor(isCalm, patience));
}

} // namespace cradle
