// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/kept_history.h"

#include <QSet>

namespace cradle {

namespace {

constexpr int mostVersions = 1000; ///< of a step
constexpr int mostCommits = 5000;  ///< of the story
constexpr qsizetype mostMessage = 20'000;

Version versionFrom(const QByteArray &id, const QString &step, const GitObjects::Commit &commit)
{
    return {.id = QString::fromLatin1(id.toHex()),
            .taskId = step,
            .when = QDateTime::fromSecsSinceEpoch(commit.time, Qt::UTC),
            .note = versionNote(QString::fromUtf8(commit.message.left(mostMessage)))};
}

/// Follows the story from HEAD.
class Story
{
public:
    Story(GitObjects &objects, const QStringList &steps)
        : m_objects(objects)
        , m_steps(steps)
    {
    }

    std::map<QString, std::vector<Version>> read()
    {
        std::map<QString, std::vector<Version>> found;
        std::vector<QByteArray> next{m_objects.reference(QStringLiteral("HEAD"))};
        QSet<QByteArray> seen;
        while (!next.empty() && seen.size() < mostCommits) {
            const QByteArray id = next.back();
            next.pop_back();
            const auto commit = seen.contains(id) ? std::nullopt : m_objects.commit(id);
            if (!commit)
                continue;
            seen.insert(id);
            next.insert(next.end(), commit->parents.begin(), commit->parents.end());
            for (const QString &step : changedBy(*commit)) {
                found[step].push_back(versionFrom(id, step, *commit));
                found[step].back().note = {}; // of all that was tried only the passes are here
            }
        }
        return found;
    }

private:
    QMap<QByteArray, QByteArray> programsOf(const QByteArray &tree)
    {
        if (!m_programs.contains(tree))
            m_programs.insert(tree, m_objects.tree(m_objects.tree(tree).value("steps")));
        return m_programs.value(tree);
    }

    QStringList changedBy(const GitObjects::Commit &commit)
    {
        QMap<QByteArray, QByteArray> before;
        if (!commit.parents.empty()) {
            // Of a clone that is not whole the first commit changed who knows what.
            const auto parent = m_objects.commit(commit.parents.front());
            if (!parent)
                return {};
            before = programsOf(parent->tree);
        }
        const auto now = programsOf(commit.tree);
        QStringList changed;
        for (const QString &step : m_steps) {
            const QByteArray file = step.toUtf8() + ".lua";
            if (now.contains(file) && now.value(file) != before.value(file))
                changed.append(step);
        }
        return changed;
    }

    GitObjects &m_objects;
    const QStringList &m_steps;
    QMap<QByteArray, QMap<QByteArray, QByteArray>> m_programs{}; ///< by tree
};

} // namespace

std::map<QString, std::vector<Version>> keptHistory(const RepositoryFiles &files,
                                                    const QStringList &steps)
{
    GitObjects objects(files);
    auto found = Story(objects, steps).read();
    for (const QString &step : steps) {
        QByteArray id = objects.reference(QStringLiteral("refs/cradle/versions/") + step);
        for (int i = 0; i < mostVersions && !id.isEmpty(); ++i) {
            const auto commit = objects.commit(id);
            if (!commit)
                break;
            found[step].push_back(versionFrom(id, step, *commit));
            id = commit->parents.empty() ? QByteArray() : commit->parents.front();
        }
    }
    return found;
}

} // namespace cradle
