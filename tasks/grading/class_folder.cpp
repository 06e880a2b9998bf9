// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_folder.h"

#include "tasks/grading/class_roster.h"
#include "tasks/grading/platform_names.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/work/work_archive.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QHash>
#include <QMap>
#include <QSet>

#include <algorithm>

namespace cradle {

namespace {

struct ClassText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr std::size_t mostEntries = 200'000;

bool isNoise(const QByteArray &name)
{
    return name.startsWith('.') || name.endsWith('~') || name == "__MACOSX" || name == "desktop.ini"
           || name == "Thumbs.db" || name == "index.html";
}

bool hasSuffix(const QString &name, const char *suffix)
{
    return name.endsWith(QLatin1String(suffix), Qt::CaseInsensitive);
}

/// Whether a folder is what one student handed in.
bool isOneStudents(const std::vector<FolderEntry> &entries)
{
    return std::any_of(entries.begin(), entries.end(), [](const FolderEntry &entry) {
        return entry.name == "steps" || entry.name == "lab.lua" || entry.name == "cradle.json";
    });
}

/// Groups what lies in a class's folder by student.
class ClassReader
{
public:
    ClassReader(const QByteArray &root, const QString &labId, const std::vector<RosterRow> &roster)
        : m_root(root)
        , m_labId(labId)
        , m_roster(roster)
    {
    }

    ClassFolder read(const std::vector<FolderEntry> &entries)
    {
        const QString assignment = classroomAssignment();
        findAccounts(entries);
        for (const FolderEntry &entry : entries) {
            if (!isNoise(entry.name))
                take(entry, assignment);
        }
        for (auto &[key, student] : m_students)
            m_class.students.push_back(std::move(student));
        m_class.root = m_root;
        const auto most =
            std::max_element(m_platforms.begin(), m_platforms.end(),
                             [](const auto &a, const auto &b) { return a.second < b.second; });
        if (most != m_platforms.end() && most->second * 2 > static_cast<int>(m_students.size()))
            m_class.platform = most->first;
        return std::move(m_class);
    }

private:
    /// GitHub Classroom's folder is called ASSIGNMENT-submissions, and the clones in it
    /// ASSIGNMENT-ACCOUNT.
    [[nodiscard]] QString classroomAssignment() const
    {
        const QString name = shownName(lastName(m_root));
        const QString end = QStringLiteral("-submissions");
        return name.endsWith(end) ? name.chopped(end.size()) + u'-' : QString();
    }

    void findAccounts(const std::vector<FolderEntry> &entries)
    {
        QSet<QString> known;
        for (const RosterRow &row : m_roster)
            known += {row.id.toCaseFolded(), row.number.toCaseFolded()};
        QStringList heads;
        for (const FolderEntry &entry : entries) {
            const auto read = platformName(shownName(entry.name), false);
            if (entry.kind == FolderEntry::Kind::File && !isNoise(entry.name) && read
                && read->platform == Platform::Blackboard)
                heads.append(headOf(*read));
        }
        m_accounts = blackboardAccounts(heads, known);
        if (!m_accounts.isGuess)
            return;
        const QString &common = m_accounts.common;
        m_class.remarks.append(
            common.isEmpty()
                ? ClassText::tr("of the names of Blackboard, what follows the last _ is taken for "
                                "the account; a roster tells better")
                : ClassText::tr("of the names of Blackboard, what follows %1 is taken for the "
                                "account; a roster tells better")
                      .arg(common));
    }

    static QString headOf(const PlatformName &blackboard)
    {
        return blackboard.assignment + u'_' + blackboard.student;
    }

    void take(const FolderEntry &entry, const QString &assignment)
    {
        const QString name = shownName(entry.name);
        const QByteArray path = m_root + '/' + entry.name;
        if (entry.kind == FolderEntry::Kind::Link || entry.kind == FolderEntry::Kind::Other) {
            m_class.remarks.append(
                entry.kind == FolderEntry::Kind::Link
                    ? ClassText::tr("%1 is a link, which is not followed").arg(name)
                    : ClassText::tr("%1 is neither a file nor a folder").arg(name));
            return;
        }
        const bool isFolder = entry.kind == FolderEntry::Kind::Folder;
        if (auto platform = platformName(name, isFolder)) {
            if (platform->platform == Platform::Blackboard)
                platform->student = platform->number = m_accounts.byHead.value(headOf(*platform));
            takeFromPlatform(*platform, path, name, isFolder);
        } else if (isFolder) {
            takeFolder(path, name, assignment);
        } else {
            takeFile(path, name);
        }
    }

    void takeFromPlatform(const PlatformName &platform, const QByteArray &path, const QString &name,
                          bool isFolder)
    {
        const QString key =
            platformText(platform.platform) + u'/' + platform.student + u'/' + platform.number;
        FoundStudent &student = m_students[key];
        if (student.id.isEmpty()) {
            ++m_platforms[platform.platform];
            student.id = studentIdFrom(platform.number);
            student.name = platform.student;
            student.number = platform.number;
            student.platform = platform.platform;
            student.how = ClassText::tr("download of %1").arg(platformText(platform.platform));
        }
        if (platform.late)
            student.remark = ClassText::tr("Canvas says: late");
        if (isFolder) {
            // Moodle gives out a text that was typed in a folder of its own.
            if (!name.contains(QLatin1String("_onlinetext")))
                student.folder = path;
            return;
        }
        QString &attempt = m_attempts[key];
        if (platform.file.isEmpty() || platform.attempt < attempt)
            return;
        if (platform.attempt > attempt && !attempt.isEmpty()) {
            student.files.clear();
            student.remark = ClassText::tr("several attempts; the last one counts");
        }
        attempt = platform.attempt;
        student.files.push_back({path, platform.file});
    }

    void takeFolder(const QByteArray &path, const QString &name, const QString &assignment)
    {
        FoundStudent student{.name = name, .folder = path, .how = ClassText::tr("folder")};
        if (!assignment.isEmpty() && name.startsWith(assignment)
            && name.size() > assignment.size()) {
            student.name = name.mid(assignment.size());
            student.how = ClassText::tr("clone of GitHub Classroom");
            ++m_platforms[Platform::GitHub];
        }
        student.id = studentIdFrom(student.name);
        m_students[QStringLiteral("folder/") + QString::fromLatin1(path.toHex())] =
            std::move(student);
    }

    void takeFile(const QByteArray &path, const QString &name)
    {
        const bool isWork = hasSuffix(name, workSuffix);
        const bool isZip = hasSuffix(name, ".zip");
        if (!isWork && !isZip && !hasSuffix(name, ".lua")) {
            m_class.remarks.append(ClassText::tr("%1 is no work of a student").arg(name));
            return;
        }
        QString who = name.left(name.lastIndexOf(u'.'));
        const QString end = u'-' + m_labId;
        if (isWork && who.endsWith(end) && who.size() > end.size())
            who.chop(end.size());
        m_students[QStringLiteral("file/") + QString::fromLatin1(path.toHex())] =
            FoundStudent{.id = studentIdFrom(who),
                         .name = who,
                         .files = {{path, isWork || isZip ? name : QStringLiteral("lab.lua")}},
                         .how = ClassText::tr("file")};
    }

    QByteArray m_root;
    QString m_labId;
    const std::vector<RosterRow> &m_roster;
    BlackboardAccounts m_accounts{};
    ClassFolder m_class{};
    std::map<QString, FoundStudent> m_students{};
    QMap<QString, QString> m_attempts{};   ///< the latest, by student
    std::map<Platform, int> m_platforms{}; ///< students of each
};

/// Ids that would be one on a disk that knows no capitals get a piece of the hash of their place.
void tellApart(std::vector<FoundStudent> &students)
{
    QHash<QString, int> count;
    for (const FoundStudent &student : students)
        ++count[student.id.toCaseFolded()];
    for (FoundStudent &student : students) {
        if (count.value(student.id.toCaseFolded()) == 1)
            continue;
        const QByteArray path =
            lastName(student.folder.isEmpty() ? student.files.front().path : student.folder);
        student.id +=
            u'-'
            + QString::fromLatin1(
                QCryptographicHash::hash(path, QCryptographicHash::Sha256).toHex().left(8));
    }
    std::sort(students.begin(), students.end(),
              [](const FoundStudent &a, const FoundStudent &b) { return a.id < b.id; });
}

} // namespace

Result<ClassFolder> readClassFolder(const QByteArray &path, const QString &labId,
                                    const std::vector<RosterRow> &roster)
{
    QByteArray root = path;
    while (root.size() > 1 && root.endsWith('/'))
        root.chop(1);
    auto entries = entriesOf(root, mostEntries);
    for (int depth = 0; entries && depth < 4; ++depth) {
        std::vector<FolderEntry> said;
        std::copy_if(entries->begin(), entries->end(), std::back_inserter(said),
                     [](const FolderEntry &entry) { return !isNoise(entry.name); });
        if (said.size() != 1 || said.front().kind != FolderEntry::Kind::Folder
            || platformName(shownName(said.front().name), true))
            break;
        const QByteArray inner = root + '/' + said.front().name;
        auto below = entriesOf(inner, mostEntries);
        // A class of one student is one, too.
        if (!below || isOneStudents(*below))
            break;
        const bool hasFolders =
            std::any_of(below->begin(), below->end(), [](const FolderEntry &entry) {
                return !isNoise(entry.name) && entry.kind == FolderEntry::Kind::Folder;
            });
        const bool isDownload =
            std::any_of(below->begin(), below->end(), [](const FolderEntry &entry) {
                return platformName(shownName(entry.name), false).has_value()
                       || hasSuffix(shownName(entry.name), workSuffix);
            });
        if (!hasFolders && !isDownload)
            break;
        root = inner;
        entries = std::move(below);
    }
    if (!entries)
        return entries.error();
    if (isOneStudents(*entries))
        return Error{.message = ClassText::tr("this is the work of one student; the folder that "
                                              "holds those of all is right"),
                     .file = shownName(path)};
    ClassFolder found = ClassReader(root, labId, roster).read(*entries);
    std::erase_if(found.students, [&](const FoundStudent &student) {
        const bool empty = student.folder.isEmpty() && student.files.empty();
        if (empty)
            found.remarks.append(ClassText::tr("%1 handed in no file").arg(student.name));
        return empty;
    });
    if (!roster.empty())
        applyRoster(found, roster);
    tellApart(found.students);
    return found;
}

std::vector<FoundStudent> shardOf(const std::vector<FoundStudent> &students, int index, int count)
{
    std::vector<FoundStudent> shard;
    for (std::size_t i = static_cast<std::size_t>(index - 1); i < students.size();
         i += static_cast<std::size_t>(count))
        shard.push_back(students[i]);
    return shard;
}

} // namespace cradle
