// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_report/drawn_moment.h"
#include "tasks/lab_report/run_pictures.h"

#include "tests/drawn_svg.h"
#include "tests/programs.h"
#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::programs;

/// What a report shows of a run: the moment that tells most, its scene, and the energies.
class TestRunPictures : public QObject
{
    Q_OBJECT
private slots:
    void firstHitOfCirclesTellsMost_data();
    void firstHitOfCirclesTellsMost();
    void energyIsAPartOfTheFirst();
    void noEnergyHasNoCurve();
    void infiniteEnergyHasNoCurve();
    void curvesOfARunAreItsSums();
    void momentHasTheWaysUpToIt();
    void crowdsAreDrawnInPart();
    void coloursAreNothingElse_data();
    void coloursAreNothingElse();
    void sceneIsDrawnAsItIs();
};

namespace {

const Vec2 down{0.0, -10.0};

/// Circles that fly freely and turn at the walls and at each other, exactly.
Observation run(std::vector<Circle> circles, Vec2 gravity, double duration)
{
    Preset preset = scene(circles, gravity);
    preset.timestep = 0.01;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Continuous};
    for (PresetCircle &circle : preset.circles)
        circle.integrator = Integrator::Verlet;
    return observe({QString(), preset, duration});
}

Vec2 place(Vec2 p) // of 4 m to each side in 300 px with a margin of 6
{
    return Vec2{150.0, 150.0} + 36.0 * Vec2{p.x, -p.y};
}

} // namespace

void TestRunPictures::firstHitOfCirclesTellsMost_data()
{
    QTest::addColumn<double>("speed1"); // of circle 1, towards the left wall 1 m away, m/s
    QTest::addColumn<double>("speed2"); // of circle 2, towards circle 3, 2 m away, m/s
    QTest::addColumn<double>("time");   // s
    QTest::addColumn<int>("kind");
    using Kind = TellingMoment::Kind;
    QTest::newRow("circles, after a wall") << 5.0 << 1.0 << 2.0 << int(Kind::Circles);
    QTest::newRow("circles, before a wall") << 0.4 << 4.0 << 0.5 << int(Kind::Circles);
    QTest::newRow("walls alone") << 2.0 << 0.0 << 0.5 << int(Kind::Wall);
    QTest::newRow("nothing") << 0.1 << 0.1 << 1.0 << int(Kind::Time);
}

void TestRunPictures::firstHitOfCirclesTellsMost()
{
    QFETCH(double, speed1);
    QFETCH(double, speed2);
    QFETCH(double, time);
    QFETCH(int, kind);
    const Observation o = run({{.position = {-2.8, 2.0}, .velocity = {-speed1, 0.0}},
                               {.position = {-1.0, -1.0}, .velocity = {speed2, 0.0}},
                               {.position = {1.4, -1.0}}},
                              {}, 3.0);
    const TellingMoment moment = tellingMoment(o);
    QCOMPARE(int(moment.kind), kind);
    QVERIFY2(std::abs(moment.time - time) < 0.011, QByteArray::number(moment.time).constData());
    QCOMPARE(o.states.time(moment.index), moment.time);
}

/// A ball that falls from rest: its energy stays, the kinetic one is m g (h₀ − h).
void TestRunPictures::energyIsAPartOfTheFirst()
{
    const Observation o = run({{.position = {0.0, 3.0}, .velocity = {1.0, 0.0}}}, down, 0.5);
    const EnergyCurve curve = energyCurve(QStringLiteral("step"), o);
    QCOMPARE(curve.name, QStringLiteral("step"));
    QCOMPARE(curve.points.size(), std::size_t(o.states.last() - o.states.first() + 1));
    for (const Vec2 &point : curve.points)
        QVERIFY(std::abs(point.y - 1.0) < 1e-3);
    QVERIFY(std::abs(curve.points[20].x - 0.2) < 1e-9);
    const Drawn drawn(energiesSvg({curve, {QStringLiteral("other"), {{0, 1}, {1, 0.5}}}}));
    QVERIFY(drawn.isSound);
    QStringList names;
    for (const Label &label : drawn.labels)
        names.append(label.text);
    QVERIFY(names.contains(QLatin1String("step")) && names.contains(QLatin1String("other")));
    QVERIFY(!drawn.curve(QStringLiteral("#1971c2")).empty());
    QVERIFY(!drawn.curve(QStringLiteral("#e8590c")).empty());
}

void TestRunPictures::noEnergyHasNoCurve()
{
    QVERIFY(energyCurve({}, run({{.position = {0.0, 1.0}}}, {}, 0.1)).points.empty());
}

/// Kinetic and potential make the sum; momenta are those of the circles.
void TestRunPictures::infiniteEnergyHasNoCurve()
{
    Preset preset = scene({{.velocity = {1e200, 0.0}}}, {});
    preset.laws = {WallLaw::None, CircleLaw::None, Timing::Discrete};
    const QByteArray drawn = energySvg(observe({QString(), preset, 0.1}));
    QVERIFY2(!drawn.contains("nan") && !drawn.contains("inf"), drawn.constData());
}

void TestRunPictures::curvesOfARunAreItsSums()
{
    const Observation o = run({{.position = {0.0, 3.0}, .velocity = {1.0, 0.0}}}, down, 0.5);
    const Drawn energy(energySvg(o));
    const auto kinetic = energy.curve(QStringLiteral("#1971c2"));
    const auto potential = energy.curve(QStringLiteral("#7048e8"));
    const auto sum = energy.curve(QStringLiteral("#212529"));
    QVERIFY(kinetic.size() > 10 && potential.size() > 10 && sum.size() > 1);
    QVERIFY(kinetic.front().y > kinetic.back().y); // up on the screen
    QVERIFY(potential.front().y < potential.back().y);
    QVERIFY(std::abs(sum.front().y - sum.back().y) < 0.5);
    const Drawn momentum(momentumSvg(o));
    const auto along = momentum.curve(QStringLiteral("#f08c00"));
    const auto across = momentum.curve(QStringLiteral("#0ca678"));
    QVERIFY(std::abs(along.front().y - along.back().y) < 0.02);
    QVERIFY(across.back().y > across.front().y); // it falls
}

void TestRunPictures::momentHasTheWaysUpToIt()
{
    const Observation o =
        run({{.position = {-2.0, 1.0}, .velocity = {2.0, 0.5}, .radius = 0.25}}, {}, 1.0);
    const DrawnMoment moment = drawnMoment(o, 50);
    QCOMPARE(moment.halfWidth, 4.0);
    QCOMPARE(moment.time, 0.5);
    QCOMPARE(moment.bodies.size(), std::size_t{1});
    const DrawnMoment::Body &body = moment.bodies[0];
    QCOMPARE(body.radius, 0.25);
    QVERIFY(length(body.position - Vec2{-1.0, 1.25}) < 1e-3);
    QVERIFY((body.velocity == Vec2{2.0, 0.5}));
    QCOMPARE(body.way.size(), std::size_t{51});
    for (std::size_t i = 0; i < body.way.size(); ++i)
        QVERIFY(length(body.way[i] - Vec2{-2.0 + 0.02 * double(i), 1.0 + 0.005 * double(i)})
                < 1e-3);
    // A longer one is thinned, and begins at the start.
    const DrawnMoment late =
        drawnMoment(run({{.position = {-2.0, 1.0}, .velocity = {2.0, 0.5}}}, {}, 10.0), 1000);
    const auto points = late.bodies[0].way.size();
    QVERIFY2(points <= 200 && points > 150, QByteArray::number(int(points)).constData());
    QVERIFY((late.bodies[0].way.front() == Vec2{-2.0, 1.0}));
}

void TestRunPictures::crowdsAreDrawnInPart()
{
    std::vector<Circle> circles;
    for (int i = 0; i < 450; ++i)
        circles.push_back({.position = {-3.9 + 0.3 * (i % 26), -3.9 + 0.3 * (i / 26)},
                           .velocity = {0.01, 0.0},
                           .radius = 0.05});
    const DrawnMoment moment = drawnMoment(run(circles, {}, 0.2), 20);
    QCOMPARE(moment.bodies.size(), std::size_t{400});
    std::size_t points = 0;
    for (const auto &body : moment.bodies)
        points += body.way.size();
    QVERIFY(points <= 2000 && points > 1000);
}

void TestRunPictures::coloursAreNothingElse_data()
{
    QTest::addColumn<QString>("given");
    QTest::addColumn<QString>("drawn");
    QTest::newRow("hexadecimal") << "#12aBeF"
                                 << "#12aBeF";
    QTest::newRow("name") << "red"
                          << "#1e90ff";
    QTest::newRow("short") << "#12a"
                           << "#1e90ff";
    QTest::newRow("no digits") << "#12345g"
                               << "#1e90ff";
    QTest::newRow("no sign") << "x123456"
                             << "#1e90ff";
    QTest::newRow("script") << "#\"/><a/>"
                            << "#1e90ff";
    QTest::newRow("none") << ""
                          << "#1e90ff";
}

void TestRunPictures::coloursAreNothingElse()
{
    QFETCH(QString, given);
    QFETCH(QString, drawn);
    Preset preset = scene({Circle{}, Circle{.position = {1, 1}}});
    preset.circles[0].colour = given;
    preset.circles[1].colour.clear();
    const DrawnMoment moment = drawnMoment(observe({QString(), preset, 0.1}), 0);
    QCOMPARE(moment.bodies[0].colour, drawn);
    QCOMPARE(moment.bodies[1].colour, QStringLiteral("#e03131"));
}

void TestRunPictures::sceneIsDrawnAsItIs()
{
    DrawnMoment moment{.halfWidth = 4.0, .time = 1.25};
    moment.bodies.push_back({.colour = QStringLiteral("#ff0000"),
                             .radius = 0.5,
                             .position = {1.0, 2.0},
                             .velocity = {4.0, 0.0},
                             .way = {{-1.0, 2.0}, {0.0, 2.0}}});
    moment.bodies.push_back({.colour = QStringLiteral("#00ff00"), .position = {4.3, 0.0}});
    const QByteArray svg = sceneSvg(moment);
    const Drawn drawn(svg);
    QVERIFY(drawn.isSound);
    QVERIFY(svg.contains("The scene at 1.25 s"));
    // The square, and the circle with its number above it.
    QVERIFY(svg.contains("<rect x=\"6\" y=\"6\" width=\"288\" height=\"288\""));
    QVERIFY(svg.contains("<circle cx=\"186\" cy=\"78\" r=\"18\" fill=\"#ff0000\""));
    QCOMPARE(svg.count("<circle"), 1); // the other is outside
    QCOMPARE(drawn.labels.size(), std::size_t{1});
    QCOMPARE(drawn.labels[0].text, QStringLiteral("1"));
    QVERIFY(length(drawn.labels[0].place - (place({1.0, 2.5}) - Vec2{0.0, 4.0})) < 0.02);
    // Its way up to it, and where it would be a quarter of a second later.
    const auto way = drawn.curve(QStringLiteral("#ff0000"));
    QCOMPARE(way.size(), std::size_t{3});
    QVERIFY(length(way[0] - place({-1.0, 2.0})) < 0.02);
    QVERIFY(length(way[2] - place({1.0, 2.0})) < 0.02);
    QCOMPARE(drawn.heads.size(), std::size_t{1});
    QVERIFY(length(drawn.heads[0][0] - place({2.0, 2.0})) < 0.02);
    // Of more than four no number is read.
    moment.bodies.assign(5, moment.bodies[0]);
    QVERIFY(Drawn(sceneSvg(moment)).labels.empty());
    moment.bodies.pop_back();
    QCOMPARE(Drawn(sceneSvg(moment)).labels.size(), std::size_t{4});
}

QTEST_GUILESS_MAIN(TestRunPictures)
#include "test_run_pictures.moc"
