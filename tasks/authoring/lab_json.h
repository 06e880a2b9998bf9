// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab_files/lab_files.h"

#include <QJsonArray>
#include <QJsonObject>

namespace cradle {

// What the edits of a lab share: reading and patching its JSON files.

inline constexpr char labSchema[] = "lab.schema.json";
inline constexpr char taskSchema[] = "task.schema.json";
inline constexpr char presetSchema[] = "preset.schema.json";
inline constexpr char translationSchema[] = "translation.schema.json";

inline const QString indexFile = QStringLiteral("lab.json");

/// The JSON of a file that fits its schema; an error names what does not, or that there is none.
[[nodiscard]] Result<QJsonObject> jsonOf(const LabFiles &files, const QString &path,
                                         const char *schema);

/// Patches a file by the difference (see patchJson()); one that is missing begins empty.
/// \return an error if the file would not fit its schema afterwards
[[nodiscard]] Result<LabFiles> withPatch(const LabFiles &files, const QString &path,
                                         const char *schema, const QJsonObject &before,
                                         const QJsonObject &after);

/// Sets one member of the file; removes it if \p value is undefined.
[[nodiscard]] Result<LabFiles> withMember(const LabFiles &files, const QString &path,
                                          const char *schema, const QString &key,
                                          const QJsonValue &value);

/// The language of the lab's own texts; "en" if it does not say.
[[nodiscard]] QString ownLanguage(const LabFiles &files);
/// Whether \p language is another than the lab's own; empty is its own.
[[nodiscard]] bool isTranslation(const LabFiles &files, const QString &language);

/// "STEP/task.json".
[[nodiscard]] QString taskPath(const QString &step);
/// "STEP/task.de.json" and so on: the files with texts in other languages.
[[nodiscard]] QStringList translationsOf(const LabFiles &files, const QString &step);
/// "NAME.de.json" for "NAME.json".
[[nodiscard]] QString translatedPath(const QString &path, const QString &language);

/// Renames, or with an empty \p newName removes, a key of an object in all translations of a
/// step: the text of a check, a mistake or a remark. Those that cannot be read stay as they are.
[[nodiscard]] LabFiles withTranslatedKey(const LabFiles &files, const QString &step,
                                         const QString &object, const QString &name,
                                         const QString &newName);

[[nodiscard]] QJsonArray toJson(const QStringList &list);
[[nodiscard]] QStringList toStrings(const QJsonValue &list);

} // namespace cradle
