// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace cradle {

/// A lab that can be opened, without its steps.
struct ListedLab {
    QString title;  ///< in the language asked for, where the lab has it
    QString folder; ///< a path, or a resource path
    QString id{};
    QString version{}; ///< empty if the lab does not say
};

/// The labs that ship with the program, Lab 4.2 first.
[[nodiscard]] std::vector<ListedLab> shippedLabs(const QString &language);

/// The folder of the shipped lab that has a step with that id; of Lab 4.2 if none has.
[[nodiscard]] QString shippedLabWith(const QString &step);

/// The labs in the folders of \p parent, by their titles; what has no lab.json that can be read is
/// left out. Reads nothing but lab.json and its translation.
[[nodiscard]] std::vector<ListedLab> labsIn(const QString &parent, const QString &language);

} // namespace cradle
