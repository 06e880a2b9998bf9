// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/variant.h"

#include "tasks/runs/meeting_scene.h"
#include "tasks/runs/scene_draws.h"
#include "tasks/runs/shot_scene.h"
#include "tasks/runs/slow_scene.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct VariantText {
    Q_DECLARE_TR_FUNCTIONS(Variant)
};

constexpr int rallyScenes = 2;  ///< behind the encounters, where circles meet again
constexpr double lowDrop = 0.1; ///< from which a circle bounces often, m

QString timestepText(double timestep)
{
    return VariantText::tr("timestep 1/%1 s").arg(qRound(1.0 / timestep));
}

/// Makes the scenes of one check.
class VariantMaker : SceneDraws
{
public:
    VariantMaker(const Preset &submission, const CheckSpec &check, qint64 seed)
        : SceneDraws(submission, check, seed)
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
            else if (m_spec.kind == QLatin1String("slow"))
                addSlowHit(i);
            else if (m_spec.kind == QLatin1String("corners"))
                addCornerShot(i);
            else
                addShot(i, spread(i + m_random.between(0.1, 0.9)));
        }
        if (m_spec.kind == QLatin1String("slow")) {
            for (const double side : {-1.0, 1.0})
                addCreepingHit(side);
            for (int k = 0; m_spec.gravity != Vec2{} && k < letGoScenes; ++k)
                addLetGo(k);
        }
        const bool rallies = m_spec.kind == QLatin1String("encounters") && m_spec.again;
        for (int k = 0; rallies && m_spec.gravity == Vec2{} && k < rallyScenes; ++k)
            addRally(k);
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

    void add(const QString &what, const Preset &preset)
    {
        QStringList name{what, timestepText(preset.timestep)};
        if (m_spec.restitutions.size() > 1)
            name.append(QStringLiteral("e = %1").arg(preset.restitution));
        m_variants.push_back({spokenList(name), preset, m_spec.duration, true});
    }

    void addFlight(int i)
    {
        Preset preset = stage(i, needed());
        // One after the other: which of two factors is drawn first is the compiler's choice.
        const double angle = range(m_spec.angles);
        const Vec2 velocity = range(m_spec.speeds) * fromAngle(angle);
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
            const auto shot = static_cast<std::size_t>(circle);
            partRadii(preset, shot, i % 2 == 0);
            // The first, from the very middle and fast, is one that a program could know.
            const bool creeps = doesCreep(i) && preset.gravity == Vec2{};
            const double speed = range(creeps ? creepingSpeeds : m_spec.speeds);
            const Vec2 place = drawStart(m_random);
            preset.circles[shot].body.velocity =
                (i == 0 ? m_spec.speeds.y : speed) * fromAngle(degrees);
            preset.circles[shot].body.position = i == 0 ? Vec2{} : place;
            bringNear(preset, shot, m_spec.duration);
            finishShot(preset, shot, degrees);
        }
    }

    /// The first four straight at the corners, the others just beside them.
    void addCornerShot(int i)
    {
        for (const int circle : m_spec.circles) {
            Preset preset = stage(i, needed());
            const auto shot = static_cast<std::size_t>(circle);
            Circle &body = preset.circles[shot].body;
            const double room = preset.halfWidth - body.radius;
            const double quarter = 45.0 + 90.0 * i;
            const Vec2 corner = std::sqrt(2.0) * room * fromAngle(quarter);
            const Vec2 place = 0.5 * drawStart(m_random);
            body.position = i == 0 ? Vec2{} : place;
            const Vec2 way = corner - body.position;
            const int round = i / 4; // of the four corners
            const double degrees = std::atan2(way.y, way.x) * 180.0 / std::numbers::pi
                                   + round * (i % 2 == 0 ? 1.5 : -1.5);
            // Fast enough to come there in time.
            const double speed =
                std::max(range(m_spec.speeds), length(way) / (0.6 * m_spec.duration));
            body.velocity = speed * fromAngle(degrees);
            finishShot(preset, shot, degrees + 360.0);
        }
    }

    void finishShot(Preset &preset, std::size_t shot, double degrees)
    {
        drawOthers(preset, shot, m_spec.duration, m_random);
        add(VariantText::tr("circle %1 towards %2°")
                .arg(shot + 1)
                .arg(std::fmod(degrees, 360.0), 0, 'f', 1),
            preset);
    }

    void addSlowHit(int i)
    {
        Preset preset = stage(i, needed());
        // Drawn once, or the moments would not be spread evenly.
        if (i == 0)
            m_slow = drawSlowHits(m_random);
        placeSlowHit(preset, m_spec, i, m_slow, m_random);
        add(VariantText::tr("slow hit %1").arg(i + 1), preset);
    }

    void addCreepingHit(double side)
    {
        Preset preset = stage(0, needed());
        placeCreepingHit(preset, m_spec, side, m_random);
        add(side < 0.0 ? VariantText::tr("slowly to one side")
                       : VariantText::tr("slowly to the other side"),
            preset);
    }

    void addLetGo(int k)
    {
        Preset preset = stage(0, needed());
        const double duration = placeLetGo(preset, m_spec, k, m_random);
        add(VariantText::tr("let go low %1").arg(k + 1), preset);
        m_variants.back().duration = std::min(m_spec.duration, duration);
    }

    void addDrop(int i)
    {
        Preset preset = stage(i, needed());
        for (const int circle : m_spec.circles) {
            PresetCircle &c = preset.circles[static_cast<std::size_t>(circle)];
            c.body.position = {-2.0 + circle * 2.5, m_random.between(-0.5, 0.5)};
            c.body.velocity = {range(m_spec.sideways), 0.0};
            // Where nothing is lost, one bounces often.
            if (i > 0 && i + 1 == m_spec.count && preset.restitution == 1.0)
                c.body.position.y = lowDrop + c.body.radius - preset.halfWidth;
        }
        add(VariantText::tr("drop %1").arg(i + 1), preset);
    }

    void addEncounter(int i)
    {
        Preset preset = stage(i, 2);
        const double degrees = angleOf(i);
        if (i % 8 == 6) // whose masses differ by their radii alone
            preset.circles[1].body.density = preset.circles[0].body.density;
        placeEncounter(preset, m_spec, i, degrees, m_random);
        if (meetsAgain(i, preset.restitution)) {
            const double duration = placeAgain(preset, m_spec, m_random);
            add(VariantText::tr("contact %1, in front of a wall").arg(i + 1), preset);
            m_variants.back().duration = std::min(m_spec.duration, duration);
            return;
        }
        add(VariantText::tr("contact at %1°").arg(degrees, 0, 'f', 1), preset);
    }

    /// With the largest e, then with the one before it.
    void addRally(int k)
    {
        const auto last = static_cast<int>(m_spec.restitutions.size()) - 1;
        Preset preset = stage(std::max(0, last - k), 2);
        if (preset.restitution < leastRestitution)
            return;
        const double duration = placeRally(preset, m_spec, m_random);
        add(VariantText::tr("two hits on one line %1").arg(k + 1), preset);
        m_variants.back().duration = duration;
    }

    void addParting(int i)
    {
        Preset preset = stage(i, 2);
        const double degrees = spread(i + m_random.between(0.0, 1.0));
        placeParting(preset, m_spec, degrees, m_random);
        add(VariantText::tr("parting at %1°").arg(degrees, 0, 'f', 1), preset);
    }

    SlowHits m_slow;
    std::vector<Variant> m_variants;
};

} // namespace

std::vector<Variant> makeVariants(const Preset &submission, const CheckSpec &check, qint64 seed)
{
    return VariantMaker(submission, check, seed).make();
}

} // namespace cradle
