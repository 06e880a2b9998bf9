// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QByteArray>

#include <optional>

namespace cradle {

/// How sure it is that a file outlives a power cut.
enum class Keeping {
    Synced,   ///< as soon as it is written; takes the disk some milliseconds
    Derivable ///< some seconds later: for thousands of files that can be written again
};

/// A file that is written in parts and replaces the one that was there only once all of it is on
/// the disk: written, flushed, synced, and only then renamed. What fails on the way (a full disk,
/// above all) leaves the old file as it was, byte for byte. The folder must be there.
///
/// A link is followed; what it leads to is replaced, and keeps its permissions. Devices and FIFOs
/// cannot be replaced and are written to as the parts come.
class WholeFile
{
public:
    explicit WholeFile(const QString &path);
    /// Without commit() it is as if nothing had been written.
    ~WholeFile();
    WholeFile(const WholeFile &) = delete;
    WholeFile &operator=(const WholeFile &) = delete;

    /// After a fault there is nothing more to write; commit() tells it.
    void append(const QByteArray &part);
    /// \return what kept it from being written, in words for the user
    [[nodiscard]] std::optional<Error> commit(Keeping keeping = Keeping::Synced);

private:
    void open();
    void fail(int number);
    void giveUp();

    QString m_path;
    QByteArray m_target; ///< what is replaced, where links lead
    QByteArray m_unfinished;
    int m_descriptor = -1;
    int m_fault = 0; ///< errno of the first one
};

/// How the names of files begin that are not yet whole. One that is found was left by a process
/// that was killed.
inline constexpr char unfinishedPrefix[] = ".cradle-unfinished-";

/// Writes a file whole or not at all; see WholeFile.
[[nodiscard]] std::optional<Error> writeFile(const QString &path, const QByteArray &content,
                                             Keeping keeping = Keeping::Synced);

/// The same to standard output, which cannot be taken back.
[[nodiscard]] std::optional<Error> writeStandardOutput(const QByteArray &content);

/// What the system's errno means to who wanted to save.
[[nodiscard]] QString wordsForFault(int number);

/// Makes a folder and those above it, if they are not there.
[[nodiscard]] std::optional<Error> makeFolder(const QString &path);

/// Removes what killed processes left in \p folder (not below it): see unfinishedPrefix. Only for
/// who is alone in writing there.
void removeUnfinished(const QString &folder);

} // namespace cradle
