// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/asked_laws.h"

#include "tests/check_spec.h"

#include <QJsonArray>
#include <QTest>

using namespace cradle;

/// What the checks of a step themselves say of the right laws, and what they leave open.
class TestAskedLaws : public QObject
{
    Q_OBJECT
private slots:
    void lawsAreThoseThatAreAskedFor_data();
    void lawsAreThoseThatAreAskedFor();
    void sceneHasTheLawsThatAreAskedFor();
    void integratorsAreThoseOfEachCircle();
};

namespace {

const QJsonArray moon{0.0, -1.62};
const QJsonArray earth{0.0, -9.81};

CheckSpec flight(const QJsonArray &gravity = moon, std::vector<int> circles = {0, 1})
{
    return checkOf(
        "integrates",
        {{QStringLiteral("gravity"), gravity},
         {QStringLiteral("integrators"), QJsonArray{QStringLiteral("symplectic_euler")}}},
        std::move(circles));
}

CheckSpec collides(const QJsonArray &laws)
{
    return checkOf("collides", {{QStringLiteral("laws"), laws}}, {0, 1});
}

CheckSpec inScene(CheckSpec check, const char *kind)
{
    check.scene = {{QStringLiteral("kind"), QLatin1String(kind)}};
    return check;
}

Task taskOf(std::vector<CheckSpec> checks)
{
    Task task;
    task.preset.gravity = {0.0, -9.81};
    task.preset.circles.resize(2);
    task.checks = std::move(checks);
    return task;
}

} // namespace

void TestAskedLaws::lawsAreThoseThatAreAskedFor_data()
{
    QTest::addColumn<std::vector<CheckSpec>>("checks");
    QTest::addColumn<bool>("motion");
    QTest::addColumn<bool>("walls");
    QTest::addColumn<bool>("pair");
    const auto row = [](const char *name, std::vector<CheckSpec> checks, bool motion,
                        bool walls = false, bool pair = false) {
        QTest::newRow(name) << std::move(checks) << motion << walls << pair;
    };
    const QJsonArray stop{QStringLiteral("stop")};
    const QJsonArray impulse{QStringLiteral("impulse")};
    const QJsonArray either{QStringLiteral("stop"), QStringLiteral("impulse")};
    const CheckSpec wall = inScene(checkOf("bounces", {}, {0, 1}), "directions");
    row("nothing", {}, false);
    row("a start alone", {checkOf("start", {}, {0, 1})}, false);
    row("a flight", {flight()}, true);
    row("a flight and a start of another", {flight(moon, {0}), checkOf("start", {}, {1})}, true);
    row("a flight by a formula", {checkOf("closed_form", {{QStringLiteral("gravity"), moon}}, {0})},
        true);
    row("gravity of the student", {flight({})}, false);
    row("the same gravity twice", {flight(), flight()}, true);
    row("two gravities", {flight(), flight(earth)}, false);
    row("two gravities, and the last again", {flight(), flight(earth), flight(earth)}, false);
    row("a flight of one, another looked at", {flight(moon, {0}), checkOf("stays_inside", {}, {1})},
        false);
    row("no flight", {wall}, false);
    row("a check in Lua", {flight(), checkOf("script", {})}, false);
    row("a check in Lua before", {checkOf("script", {}), flight()}, false);
    row("walls from all around", {flight(), wall}, true, true);
    row("walls, then others", {flight(), wall, inScene(checkOf("bounces", {}, {0, 1}), "drops")},
        true, true);
    row("walls from above", {flight(), inScene(checkOf("bounces", {}, {0, 1}), "drops")}, true);
    row("no bounces from all around",
        {flight(), inScene(checkOf("stays_inside", {}, {0, 1}), "directions")}, true);
    row("a hit", {flight(), collides(impulse)}, true, false, true);
    row("a hit, and walls", {flight(), wall, collides(stop)}, true, true, true);
    row("one hit twice", {flight(), collides(stop), collides(stop)}, true, false, true);
    row("either of two hits", {flight(), collides(either)}, true);
    row("either of two hits, then one", {flight(), collides(either), collides(stop)}, true);
    row("two hits", {flight(), collides(stop), collides(impulse)}, true);
    row("hits of no known law", {flight(), collides({QStringLiteral("bang")})}, true);
    row("passing through each other", {flight(), checkOf("passes_through", {}, {0, 1})}, true);
    row("a hit and passing", {flight(), collides(stop), checkOf("passes_through", {}, {0, 1})},
        true);
    row("a hit without a flight", {collides(stop)}, false);
}

void TestAskedLaws::lawsAreThoseThatAreAskedFor()
{
    QFETCH(std::vector<CheckSpec>, checks);
    const AskedLaws laws = askedLaws(taskOf(checks));
    QTEST(laws.motion, "motion");
    QTEST(laws.walls, "walls");
    QTEST(laws.pair, "pair");
}

void TestAskedLaws::sceneHasTheLawsThatAreAskedFor()
{
    Task task = taskOf({flight(), inScene(checkOf("bounces", {}, {0, 1}), "directions"),
                        collides({QStringLiteral("impulse")})});
    task.preset.laws = {WallLaw::None, CircleLaw::Stop, Timing::Exact};
    task.preset.restitution = 0.5;
    const Preset all = askedLaws(task).scene;
    QCOMPARE(all.gravity, (Vec2{0.0, -1.62}));
    QCOMPARE(all.laws.walls, WallLaw::Reflect);
    QCOMPARE(all.laws.circles, CircleLaw::Impulse);
    QCOMPARE(all.laws.timing, Timing::Discrete);
    QCOMPARE(all.restitution, 0.5);
    // Without checks of them walls are those of the scene, and circles pass each other.
    task.checks = {flight({})};
    const Preset none = askedLaws(task).scene;
    QCOMPARE(none.gravity, (Vec2{0.0, -9.81}));
    QCOMPARE(none.laws.walls, WallLaw::None);
    QCOMPARE(none.laws.circles, CircleLaw::None);
}

void TestAskedLaws::integratorsAreThoseOfEachCircle()
{
    CheckSpec unknown = flight(moon, {0});
    unknown.parameters[QStringLiteral("integrators")] = QJsonArray{QStringLiteral("guess")};
    const Preset scene =
        askedLaws(taskOf({checkOf("closed_form", {{QStringLiteral("gravity"), moon}}, {0}),
                          flight(moon, {2}), unknown}))
            .scene;
    QCOMPARE(scene.circles.size(), std::size_t{3});
    QCOMPARE(scene.circles[0].integrator, Integrator::Verlet);
    QCOMPARE(scene.circles[1].integrator, PresetCircle().integrator);
    QCOMPARE(scene.circles[2].integrator, Integrator::SymplecticEuler);
}

QTEST_APPLESS_MAIN(TestAskedLaws)
#include "test_asked_laws.moc"
