// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <QByteArray>
#include <QStringList>

namespace cradle {

/// Reads a preset file; an Error names the file and the JSON pointer (or the line).
Result<Preset> readPreset(const QString &path);

/// The same from text; \p source is the file's name for messages.
Result<Preset> parsePreset(const QByteArray &text, const QString &source = {});

/// The preset as JSON: keys in the order of the format, numbers with the fewest digits that read
/// back to the same double, so that reading and writing again gives the same bytes.
QByteArray writePreset(const Preset &preset);

/// Writes a preset whole or not at all. \return what kept it from being written
std::optional<Error> savePreset(const Preset &preset, const QString &path);

/// The names of the file format.
QString toName(WallLaw law);
QString toName(CircleLaw law);
QString toName(Timing timing);
QString toName(Integrator integrator);

/// What has that name in the file format; nullopt if nothing has.
std::optional<CircleLaw> circleLawFromName(const QString &name);
std::optional<Timing> timingFromName(const QString &name);
std::optional<Integrator> integratorFromName(const QString &name);

/// All names of that kind in the file format, in the order of the enumeration.
QStringList allWallLawNames();
QStringList allCircleLawNames();
QStringList allTimingNames();
QStringList allIntegratorNames();

} // namespace cradle
