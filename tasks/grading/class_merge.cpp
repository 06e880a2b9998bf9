// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_merge.h"

#include "model/files/json_schema.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>

namespace cradle {

namespace {

struct MergeText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qsizetype mostNamed = 10; ///< of a list that is told

QString listText(const QStringList &names)
{
    if (names.size() <= mostNamed)
        return spokenList(names);
    return MergeText::tr("%1 and %2 more")
        .arg(spokenList(names.mid(0, mostNamed)))
        .arg(names.size() - mostNamed);
}

class Merge
{
public:
    std::optional<Error> add(const QString &folder)
    {
        auto read = readManifest(folder);
        if (!read)
            return read.error();
        if (!*read) {
            m_merged.remarks.append(
                MergeText::tr("%1: there are no results; its shard never began").arg(folder));
            return std::nullopt;
        }
        Manifest &manifest = **read;
        if (auto error = fits(manifest, folder))
            return error;
        ++m_shards[manifest.shard.index];
        if (!manifest.complete)
            m_merged.remarks.append(MergeText::tr("%1: shard %2 of %3 did not come to its end")
                                        .arg(folder)
                                        .arg(manifest.shard.index)
                                        .arg(manifest.shard.count));
        for (const auto &[id, student] : manifest.students) {
            if (auto error = take(id, student, folder))
                return error;
        }
        return std::nullopt;
    }

    Result<MergedClass> finish()
    {
        if (!m_first)
            return Error{.message = MergeText::tr("none of these folders has results")};
        if (!m_doubles.isEmpty())
            m_merged.remarks.append(MergeText::tr("judged more than once, with the same result: %1")
                                        .arg(listText(m_doubles)));
        QStringList shards;
        for (int i = 1; i <= m_count; ++i) {
            if (m_shards[i] == 0)
                shards.append(QString::number(i));
        }
        if (!shards.isEmpty())
            m_merged.remarks.append(
                MergeText::tr("missing of %1 shards: %2").arg(m_count).arg(listText(shards)));
        for (const QString &id : m_merged.manifest.classIds) {
            if (!m_merged.files.contains(id))
                m_merged.lacking.append(id);
        }
        if (!m_merged.lacking.isEmpty())
            m_merged.remarks.append(
                MergeText::tr("without results: %1").arg(listText(m_merged.lacking)));
        return std::move(m_merged);
    }

private:
    /// Whether it is a part of the same as the first one.
    std::optional<Error> fits(const Manifest &manifest, const QString &folder)
    {
        if (!m_first) {
            m_first = true;
            m_count = manifest.shard.count;
            m_merged.manifest = manifest;
            m_merged.manifest.students.clear();
            m_merged.manifest.shard = {};
            m_merged.manifest.complete = false;
            return std::nullopt;
        }
        const Manifest &whole = m_merged.manifest;
        if (manifest.version != whole.version)
            return Error{.message = MergeText::tr("these results are of another version of the "
                                                  "lab, of Cradle or of the secret than those "
                                                  "before; they cannot be put together"),
                         .file = folder};
        if (manifest.classIds != whole.classIds || manifest.shard.count != m_count)
            return Error{.message = MergeText::tr("these results are of another class, or of "
                                                  "another number of shards, than those before"),
                         .file = folder};
        if (manifest.isolation != whole.isolation)
            m_merged.remarks.append(
                MergeText::tr("%1: other isolation: %2").arg(folder, manifest.isolation));
        return std::nullopt;
    }

    std::optional<Error> take(const QString &id, const DoneStudent &student, const QString &folder)
    {
        const QString path = folder + QStringLiteral("/students/") + id + QStringLiteral(".json");
        const auto bytes = readFile(path, mostResultBytes);
        if (!bytes || sha256(*bytes) != student.resultHash) {
            m_merged.remarks.append(
                MergeText::tr("%1 is not as its manifest says, and is left out").arg(path));
            return std::nullopt;
        }
        auto &students = m_merged.manifest.students;
        const auto there = students.find(id);
        if (there == students.end()) {
            students[id] = student;
            m_merged.files[id] = path;
            return std::nullopt;
        }
        if (there->second == student) {
            m_doubles.append(id);
            return std::nullopt;
        }
        if (there->second.workHash == student.workHash && there->second.notGraded > 0
            && student.notGraded < there->second.notGraded) {
            there->second = student;
            m_merged.files[id] = path;
            return std::nullopt;
        }
        if (there->second.workHash == student.workHash && student.notGraded > 0)
            return std::nullopt;
        return Error{.message = MergeText::tr("the results of %1 differ from those in %2")
                                    .arg(id, m_merged.files[id]),
                     .file = path};
    }

    MergedClass m_merged{};
    QStringList m_doubles{};
    std::map<int, int> m_shards{};
    int m_count = 1;
    bool m_first = false;
};

} // namespace

Result<MergedClass> mergeResults(const QStringList &folders)
{
    Merge merge;
    for (const QString &folder : folders) {
        if (auto error = merge.add(folder))
            return *error;
    }
    return merge.finish();
}

} // namespace cradle
