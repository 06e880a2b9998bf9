// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/run_pictures.h"

#include "model/inferred_hits.h"
#include "model/measurements.h"
#include "tasks/lab_report/chart_svg.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct PictureText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

constexpr double sceneSize = 300.0;      ///< px
constexpr double sceneMargin = 6.0;      ///< px
constexpr double quietMoment = 1.0;      ///< s after the start, where nothing hits
constexpr double arrowSeconds = 0.25;    ///< of its motion that an arrow shows
constexpr std::size_t mostCircles = 400; ///< that a drawing shows with ways and arrows

// As the window has them in light.
const QString background = QStringLiteral("#f0f8ff");
const QString ink = QStringLiteral("#212529");
const QString wallColour = QStringLiteral("#1e90ff");
const QString kinetic = QStringLiteral("#1971c2");
const QString potential = QStringLiteral("#7048e8");
const QString along = QStringLiteral("#f08c00");
const QString across = QStringLiteral("#0ca678");

QString colourOf(const Preset &scene, std::size_t index)
{
    static const QString usual[] = {QStringLiteral("#1e90ff"), QStringLiteral("#e03131"),
                                    QStringLiteral("#2b8a3e"), QStringLiteral("#862e9c")};
    const QString own = index < scene.circles.size() ? scene.circles[index].colour : QString();
    // Only what cannot be anything else in a drawing.
    bool isHex = own.size() == 7 && own.startsWith(QLatin1Char('#'));
    for (qsizetype i = 1; i < own.size(); ++i)
        isHex = isHex && QStringLiteral("0123456789abcdefABCDEF").contains(own[i]);
    return isHex ? own : usual[index % std::size(usual)];
}

/// Places of the scene in a drawing; what has flown off is left out by the clip.
class Frame
{
public:
    explicit Frame(double halfWidth)
        : m_scale(0.5 * (sceneSize - 2.0 * sceneMargin) / halfWidth)
    {
    }
    [[nodiscard]] Vec2 operator()(Vec2 p) const
    {
        return {0.5 * sceneSize + m_scale * p.x, 0.5 * sceneSize - m_scale * p.y};
    }
    [[nodiscard]] double length(double metres) const { return m_scale * metres; }

private:
    double m_scale; ///< px/m
};

bool isSeen(const Circle &circle, double halfWidth)
{
    const double most = 1.05 * halfWidth; // the rest would be drawn outside
    return std::abs(circle.position.x) < most && std::abs(circle.position.y) < most;
}

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

QByteArray sceneSvg(const Observation &run, const TellingMoment &moment)
{
    const Preset &scene = run.variant.preset;
    const Recording &states = run.states;
    const Frame place(scene.halfWidth);
    SvgPicture picture(sceneSize, sceneSize,
                       PictureText::tr("The scene at %1 s").arg(moment.time, 0, 'f', 2));
    picture.rectangle({}, {sceneSize, sceneSize}, background, {});
    picture.rectangle(place({-scene.halfWidth, scene.halfWidth}),
                      Vec2{1.0, 1.0} * place.length(2.0 * scene.halfWidth), {}, {wallColour, 2.0});
    const auto circles = states.circles(moment.index);
    const std::size_t shown = std::min(circles.size(), mostCircles);
    for (std::size_t c = 0; c < shown; ++c) {
        std::vector<Vec2> way;
        const qint64 every = std::max<qint64>(1, moment.index / 200);
        for (qint64 i = states.first(); i <= moment.index; i += every) {
            if (isSeen(states.circles(i)[c], scene.halfWidth))
                way.push_back(place(states.circles(i)[c].position));
        }
        picture.polyline(way, {colourOf(scene, c), 1.2, {}, 0.45});
    }
    for (std::size_t c = 0; c < shown; ++c) {
        if (!isSeen(circles[c], scene.halfWidth))
            continue;
        picture.circle(place(circles[c].position), place.length(circles[c].radius),
                       colourOf(scene, c), {ink, 0.8});
        picture.arrow(place(circles[c].position),
                      place(circles[c].position + circles[c].velocity * arrowSeconds), ink);
        if (shown <= 4)
            picture.text(place(circles[c].position)
                             + Vec2{0.0, -place.length(circles[c].radius) - 4.0},
                         QString::number(c + 1), 11.0, ink, SvgPicture::Anchor::Middle);
    }
    return picture.toSvg();
}

QByteArray momentumSvg(const Observation &run)
{
    return chartSvg(420.0, 150.0, PictureText::tr("Momentum of all circles, kg m/s"),
                    {{QStringLiteral("Σ p_x"),
                      pointsOf(run, [](const Totals &t) { return t.momentum.x; }),
                      {along, 1.6}},
                     {QStringLiteral("Σ p_y"),
                      pointsOf(run, [](const Totals &t) { return t.momentum.y; }),
                      {across, 1.6, QStringLiteral("6 2")}}});
}

QByteArray energySvg(const Observation &run)
{
    return chartSvg(420.0, 150.0, PictureText::tr("Energy of all circles, J"),
                    {{PictureText::tr("kinetic"),
                      pointsOf(run, [](const Totals &t) { return t.kinetic; }),
                      {kinetic, 1.4, QStringLiteral("6 2")}},
                     {PictureText::tr("potential"),
                      pointsOf(run, [](const Totals &t) { return t.potential; }),
                      {potential, 1.4, QStringLiteral("2 2")}},
                     {PictureText::tr("sum"),
                      pointsOf(run, [](const Totals &t) { return t.total(); }),
                      {ink, 1.8}}});
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
    return chartSvg(640.0, 320.0, PictureText::tr("Energy as a part of that at the start"), lines);
}

} // namespace cradle
