// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/student_result.h"
#include "tasks/lab/lab.h"

#include <unordered_set>

namespace cradle {

/// Some tokens of a program that stand for it.
struct Fingerprint {
    quint64 hash = 0;
    int line = 0;     ///< of the first token, from 1
    int lastLine = 0; ///< of the last one
};

/// Fingerprints by winnowing (S. Schleimer, D. Wilkerson, A. Aiken, "Winnowing: Local Algorithms
/// for Document Fingerprinting", SIGMOD 2003): of any 25 tokens in a row (w + k − 1) at least one
/// run of k = 18 is among them, wherever they stand. Names that a program gives, texts, comments
/// and space make no difference.
[[nodiscard]] std::vector<Fingerprint> fingerprintsOf(const QString &program);

/// All runs of k tokens.
[[nodiscard]] std::vector<Fingerprint> tokenRunsOf(const QString &program);

/// Two students who share much that is not the lab's and not the class's.
struct AlikePair {
    int first = 0;     ///< in the order in which they were added
    int second = 0;    ///< after the first
    int shared = 0;    ///< fingerprints
    double part = 0.0; ///< of the own fingerprints of the one who has fewer, 0 to 1
};

/// Finds programs that are alike among many, by an index of fingerprints: the cost grows with the
/// number of programs, not with that of pairs. Left out is what the lab gives (starters, solutions,
/// known mistakes, code in its texts), and what more students share than commonFrom() tells.
class SimilarPrograms
{
public:
    explicit SimilarPrograms(const Lab &lab);

    void add(const StudentResult &student);

    /// Those that are most alike first. \param most  no more are told
    [[nodiscard]] std::vector<AlikePair> pairs(std::size_t most);

    /// What more students share is taken for common: a tenth of them, 4 to 20.
    [[nodiscard]] int commonFrom() const;

    /// Some lines of a program.
    struct Lines {
        QString taskId{};
        std::vector<int> lines{}; ///< from 1, rising
    };
    struct SharedLines {
        Lines first{};
        Lines second{};
    };
    /// The two programs in which two students share most, of the same step if there is a choice;
    /// only after pairs().
    [[nodiscard]] SharedLines sharedLines(const StudentResult &first,
                                          const StudentResult &second) const;

private:
    struct Entry {
        quint64 hash;
        int student;
    };
    [[nodiscard]] bool isOwn(quint64 hash) const; ///< neither the lab's nor common

    std::unordered_set<quint64> m_ofLab{};
    std::vector<Entry> m_entries{}; ///< by hash once pairs() was asked
    int m_students = 0;
};

} // namespace cradle
