// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/console_model.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr qsizetype tabStop = 4;   ///< characters from one to the next
constexpr qsizetype leastCut = 30; ///< characters of a line that may be wider than the console

/// A line as it can be shown: tabs as spaces, and other signs that have no shape as a dot.
QString shown(const QString &line)
{
    QString text;
    for (const QChar sign : QStringView(line).left(ConsoleModel::longestLine)) {
        if (sign == QLatin1Char('\t'))
            text.append(QString(tabStop - text.size() % tabStop, QLatin1Char(' ')));
        else
            text.append(sign.isPrint() || sign.isSurrogate() ? sign : QChar(0x00b7));
    }
    if (line.size() > ConsoleModel::longestLine)
        text += QChar(0x2026);
    return text;
}

/// Characters that it takes at most.
qsizetype widthOf(const QString &line)
{
    const QStringView part = QStringView(line).left(ConsoleModel::longestLine);
    return part.size() + (tabStop - 1) * part.count(QLatin1Char('\t'));
}

} // namespace

ConsoleModel::ConsoleModel(const Simulation &simulation, QObject *parent)
    : QAbstractListModel(parent)
    , m_simulation(simulation)
{
    update();
}

qint64 ConsoleModel::newest() const
{
    return notes().droppedLines() + static_cast<qint64>(notes().lines().size());
}

int ConsoleModel::update()
{
    const qint64 kept = std::max(m_first, notes().droppedLines());
    if (kept >= m_end && m_end > m_first) { // none of the rows is there any more
        const int gone = rowCount();
        beginResetModel();
        m_first = kept;
        m_end = newest();
        measure(m_first);
        endResetModel();
        return gone;
    }
    const int gone = static_cast<int>(std::min(kept, m_end) - m_first);
    if (gone > 0) {
        beginRemoveRows({}, 0, gone - 1);
        m_first += gone;
        endRemoveRows();
    }
    m_first = std::max(m_first, kept);
    m_end = std::max(m_end, m_first);
    const qint64 end = newest();
    if (end > m_end) {
        const int row = rowCount();
        measure(m_end);
        beginInsertRows({}, row, row + static_cast<int>(end - m_end) - 1);
        m_end = end;
        endInsertRows();
    }
    return gone;
}

void ConsoleModel::measure(qint64 from)
{
    const auto &lines = notes().lines();
    for (qint64 i = from - notes().droppedLines(); i < static_cast<qint64>(lines.size()); ++i)
        m_width = std::max(m_width, widthOf(lines[static_cast<std::size_t>(i)].text));
}

void ConsoleModel::reload()
{
    beginResetModel();
    m_width = 0;
    m_first = notes().droppedLines();
    m_end = newest();
    measure(m_first);
    endResetModel();
}

void ConsoleModel::clear()
{
    beginResetModel();
    m_width = 0;
    m_first = newest();
    m_end = m_first;
    endResetModel();
}

const ProgramNotes::Line *ConsoleModel::line(int row) const
{
    const auto &lines = notes().lines();
    const qint64 i = m_first + row - notes().droppedLines();
    return i >= 0 && i < static_cast<qint64>(lines.size()) ? &lines[static_cast<std::size_t>(i)]
                                                           : nullptr;
}

qint64 ConsoleModel::lastStep() const
{
    return notes().lines().empty() ? 0 : notes().lines().back().step;
}

int ConsoleModel::lastRowAt(qint64 step) const
{
    const auto &lines = notes().lines();
    const auto later = std::upper_bound(
        lines.begin(), lines.end(), step,
        [](qint64 wanted, const ProgramNotes::Line &line) { return wanted < line.step; });
    const qint64 number = notes().droppedLines() + (later - lines.begin()) - 1;
    return static_cast<int>(std::clamp<qint64>(number - m_first, -1, rowCount() - 1));
}

QString ConsoleModel::text(const QList<int> &rows) const
{
    QString all;
    for (const int row : rows) {
        if (const ProgramNotes::Line *one = line(row))
            all += one->text + QLatin1Char('\n');
    }
    return all;
}

int ConsoleModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_end - m_first);
}

QVariant ConsoleModel::data(const QModelIndex &index, int role) const
{
    const ProgramNotes::Line *one = index.isValid() ? line(index.row()) : nullptr;
    if (!one)
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return shown(one->text);
    case stepRole:
        return one->step;
    case Qt::ToolTipRole:
        return toolTip(*one);
    case Qt::AccessibleTextRole:
        return one->step > 0 ? tr("step %1: %2").arg(one->step).arg(shown(one->text))
                             : shown(one->text);
    default:
        return {};
    }
}

QString ConsoleModel::toolTip(const ProgramNotes::Line &line) const
{
    const Recording &recording = m_simulation.recording();
    const qint64 index = recording.first() + line.step - recording.step(recording.first());
    QString place = tr("Printed in step %1").arg(line.step);
    if (line.step == 0)
        place = tr("Printed while the program was loaded");
    else if (index >= recording.first() && index <= recording.last())
        place = tr("Printed in step %1, at %2 s; a double click shows it")
                    .arg(line.step)
                    .arg(recording.time(index), 0, 'f', 3);
    // What is printed is no rich text, whatever it looks like.
    const QString text = line.text.size() < leastCut
                             ? QString()
                             : QStringLiteral("<p>%1</p>").arg(shown(line.text).toHtmlEscaped());
    return text + QStringLiteral("<p>%1</p>").arg(place.toHtmlEscaped());
}

} // namespace cradle
