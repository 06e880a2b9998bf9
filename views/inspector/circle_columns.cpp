// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the columns of the table of circles are called and measured in.
#include "views/inspector/circle_table_model.h"

namespace cradle {

QVariant CircleTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical)
        return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    if (role == unitRole)
        // One unit for density everywhere; where it has no room, the tool tip names it.
        return m_isBrief && section == Density ? QString() : unitOf(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant(isNumber(section) || section == Mass ? Qt::AlignRight | Qt::AlignVCenter
                                                             : Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole)
        return {};
    const bool tip = role == Qt::ToolTipRole;
    if (m_isBrief && role == Qt::DisplayRole && !symbolOf(section).isEmpty())
        return symbolOf(section);
    switch (section) {
    case Colour:
        return tip ? tr("Colour") : QString();
    case Name:
        return tr("Name");
    case X:
        return tip ? tr("Centre, to the right") : QStringLiteral("x");
    case Y:
        return tip ? tr("Centre, upward") : QStringLiteral("y");
    case VelocityX:
        return tip ? tr("Velocity to the right") : QStringLiteral("v_x");
    case VelocityY:
        return tip ? tr("Velocity upward") : QStringLiteral("v_y");
    case Radius:
        return tr("Radius");
    case Density:
        return tip ? tr("Density in 1000 kg/m³; steel has 7.8") : tr("Density");
    case IntegratorColumn:
        return tip ? tr("How position and velocity are carried over a timestep") : tr("Integrator");
    default:
        break;
    }
    return tip ? tr("Mass of a ball of this radius and density") : tr("Mass");
}

/// Where room is scarce it stands for the name, which is told by the tool tip.
QString CircleTableModel::symbolOf(int column)
{
    switch (column) {
    case Radius:
        return QStringLiteral("r");
    case Density:
        return QStringLiteral("ρ");
    case Mass:
        return QStringLiteral("m");
    case IntegratorColumn:
        return tr("Integr.", "short for Integrator");
    default:
        return {};
    }
}

QString CircleTableModel::unitOf(int column) const
{
    switch (column) {
    case X:
    case Y:
    case Radius:
        return QStringLiteral("m");
    case VelocityX:
    case VelocityY:
        return QStringLiteral("m/s");
    case Density:
        return QStringLiteral("1000 kg/m³");
    case Mass:
        return QStringLiteral("kg");
    default:
        return {};
    }
}

double CircleTableModel::spinStep(int column)
{
    return column == Radius ? 0.05 : 0.1;
}

int CircleTableModel::columnOf(const QString &pointer)
{
    const QString key = pointer.section(QLatin1Char('/'), 3, 3);
    const bool second = pointer.endsWith(QStringLiteral("/1"));
    if (key == QStringLiteral("position"))
        return second ? Y : X;
    if (key == QStringLiteral("velocity"))
        return second ? VelocityY : VelocityX;
    if (key == QStringLiteral("radius"))
        return Radius;
    return key == QStringLiteral("density") ? Density : Name;
}

} // namespace cradle
