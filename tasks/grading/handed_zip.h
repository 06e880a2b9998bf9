// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/lab_files/zip_handles.h"
#include "tasks/workspace/git_objects.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace cradle {

/// A zip inside of what one student handed in. It is never unpacked to disk: what is asked for is
/// read in memory, without trust in what the zip says of its sizes.
class HandedZip
{
public:
    struct Entry {
        QString name{}; ///< in the zip, with / between folders; for reading
        zip_uint64_t index = 0;
    };

    /// \param bytes  at most 32 MiB of them
    /// \return an error if it is no zip, holds absurdly many files, or those of a whole class
    static Result<HandedZip> open(QByteArray bytes);

    /// Files that may be work: none that is hidden, a link, leads out, or is there twice.
    [[nodiscard]] const std::vector<Entry> &entries() const { return m_entries; }
    /// The names of what is not among entries() for its name or kind, unless only hidden.
    [[nodiscard]] const QStringList &leftOut() const { return m_leftOut; }

    /// The first \p most bytes of an entry, at most.
    /// \param left  how many may be unpacked of this student; what was is taken off
    [[nodiscard]] Result<QByteArray> read(zip_uint64_t index, qint64 most, qint64 &left) const;
    /// As readRepository(), of the folder \p folder in the zip, which ends in ".git/".
    [[nodiscard]] Result<RepositoryFiles> repository(const QString &folder, qint64 &left) const;

private:
    HandedZip() = default;
    void take(zip_uint64_t index);
    [[nodiscard]] bool isOfAClass() const;

    QByteArray m_bytes{}; ///< that the archive reads
    ZipArchive m_archive{};
    std::vector<Entry> m_entries{};
    std::vector<Entry> m_history{}; ///< in folders called .git
    QStringList m_leftOut{};
};

} // namespace cradle
