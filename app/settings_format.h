// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>

namespace cradle {

/// A format of QSettings, JSON, of which a file is written whole or not at all. With the formats
/// of Qt 6.4 a full disk leaves a file of no bytes, and nobody is told.
[[nodiscard]] QSettings::Format settingsFormat();

/// Fills settings that are still empty with those of an earlier version of Cradle.
void takeOlderSettings(QSettings &settings, const QSettings &older);

} // namespace cradle
