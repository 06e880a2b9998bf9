// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "tests/scene_lists.h"
#include "views/scene/hit_parts.h"
#include "views/theme.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace cradle::scenes;
using namespace cradle;

namespace {

Vec2 shaft(const DrawList::Arrow &arrow)
{
    return arrow.to - arrow.from;
}

QColor colourOf(std::size_t circle)
{
    return circleColour(twoCircles().circles[circle].colour);
}

} // namespace

class TestHitParts : public QObject
{
    Q_OBJECT
private slots:
    void hitIsSplitAlongAndAcross();
    void wallHitIsSplitAlongTheWallsNormal();
    void swappedVelocitiesLookDifferent();
    void discsAndLabelsStayFree_data();
    void discsAndLabelsStayFree();
    void fastArrowsAreLabelledWhereTheyAreSeen();
    void hitFadesWhileRunning();
};

void TestHitParts::hitIsSplitAlongAndAcross()
{
    Simulation simulation(twoCircles());
    simulation.seekNextHit();
    // The first step that would overlap is where 4 − t·2 < √(0.4² − 0.3²) = 0.26458: step 113;
    // both go back to step 112, where circle 1 is at x = −2 + 112/30 = 1.73333.
    QCOMPARE(simulation.current(), qint64{113});
    const Vec2 at{-2.0 + 112.0 / 30.0, 2.3};
    const Vec2 n = normalized(Vec2{2.0, 2.0} - at);
    const Vec2 along = 2.0 * n.x * n;
    const Vec2 across = Vec2{2.0, 0.0} - along;
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(twoCircles()));
    const DrawList::Arrow alongArrow = arrowOf(list, theme().along);
    const DrawList::Arrow acrossArrow = arrowOf(list, theme().across);
    QVERIFY(near(alongArrow.to - alongArrow.from, 0.75 * along));
    QVERIFY(near(acrossArrow.from, at + 0.2 * normalized(across))); // at the rim
    QVERIFY(near(acrossArrow.to - acrossArrow.from, 0.75 * across));
    QVERIFY(near(list.arrows[0].to - list.arrows[0].from, {1.5, 0.0})); // before
    // The part along changed hands, the part across stayed.
    QVERIFY(near(shaft(arrowOf(list, colourOf(0))), 0.75 * across));
    QVERIFY(near(shaft(arrowOf(list, colourOf(1))), 0.75 * along));
    QCOMPARE(list.arrows.size(), std::size_t{6}); // and the head of the normal
    // |along| = 2 · 0.26667/0.40139 = 1.3287, |across| = 2 · 0.3/0.40139 = 1.4948
    const QStringList found = texts(list);
    QVERIFY(found.contains(QStringLiteral("along 1.33")));
    QVERIFY(found.contains(QStringLiteral("across 1.49")));
    QVERIFY(found.contains(QStringLiteral("before 2.00")));
    QVERIFY(found.contains(QStringLiteral("after 1.49")));
    QVERIFY(found.contains(QStringLiteral("after 1.33")));
    const auto normal = std::find_if(list.lines.begin(), list.lines.end(), [](const auto &line) {
        return line.dash != DrawList::Dash{};
    });
    QVERIFY(normal != list.lines.end());
    QVERIFY(near(normal->from, at));
    QVERIFY(std::abs(cross(normal->to - normal->from, n)) < 1e-9);
    const DrawList::Arrow head = list.arrows.back(); // beyond circle 2
    QVERIFY(near(normalized(shaft(head)), n));
    QVERIFY(dot(head.from - Vec2{2.0, 2.0}, n) > 0.2);
    // A step later nothing of it is shown.
    simulation.stepForward();
    const DrawList later = buildScene(SceneMoment(simulation), {}, lookAt(twoCircles()));
    QCOMPARE(arrowOf(later, theme().along), DrawList::Arrow{});
}

void TestHitParts::wallHitIsSplitAlongTheWallsNormal()
{
    Preset preset = twoCircles();
    preset.circles.pop_back();
    preset.circles[0].body = {.position = {3.0, 0.0}, .velocity = {3.0, 1.0}};
    Simulation simulation(preset);
    simulation.seekNextHit();
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(preset, {1200.0, 700.0}));
    const DrawList::Arrow along = arrowOf(list, theme().along);
    const DrawList::Arrow across = arrowOf(list, theme().across);
    QVERIFY(near(along.to - along.from, {0.75 * 3.0, 0.0}));
    QVERIFY(near(across.to - across.from, {0.0, 0.75 * 1.0}));
    QVERIFY(texts(list).contains(QStringLiteral("along 3.00")));
    QVERIFY(near(shaft(arrowOf(list, colourOf(0))), {-0.75 * 3.0, 0.75 * 1.0}));
    QVERIFY(texts(list).contains(QStringLiteral("after 3.16")));
    QVERIFY(near(normalized(shaft(list.arrows.back())), {1.0, 0.0}));
    QVERIFY(list.arrows.back().from.x > preset.halfWidth); // outside the wall
}

void TestHitParts::swappedVelocitiesLookDifferent()
{
    Preset preset = twoCircles();
    preset.laws.circles = CircleLaw::SwapVelocities;
    Simulation simulation(preset);
    simulation.seekNextHit();
    const DrawList list = buildScene(SceneMoment(simulation), {}, lookAt(preset));
    QCOMPARE(arrowOf(list, colourOf(0)), DrawList::Arrow{}); // stands still
    QVERIFY(near(shaft(arrowOf(list, colourOf(1))), {1.5, 0.0}));
    QVERIFY(texts(list).contains(QStringLiteral("after 0.00")));
    QVERIFY(texts(list).contains(QStringLiteral("after 2.00")));
}

void TestHitParts::discsAndLabelsStayFree_data()
{
    QTest::addColumn<Circle>("first");
    QTest::addColumn<Circle>("second");
    QTest::addColumn<QSizeF>("viewport");
    const Circle right{.position = {-2.0, 2.0}, .velocity = {2.0, 0.0}};
    const Circle up{.position = {2.0, -2.0}, .velocity = {0.0, 2.0}};
    const Circle slow{.position = {-2.5, 2.0}, .velocity = {1.0, 0.0}};
    const Circle back{.position = {0.0, 2.0}, .velocity = {-1.0, 0.0}, .radius = 0.252};
    for (const QSizeF size : {QSizeF(520.0, 330.0), QSizeF(700.0, 480.0)}) {
        QTest::addRow("both moving, %d px", static_cast<int>(size.width())) << right << up << size;
        QTest::addRow("head on, %d px", static_cast<int>(size.width())) << slow << back << size;
    }
}

void TestHitParts::discsAndLabelsStayFree()
{
    QFETCH(Circle, first);
    QFETCH(Circle, second);
    QFETCH(QSizeF, viewport);
    Preset preset = twoCircles();
    preset.circles[0].body = first;
    preset.circles[1].body = second;
    Simulation simulation(preset);
    simulation.seekNextHit();
    QCOMPARE(simulation.recording().hits().size(), std::size_t{1});
    const SceneLook look = lookAt(preset, viewport);
    const DrawList list = buildScene(SceneMoment(simulation), {}, look);
    QVERIFY(!textOverText(list, look.camera, look.font));
    for (const QColor &part : {theme().along, colourOf(0), colourOf(1)})
        QVERIFY(arrowOf(list, part) != DrawList::Arrow{});
    QCOMPARE(texts(list).filter(QStringLiteral("after")).size(), 2);
    QCOMPARE(texts(list).filter(QStringLiteral("along")).size(), 2);
    for (const DrawList::Disc &disc : list.discs) {
        const QPointF centre = look.camera.toPixels(disc.centre);
        const double radius = disc.radius * look.camera.pixelsPerMetre();
        for (const DrawList::Arrow &arrow : list.arrows) {
            const QPointF tip = look.camera.toPixels(arrow.to);
            QVERIFY(std::hypot(tip.x() - centre.x(), tip.y() - centre.y()) > radius);
        }
        for (const DrawList::Label &label : list.labels) {
            if (label.strong)
                continue; // a number in its disc
            const QFontMetricsF metrics(labelFont(look.font));
            QVERIFY(!labelRect(label, look.camera, metrics).contains(centre));
        }
    }
}

/// At 10 m/s the arrows would end 6.5 m below the floor, of which 1 m is seen: they are broken.
void TestHitParts::fastArrowsAreLabelledWhereTheyAreSeen()
{
    Preset preset = twoCircles();
    preset.circles[0].body.velocity = {2.0, -10.0};
    Simulation simulation(preset);
    simulation.seekNextHit();
    const SceneLook look = lookAt(preset);
    const DrawList list = buildScene(SceneMoment(simulation), {}, look);
    const QRectF seen({}, look.camera.viewport());
    for (const DrawList::Arrow &arrow : list.arrows)
        QVERIFY(seen.contains(look.camera.toPixels(arrow.to)));
    std::vector<DrawList::Arrow> along;
    std::copy_if(list.arrows.begin(), list.arrows.end(), std::back_inserter(along),
                 [](const DrawList::Arrow &arrow) {
                     return arrow.colour == theme().along && arrow.width > 2.0;
                 });
    QCOMPARE(along.size(), std::size_t{2}); // the shaft and, behind the break, the head
    QCOMPARE(along[0].head, 0.0);
    QVERIFY(along[1].head > 0.0);
    QVERIFY(near(normalized(shaft(along[1])), {0.0, -1.0}));
    QCOMPARE(std::count_if(list.lines.begin(), list.lines.end(),
                           [](const DrawList::Line &line) {
                               return line.colour == theme().along && line.dash == DrawList::Dash{};
                           }),
             2); // the break
    QVERIFY(texts(list).contains(QStringLiteral("along 10.00")));
    QVERIFY(texts(list).contains(QStringLiteral("before 10.20")));
    const QFontMetricsF metrics(labelFont(look.font));
    for (const DrawList::Label &label : list.labels) {
        const QRectF rect = labelRect(label, look.camera, metrics);
        QVERIFY2(seen.contains(rect), qPrintable(label.text));
    }
    QVERIFY(!textOverText(list, look.camera, look.font));
}

void TestHitParts::hitFadesWhileRunning()
{
    Simulation simulation(twoCircles());
    simulation.seekNextHit();
    for (int i = 0; i < 12; ++i)
        simulation.stepForward(); // 0.2 s later: half of 0.4 s
    const SceneMoment moment(simulation.preset(), simulation.recording(), simulation.current(),
                             true);
    const DrawList list = buildScene(moment, {}, lookAt(twoCircles()));
    const auto half = std::find_if(list.arrows.begin(), list.arrows.end(), [](const auto &arrow) {
        return arrow.colour.rgb() == theme().along.rgb();
    });
    QVERIFY(half != list.arrows.end());
    QVERIFY(std::abs(half->colour.alphaF() - 0.5f) < 0.01f);
}

QTEST_MAIN(TestHitParts)
#include "test_hit_parts.moc"
