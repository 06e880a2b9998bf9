// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/run_difference.h"

#include "views/law_names.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct RunDifference {
    Q_DECLARE_TR_FUNCTIONS(RunDifference)
};

/// Of a crowd the first circles tell enough.
constexpr std::size_t mostDifferences = 8;

QString nameOf(double number)
{
    return QString::number(number, 'g', 4).replace(QLatin1Char('-'), QChar(0x2212));
}

QString nameOf(Vec2 v)
{
    return QStringLiteral("(%1, %2)").arg(nameOf(v.x), nameOf(v.y));
}

/// Collects "what then → now" of values that differ.
class Differences
{
public:
    template <typename Value>
    void compare(const QString &what, const Value &then, const Value &now)
    {
        if (!(then == now))
            m_all << QStringLiteral("%1 %2 → %3").arg(what, nameOf(then), nameOf(now));
    }

    void note(const QString &text) { m_all << text; }
    [[nodiscard]] const QStringList &all() const { return m_all; }

private:
    QStringList m_all;
};

void compareCircles(Differences &found, const PresetCircle &then, const PresetCircle &now,
                    std::size_t index)
{
    const QString circle = RunDifference::tr("circle %1").arg(index + 1);
    const auto of = [&circle](const char *symbol) {
        return QStringLiteral("%1 %2").arg(circle, QString::fromUtf8(symbol));
    };
    found.compare(of("v"), then.body.velocity, now.body.velocity);
    found.compare(circle, then.body.position, now.body.position);
    found.compare(of("r"), then.body.radius, now.body.radius);
    found.compare(of("ρ"), then.body.density, now.body.density);
    found.compare(circle, then.integrator, now.integrator);
}

} // namespace

QStringList differences(const RunSource &then, const RunSource &now)
{
    Differences found;
    if (then.program.isEmpty() != now.program.isEmpty())
        found.note(then.program.isEmpty() ? RunDifference::tr("laws → program")
                                          : RunDifference::tr("program → laws"));
    else if (then.program != now.program)
        found.note(RunDifference::tr("program changed"));
    const Preset &a = then.preset;
    const Preset &b = now.preset;
    found.compare(QStringLiteral("e"), a.restitution, b.restitution);
    found.compare(QStringLiteral("g"), a.gravity, b.gravity);
    found.compare(QStringLiteral("Δt"), a.timestep, b.timestep);
    found.compare(RunDifference::tr("half width"), a.halfWidth, b.halfWidth);
    found.compare(RunDifference::tr("timing"), a.laws.timing, b.laws.timing);
    found.compare(RunDifference::tr("walls"), a.laws.walls, b.laws.walls);
    found.compare(RunDifference::tr("circles"), a.laws.circles, b.laws.circles);
    if (a.circles.size() != b.circles.size()) {
        found.note(
            RunDifference::tr("%1 → %2 circles").arg(a.circles.size()).arg(b.circles.size()));
        return found.all();
    }
    for (std::size_t i = 0; i < std::min(a.circles.size(), mostDifferences); ++i)
        compareCircles(found, a.circles[i], b.circles[i], i);
    return found.all();
}

} // namespace cradle
