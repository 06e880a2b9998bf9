// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_validation.h"

#include "tasks/checks/check_kinds.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct FaultText {
    Q_DECLARE_TR_FUNCTIONS(CheckKinds)
};

using Type = ParameterInfo::Type;

constexpr qsizetype mostValues = 100; ///< in a list

/// A value as it stands in the file, shortened.
QString shown(const QJsonValue &value)
{
    QString text = QString::fromUtf8(
        QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact).chopped(1).mid(1));
    constexpr qsizetype longest = 60;
    return text.size() > longest ? text.left(longest) + QStringLiteral("…") : text;
}

QString namesOf(const std::vector<KindInfo> &kinds)
{
    QStringList names;
    for (const KindInfo &kind : kinds)
        names.append(kind.name);
    return names.join(QStringLiteral(", "));
}

/// "a number in m/s from 0 to 3".
QString numberText(const ParameterInfo &p)
{
    const bool whole = p.type == Type::Count;
    QString text = whole ? FaultText::tr("a whole number") : FaultText::tr("a number");
    if (!p.unit.isEmpty())
        text += FaultText::tr(" in %1").arg(p.unit);
    if (p.least && p.most)
        text += FaultText::tr(" from %1 to %2").arg(*p.least, 0, 'g', 10).arg(*p.most, 0, 'g', 10);
    return text;
}

/// What would be right for \p p.
QString rightFor(const ParameterInfo &p)
{
    const QString choices = p.choices.join(QStringLiteral(", "));
    switch (p.type) {
    case Type::Number:
    case Type::Count:
        return numberText(p);
    case Type::Flag:
        return FaultText::tr("true or false");
    case Type::Choice:
        return FaultText::tr("one of %1").arg(choices);
    case Type::Choices:
        return FaultText::tr("a list out of %1").arg(choices);
    case Type::Vector:
        return FaultText::tr("a list [x, y], each %1").arg(numberText(p));
    case Type::Vectors:
        return FaultText::tr("a list of lists [x, y], each %1").arg(numberText(p));
    case Type::Range:
        return FaultText::tr("a list [least, most], each %1").arg(numberText(p));
    case Type::Numbers:
        return FaultText::tr("a list, each %1").arg(numberText(p));
    case Type::Script:
        break;
    }
    return FaultText::tr("the name of a file in the folder checks, such as heights.lua");
}

bool isNumber(const ParameterInfo &p, const QJsonValue &value)
{
    const double number = value.toDouble(std::nan(""));
    if (!std::isfinite(number) || (p.least && number < *p.least) || (p.most && number > *p.most))
        return false;
    return p.type != Type::Count || number == std::floor(number);
}

bool isPair(const ParameterInfo &p, const QJsonValue &value)
{
    const QJsonArray pair = value.toArray();
    return pair.size() == 2 && isNumber(p, pair.at(0)) && isNumber(p, pair.at(1));
}

template <typename Fits>
bool isList(const QJsonValue &value, const Fits &fits)
{
    const QJsonArray list = value.toArray();
    return !list.isEmpty() && list.size() <= mostValues
           && std::all_of(list.begin(), list.end(), [&](const QJsonValue &v) { return fits(v); });
}

bool fits(const ParameterInfo &p, const QJsonValue &value)
{
    static const QRegularExpression file(QStringLiteral("\\A[A-Za-z0-9_-]{1,64}\\.lua\\z"));
    switch (p.type) {
    case Type::Number:
    case Type::Count:
        return isNumber(p, value);
    case Type::Flag:
        return value.isBool();
    case Type::Choice:
        return p.choices.contains(value.toString());
    case Type::Choices:
        return isList(value, [&](const QJsonValue &v) { return p.choices.contains(v.toString()); });
    case Type::Vector:
        return isPair(p, value);
    case Type::Vectors:
        return isList(value, [&](const QJsonValue &v) { return isPair(p, v); });
    case Type::Range:
        return isPair(p, value)
               && value.toArray().at(0).toDouble() <= value.toArray().at(1).toDouble();
    case Type::Numbers:
        return isList(value, [&](const QJsonValue &v) { return isNumber(p, v); });
    case Type::Script:
        break;
    }
    return file.match(value.toString()).hasMatch();
}

/// Collects the faults of one step.
class Faults
{
public:
    Faults(std::size_t circles, QString source)
        : m_circles(static_cast<int>(circles))
        , m_source(std::move(source))
    {
    }

    void judgeCheck(const QJsonObject &check, const QString &place)
    {
        judgeCircles(check, place);
        const QJsonObject parameters = check.value(QStringLiteral("parameters")).toObject();
        const KindInfo *kind = judgeKind(m_checks, check.value(QStringLiteral("kind")),
                                         place + QStringLiteral("/kind"));
        if (kind)
            judgeParameters(*kind, parameters, place + QStringLiteral("/parameters"));
        judgeScene(check, place);
        const double moment = parameters.value(QStringLiteral("time")).toDouble();
        const double end = check.value(QStringLiteral("scene"))
                               .toObject()
                               .value(QStringLiteral("duration"))
                               .toDouble(moment);
        if (moment > end)
            add(place + QStringLiteral("/parameters/time"),
                FaultText::tr("the moment %1 s is after the end of the scene; at most its duration "
                              "of %2 s is right")
                    .arg(moment)
                    .arg(end));
    }

    /// The "scene" of a check or a remark.
    void judgeScene(const QJsonObject &owner, const QString &place)
    {
        const QJsonValue value = owner.value(QStringLiteral("scene"));
        if (value.isUndefined())
            return;
        QJsonObject scene = value.toObject();
        const QString here = place + QStringLiteral("/scene");
        const KindInfo *kind =
            judgeKind(m_scenes, scene.take(QStringLiteral("kind")), here + QStringLiteral("/kind"));
        if (kind)
            judgeParameters(*kind, scene, here);
    }

    void judgeCircles(const QJsonObject &owner, const QString &place)
    {
        const QJsonArray circles = owner.value(QStringLiteral("circles")).toArray();
        for (qsizetype i = 0; i < circles.size(); ++i) {
            if (circles.at(i).toInt() > m_circles)
                add(place + QStringLiteral("/circles/%1").arg(i),
                    FaultText::tr("there is no circle %1; the scene of the step has %n circle(s)",
                                  nullptr, m_circles)
                        .arg(circles.at(i).toInt()));
        }
    }

    void add(const QString &place, const QString &message)
    {
        m_faults.push_back({.message = message, .file = m_source, .pointer = place});
    }

    [[nodiscard]] std::vector<Error> take() { return std::move(m_faults); }

private:
    const KindInfo *judgeKind(const std::vector<KindInfo> &kinds, const QJsonValue &name,
                              const QString &place)
    {
        const KindInfo *kind = findKind(kinds, name.toString());
        if (!kind)
            add(place, FaultText::tr("%1 is not right here; right would be one of %2")
                           .arg(shown(name), namesOf(kinds)));
        else if (kind->circles > m_circles)
            add(place, FaultText::tr("%1 needs %2 circles; the scene of the step has %n circle(s)",
                                     nullptr, m_circles)
                           .arg(kind->name)
                           .arg(kind->circles));
        return kind;
    }

    void judgeParameters(const KindInfo &kind, const QJsonObject &values, const QString &place)
    {
        QStringList known;
        for (const ParameterInfo &p : kind.parameters) {
            known.append(p.name);
            if (p.required && !values.contains(p.name))
                add(place,
                    FaultText::tr("\"%1\" is missing; right would be %2").arg(p.name, rightFor(p)));
        }
        for (auto it = values.begin(); it != values.end(); ++it) {
            const ParameterInfo *p = findParameter(kind, it.key());
            const QString here = place + QLatin1Char('/') + escaped(it.key());
            if (!p)
                add(here, known.isEmpty() ? FaultText::tr("%1 has no parameters").arg(kind.name)
                                          : FaultText::tr("%1 has no parameter \"%2\"; it has %3")
                                                .arg(kind.name, it.key().left(64),
                                                     known.join(QStringLiteral(", "))));
            else if (!fits(*p, it.value()))
                add(here, FaultText::tr("%1 is not right here; right would be %2")
                              .arg(shown(it.value()), rightFor(*p)));
        }
    }

    /// RFC 6901.
    static QString escaped(QString key)
    {
        return key.replace(QLatin1Char('~'), QLatin1String("~0"))
            .replace(QLatin1Char('/'), QLatin1String("~1"));
    }

    int m_circles;
    QString m_source;
    std::vector<KindInfo> m_checks = checkKinds();
    std::vector<KindInfo> m_scenes = sceneKinds();
    std::vector<Error> m_faults;
};

} // namespace

std::vector<Error> findCheckFaults(const QJsonObject &task, std::size_t circles,
                                   const QString &source)
{
    Faults faults(circles, source);
    const QJsonArray checks = task.value(QStringLiteral("checks")).toArray();
    QSet<QString> ids;
    for (qsizetype i = 0; i < checks.size(); ++i) {
        const QString place = QStringLiteral("/checks/%1").arg(i);
        const QString id = checks.at(i).toObject().value(QStringLiteral("id")).toString();
        if (ids.contains(id))
            faults.add(place + QStringLiteral("/id"),
                       FaultText::tr("another check has the id %1 already; an id of its own is "
                                     "right")
                           .arg(id));
        ids.insert(id);
        faults.judgeCheck(checks.at(i).toObject(), place);
    }
    const QJsonArray remarks = task.value(QStringLiteral("remarks")).toArray();
    for (qsizetype i = 0; i < remarks.size(); ++i) {
        const QString place = QStringLiteral("/remarks/%1").arg(i);
        faults.judgeCircles(remarks.at(i).toObject(), place);
        faults.judgeScene(remarks.at(i).toObject(), place);
    }
    return faults.take();
}

} // namespace cradle
