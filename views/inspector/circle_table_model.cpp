// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/inspector/circle_table_model.h"

#include "model/world/shortest_number.h"
#include "views/circle_name.h"
#include "views/theme.h"

namespace cradle {

namespace {

/// The number of \p circle that \p column shows, to read or to write; nullptr if it is computed.
template <typename C>
auto *numberOf(C &circle, int column)
{
    auto &body = circle.body;
    switch (column) {
    case CircleTableModel::X:
        return &body.position.x;
    case CircleTableModel::Y:
        return &body.position.y;
    case CircleTableModel::VelocityX:
        return &body.velocity.x;
    case CircleTableModel::VelocityY:
        return &body.velocity.y;
    case CircleTableModel::Radius:
        return &body.radius;
    case CircleTableModel::Density:
        return &body.density;
    default:
        break;
    }
    return static_cast<decltype(&body.radius)>(nullptr);
}

/// What the undo list calls a change.
QString editText(int column, const QString &name)
{
    switch (column) {
    case CircleTableModel::Colour:
        return CircleTableModel::tr("Change colour of %1").arg(name);
    case CircleTableModel::Name:
        return CircleTableModel::tr("Rename %1").arg(name);
    case CircleTableModel::X:
    case CircleTableModel::Y:
        return CircleTableModel::tr("Change position of %1").arg(name);
    case CircleTableModel::VelocityX:
    case CircleTableModel::VelocityY:
        return CircleTableModel::tr("Change velocity of %1").arg(name);
    case CircleTableModel::Radius:
        return CircleTableModel::tr("Change radius of %1").arg(name);
    case CircleTableModel::Density:
        return CircleTableModel::tr("Change density of %1").arg(name);
    default:
        break;
    }
    return CircleTableModel::tr("Change integrator of %1").arg(name);
}

/// Sets what \p column shows of \p circle.
void setValue(PresetCircle &circle, int column, const QVariant &value)
{
    if (double *number = numberOf(circle, column))
        *number = value.toDouble();
    else if (column == CircleTableModel::Colour)
        circle.colour = value.toString();
    else if (column == CircleTableModel::Name)
        circle.name = keptCircleName(value.toString().simplified());
    else if (column == CircleTableModel::IntegratorColumn)
        circle.integrator = static_cast<Integrator>(value.toInt());
}

} // namespace

CircleTableModel::CircleTableModel(PresetDocument &document, QObject *parent)
    : QAbstractTableModel(parent)
    , m_document(document)
    , m_rows(static_cast<int>(document.preset().circles.size()))
{
}

int CircleTableModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int CircleTableModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(ColumnCount);
}

QVariant CircleTableModel::text(const PresetCircle &circle, int column) const
{
    if (const double *number = numberOf(circle, column))
        return shortestNumber(*number);
    if (column == Name)
        return shownCircleName(circle.name);
    if (column == IntegratorColumn)
        return integratorCell(circle.integrator);
    if (column == Mass) {
        const double kilograms = mass(circle.body);
        const int digits = m_isBrief ? 4 : 5;
        const bool fits = kilograms >= 1e4 && kilograms < 1e7;
        return fits ? QString::number(kilograms, 'f', 0) : QString::number(kilograms, 'g', digits);
    }
    return {};
}

QVariant CircleTableModel::value(const PresetCircle &circle, int column) const
{
    if (const double *number = numberOf(circle, column))
        return *number;
    if (column == Colour)
        return circle.colour;
    if (column == Name)
        return shownCircleName(circle.name);
    if (column == IntegratorColumn)
        return static_cast<int>(circle.integrator);
    return mass(circle.body);
}

QVariant CircleTableModel::data(const QModelIndex &index, int role) const
{
    const auto &circles = m_document.preset().circles;
    const auto row = static_cast<std::size_t>(index.row());
    if (!index.isValid() || row >= circles.size())
        return {};
    const int column = index.column();
    const bool numeric = isNumber(column) || column == Mass;
    switch (role) {
    case Qt::DisplayRole:
        return text(circles[row], column);
    case Qt::EditRole:
        return value(circles[row], column);
    case Qt::ToolTipRole:
        if (const QString why = whyLocked(index); !why.isEmpty())
            return why;
        [[fallthrough]];
    case Qt::AccessibleTextRole: {
        QString shown = text(circles[row], column).toString();
        if (column == Colour)
            shown = circles[row].colour;
        else if (column == IntegratorColumn)
            shown = nameOf(circles[row].integrator);
        const QString unit = unitOf(column);
        if (unit.isEmpty())
            return shown;
        // "7.8 · 1000 kg/m³": else it would be one number.
        return shown + (unit[0].isDigit() ? QStringLiteral(" · ") : QStringLiteral(" ")) + unit;
    }
    case Qt::TextAlignmentRole:
        return QVariant(numeric ? Qt::AlignRight | Qt::AlignVCenter
                                : Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::FontRole:
        return numeric ? QVariant(numericFont()) : QVariant();
    case Qt::BackgroundRole:
        return isFault(index) ? QVariant(theme().warningSoft) : QVariant();
    case Qt::ForegroundRole:
        if (isFault(index))
            return theme().warning;
        return column == Mass || !whyLocked(index).isEmpty() ? QVariant(theme().mutedText)
                                                             : QVariant();
    default:
        return {};
    }
}

Qt::ItemFlags CircleTableModel::flags(const QModelIndex &index) const
{
    const Qt::ItemFlags plain = QAbstractTableModel::flags(index);
    return index.column() == Mass || !whyLocked(index).isEmpty() ? plain
                                                                 : plain | Qt::ItemIsEditable;
}

bool CircleTableModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    const auto row = static_cast<std::size_t>(index.row());
    if (!index.isValid() || row >= m_document.preset().circles.size() || index.column() == Mass)
        return false;
    Preset changed = m_document.preset();
    const QString name = shownCircleName(changed.circles[row].name);
    setValue(changed.circles[row], index.column(), value);
    if (changed == m_document.preset())
        return true;
    changed.fill.reset(); // the crowd is a list from now on
    const QString key =
        role == spinningRole
            ? QStringLiteral("spin:/circles/%1/%2").arg(index.row()).arg(index.column())
            : QString();
    return m_document.edit(editText(index.column(), name), changed, key);
}

QString CircleTableModel::whyLocked(const QModelIndex &index) const
{
    QString field;
    switch (index.column()) {
    case X:
    case Y:
        field = QStringLiteral("position");
        break;
    case VelocityX:
    case VelocityY:
        field = QStringLiteral("velocity");
        break;
    case Radius:
        field = QStringLiteral("radius");
        break;
    case Density:
        field = QStringLiteral("density");
        break;
    case IntegratorColumn:
        field = QStringLiteral("integrator");
        break;
    default:
        return m_document.whyReadOnly();
    }
    const QString circle = QStringLiteral("circles/%1/").arg(index.row() + 1);
    const QString why = m_document.whyLocked(circle + field);
    const bool massive = index.column() == Radius || index.column() == Density;
    return why.isEmpty() && massive ? m_document.whyLocked(circle + QStringLiteral("mass")) : why;
}

bool CircleTableModel::isFault(const QModelIndex &index) const
{
    return index.row() == m_faultRow && index.column() == m_faultColumn;
}

void CircleTableModel::setFault(const QString &pointer)
{
    const int before = m_faultRow;
    const bool ofCircle = pointer.startsWith(QStringLiteral("/circles/"));
    m_faultRow = ofCircle ? pointer.section(QLatin1Char('/'), 2, 2).toInt() : -1;
    m_faultColumn = ofCircle ? columnOf(pointer) : -1;
    for (const int row : {before, m_faultRow}) {
        if (row >= 0 && row < m_rows)
            emit dataChanged(index(row, 0), index(row, ColumnCount - 1),
                             {Qt::BackgroundRole, Qt::ForegroundRole});
    }
}

void CircleTableModel::reload()
{
    const int rows = static_cast<int>(m_document.preset().circles.size());
    if (rows > m_rows) {
        beginInsertRows({}, m_rows, rows - 1);
        m_rows = rows;
        endInsertRows();
    } else if (rows < m_rows) {
        beginRemoveRows({}, rows, m_rows - 1);
        m_rows = rows;
        endRemoveRows();
    }
    if (rows > 0)
        emit dataChanged(index(0, 0), index(rows - 1, ColumnCount - 1));
}

void CircleTableModel::retranslate()
{
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    reload();
}

} // namespace cradle
