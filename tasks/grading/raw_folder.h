// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>

#include <vector>

namespace cradle {

// What students hand in has any names. On a disk they are bytes, which need not be UTF-8; QDir
// could not even open such a file.

/// Something in a folder.
struct FolderEntry {
    enum class Kind { File, Folder, Link, Other };

    QByteArray name;
    Kind kind = Kind::Other;

    friend bool operator==(const FolderEntry &, const FolderEntry &) = default;
};

/// What is in the folder \p path, in the order of the bytes of their names; at most \p most.
Result<std::vector<FolderEntry>> entriesOf(const QByteArray &path, std::size_t most);

/// The first \p most bytes of a plain file, or a link to one, that lies below \p root with all
/// links followed. \return an error for anything else
Result<QByteArray> readBelow(const QByteArray &root, const QByteArray &path, qint64 most);

/// A name to be shown: UTF-8, or else Latin-1, without control characters.
[[nodiscard]] QString shownName(const QByteArray &name);

/// The last name of a path, and what is before it.
[[nodiscard]] QByteArray lastName(const QByteArray &path);

} // namespace cradle
