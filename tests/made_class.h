// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_folder.h"
#include "tasks/grading/handed_in.h"
#include "tests/text.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace cradle::classes {

using cradle::text;

/// A lab of two steps without anything in them.
inline Lab labOfTwo()
{
    Lab made;
    made.id = QStringLiteral("lab");
    for (const char *id : {"L1", "L2"}) {
        Task task;
        task.id = QString::fromLatin1(id);
        made.tasks.push_back(task);
    }
    return made;
}

/// A class that is made file by file.
class Made
{
public:
    void file(const QByteArray &path, const QByteArray &content = "x = 1\n") const
    {
        const QByteArray whole = root() + '/' + path;
        for (auto slash = whole.indexOf('/', root().size() + 1); slash > 0;
             slash = whole.indexOf('/', slash + 1))
            ::mkdir(whole.left(slash).constData(), 0700);
        const int number = ::open(whole.constData(), O_WRONLY | O_CREAT, 0600);
        QVERIFY(number >= 0);
        QCOMPARE(::write(number, content.constData(), std::size_t(content.size())),
                 ssize_t(content.size()));
        ::close(number);
    }
    [[nodiscard]] QByteArray root() const { return QFile::encodeName(m_folder.path()); }
    [[nodiscard]] ClassFolder read(const std::vector<RosterRow> &roster = {}) const
    {
        const auto found = readClassFolder(root(), QStringLiteral("lab"), roster);
        return found ? *found : ClassFolder{.remarks = {found.error().toString()}};
    }

private:
    QTemporaryDir m_folder;
};

inline QStringList idsOf(const ClassFolder &found)
{
    QStringList ids;
    for (const FoundStudent &student : found.students)
        ids.append(student.id);
    return ids;
}

/// What student \p index handed in.
inline HandedIn handedInBy(const ClassFolder &found, int index)
{
    return readHandedIn(found.students.at(std::size_t(index)), found.root, labOfTwo());
}

inline QStringList filesOf(const ClassFolder &found, int index)
{
    return handedInBy(found, index).request.files.keys();
}

} // namespace cradle::classes
