// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"
#include "tasks/grading/class_results.h"
#include "tasks/grading/descriptors.h"

#include <QByteArray>
#include <QString>

#include <map>
#include <optional>

namespace cradle {

/// What made the results of a class; results of two of these never meet.
struct ResultsVersion {
    QString cradle{}; ///< name and version of what judges
    QString labId{};
    QString labVersion{};
    QString labHash{};
    QString secretHash{};                    ///< says nothing of the secret
    QString language = QStringLiteral("en"); ///< in which students are told

    friend bool operator==(const ResultsVersion &, const ResultsVersion &) = default;
};

/// That a student's file is done.
struct DoneStudent {
    QString workHash{};   ///< of all that the verdict follows from, besides ResultsVersion
    QString resultHash{}; ///< of students/ID.json
    int notGraded = 0;    ///< steps without a verdict: to be tried again
    int notPassed = 0;    ///< steps that failed, or that are missing

    friend bool operator==(const DoneStudent &, const DoneStudent &) = default;
};

/// A part of a class that one machine judges.
struct Shard {
    int index = 1; ///< from 1
    int count = 1;

    friend bool operator==(const Shard &, const Shard &) = default;
};

/// The index of results, manifest.json. While a class is judged it says so, and what is done since
/// stands in a journal beside it, a line for each student; a kill at any moment loses no line that
/// was written. In the end the manifest has it all, and there is no journal.
struct Manifest {
    ResultsVersion version{};
    Shard shard{};
    bool complete = false;
    QString className{};
    Platform platform = Platform::None;    ///< that it was downloaded from
    QString isolation{};                   ///< of the workers, see isolationText()
    std::vector<MissingStudent> missing{}; ///< who handed in nothing
    QStringList remarks{};                 ///< what was not understood
    QStringList classIds{};                ///< of all students of the class, also of other shards
    std::map<QString, DoneStudent> students{}; ///< by id
};

[[nodiscard]] QByteArray bytesOf(const Manifest &manifest);
Result<Manifest> manifestFrom(const QByteArray &text, const QString &source);

/// Reads the manifest of a folder of results with what its journal adds.
/// \return an error if it is not to be read; nothing if there is none
Result<std::optional<Manifest>> readManifest(const QString &folder);

/// The folder of results while a class is judged into it. One process at a time.
class ClassJournal
{
public:
    /// Takes the folder, which is made if there is none.
    /// \return an error if another process has it, or if it cannot be written
    static Result<ClassJournal> open(const QString &folder);

    /// Begins: manifest.json says from here on that it is not complete.
    [[nodiscard]] std::optional<Error> begin(const Manifest &manifest);
    /// Writes students/ID.json, whole, and then the line that says so.
    /// \param done  its resultHash is that of \p result, whatever it says
    [[nodiscard]] std::optional<Error> keep(const QString &id, const QByteArray &result,
                                            DoneStudent done);
    /// The index, last. \param complete  whether all of the class are in it
    [[nodiscard]] std::optional<Error> finish(bool complete);

    [[nodiscard]] const Manifest &manifest() const { return m_manifest; }
    [[nodiscard]] QString studentPath(const QString &id) const;

private:
    explicit ClassJournal(QString folder)
        : m_folder(std::move(folder))
    {
    }
    [[nodiscard]] QString journalPath() const;

    QString m_folder;
    Manifest m_manifest{};
    Descriptor m_lock{};
    Descriptor m_file{};
};

/// SHA-256 as hexadecimal digits.
[[nodiscard]] QString sha256(const QByteArray &bytes);

} // namespace cradle
