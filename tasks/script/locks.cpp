// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/locks.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

struct LockText {
    Q_DECLARE_TR_FUNCTIONS(Locks)
};

constexpr int mostCircles = 10; ///< that are offered to be locked one by one

const char *const worldFields[] = {"gravity",    "restitution",  "timestep",    "half_width",
                                   "laws/walls", "laws/circles", "laws/timing", "circles"};
const char *const circleFields[] = {"position", "velocity", "radius",
                                    "density",  "mass",     "integrator"};

/// A field of one circle.
struct LockedField {
    std::size_t circle = 0; ///< from 0
    QString name;
};

std::optional<LockedField> circleFieldFrom(const QString &field)
{
    static const QRegularExpression form(QStringLiteral("^circles/([1-9][0-9]{0,5})/([a-z]+)$"));
    const auto match = form.match(field);
    if (!match.hasMatch())
        return std::nullopt;
    return LockedField{match.captured(1).toULong() - 1, match.captured(2)};
}

bool isSame(const PresetCircle &a, const PresetCircle &b, const QString &field)
{
    if (field == QLatin1String("position"))
        return a.body.position == b.body.position;
    if (field == QLatin1String("velocity"))
        return a.body.velocity == b.body.velocity;
    if (field == QLatin1String("radius"))
        return a.body.radius == b.body.radius;
    if (field == QLatin1String("density"))
        return a.body.density == b.body.density;
    if (field == QLatin1String("integrator"))
        return a.integrator == b.integrator;
    return a.body.radius == b.body.radius && a.body.density == b.body.density;
}

bool isSame(const Preset &a, const Preset &b, const QString &field)
{
    if (const auto own = circleFieldFrom(field)) {
        const bool inA = own->circle < a.circles.size();
        const bool inB = own->circle < b.circles.size();
        return inA == inB
               && (!inA || isSame(a.circles[own->circle], b.circles[own->circle], own->name));
    }
    if (field == QLatin1String("gravity"))
        return a.gravity == b.gravity;
    if (field == QLatin1String("restitution"))
        return a.restitution == b.restitution;
    if (field == QLatin1String("timestep"))
        return a.timestep == b.timestep;
    if (field == QLatin1String("half_width"))
        return a.halfWidth == b.halfWidth;
    if (field == QLatin1String("laws/walls"))
        return a.laws.walls == b.laws.walls;
    if (field == QLatin1String("laws/circles"))
        return a.laws.circles == b.laws.circles;
    if (field == QLatin1String("laws/timing"))
        return a.laws.timing == b.laws.timing;
    return a.circles.size() == b.circles.size();
}

QString worldName(const QString &field)
{
    if (field == QLatin1String("gravity"))
        return LockText::tr("gravity");
    if (field == QLatin1String("restitution"))
        return LockText::tr("restitution");
    if (field == QLatin1String("timestep"))
        return LockText::tr("timestep");
    if (field == QLatin1String("half_width"))
        return LockText::tr("half width of the square");
    if (field == QLatin1String("laws/walls"))
        return LockText::tr("law for walls");
    if (field == QLatin1String("laws/circles"))
        return LockText::tr("law for circles");
    if (field == QLatin1String("laws/timing"))
        return LockText::tr("timing");
    return LockText::tr("number of circles");
}

QString circleFieldName(const QString &field)
{
    if (field == QLatin1String("position"))
        return LockText::tr("position of %1");
    if (field == QLatin1String("velocity"))
        return LockText::tr("velocity of %1");
    if (field == QLatin1String("radius"))
        return LockText::tr("radius of %1");
    if (field == QLatin1String("density"))
        return LockText::tr("density of %1");
    if (field == QLatin1String("integrator"))
        return LockText::tr("integrator of %1");
    return LockText::tr("mass of %1");
}

} // namespace

QStringList lockableFields(const Preset &preset)
{
    QStringList fields;
    for (const char *field : worldFields)
        fields.append(QLatin1String(field));
    const int count = std::min(static_cast<int>(preset.circles.size()), mostCircles);
    for (int circle = 1; circle <= count; ++circle) {
        for (const char *field : circleFields)
            fields.append(QStringLiteral("circles/%1/%2").arg(circle).arg(QLatin1String(field)));
    }
    return fields;
}

QString lockedName(const QString &field, const Preset &preset)
{
    const auto own = circleFieldFrom(field);
    if (!own)
        return worldName(field);
    const QString name =
        own->circle < preset.circles.size() ? preset.circles[own->circle].name : QString();
    return circleFieldName(own->name).arg(
        name.isEmpty() ? LockText::tr("circle %1").arg(own->circle + 1) : name);
}

std::optional<QString> firstChangedLock(const Preset &original, const Preset &changed,
                                        const QStringList &locked)
{
    for (const QString &field : locked) {
        if (!isSame(original, changed, field))
            return field;
    }
    return std::nullopt;
}

QString lockReason(const QString &field, const Preset &original)
{
    return LockText::tr("Fixed in this step: %1").arg(lockedName(field, original));
}

} // namespace cradle
