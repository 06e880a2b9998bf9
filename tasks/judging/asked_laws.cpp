// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/asked_laws.h"

#include "model/files/preset_json.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/motion.h"
#include "tasks/runs/scene_spec.h"

#include <QJsonArray>

#include <algorithm>
#include <set>

namespace cradle {

namespace {

/// All that the checks say, one after the other.
class Asking
{
public:
    explicit Asking(const Task &task)
    {
        m_laws.scene = task.preset;
        for (const CheckSpec &check : task.checks)
            include(check);
        const bool tellsAllFlights =
            std::includes(m_told.begin(), m_told.end(), m_asked.begin(), m_asked.end());
        m_laws.motion =
            !m_asked.empty() && tellsAllFlights && !m_isOpen && m_gravity && !m_hasTwoGravities;
        if (m_gravity)
            m_laws.scene.gravity = *m_gravity;
        m_laws.walls = m_laws.motion && m_bounces;
        m_laws.pair = m_laws.motion && m_pair && !m_isPairOpen;
        if (m_laws.walls)
            m_laws.scene.laws.walls = WallLaw::Reflect;
        m_laws.scene.laws.circles = m_laws.pair ? *m_pair : CircleLaw::None;
        m_laws.scene.laws.timing = Timing::Discrete;
    }

    [[nodiscard]] AskedLaws laws() && { return std::move(m_laws); }

private:
    void include(const CheckSpec &check)
    {
        // It fits any law: nobody but its author knows which forces it wants.
        m_isOpen = m_isOpen || check.kind == QLatin1String("script");
        if (check.kind == QLatin1String("start"))
            return;
        m_asked.insert(check.circles.begin(), check.circles.end());
        if (isOneOf(check.kind, {"integrates", "closed_form"}))
            includeFlight(check);
        // Others, like drops, come to one wall; of the rest nothing is asked.
        m_bounces = m_bounces
                    || (check.kind == QLatin1String("bounces")
                        && check.scene.value(QStringLiteral("kind")).toString()
                               == QLatin1String("directions"));
        if (showsOwnScene(check))
            includeGravity(check);
        includePair(check);
    }

    void includeFlight(const CheckSpec &check)
    {
        m_told.insert(check.circles.begin(), check.circles.end());
        const QJsonArray names = check.parameters.value(QStringLiteral("integrators")).toArray();
        const auto integrator = check.kind == QLatin1String("closed_form")
                                    ? std::optional(Integrator::Verlet)
                                    : integratorFromName(names.at(0).toString());
        if (!integrator)
            return;
        for (const int circle : check.circles) {
            const auto index = static_cast<std::size_t>(circle);
            if (index >= m_laws.scene.circles.size())
                m_laws.scene.circles.resize(index + 1);
            m_laws.scene.circles[index].integrator = *integrator;
        }
    }

    /// Where a check leaves gravity out, that of the student is right, whichever it is.
    void includeGravity(const CheckSpec &check)
    {
        const std::optional<Vec2> asked = motion::askedGravity(check);
        if (!asked)
            return;
        m_hasTwoGravities = m_hasTwoGravities || (m_gravity && *m_gravity != *asked);
        m_gravity = asked;
    }

    void includePair(const CheckSpec &check)
    {
        if (check.kind == QLatin1String("passes_through"))
            m_isPairOpen = true;
        if (check.kind != QLatin1String("collides"))
            return;
        const QJsonArray names = valueOf(check, QStringLiteral("laws")).toArray();
        const auto law = circleLawFromName(names.at(0).toString());
        m_isPairOpen = m_isPairOpen || names.size() > 1 || !law || (m_pair && *m_pair != *law);
        m_pair = law;
    }

    AskedLaws m_laws{};
    std::set<int> m_asked{}; ///< circles that a check looks at while they move
    std::set<int> m_told{};  ///< those of which it is told how
    std::optional<Vec2> m_gravity{};
    bool m_hasTwoGravities = false;
    bool m_isOpen = false;
    bool m_bounces = false;
    std::optional<CircleLaw> m_pair{};
    bool m_isPairOpen = false; ///< more than one law is right
};

} // namespace

bool isOneOf(const QString &kind, std::initializer_list<const char *> names)
{
    return std::any_of(names.begin(), names.end(),
                       [&](const char *name) { return kind == QLatin1String(name); });
}

AskedLaws askedLaws(const Task &task)
{
    return Asking(task).laws();
}

} // namespace cradle
