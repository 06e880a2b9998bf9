// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/values/put_values.h"

#include "model/files/expression.h"
#include "model/world/shortest_number.h"

#include <QHash>
#include <QJsonArray>
#include <QRegularExpression>

namespace cradle {

namespace {

const QRegularExpression &mark()
{
    static const QRegularExpression form(QStringLiteral("\\{\\{([^{}\\n]+)\\}\\}"));
    return form;
}

/// The expression that is all of \p text, between marks; empty if there is more or none.
QString onlyExpression(const QString &text)
{
    static const QRegularExpression form(
        QRegularExpression::anchoredPattern(QStringLiteral("\\s*\\{\\{([^{}\\n]+)\\}\\}\\s*")));
    return form.match(text).captured(1);
}

/// The unit of the number at a place of a scene or of a check's parameters; empty if the name does
/// not tell.
QString unitAt(const QString &place)
{
    static const QHash<QString, QString> units = [] {
        QHash<QString, QString> known;
        const auto add = [&](const char *unit, std::initializer_list<const char *> names) {
            for (const char *name : names)
                known.insert(QLatin1String(name), QString::fromUtf8(unit));
        };
        add("m", {"position", "positions", "radius", "radii", "half_width"});
        add("m/s", {"velocity", "velocities", "speeds", "rms_speed"});
        add("m/s²", {"gravity"});
        add("s", {"timestep", "timesteps", "duration"});
        add("°", {"angles"});
        add("1000 kg/m³", {"density", "densities"});
        return known;
    }();
    static const QRegularExpression index(QStringLiteral("(/\\d+)+$"));
    return units.value(QString(place).remove(index).section(QLatin1Char('/'), -1));
}

/// Puts numbers into everything below a value of JSON.
class Putting
{
public:
    explicit Putting(const Values &values)
        : m_values(values)
    {
    }

    [[nodiscard]] const std::optional<Error> &fault() const { return m_fault; }

    /// As it is in a lab without values, where braces are braces.
    QJsonValue text(const QString &value, const QString &place)
    {
        if (m_values.isEmpty())
            return value;
        const Result<QString> put = withNumbers(value, m_values);
        return put ? QJsonValue(*put) : fail(put.error(), place, value);
    }

    QJsonValue number(const QString &expression, const QString &value, const QString &place,
                      const QString &unit)
    {
        const Result<double> number = evaluated(expression, m_values, unit);
        return number ? QJsonValue(*number) : fail(number.error(), place, value);
    }

    /// \param ofScene  whether a text is an expression, but for names of things
    QJsonValue all(const QJsonValue &value, const QString &place, bool ofScene)
    {
        if (value.isObject()) {
            QJsonObject object = value.toObject();
            for (auto it = object.begin(); it != object.end(); ++it) {
                const QString below = place + QLatin1Char('/') + it.key();
                const bool names = isName(it.key());
                it.value() = ofScene && names ? textBelow(it.value(), below)
                                              : all(it.value(), below, ofScene);
            }
            return object;
        }
        if (value.isArray()) {
            QJsonArray list = value.toArray();
            for (qsizetype i = 0; i < list.size(); ++i)
                list[i] = all(list.at(i), QStringLiteral("%1/%2").arg(place).arg(i), ofScene);
            return list;
        }
        if (!value.isString())
            return value;
        const QString written = value.toString();
        const QString only = onlyExpression(written);
        if (!only.isEmpty())
            return number(only, written, place, unitAt(place));
        return ofScene ? number(written, written, place, unitAt(place)) : text(written, place);
    }

    /// A value of which texts stay texts, whatever is in them.
    QJsonValue textBelow(const QJsonValue &value, const QString &place)
    {
        if (value.isString())
            return text(value.toString(), place);
        if (value.isObject())
            return object(value.toObject(), place);
        if (!value.isArray())
            return value;
        QJsonArray list = value.toArray();
        for (qsizetype i = 0; i < list.size(); ++i)
            list[i] = textBelow(list.at(i), QStringLiteral("%1/%2").arg(place).arg(i));
        return list;
    }

    /// Texts of a task.json, and the numbers among its parameters.
    QJsonObject object(QJsonObject json, const QString &place)
    {
        for (auto it = json.begin(); it != json.end(); ++it) {
            const QString below = place + QLatin1Char('/') + it.key();
            const bool numbers =
                it.key() == QLatin1String("parameters") || it.key() == QLatin1String("scene");
            const bool ofAnswer =
                it.key() == QLatin1String("right") || it.key() == QLatin1String("tolerance");
            if (ofAnswer && it.value().isString() && !m_values.isEmpty())
                it.value() = number(withoutMarks(it.value().toString()), it.value().toString(),
                                    below, json.value(QStringLiteral("unit")).toString());
            else if (it.key() != QLatin1String("values"))
                it.value() = numbers ? all(it.value(), below, false) : textBelow(it.value(), below);
        }
        return json;
    }

private:
    /// Members of a scene that are words.
    static bool isName(const QString &key)
    {
        static const QStringList names{QStringLiteral("name"), QStringLiteral("colour"),
                                       QStringLiteral("integrator"), QStringLiteral("laws")};
        return names.contains(key);
    }

    QJsonValue fail(Error error, const QString &place, const QString &value)
    {
        error.pointer = place;
        if (!m_fault)
            m_fault = error;
        return value;
    }

    const Values &m_values;
    std::optional<Error> m_fault{};
};

} // namespace

QString withoutMarks(const QString &expression)
{
    return QString(expression).replace(mark(), QStringLiteral("(\\1)"));
}

Result<QString> withNumbers(const QString &text, const Values &values, bool lenient)
{
    QString result;
    qsizetype end = 0;
    for (auto each = mark().globalMatch(text); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        const Result<double> number = evaluated(match.captured(1), values);
        if (!number && !lenient)
            return number.error();
        result += QStringView(text).mid(end, match.capturedStart() - end);
        result += number ? shortestNumber(*number) : match.captured();
        end = match.capturedEnd();
    }
    return result + text.mid(end);
}

Result<QJsonObject> sceneWithNumbers(const QJsonObject &scene, const Values &values)
{
    Putting putting(values);
    const QJsonObject put = putting.all(scene, {}, true).toObject();
    return putting.fault() ? Result<QJsonObject>(*putting.fault()) : put;
}

Result<QJsonObject> taskWithNumbers(const QJsonObject &task, const Values &values)
{
    Putting putting(values);
    const QJsonObject put = putting.object(task, {});
    return putting.fault() ? Result<QJsonObject>(*putting.fault()) : put;
}

} // namespace cradle
