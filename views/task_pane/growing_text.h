// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

QT_BEGIN_NAMESPACE
class QTextBrowser;
QT_END_NAMESPACE

namespace cradle {

/// Gives \p view the height of its text, always, so that what holds it scrolls.
void growWithText(QTextBrowser *view);

} // namespace cradle
