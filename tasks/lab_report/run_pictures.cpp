// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/run_pictures.h"

#include "model/run/inferred_hits.h"
#include "model/world/measurements.h"
#include "tasks/lab_report/chart_svg.h"

#include <QCoreApplication>

#include <cmath>

namespace cradle {

namespace {

struct RunPictureText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

constexpr double quietMoment = 1.0; ///< s after the start, where nothing hits

// As the window has them in light.
const QString pictureInk = QStringLiteral("#212529");
const QString kinetic = QStringLiteral("#1971c2");
const QString potential = QStringLiteral("#7048e8");
const QString alongColour = QStringLiteral("#f08c00");
const QString acrossColour = QStringLiteral("#0ca678");

template <typename Value>
std::vector<Vec2> pointsOf(const Observation &run, Value value)
{
    std::vector<Vec2> points;
    const Preset &scene = run.variant.preset;
    for (qint64 i = run.states.first(); i <= run.states.last(); ++i) {
        const double y = value(measure(run.states.circles(i), scene.gravity, scene.halfWidth));
        if (std::isfinite(y))
            points.push_back({run.states.time(i), y});
    }
    return points;
}

} // namespace

TellingMoment tellingMoment(const Observation &run)
{
    const Preset &scene = run.variant.preset;
    const Recording &states = run.states;
    TellingMoment wall;
    std::vector<Hit> hits;
    for (qint64 i = states.first() + 1; i <= states.last(); ++i) {
        hits.clear();
        const auto before = states.circles(i - 1);
        const auto after = states.circles(i);
        inferHits(scene, {before.begin(), before.end()}, {after.begin(), after.end()},
                  run.timestep(), states.step(i), states.time(i), hits);
        for (const Hit &hit : hits) {
            if (hit.kind == Hit::Kind::Circle)
                return {i, states.time(i), TellingMoment::Kind::Circles};
            if (wall.kind == TellingMoment::Kind::Time)
                wall = {i, states.time(i), TellingMoment::Kind::Wall};
        }
    }
    if (wall.kind == TellingMoment::Kind::Wall)
        return wall;
    const qint64 index = states.indexAt(quietMoment);
    return {index, states.time(index), TellingMoment::Kind::Time};
}

QByteArray momentumSvg(const Observation &run)
{
    return chartSvg(420.0, 150.0, RunPictureText::tr("Momentum of all circles, kg m/s"),
                    {{QStringLiteral("Σ p_x"),
                      pointsOf(run, [](const Totals &t) { return t.momentum.x; }),
                      {alongColour, 1.6}},
                     {QStringLiteral("Σ p_y"),
                      pointsOf(run, [](const Totals &t) { return t.momentum.y; }),
                      {acrossColour, 1.6, QStringLiteral("6 2")}}});
}

QByteArray energySvg(const Observation &run)
{
    return chartSvg(420.0, 150.0, RunPictureText::tr("Energy of all circles, J"),
                    {{RunPictureText::tr("kinetic"),
                      pointsOf(run, [](const Totals &t) { return t.kinetic; }),
                      {kinetic, 1.4, QStringLiteral("6 2")}},
                     {RunPictureText::tr("potential"),
                      pointsOf(run, [](const Totals &t) { return t.potential; }),
                      {potential, 1.4, QStringLiteral("2 2")}},
                     {RunPictureText::tr("sum"),
                      pointsOf(run, [](const Totals &t) { return t.total(); }),
                      {pictureInk, 1.8}}});
}

EnergyCurve energyCurve(const QString &name, const Observation &run)
{
    std::vector<Vec2> points = pointsOf(run, [](const Totals &t) { return t.total(); });
    const double start = points.empty() ? 0.0 : points.front().y;
    if (!(std::abs(start) > 1e-9))
        return {name, {}};
    for (Vec2 &point : points)
        point.y /= start;
    return {name, std::move(points)};
}

QByteArray energiesSvg(const std::vector<EnergyCurve> &curves)
{
    static const QString colours[] = {QStringLiteral("#1971c2"), QStringLiteral("#e8590c"),
                                      QStringLiteral("#2f9e44"), QStringLiteral("#9c36b5"),
                                      QStringLiteral("#e03131"), QStringLiteral("#0c8599")};
    static const QString dashes[] = {{}, QStringLiteral("6 2"), QStringLiteral("2 2")};
    std::vector<ChartLine> lines;
    for (std::size_t i = 0; i < curves.size(); ++i)
        lines.push_back({curves[i].name,
                         curves[i].points,
                         {colours[i % std::size(colours)], 1.3,
                          dashes[i / std::size(colours) % std::size(dashes)]}});
    return chartSvg(640.0, 320.0, RunPictureText::tr("Energy as a part of that at the start"),
                    lines);
}

} // namespace cradle
