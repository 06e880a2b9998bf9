// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/roster.h"

#include "model/files/json_schema.h"
#include "tasks/text/plain_text.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringDecoder>

#include <algorithm>
#include <array>

namespace cradle {

namespace {

struct RosterText {
    Q_DECLARE_TR_FUNCTIONS(Grading)
};

constexpr qint64 mostRosterBytes = 16 * 1024 * 1024;
constexpr double mostLateDays = 10'000.0;

enum class Column { Folder, Id, Name, FirstName, LastName, Number, Email, LateDays };

struct ColumnName {
    const char *name;
    Column column;
};

constexpr std::array columnNames{
    ColumnName{"folder", Column::Folder},        ColumnName{"submission", Column::Folder},
    ColumnName{"file", Column::Folder},          ColumnName{"id", Column::Id},
    ColumnName{"student id", Column::Id},        ColumnName{"username", Column::Id},
    ColumnName{"user name", Column::Id},         ColumnName{"sis login id", Column::Id},
    ColumnName{"github username", Column::Id},   ColumnName{"name", Column::Name},
    ColumnName{"full name", Column::Name},       ColumnName{"student", Column::Name},
    ColumnName{"first name", Column::FirstName}, ColumnName{"last name", Column::LastName},
    ColumnName{"surname", Column::LastName},     ColumnName{"number", Column::Number},
    ColumnName{"id number", Column::Number},     ColumnName{"sis user id", Column::Number},
    ColumnName{"email", Column::Email},          ColumnName{"email address", Column::Email},
    ColumnName{"late days", Column::LateDays},
};

QChar separatorOf(const QString &line)
{
    QChar best = u',';
    for (const QChar each : {QChar(u';'), QChar(u'\t')}) {
        if (line.count(each) > line.count(best))
            best = each;
    }
    return best;
}

/// The columns of a header, by what they are.
QHash<int, qsizetype> columnsOf(const QStringList &header)
{
    QHash<int, qsizetype> columns;
    for (qsizetype i = 0; i < header.size(); ++i) {
        QString title = header[i].simplified().toLower();
        title.replace(QLatin1Char('_'), QLatin1Char(' '))
            .replace(QLatin1Char('-'), QLatin1Char(' '));
        const auto *known =
            std::find_if(columnNames.begin(), columnNames.end(),
                         [&](const ColumnName &each) { return title == QLatin1String(each.name); });
        if (known != columnNames.end() && !columns.contains(static_cast<int>(known->column)))
            columns.insert(static_cast<int>(known->column), i);
    }
    return columns;
}

} // namespace

std::vector<QStringList> tableFrom(const QString &text)
{
    const QChar separator = separatorOf(text.section(QLatin1Char('\n'), 0, 0));
    std::vector<QStringList> rows;
    QStringList row;
    QString cell;
    bool quoted = false;
    const auto endRow = [&] {
        row.append(cell);
        cell.clear();
        if (row.size() > 1 || !row.first().trimmed().isEmpty())
            rows.push_back(row);
        row.clear();
    };
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar letter = text[i];
        if (quoted && letter == u'"' && i + 1 < text.size() && text[i + 1] == u'"')
            cell += text[++i];
        else if (letter == u'"' && (quoted || cell.isEmpty()))
            quoted = !quoted;
        else if (quoted)
            cell += letter;
        else if (letter == separator) {
            row.append(cell);
            cell.clear();
        } else if (letter == u'\n')
            endRow();
        else if (letter != u'\r')
            cell += letter;
    }
    if (!row.isEmpty() || !cell.isEmpty())
        endRow();
    return rows;
}

Result<std::vector<RosterRow>> readRoster(const QString &path)
{
    const auto bytes = readFile(path, mostRosterBytes);
    if (!bytes)
        return bytes.error();
    QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString text = decode(*bytes);
    if (decode.hasError()) // as older spreadsheets save it
        text = QString::fromLatin1(*bytes);
    return rosterFrom(text, path);
}

Result<std::vector<RosterRow>> rosterFrom(const QString &text, const QString &source)
{
    const std::vector<QStringList> table =
        tableFrom(text.startsWith(QChar::ByteOrderMark) ? text.mid(1) : text);
    const auto columns = columnsOf(table.empty() ? QStringList() : table.front());
    if (!columns.contains(static_cast<int>(Column::Folder))
        && !columns.contains(static_cast<int>(Column::Id)))
        return Error{.message = RosterText::tr("this is no roster: its first line has neither a "
                                               "column \"id\" nor a column \"folder\""),
                     .file = source,
                     .line = 1};
    std::vector<RosterRow> rows;
    for (std::size_t i = 1; i < table.size(); ++i) {
        const auto cell = [&](Column column) {
            const auto at = columns.constFind(static_cast<int>(column));
            return at == columns.constEnd() ? QString()
                                            : printable(table[i].value(*at).simplified());
        };
        RosterRow row{.folder = cell(Column::Folder),
                      .id = cell(Column::Id),
                      .name = cell(Column::Name),
                      .number = cell(Column::Number),
                      .email = cell(Column::Email)};
        if (row.name.isEmpty())
            row.name =
                (cell(Column::FirstName) + QLatin1Char(' ') + cell(Column::LastName)).trimmed();
        if (row.id.isEmpty() && row.folder.isEmpty())
            return Error{.message = RosterText::tr("row %1 names nobody: it has neither an id nor "
                                                   "a folder")
                                        .arg(i + 1),
                         .file = source};
        bool isNumber = true;
        QString days = cell(Column::LateDays);
        row.lateDays = days.isEmpty()
                           ? 0.0
                           : days.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
        if (!isNumber || !(row.lateDays >= 0.0 && row.lateDays <= mostLateDays))
            return Error{.message =
                             RosterText::tr("row %1: late days are a number from 0").arg(i + 1),
                         .file = source};
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace cradle
