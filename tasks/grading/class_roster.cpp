// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/class_roster.h"

#include "tasks/grading/raw_folder.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QHash>
#include <QSet>

#include <utility>

namespace cradle {

namespace {

struct RosterMatchText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qsizetype mostIdLetters = 80;

/// A name by which a roster and a platform may agree: letters only, in the order of the alphabet of
/// its words, so that "Lovelace, Ada" is "Ada Lovelace".
QString nameKey(const QString &name)
{
    QStringList words;
    QString word;
    for (const QChar letter : name.toCaseFolded() + u' ') {
        if (letter.isLetterOrNumber())
            word += letter;
        else if (!word.isEmpty())
            words.append(std::exchange(word, {}));
    }
    words.sort();
    return words.join(u' ');
}

/// Finds the student of a row, each at most once.
class RosterMatch
{
public:
    explicit RosterMatch(const std::vector<FoundStudent> &students)
    {
        for (std::size_t i = 0; i < students.size(); ++i) {
            const FoundStudent &student = students[i];
            const QByteArray path =
                student.folder.isEmpty() ? student.files.front().path : student.folder;
            add(QStringLiteral("folder ") + shownName(lastName(path)), i);
            add(QStringLiteral("folder ") + student.name, i);
            add(QStringLiteral("id ") + student.id.toCaseFolded(), i);
            add(QStringLiteral("id ") + student.number.toCaseFolded(), i);
            add(QStringLiteral("name ") + nameKey(student.name), i);
            // Canvas: "lovelaceada".
            add(QStringLiteral("joined ") + student.name.toCaseFolded(), i);
        }
    }

    /// \return the index, or -1
    int take(const RosterRow &row)
    {
        QString joined;
        for (const QChar letter : row.name.section(u' ', -1) + row.name.section(u' ', 0, -2)) {
            if (letter.isLetterOrNumber())
                joined += letter.toCaseFolded();
        }
        const QStringList keys{
            QStringLiteral("folder ") + row.folder, QStringLiteral("id ") + row.id.toCaseFolded(),
            QStringLiteral("id ") + row.number.toCaseFolded(),
            QStringLiteral("name ") + nameKey(row.name), QStringLiteral("joined ") + joined};
        for (const QString &key : keys) {
            const auto found = m_byKey.constFind(key);
            if (key.endsWith(u' ') || found == m_byKey.constEnd() || *found < 0
                || m_taken.contains(*found))
                continue;
            m_taken.insert(*found);
            return *found;
        }
        return -1;
    }

private:
    /// What two students share tells neither.
    void add(const QString &key, std::size_t index)
    {
        const int number = static_cast<int>(index);
        const auto found = m_byKey.find(key);
        if (found == m_byKey.end())
            m_byKey.insert(key, number);
        else if (*found != number)
            *found = -1;
    }

    QHash<QString, int> m_byKey{};
    QSet<int> m_taken{};
};

} // namespace

QString studentIdFrom(const QString &name)
{
    QString id;
    bool whole = true;
    for (const QChar letter : name.normalized(QString::NormalizationForm_KD)) {
        const bool plain = letter.unicode() < 128
                           && (letter.isLetterOrNumber() || letter == u'-' || letter == u'_'
                               || letter == u'.' || letter == u'@' || letter == u'+');
        whole = whole && (plain || letter == u' ');
        if (plain)
            id += letter;
        else if (letter.category() != QChar::Mark_NonSpacing && !id.endsWith(u'-'))
            id += u'-';
    }
    while (id.startsWith(u'.') || id.startsWith(u'-'))
        id.remove(0, 1);
    if (whole && !id.isEmpty() && id.size() <= mostIdLetters)
        return id;
    const QByteArray hash =
        QCryptographicHash::hash(name.toUtf8(), QCryptographicHash::Sha256).toHex();
    return id.left(mostIdLetters - 9) + (id.isEmpty() ? QString() : QStringLiteral("-"))
           + QString::fromLatin1(hash.left(8));
}

namespace {

/// What two rows share is nobody's alone: an id gets an ending, values are drawn alike.
void tellDoubles(ClassFolder &found, const std::vector<RosterRow> &roster,
                 QString RosterRow::*field)
{
    QHash<QString, int> rows;
    for (const RosterRow &row : roster) {
        const QString text = row.*field;
        if (!text.isEmpty() && ++rows[text.toCaseFolded()] == 2)
            found.remarks.append(RosterMatchText::tr("the roster has %1 more than once").arg(text));
    }
}

} // namespace

void applyRoster(ClassFolder &found, const std::vector<RosterRow> &roster)
{
    RosterMatch match(found.students);
    tellDoubles(found, roster, &RosterRow::id);
    tellDoubles(found, roster, &RosterRow::number);
    std::vector<bool> named(found.students.size(), false);
    for (const RosterRow &row : roster) {
        const int index = match.take(row);
        if (index < 0) {
            found.missing.push_back({.id = row.id.isEmpty() ? row.folder : row.id,
                                     .name = row.name,
                                     .number = row.number,
                                     .email = row.email});
            continue;
        }
        FoundStudent &student = found.students[static_cast<std::size_t>(index)];
        named[static_cast<std::size_t>(index)] = true;
        if (!row.id.isEmpty())
            student.id = studentIdFrom(row.id);
        if (!row.name.isEmpty())
            student.name = row.name;
        if (!row.number.isEmpty() && row.number != student.number) {
            student.number = row.number;
            student.platform = Platform::None;
        }
        if (!row.number.isEmpty())
            student.rosterNumbers = QStringList{row.number, row.id};
        student.rosterNumbers.removeAll(QString());
        student.email = row.email;
        student.lateDays = row.lateDays;
    }
    for (std::size_t i = 0; i < named.size(); ++i) {
        if (!named[i])
            found.remarks.append(
                RosterMatchText::tr("%1 is not in the roster").arg(found.students[i].name));
    }
}

} // namespace cradle
