// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tasks/lab_files/lab_files.h"

#include <QJsonObject>

namespace cradle {

/// The files that a lab is read from. What is wrong with one is said once, with its whole path.
class LabSource
{
public:
    /// \param folder  where the files lie, for messages
    /// \param faults  of files that are not among \p files, or that are there all the same
    LabSource(const LabFiles &files, const QString &folder, std::vector<Error> faults);

    [[nodiscard]] const LabFiles &files() const { return m_files; }
    [[nodiscard]] bool has(const QString &path) const;
    /// The path for messages.
    [[nodiscard]] QString fullPath(const QString &path) const;

    /// A file of at most \p maxBytes, else what is wrong with it.
    [[nodiscard]] Result<QByteArray> read(const QString &path, qint64 maxBytes) const;
    /// A file that fits the schema of that name in resources/schemas.
    [[nodiscard]] Result<QJsonObject> readJson(const QString &path, const char *schema) const;
    [[nodiscard]] Result<Preset> readPreset(const QString &path) const;
    /// A text in UTF-8; what is wrong with it goes to \p findings, and is lost if it cannot be
    /// read at all.
    [[nodiscard]] QString readText(const QString &path, qint64 maxBytes,
                                   std::vector<Error> &findings) const;

    /// Those of the faults that \p findings does not tell.
    [[nodiscard]] std::vector<Error> untold(const std::vector<Error> &findings) const;

private:
    const LabFiles &m_files;
    QString m_folder;
    std::vector<Error> m_faults;
};

} // namespace cradle
