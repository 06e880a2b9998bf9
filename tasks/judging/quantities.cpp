// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/quantities.h"

#include <QRegularExpression>

#include <algorithm>

namespace cradle {

namespace {

/// Both ways round.
QStringList eitherWay(const QString &pattern, const QString &a, const QString &b)
{
    return {pattern.arg(a, b), pattern.arg(b, a)};
}

} // namespace

Quantities::Quantities(const NamesAtHand &names, const QStringList &timesteps, Aspect aspect,
                       Suspect suspect)
    : m_names(names)
    , m_timesteps(timesteps)
    , m_aspect(aspect)
    , m_suspect(suspect)
{
    const auto pair = names.pair();
    if (pair && (aspect == Aspect::Contact || aspect == Aspect::Response))
        addPair(pair->first, pair->second);
    switch (aspect) {
    case Aspect::Motion:
        m_all = {QStringLiteral("gravity"), QStringLiteral("gravity.x"),
                 QStringLiteral("gravity.y")};
        m_all += timesteps;
        addMotion();
        break;
    case Aspect::Walls:
    case Aspect::Course:
        for (const QString &radius : names.radii())
            m_all += {QStringLiteral("square.half_width - ") + radius,
                      radius + QStringLiteral(" - square.half_width"), radius};
        m_sound = m_all;
        break;
    case Aspect::Contact:
        if (pair)
            addContact(pair->first, pair->second);
        addHelper(names.parameters());
        break;
    case Aspect::Response:
        addMasses();
        if (pair) {
            addResponse(pair->first, pair->second, names.masses());
            addPushes(pair->first, pair->second, names.masses());
        }
        addHelper(names.parameters());
        if (names.masses().size() == 2)
            m_all +=
                {QStringLiteral("%1 * %2 / (%1 + %2)").arg(names.masses()[0], names.masses()[1]),
                 QStringLiteral("%1 + %2").arg(names.masses()[0], names.masses()[1]),
                 QStringLiteral("%2 / (%1 + %2)").arg(names.masses()[0], names.masses()[1]),
                 QStringLiteral("%1 / (%1 + %2)").arg(names.masses()[0], names.masses()[1])};
        break;
    case Aspect::Start:
        break;
    }
}

/// What is right wherever one circle is moved: the way and what gravity adds, in a step.
void Quantities::addMotion()
{
    m_sound = m_all;
    for (const QString &radius : m_names.radii())
        m_sound += {QStringLiteral("square.half_width - ") + radius,
                    radius + QStringLiteral(" - square.half_width")};
    for (const QString &h : m_timesteps) {
        for (const char *kick : {"gravity * %1", "gravity.x * %1", "gravity.y * %1",
                                 "gravity * %1 / 2", "gravity * %1 ^ 2", "gravity * %1 ^ 2 / 2"})
            m_sound.append(QString::fromLatin1(kick).arg(h));
        for (const NamedCircle &circle : m_names.circles()) {
            const QString &v = circle.velocity;
            for (const char *move :
                 {"%1 * %2", "%1.x * %2", "%1.y * %2", "%1 + gravity * %2", "%1 + gravity * %2 / 2",
                  "%1.x + gravity.x * %2", "%1.y + gravity.y * %2"})
                m_sound.append(QString::fromLatin1(move).arg(v, h));
            for (const char *end : {"%1 + %2 * %3", "%1.x + %2.x * %3", "%1.y + %2.y * %3"})
                m_sound.append(QString::fromLatin1(end).arg(circle.position, v, h));
        }
    }
}

/// What is right wherever two circles are named: ways, distances, normals, and the parts of
/// velocities along a normal, also one that the program has a name for.
void Quantities::addPair(const NamedCircle &a, const NamedCircle &b)
{
    const QString way = QStringLiteral("(%1 - %2)").arg(b.position, a.position);
    const QString length = way + QStringLiteral(":length()");
    const QString normal = way + QStringLiteral(":normalized()");
    const QString sum = QStringLiteral("%1 + %2").arg(a.radius, b.radius);
    m_sound = QStringList{sum,
                          length,
                          QStringLiteral("%1 - (%2)").arg(length, sum),
                          QStringLiteral("%1 - %2").arg(sum, length),
                          normal,
                          QLatin1Char('-') + normal}
              + eitherWay(QStringLiteral("%1 - %2"), b.position, a.position)
              + eitherWay(QStringLiteral("%1 - %2"), a.velocity, b.velocity);
    for (const QString &along : QStringList{normal} + m_names.normals()) {
        for (const QString &velocity : {a.velocity, b.velocity})
            m_sound += {QStringLiteral("%1:dot(%2)").arg(velocity, along),
                        QStringLiteral("-%1:dot(%2)").arg(velocity, along)};
        m_sound += eitherWay(QStringLiteral("(%1 - %2):dot(") + along + QLatin1Char(')'),
                             a.velocity, b.velocity);
    }
    m_parts = eitherWay(QStringLiteral("%1.x - %2.x"), b.position, a.position)
              + eitherWay(QStringLiteral("%1.y - %2.y"), b.position, a.position);
}

void Quantities::addContact(const NamedCircle &a, const NamedCircle &b)
{
    const QString way = QStringLiteral("(%1 - %2)").arg(b.position, a.position);
    const QString length = way + QStringLiteral(":length()");
    const QString sum = QStringLiteral("%1 + %2").arg(a.radius, b.radius);
    const QString relative = QStringLiteral("(%1 - %2)").arg(a.velocity, b.velocity);
    m_all = QStringList{sum, length, QStringLiteral("%1 - (%2)").arg(length, sum),
                        QStringLiteral("%1 - %2").arg(sum, length)}
            + eitherWay(QStringLiteral("%1 - %2"), b.position, a.position)
            + eitherWay(QStringLiteral("%1 - %2"), a.velocity, b.velocity) + m_parts
            + QStringList{QStringLiteral("%1:dot%2").arg(relative, way),
                          QStringLiteral("-%1:dot%2").arg(relative, way),
                          way + QStringLiteral(":normalized()")};
}

void Quantities::addResponse(const NamedCircle &a, const NamedCircle &b, const QStringList &masses)
{
    const QString normal = QStringLiteral("(%1 - %2):normalized()").arg(b.position, a.position);
    const auto along = [&](const QString &velocity) {
        return QStringLiteral("%1:dot(%2)").arg(velocity, normal);
    };
    const QString relative = QStringLiteral("(%1 - %2)").arg(a.velocity, b.velocity);
    for (const QString &velocity : {a.velocity, b.velocity})
        m_across.append(QStringLiteral("%1 - %2 * %3").arg(velocity, along(velocity), normal));
    m_all += QStringList{normal,
                         QLatin1Char('-') + normal,
                         along(a.velocity),
                         along(b.velocity),
                         along(relative),
                         QLatin1Char('-') + along(relative)}
             + m_across + eitherWay(QStringLiteral("%1 - %2"), a.velocity, b.velocity)
             + eitherWay(QStringLiteral("%1 - %2"), b.position, a.position);
    if (masses.size() != 2)
        return;
    const QString common = QStringLiteral("(%1 * %3 + %2 * %4) / (%1 + %2)")
                               .arg(masses[0], masses[1], along(a.velocity), along(b.velocity));
    m_all += {common, QStringLiteral("%1 * %2").arg(common, normal)};
}

/// What is right on the way to a push: masses, parts along and across, the push of a hit with e.
void Quantities::addPushes(const NamedCircle &a, const NamedCircle &b, QStringList masses)
{
    m_sound += {a.velocity, b.velocity};
    const QString relative = QStringLiteral("(%1 - %2)").arg(a.velocity, b.velocity);
    const QStringList normals =
        QStringList{QStringLiteral("(%1 - %2):normalized()").arg(b.position, a.position)}
        + m_names.normals();
    for (const QString &normal : normals) {
        const QString s = QStringLiteral("%1:dot(%2)").arg(relative, normal);
        for (const QString &v : {a.velocity, b.velocity, relative}) {
            const QString along = QStringLiteral("%1:dot(%2) * %2").arg(v, normal);
            m_sound += {along, QLatin1Char('-') + along, QStringLiteral("%1 - %2").arg(v, along)};
        }
        m_sound += {QStringLiteral("vec(-%1.y, %1.x)").arg(normal),
                    QStringLiteral("vec(%1.y, -%1.x)").arg(normal)};
        if (masses.size() != 2)
            continue;
        const QString both = QStringLiteral("(%1 + %2)").arg(masses[0], masses[1]);
        const QString reduced = QStringLiteral("%1 * %2 / %3").arg(masses[0], masses[1], both);
        const QString push = QStringLiteral("%1 * %2 * %3").arg(m_names.rebound(), s, reduced);
        m_sound += {reduced,
                    both,
                    push,
                    QLatin1Char('-') + push,
                    QStringLiteral("%1 * %2").arg(push, normal),
                    QStringLiteral("-%1 * %2").arg(push, normal),
                    QStringLiteral("(%1 * %4:dot(%6) + %2 * %5:dot(%6)) / %3")
                        .arg(masses[0], masses[1], both, a.velocity, b.velocity, normal),
                    QStringLiteral("(%1 * %4 + %2 * %5) / %3")
                        .arg(masses[0], masses[1], both, a.velocity, b.velocity)};
    }
}

/// What a function of vectors alone is likely to give.
void Quantities::addHelper(const QStringList &parameters)
{
    if (!m_names.circles().empty())
        return;
    if (parameters.size() == 1) {
        m_helpers = {parameters[0] + QStringLiteral(":length()"),
                     parameters[0] + QStringLiteral(":normalized()")};
        m_all += m_helpers;
    } else if (parameters.size() == 2) {
        const QString dot = QStringLiteral("%1:dot(%2)").arg(parameters[0], parameters[1]);
        m_all += {dot, QStringLiteral("%1 * %2").arg(dot, parameters[1]),
                  QStringLiteral("%1 - %2 * %3").arg(parameters[0], dot, parameters[1])};
    }
}

/// The mass of a ball; the factors that all have in common do not count.
void Quantities::addMasses()
{
    for (const QString &radius : m_names.radii())
        m_masses.append(QStringLiteral("4 / 3 * math.pi * %1 ^ 3").arg(radius));
    for (const NamedCircle &circle : m_names.circles()) {
        const bool isTried = m_suspect == Suspect::Masses;
        const QString mass = QStringLiteral("%1 * %2 ^ 3").arg(circle.density, circle.radius);
        if (isTried)
            m_all += {mass, QStringLiteral("1 / (%1)").arg(mass)};
        const QString volume = QStringLiteral("4 / 3 * math.pi * %1 ^ 3").arg(circle.radius);
        m_masses += {volume, mass, QStringLiteral("%1 * %2").arg(circle.density, volume),
                     QStringLiteral("1000 * %1 * %2").arg(circle.density, volume)};
    }
}

QStringList Quantities::soundFor(const QString &value) const
{
    static const QRegularExpression ofBall(
        QStringLiteral("radius|density|volume|[mM]ass|\\bpi\\b|\\br(ad)?_?\\d?\\b"));
    // A number has no length.
    const bool isOfVectors = std::all_of(
        m_names.parameters().begin(), m_names.parameters().end(), [&](const QString &name) {
            return value.contains(name + QLatin1Char('.')) || value.contains(name + u':');
        });
    return m_sound + (value.contains(ofBall) ? m_masses : QStringList{})
           + (isOfVectors ? m_helpers : QStringList{});
}

QStringList Quantities::sidesOfScene(const QString &value) const
{
    if (m_names.pair() || !m_names.circles().empty())
        return {};
    const auto [a, b] = NamesAtHand::pairOfScene();
    return sidesFor(value, QStringLiteral("%1 + %2").arg(a.radius, b.radius),
                    QStringLiteral("(%1 - %2):length()").arg(b.position, a.position));
}

QStringList Quantities::sides(const QString &value) const
{
    return m_sound.size() < 2 ? QStringList{} : sidesFor(value, m_sound[0], m_sound[1]);
}

QStringList Quantities::sidesFor(const QString &value, const QString &sum, const QString &length)
{
    static const QRegularExpression reach(
        QStringLiteral("\\br(ad|adius)?_?\\d?\\b|^[\\d.]*[1-9][\\d.]*$"));
    static const QRegularExpression distance(QStringLiteral("\\babs\\b|:length"));
    const QStringList whole = value.contains(distance) ? QStringList{length}
                              : value.contains(reach)  ? QStringList{sum}
                                                       : QStringList{};
    return whole.isEmpty() ? whole : whole + QStringList{QStringLiteral("(%1) ^ 2").arg(whole[0])};
}

QStringList Quantities::completed(const QString &value, const QStringList &forgottenNames) const
{
    QStringList all;
    if (m_aspect == Aspect::Motion) {
        for (const QString &timestep : m_timesteps)
            all.append(QStringLiteral("%1 + gravity * %2").arg(value, timestep));
    }
    const bool isQuestion = value.contains(QLatin1Char('<')) || value.contains(QLatin1Char('>'));
    if (m_aspect == Aspect::Walls && isQuestion && !m_names.circles().empty()) {
        const NamedCircle &circle = m_names.circles().front();
        for (const char *wall :
             {"x < square.left +", "x > square.right -", "y < square.bottom +", "y > square.top -"})
            all.append(QStringLiteral("%1 or %2.%3 %4")
                           .arg(value, circle.position, QLatin1String(wall), circle.radius));
    }
    static const QRegularExpression radius(QStringLiteral("\\br(ad|adius)?_?\\d?\\b"));
    static const QRegularExpression index(QStringLiteral("^([ijk]|index|\\w+\\.index)$"));
    if (m_aspect == Aspect::Walls && !isQuestion && !value.contains(radius)
        && !value.contains(index) && !m_names.radii().isEmpty())
        all += {QStringLiteral("%1 - %2").arg(value, m_names.radii().front()),
                QStringLiteral("%1 + %2").arg(value, m_names.radii().front())};
    if (m_suspect == Suspect::Masses && !m_names.circles().empty()) {
        const NamedCircle &circle = m_names.circles().front();
        all += {QStringLiteral("(%1) * %2").arg(value, circle.density),
                QStringLiteral("(%1) / %2").arg(value, circle.density),
                QStringLiteral("1 / (%1)").arg(value)};
        // Where a radius counts, it may count once too seldom or too often; else it is missing.
        const bool isOfRadius =
            value.contains(radius)
            || (!value.contains(QLatin1String("density"))
                && std::any_of(m_names.ofRadius().begin(), m_names.ofRadius().end(),
                               [&](const QString &name) { return value.contains(name); }));
        if (isOfRadius)
            all += {QStringLiteral("(%1) * %2").arg(value, circle.radius),
                    QStringLiteral("(%1) / %2").arg(value, circle.radius)};
        else
            all.append(QStringLiteral("(%1) * %2 ^ 3").arg(value, circle.radius));
    }
    static const QRegularExpression name(QStringLiteral("^\\w+$"));
    for (const QString &forgotten : forgottenNames) {
        if (isQuestion || value.contains(name))
            all.append(QStringLiteral("%1 or %2").arg(value, forgotten));
    }
    for (const QString &part : m_across)
        all.append(QStringLiteral("%1 + %2").arg(value, part));
    return all;
}

} // namespace cradle
