// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_library.h"

#include "tests/check_spec.h"
#include "tests/contact_programs.h"
#include "tests/scenes.h"

#include <QJsonArray>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::programs::contacts;

/// Scenes that a lab narrows down: circles that part, ranges of angles, a seed of its own.
class TestNarrowedScenes : public QObject
{
    Q_OBJECT
private slots:
    void partingCirclesAreLeftAlone_data();
    void partingCirclesAreLeftAlone();
    void partingCirclesOverlapByAStepOrTwo_data();
    void partingCirclesOverlapByAStepOrTwo();
    void anglesStayInTheirRange_data();
    void anglesStayInTheirRange();
    void ownSeedDrawsTheSameScenes();
};

namespace {

/// From the one to the other after \p seconds.
Vec2 betweenAfter(const Circle &a, const Circle &b, double seconds)
{
    return b.position - a.position + seconds * (b.velocity - a.velocity);
}

} // namespace

void TestNarrowedScenes::partingCirclesAreLeftAlone_data()
{
    QTest::addColumn<bool>("asks"); ///< the program asks whether they approach
    QTest::newRow("with the test") << true;
    QTest::newRow("without the test") << false;
}

void TestNarrowedScenes::partingCirclesAreLeftAlone()
{
    QFETCH(bool, asks);
    CheckSpec check = checkOf("collides", {{QStringLiteral("contacts"), 0}}, {0, 1});
    check.scene = {{QStringLiteral("kind"), QStringLiteral("parting")},
                   {QStringLiteral("count"), 12},
                   {QStringLiteral("radii"), QJsonArray{0.1, 0.5}},
                   {QStringLiteral("timesteps"), QJsonArray{1.0 / 60.0, 1.0 / 120.0, 1.0 / 30.0}}};
    const auto variants = makeVariants(scene({Circle{}, Circle{.position = {1, 1}}}), check, 3);
    QCOMPARE(variants.size(), 12U);
    // Where the program leaves the motion to the laws, they are left alone, too.
    const QString lawsAlone = QStringLiteral("function on_load() end");
    for (const Variant &variant : variants) {
        const Observation byLaws = observe(variant, &lawsAlone);
        QVERIFY2(!byLaws.error, byLaws.error ? qPrintable(byLaws.error->message) : "");
        QVERIFY(!judge(check, byLaws));
        const Circle &a = variant.preset.circles[0].body;
        const Circle &b = variant.preset.circles[1].body;
        QVERIFY(length(b.position - a.position) < a.radius + b.radius);
        QVERIFY(dot(b.velocity - a.velocity, b.position - a.position) > 0.0);
        const Observation run = observed(variant.preset, 0.5, [&](Circles &c, double h) {
            move(c, h);
            const Vec2 n = normalized(between(c));
            const double closing = dot(c[0].velocity - c[1].velocity, n);
            if (!touches(c) || (asks && closing <= 0.0))
                return;
            c[0].velocity -= closing * n;
            c[1].velocity += closing * n;
        });
        const auto fault = judge(check, run);
        QVERIFY2(fault.has_value() != asks, qPrintable(variant.name));
        if (fault)
            QVERIFY2(fault->message.contains(QStringLiteral("already moving apart")),
                     qPrintable(fault->message));
    }
}

void TestNarrowedScenes::partingCirclesOverlapByAStepOrTwo_data()
{
    QTest::addColumn<double>("speed");  // m/s
    QTest::addColumn<Vec2>("distance"); // of the centres, at least and at most, m
    // A fifth to four fifths of a step more than one step takes them apart, 0.4 m being touching.
    QTest::newRow("slowly") << 1.0 << Vec2{0.4 - 1.8 / 60.0, 0.4 - 1.2 / 60.0};
    QTest::newRow("fast") << 6.0 << Vec2{0.4 - 10.8 / 60.0, 0.4 - 7.2 / 60.0};
    QTest::newRow("never by more than half") << 20.0 << Vec2{0.2, 0.2};
}

void TestNarrowedScenes::partingCirclesOverlapByAStepOrTwo()
{
    QFETCH(double, speed);
    QFETCH(Vec2, distance);
    CheckSpec check = checkOf("collides", {}, {0, 1});
    check.scene = {{QStringLiteral("kind"), QStringLiteral("parting")},
                   {QStringLiteral("count"), 12},
                   {QStringLiteral("speeds"), QJsonArray{speed, speed}},
                   {QStringLiteral("radii"), QJsonArray{0.2, 0.2}},
                   {QStringLiteral("timesteps"), QJsonArray{1.0 / 60.0}}};
    for (const Variant &variant :
         makeVariants(scene({Circle{}, Circle{.position = {1, 1}}}), check, 3)) {
        const Circle &a = variant.preset.circles[0].body;
        const Circle &b = variant.preset.circles[1].body;
        const double apart = length(b.position - a.position);
        QVERIFY2(apart >= distance.x - 1e-9 && apart <= distance.y + 1e-9,
                 QByteArray::number(apart).constData());
        QVERIFY(std::abs(dot(b.velocity - a.velocity, normalized(b.position - a.position)) - speed)
                < 1e-9);
    }
}

void TestNarrowedScenes::anglesStayInTheirRange_data()
{
    QTest::addColumn<QString>("kind");
    for (const char *kind : {"flight", "directions", "encounters", "parting"})
        QTest::newRow(kind) << QString::fromLatin1(kind);
}

void TestNarrowedScenes::anglesStayInTheirRange()
{
    QFETCH(QString, kind);
    CheckSpec narrow = checkOf("integrates", {}, {0, 1});
    narrow.scene = {{QStringLiteral("kind"), kind},
                    {QStringLiteral("count"), 12},
                    {QStringLiteral("angles"), QJsonArray{30.0, 60.0}}};
    const Preset preset = scene({Circle{}, Circle{.position = {1, 1}}});
    const auto variants = makeVariants(preset, narrow, 5);
    QVERIFY(variants.size() >= 12);
    for (const Variant &variant : variants) {
        const Circle &a = variant.preset.circles[0].body;
        const Circle &b = variant.preset.circles[1].body;
        // Encounters are told by the line of centres at the contact, after 0.5 s and a part of a
        // step; the others by what is thrown.
        const bool isSecond = kind == QLatin1String("directions")
                                  ? variant.name.startsWith(QLatin1String("circle 2"))
                                  : length(b.velocity) > length(a.velocity);
        Vec2 way = isSecond ? b.velocity : a.velocity;
        if (kind == QLatin1String("encounters"))
            way = betweenAfter(a, b, 0.5 + 0.5 * variant.preset.timestep);
        else if (kind == QLatin1String("parting"))
            way = betweenAfter(a, b, 0.0);
        const double degrees = std::atan2(way.y, way.x) * 180.0 / scenes::pi;
        QVERIFY2(degrees > 25.0 && degrees < 65.0, qPrintable(variant.name));
    }
}

void TestNarrowedScenes::ownSeedDrawsTheSameScenes()
{
    CheckSpec check = checkOf("integrates", {});
    check.scene = {{QStringLiteral("kind"), QStringLiteral("flight")},
                   {QStringLiteral("count"), 3}};
    const Preset preset = scene({Circle{}});
    const auto presetsOf = [&](qint64 seed) {
        std::vector<Preset> presets;
        for (const Variant &variant : makeVariants(preset, check, seed))
            presets.push_back(variant.preset);
        return presets;
    };
    QVERIFY(!(presetsOf(1) == presetsOf(2)));
    check.scene.insert(QStringLiteral("seed"), 7);
    QVERIFY(presetsOf(1) == presetsOf(2));
}

QTEST_GUILESS_MAIN(TestNarrowedScenes)
#include "test_narrowed_scenes.moc"
