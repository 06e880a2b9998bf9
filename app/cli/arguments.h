// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QStringList>

namespace cradle::cli {

/// The arguments of the command line, without the program, as texts. A path whose bytes are no
/// UTF-8 cannot be a text: what it names is opened instead, and "/proc/self/fd/N" leads there.
/// Also in "--option=PATH".
/// \return an error for one that names nothing that is there
[[nodiscard]] Result<QStringList> textsOf(int argc, char **argv);

} // namespace cradle::cli
