// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/handed_in.h"

#include "tasks/grading/handed_repository.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/script/script_limits.h"
#include "tasks/work/work_archive.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

struct HandedInText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr int mostDepth = 5;
constexpr std::size_t mostFiles = 2000; ///< of one student that are looked at
constexpr qsizetype mostRemarks = 10;
constexpr qint64 mostArchiveBytes = 32 * 1024 * 1024;
constexpr qint64 mostSmallBytes = 1024 * 1024; ///< of a scene, of cradle.json

/// A file of a student.
struct Candidate {
    QByteArray path;
    QString name; ///< below the student's folder, or as the student called it
};

bool isArchive(const QString &name)
{
    return name.endsWith(QLatin1String(workSuffix), Qt::CaseInsensitive);
}

bool isProgram(const QString &name)
{
    return name.endsWith(QLatin1String(".lua"), Qt::CaseInsensitive);
}

/// Whether it may hold programs that only unpacking brings to light.
bool isPacked(const QString &name)
{
    for (const char *suffix : {".zip", ".rar", ".7z", ".tar", ".gz", ".tgz", ".xz", ".bz2"}) {
        if (name.endsWith(QLatin1String(suffix), Qt::CaseInsensitive))
            return true;
    }
    return false;
}

QString folderOf(const QString &name)
{
    return name.left(name.lastIndexOf(u'/') + 1);
}

class Reader
{
public:
    Reader(const FoundStudent &student, const QByteArray &classRoot, const Lab &lab)
        : m_student(student)
        , m_root(student.folder.isEmpty() ? classRoot : student.folder)
        , m_lab(lab)
    {
    }

    HandedIn read()
    {
        if (m_student.folder.isEmpty()) {
            for (const FoundStudent::File &file : m_student.files)
                m_candidates.push_back({file.path, file.calledBy});
        } else {
            walk(m_student.folder, {}, 0);
        }
        if (!takeArchive() && !takeWorkspace())
            takeLoose();
        for (const Task &task : m_lab.tasks)
            m_read.request.steps.append(task.id);
        QStringList remarks = m_remarks.mid(0, mostRemarks);
        if (m_remarks.size() > mostRemarks)
            remarks.append(
                HandedInText::tr("and %1 more of that sort").arg(m_remarks.size() - mostRemarks));
        if (!m_student.remark.isEmpty())
            remarks.prepend(m_student.remark);
        m_read.remark = remarks.join(QStringLiteral("; "));
        return std::move(m_read);
    }

private:
    void walk(const QByteArray &folder, const QString &below, int depth)
    {
        const auto entries = entriesOf(folder, mostFiles);
        if (!entries) {
            m_remarks.append(entries.error().toString());
            return;
        }
        for (const FolderEntry &entry : *entries) {
            const QString name = below + shownName(entry.name);
            const QByteArray path = folder + '/' + entry.name;
            if (entry.name.startsWith('.') || entry.name == "__MACOSX")
                continue;
            if (entry.kind == FolderEntry::Kind::Folder && depth < mostDepth)
                walk(path, name + u'/', depth + 1);
            else if (entry.kind == FolderEntry::Kind::File || entry.kind == FolderEntry::Kind::Link)
                m_candidates.push_back({path, name});
            if (m_candidates.size() > mostFiles)
                return;
        }
    }

    /// \return whether it could be read; if not, that is told
    std::optional<QByteArray> bytesOf(const Candidate &file, qint64 most)
    {
        auto bytes = readBelow(m_root, file.path, most);
        if (bytes)
            return std::move(*bytes);
        m_remarks.append(file.name + QStringLiteral(": ") + bytes.error().message);
        return std::nullopt;
    }

    /// Of a program one byte more than it may have is enough to see that it is too long.
    void take(const QString &as, const Candidate &file)
    {
        const qint64 most = isProgram(as) ? qint64(limits::sourceBytes) + 1 : mostSmallBytes;
        if (auto bytes = bytesOf(file, most))
            m_read.request.files.insert(as, std::move(*bytes));
    }

    bool takeArchive()
    {
        const Candidate *last = nullptr;
        for (const Candidate &file : m_candidates) {
            if (!isArchive(file.name))
                continue;
            if (last)
                m_remarks.append(
                    HandedInText::tr("%1 was passed over for %2").arg(last->name, file.name));
            last = &file;
        }
        if (!last)
            return false;
        if (auto bytes = bytesOf(*last, mostArchiveBytes))
            m_read.request.archive = std::move(*bytes);
        return !m_read.request.archive.isEmpty();
    }

    /// The folder that looks most like a workspace: not deep down, the first of its kind.
    [[nodiscard]] std::optional<QString> workspace() const
    {
        std::optional<QString> best;
        const auto consider = [&](const QString &folder) {
            if (!best || folder.count(u'/') < best->count(u'/'))
                best = folder;
        };
        for (const Candidate &file : m_candidates) {
            const QString folder = folderOf(file.name);
            if (isProgram(file.name)
                && (folder == QLatin1String("steps/") || folder.endsWith(QLatin1String("/steps/"))))
                consider(folder.chopped(6));
        }
        return best;
    }

    bool takeWorkspace()
    {
        const auto folder = workspace();
        if (!folder)
            return false;
        for (const Candidate &file : m_candidates) {
            if (!file.name.startsWith(*folder))
                continue;
            const QString below = file.name.mid(folder->size());
            const QString id = below.section(u'/', 1).section(u'.', 0, 0);
            if (below == QLatin1String("cradle.json") || below == QLatin1String("lab.lua")
                || below == QLatin1String("answers.json"))
                take(below, file);
            else if (const Task *task = taskCalled(id); task && below.count(u'/') == 1) {
                if (below.startsWith(QLatin1String("steps/")) && isProgram(below))
                    take(QStringLiteral("steps/%1.lua").arg(task->id), file);
                else if (below.startsWith(QLatin1String("presets/")))
                    take(QStringLiteral("presets/%1.json").arg(task->id), file);
            }
        }
        takeHistory(*folder);
        return true;
    }

    /// The repository that the workspace is, or is in.
    void takeHistory(const QString &folder)
    {
        if (m_student.folder.isEmpty())
            return;
        for (const QByteArray &place :
             {m_student.folder + '/' + folder.toUtf8(), m_student.folder + '/'}) {
            auto repository = readRepository(m_root, place + ".git");
            if (!repository)
                m_remarks.append(repository.error().message);
            else if (!repository->isEmpty())
                m_read.request.repository = std::move(*repository);
            if (!repository || !m_read.request.repository.isEmpty())
                return;
        }
    }

    [[nodiscard]] const Task *taskCalled(const QString &name) const
    {
        const auto found =
            std::find_if(m_lab.tasks.begin(), m_lab.tasks.end(), [&](const Task &task) {
                return task.id.compare(name, Qt::CaseInsensitive) == 0;
            });
        return found == m_lab.tasks.end() ? nullptr : &*found;
    }

    void tellNoProgram()
    {
        m_remarks.append(HandedInText::tr("nothing that was handed in is a program"));
        for (const Candidate &file : m_candidates) {
            if (isPacked(file.name))
                m_remarks.append(HandedInText::tr("%1 is not looked into; unpack it in its place")
                                     .arg(file.name));
        }
    }

    void takeLoose()
    {
        // What browsers and platforms add to a name that was there: "lab (1)", "lab-2".
        static const QRegularExpression copy(QStringLiteral("(\\s*\\([0-9]+\\)|-[0-9]+)$"));
        std::vector<const Candidate *> others;
        for (const Candidate &file : m_candidates) {
            if (!isProgram(file.name))
                continue;
            QString base = file.name.mid(file.name.lastIndexOf(u'/') + 1).chopped(4);
            base.remove(copy);
            if (const Task *task = taskCalled(base))
                take(QStringLiteral("steps/%1.lua").arg(task->id), file);
            else
                others.push_back(&file);
        }
        if (!m_read.request.files.isEmpty() || others.empty()) {
            if (others.empty() && m_read.request.files.isEmpty())
                tellNoProgram();
            return;
        }
        const Candidate *chosen = others.back();
        for (const Candidate *each : others) {
            const QString base = each->name.mid(each->name.lastIndexOf(u'/') + 1).chopped(4);
            if (QString(base).remove(copy) == QLatin1String("lab"))
                chosen = each;
        }
        for (const Candidate *each : others) {
            if (each != chosen)
                m_remarks.append(
                    HandedInText::tr("%1 was passed over for %2").arg(each->name, chosen->name));
        }
        take(QStringLiteral("lab.lua"), *chosen);
    }

    const FoundStudent &m_student;
    QByteArray m_root;
    const Lab &m_lab;
    std::vector<Candidate> m_candidates{};
    QStringList m_remarks{};
    HandedIn m_read{};
};

} // namespace

HandedIn readHandedIn(const FoundStudent &student, const QByteArray &classRoot, const Lab &lab)
{
    return Reader(student, classRoot, lab).read();
}

} // namespace cradle
