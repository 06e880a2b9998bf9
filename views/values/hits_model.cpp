// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/values/hits_model.h"

#include "views/hit_columns.h"
#include "views/number_text.h"
#include "views/theme.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cradle {

QString wallName(int wall)
{
    switch (static_cast<Wall>(wall)) {
    case Wall::Left:
        return HitsModel::tr("left wall");
    case Wall::Right:
        return HitsModel::tr("right wall");
    case Wall::Bottom:
        return HitsModel::tr("floor");
    case Wall::Top:
        break;
    }
    return HitsModel::tr("ceiling");
}

namespace {

/// Less than this part of the momentum is rounding, not change.
constexpr double impulseNoise = 1e-9;

double sizeOf(const HitMomentum &p)
{
    return std::max(length(p.before), length(p.after));
}

/// The momenta of one hit: as vectors, or their x alone if none of them has a y.
class MomentumText
{
public:
    explicit MomentumText(const HitMomentum &p)
        : m_scale(sizeOf(p))
        , m_isLevel(std::max(std::abs(p.before.y), std::abs(p.after.y)) <= impulseNoise * m_scale)
    {
    }

    QString operator()(Vec2 v) const
    {
        const QString x = shortNumber(v.x, m_scale);
        return m_isLevel ? x : QStringLiteral("(%1, %2)").arg(x, shortNumber(v.y, m_scale));
    }

private:
    double m_scale;
    bool m_isLevel;
};

QString whoMet(const Hit &hit)
{
    return hit.kind == Hit::Kind::Wall
               ? HitsModel::tr("%1, %2", "circle, wall").arg(hit.a + 1).arg(wallName(hit.b))
               : HitsModel::tr("%1, %2", "circle, circle").arg(hit.a + 1).arg(hit.b + 1);
}

} // namespace

HitMomentum momentumOf(const Hit &hit, std::span<const Circle> circles)
{
    const double massA = mass(circles[static_cast<std::size_t>(hit.a)]);
    HitMomentum p{massA * hit.beforeA, massA * hit.afterA};
    if (hit.kind == Hit::Kind::Circle) {
        const double massB = mass(circles[static_cast<std::size_t>(hit.b)]);
        p.before += massB * hit.beforeB;
        p.after += massB * hit.afterB;
    }
    return p;
}

QString describeHit(qint64 number, const Hit &hit, std::span<const Circle> circles)
{
    const HitMomentum p = momentumOf(hit, circles);
    const MomentumText momentum(p);
    const QString time = QString::number(hit.time, 'f', 3);
    const QString text =
        hit.kind == Hit::Kind::Circle
            ? HitsModel::tr("Hit %1 at %2 s: momentum before %3, after %4, change %5 kg m/s.")
            : HitsModel::tr("Hit %1 at %2 s, circle %6 on the %7: "
                            "momentum before %3, after %4, change %5 kg m/s.");
    const QString told =
        text.arg(number).arg(time, momentum(p.before), momentum(p.after), momentum(p.change()));
    return hit.kind == Hit::Kind::Circle ? told : told.arg(hit.a + 1).arg(wallName(hit.b));
}

QString describeEncounter(qint64 number, const Hit &first, double until)
{
    const QString from = QString::number(first.time, 'f', 3);
    const QString to = QString::number(until, 'f', 3);
    return first.kind == Hit::Kind::Wall
               ? HitsModel::tr("Hit %1: circle %2 on the %3, in contact from %4 s to %5 s.")
                     .arg(number)
                     .arg(first.a + 1)
                     .arg(wallName(first.b), from, to)
               : HitsModel::tr("Hit %1: circles %2 and %3, in contact from %4 s to %5 s.")
                     .arg(number)
                     .arg(first.a + 1)
                     .arg(first.b + 1)
                     .arg(from, to);
}

HitsModel::HitsModel(const Simulation &simulation, QObject *parent)
    : QAbstractTableModel(parent)
    , m_simulation(simulation)
{
    connect(&simulation, &Simulation::restarted, this, &HitsModel::reload);
    reload();
}

void HitsModel::reload()
{
    const Recording &recording = m_simulation.recording();
    beginResetModel();
    m_font = columnFont();
    const auto kept = static_cast<qint64>(recording.encounters().size());
    m_count = std::min(kept, mostRows);
    m_first = recording.droppedEncounters() + kept - m_count;
    endResetModel();
}

void HitsModel::update()
{
    const Recording &recording = m_simulation.recording();
    const auto kept = static_cast<qint64>(recording.encounters().size());
    const qint64 end = recording.droppedEncounters() + kept;
    const qint64 first = end - std::min(kept, mostRows);
    if (end == hitCount() && first == m_first)
        return;
    if (end < hitCount() || first >= hitCount())
        return reload();
    if (first > m_first) {
        beginRemoveRows({}, 0, static_cast<int>(first - m_first - 1));
        m_count -= first - m_first;
        m_first = first;
        endRemoveRows();
    }
    if (end > hitCount()) {
        const auto row = static_cast<int>(m_count);
        beginInsertRows({}, row, row + static_cast<int>(end - hitCount() - 1));
        m_count = end - m_first;
        endInsertRows();
    }
}

const Hit &HitsModel::hit(int row) const
{
    return m_simulation.recording().hitOf(contact(row));
}

const Encounter &HitsModel::contact(int row) const
{
    const Recording &recording = m_simulation.recording();
    const qint64 index = std::max<qint64>(0, m_first + row - recording.droppedEncounters());
    return recording.encounters()[static_cast<std::size_t>(index)];
}

std::optional<int> HitsModel::rowAt(qint64 step) const
{
    const Recording &recording = m_simulation.recording();
    const auto found = lastHit(recording.encounters(), step);
    if (!found)
        return std::nullopt;
    const qint64 row = recording.droppedEncounters() + static_cast<qint64>(*found) - m_first;
    return row >= 0 && row < m_count ? std::optional(static_cast<int>(row)) : std::nullopt;
}

int HitsModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_count);
}

int HitsModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : Count;
}

QVariant HitsModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((index.column() == Who ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::FontRole)
        return m_font;
    const Recording &recording = m_simulation.recording();
    const qint64 place = m_first + index.row() - recording.droppedEncounters();
    const bool kept = place >= 0 && place < static_cast<qint64>(recording.encounters().size());
    if (role != Qt::DisplayRole || !kept)
        return {};
    return text(contact(index.row()), index.column());
}

QString HitsModel::text(const Encounter &contact, int column) const
{
    const Recording &recording = m_simulation.recording();
    const Hit &hit = recording.hitOf(contact);
    const HitMomentum p = momentumOf(hit, recording.circles(recording.last()));
    const MomentumText momentum(p);
    switch (column) {
    case Time:
        return contact.lasts() ? QStringLiteral("%1–%2")
                                     .arg(hit.time, 0, 'f', 3)
                                     .arg(contact.endTime, 0, 'f', 3)
                               : QString::number(hit.time, 'f', 3);
    case Who:
        return whoMet(hit);
    case Impulse:
        return shortNumber(hit.impulse, sizeOf(p));
    case Before:
        return momentum(p.before);
    case After:
        return momentum(p.after);
    case Change:
        return momentum(p.change());
    default:
        return {};
    }
}

QVariant HitsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation == Qt::Vertical) {
        if (role == Qt::TextAlignmentRole)
            return int(Qt::AlignRight | Qt::AlignVCenter);
        if (role == Qt::ForegroundRole)
            return theme().mutedText;
        return role == Qt::DisplayRole ? QString::number(m_first + section + 1) : QVariant();
    }
    const bool isMomentum = section == Before || section == After || section == Change;
    if (role == unitRole)
        return section == Time      ? tr("s")
               : section == Impulse ? tr("N s")
               : isMomentum         ? tr("kg m/s")
                                    : QString();
    if (role == Qt::TextAlignmentRole)
        return int(section == Who ? Qt::AlignLeft : Qt::AlignRight);
    if (role == Qt::ToolTipRole && isMomentum)
        return tr("Momentum (p_x, p_y) of the circles of the hit; p_x alone where there is no p_y");
    if (role != Qt::DisplayRole)
        return {};
    const std::array<QString, Count> names{tr("time"),   tr("who"),   tr("impulse"),
                                           tr("before"), tr("after"), tr("change")};
    return names[static_cast<std::size_t>(section)];
}

} // namespace cradle
