// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

QT_BEGIN_NAMESPACE
class QAbstractScrollArea;
QT_END_NAMESPACE

namespace cradle {

/// Draws a ring over what \p area shows while it has the focus, unless a click gave it: for texts
/// and pages, which have no frame that could tell.
void ringFocus(QAbstractScrollArea *area);

} // namespace cradle
