// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/approved_text.h"
#include "tests/made_class.h"
#include "tests/zip_maker.h"

/// What is understood of a made class, as text.
namespace cradle::classes {

using cradle::authoring::ZipMaker;

/// Fails unless \p now is what tests/approved/handed has in \p file.
inline void compare(const char *file, const QString &now)
{
    const QString difference =
        approved::compare(QStringLiteral("handed/") + QString::fromLatin1(file), now);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

/// What is said may name where the test has its files.
inline QString placed(QString said, const QByteArray &root)
{
    return root.isEmpty() ? said : said.replace(QString::fromUtf8(root), text("CLASS"));
}

/// What is understood of one student's work, or of a class, line by line.
inline QString understood(const HandedIn &handed)
{
    QString all;
    const JudgingRequest &request = handed.request;
    all += QStringLiteral("  seed %1, steps %2, numbers %3, moments %4, archive of %5 bytes\n")
               .arg(request.seed)
               .arg(request.steps.join(u' '), request.numbers.join(u' '))
               .arg(int(request.moments))
               .arg(request.archive.size());
    for (auto it = request.files.cbegin(); it != request.files.cend(); ++it)
        all += QStringLiteral("  %1: %2 bytes: %3\n")
                   .arg(it.key())
                   .arg(it->size())
                   .arg(QString::fromUtf8(it->left(40)).trimmed());
    for (auto it = request.repository.cbegin(); it != request.repository.cend(); ++it)
        all += QStringLiteral("  of its repository: %1: %2 bytes\n").arg(it.key()).arg(it->size());
    if (!handed.remark.isEmpty())
        all += QStringLiteral("  ! ") + handed.remark + u'\n';
    return all;
}

inline QString understood(const Made &made, const std::vector<RosterRow> &roster = {})
{
    const ClassFolder found = made.read(roster);
    QString all = QStringLiteral("platform %1\n").arg(int(found.platform));
    for (const QString &remark : found.remarks)
        all += QStringLiteral("! ") + remark + u'\n';
    for (const MissingStudent &missing : found.missing)
        all += QStringLiteral("missing %1 %2\n").arg(missing.id, missing.name);
    for (std::size_t i = 0; i < found.students.size(); ++i) {
        const FoundStudent &student = found.students[i];
        all += QStringLiteral("%1 | %2 | %3 | %4 | %5 | platform %6 | %7 days late | %8 | %9\n")
                   .arg(student.id, student.name, student.number, student.email,
                        student.rosterNumbers.join(u' '))
                   .arg(int(student.platform))
                   .arg(student.lateDays)
                   .arg(student.how, student.remark);
        all += understood(handedInBy(found, int(i)));
    }
    for (const auto &[index, count] : {std::pair(1, 2), {2, 2}, {3, 3}}) {
        all += QStringLiteral("shard %1 of %2:").arg(index).arg(count);
        for (const FoundStudent &student : shardOf(found.students, index, count))
            all += u' ' + student.id;
        all += u'\n';
    }
    return placed(all, made.root());
}

inline QByteArray zipped(const QList<QByteArray> &names)
{
    ZipMaker zip;
    for (const QByteArray &name : names)
        zip.add({.name = name, .content = "-- " + name + '\n'});
    return zip.toBytes();
}

} // namespace cradle::classes
