// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/values_model.h"

#include "views/circle_name.h"
#include "views/number_text.h"
#include "views/theme.h"

#include <array>

namespace cradle {

namespace {

struct ColumnText {
    const char *symbol;
    const char *unit;
    const char *meaning;
};

constexpr std::array<ColumnText, ValuesModel::Count> columnTexts{{
    {"x", QT_TRANSLATE_NOOP("cradle::ValuesModel", "m"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Position to the right of the middle")},
    {"y", QT_TRANSLATE_NOOP("cradle::ValuesModel", "m"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Position above the middle")},
    {"v_x", QT_TRANSLATE_NOOP("cradle::ValuesModel", "m/s"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Velocity to the right")},
    {"v_y", QT_TRANSLATE_NOOP("cradle::ValuesModel", "m/s"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Velocity upwards")},
    {"|v|", QT_TRANSLATE_NOOP("cradle::ValuesModel", "m/s"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Speed")},
    {"p_x", QT_TRANSLATE_NOOP("cradle::ValuesModel", "kg m/s"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Momentum to the right")},
    {"p_y", QT_TRANSLATE_NOOP("cradle::ValuesModel", "kg m/s"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Momentum upwards")},
    {QT_TRANSLATE_NOOP("cradle::ValuesModel", "kinetic"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "J"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Kinetic energy")},
    {"m", QT_TRANSLATE_NOOP("cradle::ValuesModel", "kg"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Mass")},
    {"Δr", QT_TRANSLATE_NOOP("cradle::ValuesModel", "m"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Distance from the exact motion")},
    {"ΔE", QT_TRANSLATE_NOOP("cradle::ValuesModel", "J"),
     QT_TRANSLATE_NOOP("cradle::ValuesModel", "Total energy more than in the exact motion")},
}};

/// The exact circles of the moment shown; none where they are not there.
std::span<const Circle> exactCircles(const Simulation &simulation)
{
    const ShadowRun *shadow = simulation.shadow();
    return shadow ? shadow->circles(simulation.current()) : std::span<const Circle>{};
}

} // namespace

ValuesModel::ValuesModel(const Simulation &simulation, QObject *parent)
    : QAbstractTableModel(parent)
    , m_simulation(simulation)
{
    connect(&simulation, &Simulation::restarted, this, &ValuesModel::reload);
    connect(&simulation, &Simulation::shadowChanged, this, &ValuesModel::reload);
    reload();
}

void ValuesModel::refresh(int firstRow, int lastRow)
{
    m_sum.reset();
    if (firstRow <= lastRow)
        emit dataChanged(index(firstRow, 0), index(lastRow, columnCount() - 1), {Qt::DisplayRole});
}

void ValuesModel::reload()
{
    beginResetModel();
    m_sum.reset();
    m_font = columnFont();
    endResetModel();
}

int ValuesModel::circleCount() const
{
    return static_cast<int>(m_simulation.recording().circleCount());
}

int ValuesModel::rowCount(const QModelIndex &parent) const
{
    // Of a single circle the sum is the same again.
    const int count = circleCount();
    return parent.isValid() ? 0 : count + (count > 1 ? 1 : 0);
}

int ValuesModel::columnCount(const QModelIndex &parent) const
{
    if (parent.isValid())
        return 0;
    return m_simulation.shadow() && m_simulation.shadow()->isPossible() ? Count : Offset;
}

std::optional<double> ValuesModel::number(int row, int column) const
{
    if (row >= circleCount())
        return sumOf(column);
    const auto circles = m_simulation.recording().circles(m_simulation.current());
    const Circle &c = circles[static_cast<std::size_t>(row)];
    switch (column) {
    case X:
        return c.position.x;
    case Y:
        return c.position.y;
    case VelocityX:
        return c.velocity.x;
    case VelocityY:
        return c.velocity.y;
    case Mass:
        return mass(c);
    case Speed:
        return length(c.velocity);
    case MomentumX:
        return mass(c) * c.velocity.x;
    case MomentumY:
        return mass(c) * c.velocity.y;
    case Kinetic:
        return 0.5 * mass(c) * lengthSquared(c.velocity);
    default:
        return offsetOf(c, row, column);
    }
}

std::optional<double> ValuesModel::offsetOf(const Circle &circle, int row, int column) const
{
    const auto exact = exactCircles(m_simulation);
    const auto i = static_cast<std::size_t>(row);
    if (i >= exact.size())
        return std::nullopt;
    if (column == Offset)
        return length(circle.position - exact[i].position);
    const Preset &preset = m_simulation.preset();
    return measure(circle, preset.gravity, preset.halfWidth).total()
           - measure(exact[i], preset.gravity, preset.halfWidth).total();
}

std::optional<double> ValuesModel::sumOf(int column) const
{
    if (!m_sum) {
        const Preset &preset = m_simulation.preset();
        const auto circles = m_simulation.recording().circles(m_simulation.current());
        m_sum = Sum{.totals = measure(circles, preset.gravity, preset.halfWidth)};
        for (const Circle &circle : circles)
            m_sum->mass += mass(circle);
        if (const auto exact = exactCircles(m_simulation); !exact.empty())
            m_sum->energyOffset =
                deviation(circles, exact, preset.gravity, preset.halfWidth).energy;
    }
    switch (column) {
    case Mass:
        return m_sum->mass;
    case MomentumX:
        return m_sum->totals.momentum.x;
    case MomentumY:
        return m_sum->totals.momentum.y;
    case Kinetic:
        return m_sum->totals.kinetic;
    case EnergyOffset:
        return m_sum->energyOffset;
    default:
        return std::nullopt;
    }
}

QVariant ValuesModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::FontRole)
        return m_font;
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const auto value = number(index.row(), index.column());
    if (!value)
        return QString();
    if (role == Qt::DisplayRole)
        return text(*value, index.column());
    const ColumnText &column = columnTexts[static_cast<std::size_t>(index.column())];
    return tr("%1 %2", "number unit").arg(fullNumber(*value), tr(column.unit));
}

QString ValuesModel::text(double value, int column) const
{
    if (column == Mass)
        return fourDigits(value);
    const int places = column <= Speed ? narrowPlaces : widePlaces;
    return fixedNumber(value, value < 0.0 ? places : places - 1); // so that points stand in line
}

QVariant ValuesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical)
        return circleHeader(section, role);
    if (section < 0 || section >= columnCount())
        return {};
    const ColumnText &text = columnTexts[static_cast<std::size_t>(section)];
    switch (role) {
    case Qt::DisplayRole:
        return section == Kinetic ? tr(text.symbol) : QString::fromUtf8(text.symbol);
    case unitRole:
        return tr(text.unit);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return tr("%1, %2", "quantity, unit").arg(tr(text.meaning), tr(text.unit));
    default:
        return {};
    }
}

QVariant ValuesModel::circleHeader(int row, int role) const
{
    const bool isSum = row >= circleCount();
    const auto &circles = m_simulation.preset().circles;
    const auto i = static_cast<std::size_t>(row);
    switch (role) {
    case Qt::DisplayRole:
        return isSum ? QStringLiteral("Σ") : QString::number(row + 1);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        return isSum || i >= circles.size()
                   ? theme().text
                   : readableOn(circleColour(circles[i].colour), theme().panel);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return isSum || i >= circles.size() ? tr("All circles together")
                                            : shownCircleName(circles[i].name);
    default:
        return {};
    }
}

} // namespace cradle
