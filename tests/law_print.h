// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/measured_laws.h"

#include "model/files/preset_json.h"

#include <QCryptographicHash>

#include <cstring>

namespace cradle::approved {

/// A hash of values, in turn.
class Print
{
public:
    void add(double value)
    {
        char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        m_hash.addData(QByteArrayView(bytes, sizeof bytes));
    }
    void add(Vec2 v)
    {
        add(v.x);
        add(v.y);
    }
    void add(const Circle &c)
    {
        add(c.position);
        add(c.velocity);
        add(c.radius);
        add(c.density);
    }
    void add(const QString &text) { m_hash.addData(text.toUtf8()); }
    /// What is worked out by sines while compiling is not the same to the bit from every compiler.
    void addRounded(const Preset &preset)
    {
        const auto number = [&](double value) { add(QString::number(value, 'g', 10)); };
        for (const double value : {preset.gravity.x, preset.gravity.y, preset.restitution,
                                   preset.timestep, preset.halfWidth})
            number(value);
        for (const PresetCircle &circle : preset.circles) {
            const Circle &c = circle.body;
            for (const double value : {c.position.x, c.position.y, c.velocity.x, c.velocity.y,
                                       c.radius, c.density, double(circle.integrator)})
                number(value);
        }
    }
    void add(const Preset &preset) { m_hash.addData(writePreset(preset)); }
    void add(const Stage &stage)
    {
        add(stage.preset);
        add(stage.pinned);
    }
    void add(const Occasion &when)
    {
        for (const double value :
             {when.time, double(when.run), double(when.number), double(when.ownNumber),
              double(when.wallNumber), double(when.likeNumber), when.pause, when.speed, when.into,
              when.along, double(when.setting), double(when.hasMet), double(when.hasHit)})
            add(value);
        for (const Vec2 v : {when.place, when.velocity, when.otherVelocity})
            add(v);
    }
    void add(const Flight::Step &step)
    {
        for (const Vec2 v : {step.velocity, step.way, step.turn})
            add(v);
    }
    void add(const Motion &motion)
    {
        add(motion.position);
        add(motion.velocity);
    }
    void add(const Flight &flight)
    {
        for (const Vec2 v : {flight.way, flight.drift, flight.acceleration, flight.growth,
                             flight.pull, flight.lateWay, flight.lateVelocity, flight.firstWay,
                             flight.lateFirstWay, flight.restedAt, flight.startedWith,
                             flight.turnedInto, flight.wayMade, flight.startedAt, flight.putAt})
            add(v);
        for (const Flight::Step &step : {flight.seen[0], flight.seen[1], flight.fromRest})
            add(step);
        if (flight.leap) {
            add(flight.leap->from);
            add(flight.leap->to);
            add(double(flight.leap->speed));
        }
        for (const double value : {double(flight.isKnown),
                                   double(flight.resets),
                                   double(flight.resetsX),
                                   double(flight.resetsY),
                                   flight.carried,
                                   double(flight.jumps),
                                   double(flight.leader),
                                   double(flight.borrows),
                                   double(flight.onlySlow),
                                   double(flight.isTimeless),
                                   double(flight.isWayOfNew),
                                   double(flight.follows),
                                   double(flight.isWayLinear),
                                   double(flight.isTurnLinear),
                                   double(flight.crossing),
                                   double(flight.xFollows),
                                   double(flight.yFollows),
                                   double(flight.isOfStart),
                                   double(flight.isFromLeader),
                                   double(flight.isCounted)})
            add(value);
    }
    void add(const WallHit &hit)
    {
        for (const double value : {double(hit.circle),
                                   double(hit.wall),
                                   hit.restitution,
                                   hit.radius,
                                   hit.otherRadius,
                                   double(hit.missed),
                                   double(hit.turned),
                                   double(hit.held),
                                   hit.before,
                                   hit.reached,
                                   hit.travel,
                                   hit.back,
                                   hit.along,
                                   double(hit.again),
                                   double(hit.turnsBoth),
                                   double(hit.stays),
                                   hit.after,
                                   hit.leap,
                                   double(hit.disturbs),
                                   double(hit.kicks),
                                   double(hit.step)})
            add(value);
        for (const Vec2 v : {hit.was, hit.came, hit.left, hit.landed})
            add(v);
        add(hit.isLost);
        add(hit.otherFree);
        add(hit.otherWas);
        add(hit.stage);
    }
    void add(const LentWall &lent)
    {
        add(lent.hit);
        add(double(lent.other));
    }
    void add(const Drop &drop)
    {
        for (const double value :
             {double(drop.circle), double(drop.wall), drop.restitution, double(drop.again),
              drop.depth, double(drop.sinks), double(drop.step)})
            add(value);
        add(drop.stage);
    }
    void add(const PairHit &hit)
    {
        const Meeting &m = hit.meeting;
        for (const double value : {m.degrees,
                                   m.radius1,
                                   m.radius2,
                                   m.density1,
                                   m.density2,
                                   m.restitution,
                                   m.velocities.along1,
                                   m.velocities.across1,
                                   m.velocities.along2,
                                   m.velocities.across2,
                                   double(hit.answered),
                                   hit.before,
                                   hit.reached,
                                   hit.slowness,
                                   double(hit.parting),
                                   double(hit.moved1),
                                   double(hit.moved2),
                                   hit.after,
                                   double(hit.stopped),
                                   double(hit.late),
                                   double(hit.leaper),
                                   double(hit.again),
                                   double(hit.partsInside),
                                   double(hit.step)})
            add(value);
        for (const Vec2 v :
             {hit.normal, hit.nextNormal, hit.came1, hit.came2, hit.left1, hit.left2, hit.landed})
            add(v);
        add(hit.stage);
    }
    void add(const LaterHit &later)
    {
        add(later.first);
        add(later.second);
    }
    void add(const FlightOccasion &flight)
    {
        add(double(flight.circle));
        add(flight.before);
        add(flight.after);
        add(flight.when);
    }
    void add(const WallOccasion &wall)
    {
        add(wall.hit);
        add(wall.when);
        add(double(wall.isSlow));
    }
    void add(const PairOccasion &pair)
    {
        add(pair.hit);
        add(pair.when);
    }
    void add(bool value) { add(double(value)); }
    [[nodiscard]] QString text() const
    {
        return QString::fromLatin1(m_hash.result().toHex().left(12));
    }

private:
    QCryptographicHash m_hash{QCryptographicHash::Sha256};
};

} // namespace cradle::approved
