// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/lab_test.h"
#include "tests/slips.h"

#include "tasks/checks/check_library.h"
#include "tasks/judging/measured_laws.h"
#include "tasks/runs/variant.h"

#include <QCryptographicHash>

#include <cstring>

using namespace cradle;

/// Every bit of what the judging measures, and of the scenes in which it and the checks look:
/// tests/approved/laws.txt and scenes.txt have hashes, part by part, so that it is seen where a
/// change of the judging reaches.
class TestApprovedLaws : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void scenesAreAsApproved();
    void lawsAreAsApproved();

private:
    Lab m_labs[2];
};

namespace {

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
             {when.time, double(when.number), double(when.ownNumber), when.pause, when.place.x,
              when.place.y, when.speed, double(when.setting), double(when.hasMet)})
            add(value);
    }
    void add(const Flight &flight)
    {
        for (const Vec2 v :
             {flight.way, flight.drift, flight.acceleration, flight.growth, flight.pull,
              flight.lateWay, flight.lateVelocity, flight.firstWay, flight.lateFirstWay,
              flight.restedAt, flight.startedWith, flight.turnedInto, flight.wayMade,
              flight.seen[0].velocity, flight.seen[0].way, flight.seen[0].turn,
              flight.seen[1].velocity, flight.seen[1].way, flight.seen[1].turn})
            add(v);
        for (const double value :
             {double(flight.isKnown), double(flight.resets), double(flight.resetsX),
              double(flight.resetsY), flight.carried, double(flight.jumps), double(flight.leader),
              double(flight.borrows), double(flight.onlySlow), double(flight.isTimeless),
              double(flight.isWayOfNew), double(flight.follows), double(flight.isWayLinear),
              double(flight.isTurnLinear), double(flight.crossing)})
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
        for (const Vec2 v : {hit.came, hit.left, hit.landed})
            add(v);
        add(hit.stage);
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
                                   double(hit.isHeld()),
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

template <typename Value>
QString told(const char *name, const std::vector<Value> &all)
{
    if (all.empty())
        return {};
    Print print;
    for (const Value &each : all)
        print.add(each);
    return QStringLiteral(" %1 %2:%3")
        .arg(QString::fromLatin1(name))
        .arg(all.size())
        .arg(print.text());
}

template <typename Value>
QString told(const char *name, const std::optional<Value> &one)
{
    return told(name, one ? std::vector<Value>{*one} : std::vector<Value>{});
}

QString flightTold(const MeasuredFlight &flight, const Ground &ground)
{
    Print print;
    for (const Vec2 gravity : ground.gravities) {
        for (const Flight &each : flight.at(gravity, ground.own.timestep)) {
            print.add(each);
        }
        for (int i = 0; i < int(ground.own.circles.size()); ++i)
            print.add(flight.heavierFall(gravity, ground.own.timestep, i).value_or(Vec2{}));
    }
    for (std::size_t i = 0; i < flight.own().accelerations.size(); ++i) {
        print.add(flight.own().accelerations[i]);
        print.add(flight.own().later[i]);
        print.add(flight.ownFallElsewhere(int(i)).value_or(Vec2{}));
    }
    return QStringLiteral(" flight ") + print.text();
}

QString lawsTold(const Task &task, const QString &program)
{
    const Ground ground(task, task.preset);
    const MeasuredLaws laws(&program, ground);
    const MeasuredWalls &walls = laws.walls();
    const MeasuredPair &pair = laws.pair();
    QString all =
        flightTold(laws.flight(), ground) + told("again", laws.flightAgain())
        + QStringLiteral("\n  walls") + told("hits", walls.hits) + told("corners", walls.corners)
        + told("slow", walls.slow) + told("far", walls.far) + told("drops", walls.drops)
        + told("again", laws.wallsAgain({std::begin(allWalls), std::end(allWalls)}))
        + QStringLiteral("\n  pair") + told("contacts", pair.contacts)
        + told("radii", pair.otherRadii) + told("modes", pair.modes) + told("equals", pair.equals)
        + told("larger", pair.radii) + told("denser", pair.densities)
        + told("rebounds", pair.rebounds) + told("partings", pair.partings)
        + told("twice", pair.twice) + told("own", pair.own) + told("varied", pair.varied)
        + told("slow", pair.slow) + told("later", pair.later) + told("returning", pair.returning)
        + told("again", laws.pairAgain());
    return all
           + QStringLiteral(" %1 %2 %3\n")
                 .arg(pair.ownContacts)
                 .arg(int(pair.ranThrough))
                 .arg(int(pair.ranThroughAtOnce));
}

} // namespace

void TestApprovedLaws::initTestCase()
{
    m_labs[0] = *readLab(QLatin1String(shippedLab));
    m_labs[1] = *readLab(QLatin1String(bouncingBallLab));
}

void TestApprovedLaws::scenesAreAsApproved()
{
    QString all;
    for (const Lab &lab : m_labs) {
        for (const Task &task : lab.tasks) {
            for (const CheckSpec &check : task.checks) {
                all += task.id + QLatin1Char(' ') + check.id;
                for (qint64 seed = 1; seed <= 3; ++seed) {
                    Print print;
                    const auto variants = makeVariants(task.preset, check, seed);
                    for (const Variant &variant : variants) {
                        print.add(variant.name);
                        print.addRounded(variant.preset);
                        print.add(variant.duration);
                    }
                    all += QStringLiteral(" %1:%2").arg(variants.size()).arg(print.text());
                }
                all += QLatin1Char('\n');
            }
        }
    }
    const QString difference = approved::compare(QStringLiteral("scenes.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

void TestApprovedLaws::lawsAreAsApproved()
{
    QString all;
    std::size_t step = 0;
    for (const Lab &lab : m_labs) {
        for (const Task &task : lab.tasks) {
            all += task.id + lawsTold(task, task.solution);
            // Every third, for there are some two hundred.
            for (std::size_t i = 0; i < task.mistakes.size(); i += 3)
                all += task.id + QLatin1Char(' ') + task.mistakes[i].name
                       + lawsTold(task, task.mistakes[i].source);
            // Every fourth, others in the next step.
            for (std::size_t i = step++ % 4; i < std::size(approved::slips); i += 4) {
                Print print;
                print.add(lawsTold(task, approved::withSlip(task.solution, approved::slips[i])));
                all += task.id + QStringLiteral(" %1: ").arg(QLatin1String(approved::slips[i]))
                       + print.text() + QLatin1Char('\n');
            }
        }
    }
    const QString difference = approved::compare(QStringLiteral("laws.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedLaws)
#include "test_approved_laws.moc"
