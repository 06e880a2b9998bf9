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

/// A field of the world: its name in files and for people, and whether two scenes have it alike.
struct WorldField {
    const char *name;
    const char *said;
    bool (*isSame)(const Preset &, const Preset &);
};
constexpr WorldField worldFields[] = {
    {"gravity", QT_TRANSLATE_NOOP("Locks", "gravity"),
     [](auto &a, auto &b) { return a.gravity == b.gravity; }},
    {"restitution", QT_TRANSLATE_NOOP("Locks", "restitution"),
     [](auto &a, auto &b) { return a.restitution == b.restitution; }},
    {"timestep", QT_TRANSLATE_NOOP("Locks", "timestep"),
     [](auto &a, auto &b) { return a.timestep == b.timestep; }},
    {"half_width", QT_TRANSLATE_NOOP("Locks", "half width of the square"),
     [](auto &a, auto &b) { return a.halfWidth == b.halfWidth; }},
    {"laws/walls", QT_TRANSLATE_NOOP("Locks", "law for walls"),
     [](auto &a, auto &b) { return a.laws.walls == b.laws.walls; }},
    {"laws/circles", QT_TRANSLATE_NOOP("Locks", "law for circles"),
     [](auto &a, auto &b) { return a.laws.circles == b.laws.circles; }},
    {"laws/timing", QT_TRANSLATE_NOOP("Locks", "timing"),
     [](auto &a, auto &b) { return a.laws.timing == b.laws.timing; }},
    {"circles", QT_TRANSLATE_NOOP("Locks", "number of circles"),
     [](auto &a, auto &b) { return a.circles.size() == b.circles.size(); }},
};

/// The same of a circle, behind "circles/N/"; %1 is its name.
struct LockableField {
    const char *name;
    const char *said;
    bool (*isSame)(const PresetCircle &, const PresetCircle &);
};
constexpr LockableField lockableOfCircle[] = {
    {"position", QT_TRANSLATE_NOOP("Locks", "position of %1"),
     [](auto &a, auto &b) { return a.body.position == b.body.position; }},
    {"velocity", QT_TRANSLATE_NOOP("Locks", "velocity of %1"),
     [](auto &a, auto &b) { return a.body.velocity == b.body.velocity; }},
    {"radius", QT_TRANSLATE_NOOP("Locks", "radius of %1"),
     [](auto &a, auto &b) { return a.body.radius == b.body.radius; }},
    {"density", QT_TRANSLATE_NOOP("Locks", "density of %1"),
     [](auto &a, auto &b) { return a.body.density == b.body.density; }},
    {"mass", QT_TRANSLATE_NOOP("Locks", "mass of %1"),
     [](auto &a, auto &b) {
         return a.body.radius == b.body.radius && a.body.density == b.body.density;
     }},
    {"integrator", QT_TRANSLATE_NOOP("Locks", "integrator of %1"),
     [](auto &a, auto &b) { return a.integrator == b.integrator; }},
};

/// nullptr if no field of the \p table has that name
template <typename Field, std::size_t size>
const Field *named(const Field (&table)[size], const QString &name)
{
    const auto found = std::find_if(std::begin(table), std::end(table), [&](const Field &field) {
        return name == QLatin1String(field.name);
    });
    return found == std::end(table) ? nullptr : found;
}

/// A field of one circle.
struct LockedField {
    std::size_t circle = 0; ///< from 0
    const LockableField *field = nullptr;
};

std::optional<LockedField> circleFieldFrom(const QString &field)
{
    static const QRegularExpression form(QStringLiteral("^circles/([1-9][0-9]{0,5})/([a-z]+)$"));
    const auto match = form.match(field);
    const LockableField *known = named(lockableOfCircle, match.captured(2));
    if (!known)
        return std::nullopt;
    return LockedField{match.captured(1).toULong() - 1, known};
}

/// What is no field is alike.
bool isSame(const Preset &a, const Preset &b, const QString &field)
{
    if (const auto own = circleFieldFrom(field)) {
        const bool inA = own->circle < a.circles.size();
        const bool inB = own->circle < b.circles.size();
        return inA == inB
               && (!inA || own->field->isSame(a.circles[own->circle], b.circles[own->circle]));
    }
    const WorldField *known = named(worldFields, field);
    return !known || known->isSame(a, b);
}

} // namespace

QStringList lockableFields(const Preset &preset)
{
    QStringList fields;
    for (const WorldField &field : worldFields)
        fields.append(QLatin1String(field.name));
    const int count = std::min(static_cast<int>(preset.circles.size()), mostCircles);
    for (int circle = 1; circle <= count; ++circle) {
        for (const LockableField &field : lockableOfCircle)
            fields.append(
                QStringLiteral("circles/%1/%2").arg(circle).arg(QLatin1String(field.name)));
    }
    return fields;
}

QString lockedName(const QString &field, const Preset &preset)
{
    const auto own = circleFieldFrom(field);
    if (!own) {
        const WorldField *known = named(worldFields, field);
        return known ? LockText::tr(known->said) : field;
    }
    const QString name =
        own->circle < preset.circles.size() ? preset.circles[own->circle].name : QString();
    return LockText::tr(own->field->said)
        .arg(name.isEmpty() ? LockText::tr("circle %1").arg(own->circle + 1) : name);
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
