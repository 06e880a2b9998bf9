// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/variant.h"

#include "model/random.h"
#include "model/stepper.h"
#include "tasks/scene_spec.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct VariantText {
    Q_DECLARE_TR_FUNCTIONS(Variant)
};

constexpr double halfWidth = 4.0;      ///< of the square of pinned scenes, m
constexpr double timeToContact = 0.5;  ///< from the start of an encounter, s
constexpr double placeOfContact = 1.0; ///< encounters happen within ± this of the middle, m

QString timestepText(double timestep)
{
    return VariantText::tr("timestep 1/%1 s").arg(qRound(1.0 / timestep));
}

Vec2 fromAngle(double degrees)
{
    const double a = degrees * std::numbers::pi / 180.0;
    return {std::cos(a), std::sin(a)};
}

/// Makes the scenes of one check.
class VariantMaker
{
public:
    VariantMaker(const Preset &submission, const CheckSpec &check, qint64 seed)
        : m_submission(submission)
        , m_spec(check, submission.timestep)
        , m_random(check.scene.value(QStringLiteral("seed")).toInteger(seed))
    {
    }

    std::vector<Variant> make()
    {
        if (m_spec.kind == QLatin1String("own"))
            return own();
        for (int i = 0; i < m_spec.count; ++i) {
            if (m_spec.kind == QLatin1String("flight"))
                addFlight(i);
            else if (m_spec.kind == QLatin1String("encounters"))
                addEncounter(i);
            else if (m_spec.kind == QLatin1String("parting"))
                addParting(i);
            else if (m_spec.kind == QLatin1String("drop"))
                addDrop(i);
            else if (m_spec.kind == QLatin1String("corners"))
                addShot(i, 45.0 + 90.0 * i + (i / 4) * (i % 2 == 0 ? 1.5 : -1.5));
            else
                addShot(i, spread(i + m_random.between(0.1, 0.9)));
        }
        return std::move(m_variants);
    }

private:
    std::vector<Variant> own()
    {
        for (const double timestep : m_spec.timesteps) {
            Preset preset = m_submission;
            preset.timestep = timestep;
            const bool unchanged = timestep == m_submission.timestep;
            m_variants.push_back({unchanged ? QStringLiteral("preset") : timestepText(timestep),
                                  preset, m_spec.duration});
        }
        return std::move(m_variants);
    }

    /// The angle of scene \p place of all, which divide the angles evenly; degrees.
    [[nodiscard]] double spread(double place) const
    {
        return m_spec.angles.x + (m_spec.angles.y - m_spec.angles.x) * place / m_spec.count;
    }

    double range(Vec2 lowHigh) { return m_random.between(lowHigh.x, lowHigh.y); }

    /// What item \p i of a list is when the list is gone through again and again.
    static double cycle(const std::vector<double> &list, int i)
    {
        return list[static_cast<std::size_t>(i) % list.size()];
    }

    /// The student's laws over an empty stage with \p circles circles.
    Preset stage(int i, std::size_t circles)
    {
        Preset preset = m_submission;
        preset.fill.reset();
        preset.halfWidth = halfWidth;
        preset.gravity = m_spec.gravity;
        preset.restitution = cycle(m_spec.restitutions, i);
        // Offset, so that restitutions and timesteps do not go in step.
        preset.timestep =
            cycle(m_spec.timesteps, i + i / static_cast<int>(m_spec.timesteps.size()));
        preset.circles.resize(std::max(circles, needed()));
        for (PresetCircle &circle : preset.circles) {
            circle.body = {.radius = range(m_spec.radii), .density = range(m_spec.densities)};
        }
        return preset;
    }

    [[nodiscard]] std::size_t needed() const
    {
        return static_cast<std::size_t>(
                   *std::max_element(m_spec.circles.begin(), m_spec.circles.end()))
               + 1;
    }

    void add(const QString &what, const Preset &preset)
    {
        QStringList name{what, timestepText(preset.timestep)};
        if (m_spec.restitutions.size() > 1)
            name.append(QStringLiteral("e = %1").arg(preset.restitution));
        m_variants.push_back({name.join(QStringLiteral(", ")), preset, m_spec.duration, true});
    }

    void addFlight(int i)
    {
        Preset preset = stage(i, needed());
        const Vec2 velocity = range(m_spec.speeds) * fromAngle(range(m_spec.angles));
        const Vec2 place{m_random.between(-1.0, 1.0), m_random.between(-1.0, 1.0)};
        for (PresetCircle &circle : preset.circles) {
            circle.body.position = place;
            circle.body.velocity = velocity;
        }
        add(VariantText::tr("throw %1").arg(i + 1), preset);
    }

    void addShot(int i, double degrees)
    {
        for (const int circle : m_spec.circles) {
            Preset preset = stage(i, needed());
            const double speed = range(m_spec.speeds);
            preset.circles[static_cast<std::size_t>(circle)].body.velocity =
                speed * fromAngle(degrees);
            parkOthers(preset, static_cast<std::size_t>(circle));
            add(VariantText::tr("circle %1 towards %2°")
                    .arg(circle + 1)
                    .arg(std::fmod(degrees, 360.0), 0, 'f', 1),
                preset);
        }
    }

    void addDrop(int i)
    {
        Preset preset = stage(i, needed());
        for (const int circle : m_spec.circles) {
            PresetCircle &c = preset.circles[static_cast<std::size_t>(circle)];
            c.body.position = {-2.0 + circle * 2.5, m_random.between(-0.5, 0.5)};
            c.body.velocity = {0.0, 0.0};
        }
        add(VariantText::tr("drop %1").arg(i + 1), preset);
    }

    void addEncounter(int i)
    {
        Preset preset = stage(i, 2);
        Circle &a = preset.circles[0].body;
        Circle &b = preset.circles[1].body;
        const double degrees = spread(i + m_random.between(0.0, 1.0));
        const Vec2 n = fromAngle(degrees);
        // Off centre by the sine of the angle between the relative velocity and the normal.
        const double sine = m_spec.offset * m_random.between(-1.0, 1.0);
        const Vec2 u =
            range(m_spec.speeds) * (std::sqrt(1.0 - sine * sine) * n + sine * perpendicular(n));
        const Vec2 common =
            m_spec.bothMove ? range({0.5, 1.5}) * fromAngle(m_random.between(0, 360)) : Vec2{};
        a.velocity = u + common;
        b.velocity = common;
        const Vec2 place{m_random.between(-placeOfContact, placeOfContact),
                         m_random.between(-placeOfContact, placeOfContact)};
        // A part of a step more, so that the moment of contact falls anywhere inside a step.
        const double t = timeToContact + preset.timestep * m_random.uniform();
        a.position = place - t * a.velocity;
        b.position = place + (a.radius + b.radius) * n - t * b.velocity;
        add(VariantText::tr("contact at %1°").arg(degrees, 0, 'f', 1), preset);
    }

    /// As after a hit that was told late: they overlap, and for one update more while they part.
    void addParting(int i)
    {
        Preset preset = stage(i, 2);
        Circle &a = preset.circles[0].body;
        Circle &b = preset.circles[1].body;
        const double degrees = spread(i + m_random.between(0.0, 1.0));
        const Vec2 n = fromAngle(degrees);
        const double speed = range(m_spec.speeds);
        const Vec2 common = range({0.5, 1.5}) * fromAngle(m_random.between(0.0, 360.0));
        a.velocity = common - 0.5 * speed * n;
        b.velocity = common + 0.5 * speed * n;
        const double touching = a.radius + b.radius;
        const double overlap = speed * preset.timestep * m_random.between(1.2, 1.8);
        b.position = std::max(touching - overlap, 0.5 * touching) * n;
        add(VariantText::tr("parting at %1°").arg(degrees, 0, 'f', 1), preset);
    }

    /// Puts the circles that a shot does not need where it will not come.
    void parkOthers(Preset &preset, std::size_t shot) const
    {
        if (preset.circles.size() < 2)
            return;
        Preset alone = preset;
        alone.circles = {preset.circles[shot]};
        alone.laws = {WallLaw::Reflect, CircleLaw::None, Timing::Continuous};
        Stepper stepper(alone);
        World world = initialWorld(alone);
        std::vector<Hit> hits;
        std::vector<Vec2> way;
        while (world.time < m_spec.duration) {
            way.push_back(world.circles[0].position);
            stepper.advance(world, hits);
        }
        for (std::size_t other = 0; other < preset.circles.size(); ++other) {
            if (other == shot)
                continue;
            Circle &parked = preset.circles[other].body;
            const double room = preset.halfWidth - parked.radius;
            double best = -1.0;
            for (const double x : {-0.95, -0.5, 0.0, 0.5, 0.95}) {
                for (const double y : {-1.0, -0.5, 0.5, 0.95}) {
                    // Under gravity only the floor holds it.
                    if (preset.gravity != Vec2{} && y != -1.0)
                        continue;
                    const Vec2 spot{room * x, room * y};
                    double nearest = 1e9;
                    for (const Vec2 point : way)
                        nearest = std::min(nearest, length(point - spot));
                    if (nearest > best) {
                        best = nearest;
                        parked.position = spot;
                    }
                }
            }
        }
    }

    const Preset &m_submission;
    SceneSpec m_spec;
    Random m_random;
    std::vector<Variant> m_variants;
};

} // namespace

std::vector<Variant> makeVariants(const Preset &submission, const CheckSpec &check, qint64 seed)
{
    return VariantMaker(submission, check, seed).make();
}

} // namespace cradle
