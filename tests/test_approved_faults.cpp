// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/programs.h"
#include "tests/scenes.h"

#include "tasks/checks/check_library.h"

#include <QCryptographicHash>

using namespace cradle;
using namespace cradle::programs;

/// What every kind of check says of right runs in which one state is changed, by less than it
/// bears up to much more: how many it refuses, and a hash of what it says, in
/// tests/approved/faults.txt.
class TestApprovedFaults : public QObject
{
    Q_OBJECT
private slots:
    void faultsAreAsApproved();
};

namespace {

Preset sceneOf(std::vector<Circle> circles, Vec2 gravity, double e, Integrator integrator)
{
    Preset preset = programs::scene(circles, gravity, e);
    preset.timestep = 1.0 / 40.0;
    for (PresetCircle &circle : preset.circles)
        circle.integrator = integrator;
    return preset;
}

struct Scene {
    const char *name;
    Preset preset;
    double duration; ///< s
};

std::vector<Scene> faultScenes()
{
    constexpr Vec2 down{0.0, -9.81};
    std::vector<Scene> all{
        {"walls",
         sceneOf({{{1.0, 1.0}, {2.0, 1.3}, 0.3, 2.0}, {{-2.0, -2.0}, {-1.5, 0.4}, 0.2, 7.8}}, {},
                 1.0, Integrator::Euler),
         3.0},
        {"losing walls",
         sceneOf({{{1.0, 1.0}, {2.5, 1.3}, 0.3, 2.0}, {{-2.0, -2.0}, {-1.5, 0.4}, 0.2, 7.8}},
                 {0.0, -1.0}, 0.5, Integrator::SymplecticEuler),
         3.0},
        {"drop",
         sceneOf({{{0.5, -1.5}, {}, 0.3, 2.0}, {{-2.0, -3.0}, {0.3, 0.0}, 0.2, 7.8}}, down, 0.6,
                 Integrator::Verlet),
         4.0},
        {"hit",
         sceneOf({{{-1.0, 0.05}, {1.5, 0.1}, 0.3, 2.0}, {{0.6, -0.1}, {-0.7, 0.0}, 0.2, 7.8}}, {},
                 1.0, Integrator::Euler),
         1.5},
        {"hit with losses",
         sceneOf({{{-1.0, 0.05}, {1.5, 0.4}, 0.25, 1.0}, {{0.6, 0.2}, {-0.7, 0.2}, 0.35, 3.0}},
                 {0.0, -0.5}, 0.4, Integrator::RungeKutta4),
         1.5},
        {"one place",
         sceneOf({{{-1.0, 0.5}, {1.0, 0.4}, 0.2, 1.0}, {{-1.0, 0.5}, {1.0, 0.4}, 0.2, 1.0}},
                 {0.0, -0.5}, 1.0, Integrator::Verlet),
         1.5}};
    all.back().preset.laws.circles = CircleLaw::None;
    return all;
}

/// What is done to a circle, in that measure.
using Change = void (*)(Circle &, double);

constexpr std::pair<const char *, Change> stateChanges[] = {
    {"right", [](Circle &c, double by) { c.position.x += by; }},
    {"down", [](Circle &c, double by) { c.position.y -= by; }},
    {"faster", [](Circle &c, double by) { c.velocity = (1.0 + by) * c.velocity; }},
    {"askew", [](Circle &c, double by) {
         c.velocity += by * Vec2{0.6, -0.8};
     }}};

/// The run of the laws, in which circle \p i is changed after \p step.
/// \param goesOn  from what it was changed to; else that state alone is another
Observation changedRun(const Scene &scene, std::size_t i, qint64 step, Change change, double by,
                       bool goesOn)
{
    Observation o{{QStringLiteral("preset"), scene.preset, scene.duration}, Recording{}};
    scenes::Run run(scene.preset);
    o.states.append(run.world);
    while (run.world.time < scene.duration - 1e-9) {
        run.steps(1);
        World shown = run.world;
        if (run.world.step == step) {
            change(shown.circles[i], by);
            if (goesOn)
                run.world = shown;
        }
        o.states.append(shown);
    }
    return o;
}

struct NamedCheck {
    const char *name;
    CheckSpec spec;
};

std::vector<NamedCheck> allChecks(const Scene &scene)
{
    const Circle &a = scene.preset.circles[0].body;
    const Circle &b = scene.preset.circles[1].body;
    const QString velocities = QStringLiteral("velocities");
    const QJsonObject beside{{QStringLiteral("collisions"), true}};
    const auto with = [](const char *name, const QJsonValue &value) {
        return QJsonObject{{QLatin1String(name), value}};
    };
    return {{"start", check("start", {0}, with("position", json(a.position)))},
            {"start at 2", check("start", {1}, with("velocity", json(b.velocity)))},
            {"integrates", check("integrates", {0, 1}, beside)},
            {"integrates by Euler",
             check("integrates", {0}, with("integrators", QJsonArray{QStringLiteral("euler")}))},
            {"closed_form", check("closed_form", {0, 1}, beside)},
            {"together", check("together", {0, 1})},
            {"same_integrator", check("same_integrator", {0, 1}, beside)},
            {"ends_at", check("ends_at", {0},
                              {{QStringLiteral("time"), 1.013},
                               {velocities, QJsonArray{QJsonValue(json({2.0, 1.3}))}}, // no copy
                               {QStringLiteral("tolerance"), 0.01}})},
            {"bounces", check("bounces", {0, 1}, beside)},
            {"bounces alone", check("bounces", {0})},
            {"stays_inside", check("stays_inside", {0, 1})},
            {"bounce_heights", check("bounce_heights", {0}, with("bounces", 1))},
            {"settles", check("settles", {0})},
            {"collides",
             check("collides", {0, 1}, with("laws", QJsonArray{QStringLiteral("impulse")}))},
            {"collides by any", check("collides", {0, 1})},
            {"touches", check("touches", {0, 1})},
            {"rebounds", check("rebounds", {0, 1})},
            {"conserves", check("conserves", {0, 1})},
            {"conserves energy", check("conserves", {0, 1}, with("energy", true))},
            {"after_contact", check("after_contact", {0, 1},
                                    {{velocities, QJsonArray{json({-0.6, 0.1}), json({0.1, 0.2})}},
                                     {QStringLiteral("tolerance"), 0.2}})},
            {"loses_energy", check("loses_energy", {0, 1})},
            {"passes_through", check("passes_through", {0, 1})}};
}

/// What a check says of several runs.
struct Faults {
    int refused = 0;
    QCryptographicHash hash{QCryptographicHash::Sha256};

    void add(const std::optional<Fault> &fault)
    {
        if (!fault)
            return;
        ++refused;
        const auto number = [](const std::optional<double> &value) {
            return QString::number(value.value_or(-1.0), 'g', 6);
        };
        hash.addData(
            QStringLiteral("%1|%2|%3|%4|%5|%6\n")
                .arg(fault->message, number(fault->expected), number(fault->observed), fault->unit)
                .arg(fault->step)
                .arg(fault->circle)
                .toUtf8());
    }
};

/// Steps at which something happens, and others: the first and the last, and those around which a
/// velocity changes most.
std::vector<qint64> tellingSteps(const Scene &scene)
{
    const Observation o = changedRun(scene, 0, -1, stateChanges[0].second, 0.0, false);
    qint64 turn = 1;
    double most = -1.0;
    for (qint64 k = 0; k < o.steps(); ++k) {
        const double change = length(o.circle(0, k + 1).velocity - o.circle(0, k).velocity);
        if (change > most) {
            most = change;
            turn = k + 1;
        }
    }
    return {1, turn / 2 + 1, turn - 1, turn, turn + 1, o.steps()};
}

} // namespace

void TestApprovedFaults::faultsAreAsApproved()
{
    QString all;
    for (const Scene &scene : faultScenes()) {
        const std::vector<NamedCheck> checks = allChecks(scene);
        for (const auto &[name, change] : stateChanges) {
            std::vector<Faults> faults(checks.size());
            int runs = 0;
            for (const qint64 step : tellingSteps(scene)) {
                for (const double by : {1e-10, 0.8e-9, 1.3e-9, 0.7e-6, 1.5e-6, 0.03, -0.4}) {
                    ++runs;
                    const std::size_t circle = runs % 3 == 0 ? 1 : 0;
                    const Observation o =
                        changedRun(scene, circle, step, change, by, runs % 2 == 0);
                    for (std::size_t i = 0; i < checks.size(); ++i)
                        faults[i].add(judge(checks[i].spec, o));
                }
            }
            all += QStringLiteral("%1, %2, of %3:")
                       .arg(QLatin1String(scene.name), QLatin1String(name))
                       .arg(runs);
            for (std::size_t i = 0; i < checks.size(); ++i) {
                if (faults[i].refused > 0)
                    all += QStringLiteral(" %1 %2 %3,")
                               .arg(QLatin1String(checks[i].name))
                               .arg(faults[i].refused)
                               .arg(QString::fromLatin1(faults[i].hash.result().toHex().left(8)));
            }
            all += QLatin1Char('\n');
        }
    }
    const QString difference = approved::compare(QStringLiteral("faults.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedFaults)
#include "test_approved_faults.moc"
