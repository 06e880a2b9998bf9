// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_folder.h"
#include "tasks/grading/handed_zip.h"

#include <memory>

namespace cradle {

/// The files of one student, in folders and in zips alike. Links that lead out of what was handed
/// in are not followed; zips are not unpacked to disk, and a zip in a zip stays one.
class HandedFiles
{
public:
    struct File {
        QByteArray path{};              ///< on disk, maybe of the zip
        QString name{};                 ///< below the student's folder, or as the student called it
        const HandedZip *zip = nullptr; ///< that holds the file, if one does
        zip_uint64_t index = 0;         ///< in it
        qsizetype inZip = 0;            ///< where in the name that of the zip has ended
    };

    HandedFiles(const FoundStudent &student, const QByteArray &classRoot);

    [[nodiscard]] const std::vector<File> &files() const { return m_files; }
    /// \return at most \p most bytes, or nothing if it cannot be read, which becomes a remark
    std::optional<QByteArray> read(const File &file, qint64 most);
    /// The history of the repository that \p folder, one of a program \p file, is, or is in.
    RepositoryFiles history(const QString &folder, const File &file);
    /// What is strange about them; plain text.
    QStringList remarks{};

private:
    void walk(const QByteArray &folder, const QString &below, int depth);
    void lookIntoZips();
    void lookInto(const HandedZip &zip, const File &file);

    QByteArray m_folder;
    QByteArray m_root;
    std::vector<File> m_files{};
    std::vector<std::unique_ptr<HandedZip>> m_zips{};
    qint64 m_unpackLeft;
};

} // namespace cradle
