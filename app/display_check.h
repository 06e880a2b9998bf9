// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// Why no window can be opened here, in one line with what to do; empty if one can. To be asked
/// before QApplication is made, which would abort.
QString missingDisplay(int argc, char **argv);

} // namespace cradle
