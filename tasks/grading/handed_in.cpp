// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/handed_in.h"

#include "tasks/grading/handed_files.h"
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

constexpr qsizetype mostRemarks = 10;
constexpr qint64 mostArchiveBytes = 32 * 1024 * 1024;
constexpr qint64 mostSmallBytes = 1024 * 1024; ///< of a scene, of cradle.json

using File = HandedFiles::File;

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
        , m_files(student, classRoot)
        , m_lab(lab)
    {
    }

    HandedIn read()
    {
        if (!takeArchive() && !takeWorkspace())
            takeLoose();
        for (const Task &task : m_lab.tasks)
            m_read.request.steps.append(task.id);
        QStringList remarks = m_files.remarks.mid(0, mostRemarks);
        if (m_files.remarks.size() > mostRemarks)
            remarks.append(HandedInText::tr("and %1 more of that sort")
                               .arg(m_files.remarks.size() - mostRemarks));
        if (!m_student.remark.isEmpty())
            remarks.prepend(m_student.remark);
        m_read.remark = remarks.join(QStringLiteral("; "));
        return std::move(m_read);
    }

private:
    /// Of a program one byte more than it may have is enough to see that it is too long.
    void take(const QString &as, const File &file)
    {
        const qint64 most = isProgram(as) ? qint64(limits::sourceBytes) + 1 : mostSmallBytes;
        if (auto bytes = m_files.read(file, most))
            m_read.request.files.insert(as, std::move(*bytes));
    }

    bool takeArchive()
    {
        const File *last = nullptr;
        for (const File &file : m_files.files()) {
            if (!isArchive(file.name))
                continue;
            if (last)
                tellPassedOver(last->name, file.name);
            last = &file;
        }
        if (!last)
            return false;
        if (auto bytes = m_files.read(*last, mostArchiveBytes))
            m_read.request.archive = std::move(*bytes);
        return !m_read.request.archive.isEmpty();
    }

    /// A program of the folder that looks most like a workspace: not deep down, the first of its
    /// kind. Others are told.
    const File *programOfWorkspace()
    {
        const File *best = nullptr;
        QStringList all;
        for (const File &file : m_files.files()) {
            const QString folder = folderOf(file.name);
            if (!isProgram(file.name)
                || (folder != QLatin1String("steps/")
                    && !folder.endsWith(QLatin1String("/steps/"))))
                continue;
            if (!all.contains(folder))
                all.append(folder);
            if (!best || folder.count(u'/') < folderOf(best->name).count(u'/'))
                best = &file;
        }
        for (const QString &folder : all) {
            if (folder != folderOf(best->name))
                tellPassedOver(folder, folderOf(best->name));
        }
        return best;
    }

    void tellPassedOver(const QString &name, const QString &chosen)
    {
        m_files.remarks.append(HandedInText::tr("%1 was passed over for %2").arg(name, chosen));
    }

    bool takeWorkspace()
    {
        const File *program = programOfWorkspace();
        if (!program)
            return false;
        const QString folder = folderOf(program->name).chopped(6);
        for (const File &file : m_files.files()) {
            if (!file.name.startsWith(folder))
                continue;
            const QString below = file.name.mid(folder.size());
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
        m_read.request.repository = m_files.history(folder, *program);
        return true;
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
        m_files.remarks.append(HandedInText::tr("nothing that was handed in is a program"));
        for (const File &file : m_files.files()) {
            if (isPacked(file.name))
                m_files.remarks.append(
                    HandedInText::tr("%1 is not looked into; unpack it in its place")
                        .arg(file.name));
        }
    }

    void takeLoose()
    {
        // What browsers and platforms add to a name that was there: "lab (1)", "lab-2".
        static const QRegularExpression copy(QStringLiteral("(\\s*\\([0-9]+\\)|-[0-9]+)$"));
        std::vector<const File *> others;
        for (const File &file : m_files.files()) {
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
        const File *chosen = others.back();
        for (const File *each : others) {
            const QString base = each->name.mid(each->name.lastIndexOf(u'/') + 1).chopped(4);
            if (QString(base).remove(copy) == QLatin1String("lab"))
                chosen = each;
        }
        for (const File *each : others) {
            if (each != chosen)
                tellPassedOver(each->name, chosen->name);
        }
        take(QStringLiteral("lab.lua"), *chosen);
    }

    const FoundStudent &m_student;
    HandedFiles m_files;
    const Lab &m_lab;
    HandedIn m_read{};
};

} // namespace

HandedIn readHandedIn(const FoundStudent &student, const QByteArray &classRoot, const Lab &lab)
{
    return Reader(student, classRoot, lab).read();
}

} // namespace cradle
