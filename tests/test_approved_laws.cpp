// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/lab_test.h"
#include "tests/law_print.h"
#include "tests/slips.h"

#include "tasks/checks/check_library.h"
#include "tasks/runs/variant.h"

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

using approved::Print;

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
    const double h = ground.own.timestep;
    for (const Vec2 gravity : ground.gravities) {
        for (const Flight &each : flight.at(gravity, h)) {
            print.add(each);
        }
        for (int i = 0; i < int(ground.flights.size()); ++i) {
            print.add(flight.heavierFall(gravity, h, i).value_or(Vec2{}));
            print.add(flight.whileOthersRest(gravity, h, i).value_or(Flight::Step{}));
            print.add(flight.withRestitution(gravity, h, i, 0.5).value_or(Flight::Step{}));
            print.add(flight.slowStart(0.1, h, i).value_or(Flight::Step{}));
        }
    }
    for (std::size_t i = 0; i < flight.own().accelerations.size(); ++i) {
        print.add(flight.own().accelerations[i]);
        print.add(flight.own().later[i]);
        print.add(flight.own().ways[i]);
        print.add(flight.ownFallElsewhere(int(i)).value_or(Vec2{}));
    }
    return QStringLiteral(" flight ") + print.text();
}

/// \param isWhole  with what takes longer
QString lawsTold(const Task &task, const QString &program, bool isWhole)
{
    const Ground ground(task, task.preset);
    const MeasuredLaws laws(&program, ground);
    const MeasuredWalls &walls = laws.walls();
    const MeasuredPair &pair = laws.pair();
    QString all =
        flightTold(laws.flight(), ground) + told("again", laws.flightAgain())
        + QStringLiteral("\n  walls") + told("hits", walls.hits) + told("corners", walls.corners)
        + told("slow", walls.slow) + told("far", walls.far) + told("middle", walls.middle)
        + told("lent", walls.lent) + told("drops", walls.drops)
        + told("again", laws.wallsAgain({std::begin(allWalls), std::end(allWalls)}))
        + QStringLiteral("\n  pair") + told("contacts", pair.contacts)
        + told("radii", pair.otherRadii) + told("modes", pair.modes) + told("equals", pair.equals)
        + told("larger", pair.radii) + told("both larger", pair.larger)
        + told("denser", pair.densities) + told("rebounds", pair.rebounds)
        + told("partings", pair.partings) + told("twice", pair.twice) + told("own", pair.own)
        + told("varied", pair.varied) + told("opposite", pair.opposite) + told("slow", pair.slow)
        + told("fast", pair.fast) + told("later", pair.later) + told("returning", pair.returning)
        + told("anew", pair.ranThroughAnew) + told("again", laws.pairAgain());
    if (isWhole)
        all += told("answers", laws.pairAnswers()) + told("chases", laws.pairChases());
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
            all += task.id + lawsTold(task, task.solution, true);
            // Every third, for there are some two hundred.
            for (std::size_t i = 0; i < task.mistakes.size(); i += 3)
                all += task.id + QLatin1Char(' ') + task.mistakes[i].name
                       + lawsTold(task, task.mistakes[i].source, true);
            // Every fourth, others in the next step.
            for (std::size_t i = step++ % 4; i < std::size(approved::slips); i += 4) {
                Print print;
                print.add(
                    lawsTold(task, approved::withSlip(task.solution, approved::slips[i]), false));
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
