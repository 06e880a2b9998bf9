// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// A formula in plain words, as it is read aloud: `v_1^2` becomes "v sub 1 squared", `\frac{a}{b}`
/// "a over b". What is not known is left as it is written, without its backslash.
/// \param tex  without the dollars
[[nodiscard]] QString spokenFormula(const QString &tex);

} // namespace cradle
