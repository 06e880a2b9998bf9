// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <QJsonValue>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace cradle {

/// One parameter of a kind of check or scene: all that a form or a reader needs to know of it.
struct ParameterInfo {
    enum class Type {
        Number,  ///< a number
        Count,   ///< a whole number
        Flag,    ///< true or false
        Choice,  ///< one of \c choices
        Choices, ///< a list of one or more of \c choices
        Vector,  ///< two numbers [x, y]
        Vectors, ///< a list of [x, y], one for each circle of the check
        Range,   ///< two numbers [least, most]
        Numbers, ///< a list of one or more numbers
        Script   ///< the name of a file in the folder "checks" of the step
    };

    QString name; ///< its key in task.json
    Type type = Type::Number;
    QString label;                 ///< a few words, translated
    QString help;                  ///< a sentence, translated
    QString unit{};                ///< of every number: "m", "m/s"; empty if it has none
    std::optional<double> least{}; ///< of every number
    std::optional<double> most{};
    QJsonValue standard{QJsonValue::Undefined}; ///< what holds where it is left out; undefined if
                                                ///< nothing or a value of the scene (see help)
    QStringList choices{};
    bool required = false;
};

/// One kind of check, or of scene, with its parameters in the order in which to show them.
struct KindInfo {
    QString name;    ///< in task.json
    QString title;   ///< a few words, translated
    QString purpose; ///< what it judges or shows, translated
    int circles = 1; ///< how many circles it needs at least; of two, they are circles 1 and 2
                     ///< unless the check names others
    std::vector<ParameterInfo> parameters{};
};

/// All kinds of checks ("parameters" of a check in task.json), the most usual first.
[[nodiscard]] std::vector<KindInfo> checkKinds();

/// All kinds of scenes ("scene" of a check in task.json).
[[nodiscard]] std::vector<KindInfo> sceneKinds();

/// The one with that name; nullptr if there is none.
[[nodiscard]] const KindInfo *findKind(const std::vector<KindInfo> &kinds, const QString &name);

/// What \p check says of \p parameter, else what the catalogue has where it is left out; undefined
/// where that depends on the scene, or is nothing.
[[nodiscard]] QJsonValue valueOf(const CheckSpec &check, const QString &parameter);

/// The parameter with that name; nullptr if there is none.
[[nodiscard]] const ParameterInfo *findParameter(const KindInfo &kind, const QString &name);

} // namespace cradle
