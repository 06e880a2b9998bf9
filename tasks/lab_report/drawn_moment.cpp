// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/drawn_moment.h"

#include "tasks/lab_report/svg_picture.h"
#include "tasks/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct PictureText {
    Q_DECLARE_TR_FUNCTIONS(LabReport)
};

constexpr double sceneSize = 300.0;       ///< px
constexpr double sceneMargin = 6.0;       ///< px
constexpr double arrowSeconds = 0.25;     ///< of its motion that an arrow shows
constexpr std::size_t mostOfOneWay = 200; ///< points

// As the window has them in light.
const QString background = QStringLiteral("#f0f8ff");
const QString momentInk = QStringLiteral("#212529");
const QString wallColour = QStringLiteral("#1e90ff");

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

/// Five digits are finer than a drawing, and short in a file.
double rounded(double value)
{
    if (!std::isfinite(value) || value == 0.0)
        return 0.0;
    return QString::number(value, 'g', 5).toDouble();
}
Vec2 rounded(Vec2 value)
{
    return {rounded(value.x), rounded(value.y)};
}

/// Places of the scene in a drawing.
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

bool isSeen(Vec2 position, double halfWidth)
{
    const double most = 1.05 * halfWidth; // the rest would be drawn outside
    return std::abs(position.x) < most && std::abs(position.y) < most;
}

} // namespace

DrawnMoment drawnMoment(const Observation &run, qint64 index)
{
    const Preset &scene = run.variant.preset;
    const Recording &states = run.states;
    DrawnMoment moment{.halfWidth = scene.halfWidth, .time = rounded(states.time(index))};
    const auto circles = states.circles(index);
    const std::size_t shown = std::min(circles.size(), mostBodiesOfMoment);
    const std::size_t most =
        std::min(mostOfOneWay, mostWayPoints / std::max<std::size_t>(1, shown));
    const auto length = index - states.first() + 1;
    const qint64 every =
        std::max<qint64>(1, (length + static_cast<qint64>(most) - 1) / static_cast<qint64>(most));
    for (std::size_t c = 0; c < shown; ++c) {
        DrawnMoment::Body body{.colour = colourOf(scene, c),
                               .radius = rounded(circles[c].radius),
                               .position = rounded(circles[c].position),
                               .velocity = rounded(circles[c].velocity)};
        for (qint64 i = states.first(); i <= index; i += every) {
            if (isSeen(states.circles(i)[c].position, scene.halfWidth))
                body.way.push_back(rounded(states.circles(i)[c].position));
        }
        moment.bodies.push_back(std::move(body));
    }
    return moment;
}

QByteArray sceneSvg(const DrawnMoment &moment)
{
    const Frame place(moment.halfWidth);
    SvgPicture picture(sceneSize, sceneSize,
                       PictureText::tr("The scene at %1 s").arg(quantityText(moment.time, 'f', 2)));
    picture.rectangle({}, {sceneSize, sceneSize}, background, {});
    picture.rectangle(place({-moment.halfWidth, moment.halfWidth}),
                      Vec2{1.0, 1.0} * place.length(2.0 * moment.halfWidth), {}, {wallColour, 2.0});
    for (const DrawnMoment::Body &body : moment.bodies) {
        std::vector<Vec2> way;
        for (const Vec2 &point : body.way)
            way.push_back(place(point));
        if (isSeen(body.position, moment.halfWidth))
            way.push_back(place(body.position));
        picture.polyline(way, {body.colour, 1.2, {}, 0.45});
    }
    int number = 0;
    for (const DrawnMoment::Body &body : moment.bodies) {
        ++number;
        if (!isSeen(body.position, moment.halfWidth))
            continue;
        picture.circle(place(body.position), place.length(body.radius), body.colour,
                       {momentInk, 0.8});
        picture.arrow(place(body.position), place(body.position + body.velocity * arrowSeconds),
                      momentInk);
        if (moment.bodies.size() <= 4)
            picture.text(place(body.position) + Vec2{0.0, -place.length(body.radius) - 4.0},
                         QString::number(number), 11.0, momentInk, SvgPicture::Anchor::Middle);
    }
    return picture.toSvg();
}

} // namespace cradle
