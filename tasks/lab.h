// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/preset.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <vector>

namespace cradle {

/// One check of a step, as its lab wrote it: a kind from the library with its parameters.
struct CheckSpec {
    QString id;
    QString title;
    QString kind;               ///< see tasks/checks/check_library.h
    std::vector<int> circles{}; ///< the circles that it looks at, from 0
    QJsonObject parameters{};   ///< of the kind
    QJsonObject scene{};        ///< which scenes it runs, see tasks/variant.h

    friend bool operator==(const CheckSpec &, const CheckSpec &) = default;
};

/// One step of a lab; a plain value.
struct Task {
    QString id;           ///< L42T1
    QString title;        ///< a few words
    QString commit;       ///< the commit message, without the id; {integrator} is filled in
    QString folder;       ///< where its files are (a path, or a resource path)
    QString instructions; ///< CommonMark with TeX
    QStringList hints{};  ///< CommonMark, from a nudge to nearly the solution
    Preset preset{};      ///< the scene that the step starts with
    std::vector<CheckSpec> checks{};
    bool extra = false; ///< not in the original lab
};

/// A lab; a plain value.
struct Lab {
    QString id;
    QString title;
    QString version;
    QString language;
    QString folder;
    QString hash; ///< sha256 of its files
    std::vector<Task> tasks{};
    std::vector<Error> findings{}; ///< what could not be read; the rest is there

    /// The index of the task with that id; -1 if there is none.
    [[nodiscard]] int indexOf(const QString &taskId) const;
};

} // namespace cradle
