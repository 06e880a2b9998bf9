// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>

#include <optional>
#include <vector>

namespace cradle {

/// The files of a git repository that hold its history, by path below its folder .git: HEAD,
/// packed-refs, refs/ and objects/, and no others.
using RepositoryFiles = QMap<QString, QByteArray>;

/// Reads commits and trees of a repository of a stranger, from the bytes of its files. libgit2
/// opens files, also such as a repository names (settings, alternates, hooks); this opens none, and
/// can do its work in a process that may do nothing but compute. What is broken, is too large or
/// goes on without end is as if it were not there.
class GitObjects
{
public:
    explicit GitObjects(const RepositoryFiles &files);

    /// The id (20 bytes) that a reference leads to, "HEAD" too; empty if there is none.
    [[nodiscard]] QByteArray reference(const QString &name) const;

    struct Commit {
        QByteArray tree{};
        std::vector<QByteArray> parents{};
        qint64 time = 0; ///< of the committer, s since 1970
        QByteArray message{};
    };
    [[nodiscard]] std::optional<Commit> commit(const QByteArray &id);
    /// The ids of what is in a tree, by name.
    [[nodiscard]] QMap<QByteArray, QByteArray> tree(const QByteArray &id);

private:
    enum Kind { NoKind = 0, CommitKind = 1, TreeKind = 2, OffsetDelta = 6, IdDelta = 7 };
    struct Object {
        int kind = NoKind;
        QByteArray content{};
    };
    /// A pack with its index, as far as it is one.
    struct Pack {
        QByteArray index{};
        QByteArray data{};
        quint32 count = 0;

        [[nodiscard]] std::optional<qsizetype> placeOf(const QByteArray &id) const;
    };

    void addPack(const QByteArray &index, const QByteArray &data);
    std::optional<Object> object(const QByteArray &id, int depth = 0);
    std::optional<Object> looseObject(const QByteArray &file);
    std::optional<Object> packedObject(const Pack &pack, qsizetype place, int depth);
    QByteArray unpacked(const char *data, qsizetype size, qsizetype most);

    const RepositoryFiles &m_files;
    QMap<QString, QByteArray> m_references{};
    std::vector<Pack> m_packs{};
    qint64 m_left; ///< bytes that may still be unpacked
};

} // namespace cradle
