// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/reading/lab_source.h"

#include <QJsonObject>

namespace cradle {

/// The texts in a list; what is no text is empty.
[[nodiscard]] QStringList stringsOf(const QJsonValue &list);

/// The texts of "NAME.LANGUAGE.json" beside "NAME.json"; empty if there are none. What keeps them
/// from being read is added to the findings of \p lab.
[[nodiscard]] QJsonObject translationOf(const LabSource &source, const QString &path,
                                        const QString &language, Lab &lab);

/// Reads the step in the folder \p step, with its texts in \p language where it has them, and adds
/// it to \p lab; or adds what keeps it from being read to the findings.
void readTask(const LabSource &source, const QString &step, const QString &language, Lab &lab);

} // namespace cradle
