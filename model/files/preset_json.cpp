// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "model/world/shortest_number.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <array>

namespace cradle {

namespace {

/// Larger than 100,000 circles need; a file beyond it is refused unread.
constexpr qint64 maxPresetBytes = 32 * 1024 * 1024;

template <typename T>
struct Named {
    T value;
    const char *name;
};
template <typename T>
Named(T, const char *) -> Named<T>;

constexpr std::array wallNames{Named{WallLaw::None, "none"}, Named{WallLaw::Reflect, "reflect"}};
constexpr std::array circleNames{Named{CircleLaw::None, "none"}, Named{CircleLaw::Stop, "stop"},
                                 Named{CircleLaw::SwapVelocities, "swap_velocities"},
                                 Named{CircleLaw::SwapNormal, "swap_normal"},
                                 Named{CircleLaw::Impulse, "impulse"}};
constexpr std::array timingNames{Named{Timing::Discrete, "discrete"},
                                 Named{Timing::Continuous, "continuous"},
                                 Named{Timing::Exact, "exact"}};
constexpr std::array integratorNames{
    Named{Integrator::Euler, "euler"}, Named{Integrator::SymplecticEuler, "symplectic_euler"},
    Named{Integrator::Verlet, "verlet"}, Named{Integrator::RungeKutta4, "rk4"}};

template <typename Table, typename T>
QString nameIn(const Table &table, T value)
{
    for (const auto &entry : table) {
        if (entry.value == value)
            return QString::fromLatin1(entry.name);
    }
    return {};
}

template <typename Table>
QStringList namesIn(const Table &table)
{
    QStringList names;
    for (const auto &entry : table)
        names.append(QString::fromLatin1(entry.name));
    return names;
}

template <typename T, std::size_t N>
std::optional<T> valueIn(const std::array<Named<T>, N> &table, const QString &name)
{
    for (const auto &entry : table) {
        if (name == QLatin1String(entry.name))
            return entry.value;
    }
    return std::nullopt;
}

Vec2 toVec2(const QJsonValue &value, Vec2 fallback = {})
{
    const QJsonArray list = value.toArray();
    return list.size() == 2 ? Vec2{list.at(0).toDouble(), list.at(1).toDouble()} : fallback;
}

PresetCircle circleFrom(const QJsonObject &json, std::size_t index)
{
    PresetCircle circle;
    circle.name =
        json.value(QStringLiteral("name")).toString(QStringLiteral("circle %1").arg(index + 1));
    circle.body.position = toVec2(json.value(QStringLiteral("position")));
    circle.body.velocity = toVec2(json.value(QStringLiteral("velocity")));
    circle.body.radius = json.value(QStringLiteral("radius")).toDouble(circle.body.radius);
    circle.body.density = json.value(QStringLiteral("density")).toDouble(circle.body.density);
    circle.colour = json.value(QStringLiteral("colour")).toString(circle.colour);
    circle.integrator =
        valueIn(integratorNames, json.value(QStringLiteral("integrator")).toString())
            .value_or(circle.integrator);
    return circle;
}

CircleFill fillFrom(const QJsonObject &json)
{
    CircleFill fill;
    fill.count = json.value(QStringLiteral("count")).toInt();
    fill.radius = json.value(QStringLiteral("radius")).toDouble(fill.radius);
    fill.rmsSpeed = json.value(QStringLiteral("rms_speed")).toDouble(fill.rmsSpeed);
    fill.density = json.value(QStringLiteral("density")).toDouble(fill.density);
    fill.seed = json.value(QStringLiteral("seed")).toInteger(fill.seed);
    return fill;
}

Preset scalarsFrom(const QJsonObject &json)
{
    Preset preset;
    preset.name = json.value(QStringLiteral("name")).toString();
    preset.halfWidth = json.value(QStringLiteral("square"))
                           .toObject()
                           .value(QStringLiteral("half_width"))
                           .toDouble(preset.halfWidth);
    preset.gravity = toVec2(json.value(QStringLiteral("gravity")));
    preset.restitution = json.value(QStringLiteral("restitution")).toDouble(preset.restitution);
    preset.timestep = json.value(QStringLiteral("timestep")).toDouble(preset.timestep);
    const QJsonObject laws = json.value(QStringLiteral("laws")).toObject();
    const auto law = [&](const char *key) { return laws.value(QLatin1String(key)).toString(); };
    preset.laws.walls = valueIn(wallNames, law("walls")).value_or(preset.laws.walls);
    preset.laws.circles = valueIn(circleNames, law("circles")).value_or(preset.laws.circles);
    preset.laws.timing = valueIn(timingNames, law("timing")).value_or(preset.laws.timing);
    return preset;
}

QString quoted(const QString &text)
{
    // QJsonDocument knows how to escape; a list of one is the smallest document that it writes.
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

QString pair(Vec2 v)
{
    return QStringLiteral("[%1, %2]").arg(shortestNumber(v.x), shortestNumber(v.y));
}

QString circleText(const PresetCircle &c)
{
    return QStringLiteral("    {\"name\": %1, \"position\": %2, \"velocity\": %3, "
                          "\"radius\": %4, \"density\": %5,\n"
                          "     \"colour\": %6, \"integrator\": \"%7\"}")
        .arg(quoted(c.name), pair(c.body.position), pair(c.body.velocity),
             shortestNumber(c.body.radius), shortestNumber(c.body.density), quoted(c.colour),
             toName(c.integrator));
}

QString circlesText(const Preset &preset)
{
    if (preset.fill) {
        return QStringLiteral("{\"fill\": {\"count\": %1, \"radius\": %2, \"rms_speed\": %3, "
                              "\"density\": %4, \"seed\": %5}}")
            .arg(QString::number(preset.fill->count), shortestNumber(preset.fill->radius),
                 shortestNumber(preset.fill->rmsSpeed), shortestNumber(preset.fill->density),
                 QString::number(preset.fill->seed));
    }
    QStringList lines;
    for (const PresetCircle &circle : preset.circles)
        lines.append(circleText(circle));
    return lines.isEmpty() ? QStringLiteral("[]")
                           : QStringLiteral("[\n%1\n  ]").arg(lines.join(QStringLiteral(",\n")));
}

} // namespace

Result<Preset> readPreset(const QString &path)
{
    const Result<QByteArray> text = readFile(path, maxPresetBytes);
    return text ? parsePreset(*text, path) : Result<Preset>(text.error());
}

Result<Preset> parsePreset(const QByteArray &text, const QString &source)
{
    const Result<QJsonObject> json =
        parseJson(text, QStringLiteral(":/schemas/preset.schema.json"), source);
    if (!json)
        return json.error();
    Preset preset = scalarsFrom(*json);
    const QJsonValue circles = json->value(QStringLiteral("circles"));
    if (circles.isObject()) {
        preset.fill = fillFrom(circles.toObject().value(QStringLiteral("fill")).toObject());
        auto made = makeCircles(*preset.fill, preset.halfWidth);
        if (!made) {
            Error error = made.error();
            error.file = source;
            return error;
        }
        preset.circles = std::move(*made);
    } else {
        for (const QJsonValue &circle : circles.toArray())
            preset.circles.push_back(circleFrom(circle.toObject(), preset.circles.size()));
    }
    if (std::optional<Error> fault = findFault(preset)) {
        fault->file = source;
        return *fault;
    }
    return preset;
}

QByteArray writePreset(const Preset &preset)
{
    return QStringLiteral("{\n  \"format\": 1,\n  \"name\": %1,\n"
                          "  \"square\": {\"half_width\": %2},\n  \"gravity\": %3,\n"
                          "  \"restitution\": %4,\n  \"timestep\": %5,\n"
                          "  \"laws\": {\"walls\": \"%6\", \"circles\": \"%7\", "
                          "\"timing\": \"%8\"},\n  \"circles\": %9\n}\n")
        .arg(quoted(preset.name), shortestNumber(preset.halfWidth), pair(preset.gravity),
             shortestNumber(preset.restitution), shortestNumber(preset.timestep),
             toName(preset.laws.walls), toName(preset.laws.circles), toName(preset.laws.timing),
             circlesText(preset))
        .toUtf8();
}

std::optional<Error> savePreset(const Preset &preset, const QString &path)
{
    return writeFile(path, writePreset(preset));
}

QString toName(WallLaw law)
{
    return nameIn(wallNames, law);
}

QString toName(CircleLaw law)
{
    return nameIn(circleNames, law);
}

QString toName(Timing timing)
{
    return nameIn(timingNames, timing);
}

QString toName(Integrator integrator)
{
    return nameIn(integratorNames, integrator);
}

std::optional<CircleLaw> circleLawFromName(const QString &name)
{
    return valueIn(circleNames, name);
}

std::optional<Timing> timingFromName(const QString &name)
{
    return valueIn(timingNames, name);
}

std::optional<Integrator> integratorFromName(const QString &name)
{
    return valueIn(integratorNames, name);
}

QStringList allWallLawNames()
{
    return namesIn(wallNames);
}

QStringList allCircleLawNames()
{
    return namesIn(circleNames);
}

QStringList allTimingNames()
{
    return namesIn(timingNames);
}

QStringList allIntegratorNames()
{
    return namesIn(integratorNames);
}

} // namespace cradle
