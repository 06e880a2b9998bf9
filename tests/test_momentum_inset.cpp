// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/run/simulation.h"
#include "model/world/measurements.h"
#include "tests/scene_lists.h"
#include "views/scene/momentum_inset.h"

#include <QTest>

#include <rapidcheck.h>

#include <cmath>

using namespace cradle;
using namespace cradle::scenes;

namespace {

MomentumInset insetOf(const Preset &preset, QSizeF viewport = {700.0, 700.0},
                      const std::vector<QRectF> &reserved = {})
{
    const Simulation simulation(preset);
    return momentumInset(SceneMoment(simulation), lookAt(preset, viewport).camera, {}, reserved)
        .value_or(MomentumInset{});
}

/// The momentum that an arrow stands for, kg m/s.
Vec2 momentumOf(const MomentumInset &inset, const MomentumInset::Arrow &arrow)
{
    const QPointF way = arrow.to - arrow.from;
    return (inset.scaleMomentum / inset.scaleLength) * Vec2{way.x(), -way.y()};
}

Vec2 momentum(const Circle &circle)
{
    return mass(circle) * circle.velocity;
}

bool meet(QPointF a, QPointF b)
{
    return (a - b).manhattanLength() < 1e-6;
}

Preset moving(Vec2 first, Vec2 second)
{
    Preset preset = twoCircles();
    preset.circles[0].body.velocity = first;
    preset.circles[1].body.velocity = second;
    return preset;
}

} // namespace

class TestMomentumInset : public QObject
{
    Q_OBJECT
private slots:
    void arrowsLieTipToTail();
    void aHitLeavesTheSumAsItWas();
    void momentaInOneLineLieSideBySide();
    void labelsOfANarrowTriangleStandApart();
    void equalAndOppositeMakeZero();
    void everythingLiesInTheFrame();
    void standsInACornerThatIsFree();
    void isLeftOutWhereItHelpsNobody();
};

void TestMomentumInset::arrowsLieTipToTail()
{
    const Preset preset = moving({2.0, 0.0}, {-0.5, 1.0});
    const MomentumInset inset = insetOf(preset);
    QCOMPARE(inset.arrows.size(), std::size_t{3});
    const auto &[first, second, sum] = std::tie(inset.arrows[0], inset.arrows[1], inset.arrows[2]);
    QVERIFY(meet(first.to, second.from));
    QVERIFY(meet(first.from, sum.from));
    QVERIFY(meet(second.to, sum.to));
    QCOMPARE(first.label, QStringLiteral("1"));
    QCOMPARE(second.label, QStringLiteral("2"));
    QCOMPARE(sum.label, QStringLiteral("Σ"));
    QVERIFY(sum.isSum && !first.isSum && !second.isSum);
    QVERIFY(near(momentumOf(inset, first), momentum(preset.circles[0].body), 1e-6));
    QVERIFY(near(momentumOf(inset, second), momentum(preset.circles[1].body), 1e-6));
    QVERIFY(near(momentumOf(inset, sum),
                 momentum(preset.circles[0].body) + momentum(preset.circles[1].body), 1e-6));
}

void TestMomentumInset::aHitLeavesTheSumAsItWas()
{
    Simulation simulation(twoCircles());
    const Camera camera = lookAt(twoCircles()).camera;
    const auto before = momentumInset(SceneMoment(simulation), camera, {}, {});
    simulation.seekNextHit();
    const auto after = momentumInset(SceneMoment(simulation), camera, {}, {});
    QVERIFY(before && after);
    QCOMPARE(before->arrows.size(), std::size_t{2}); // the second one rests
    QCOMPARE(after->arrows.size(), std::size_t{3});
    const Vec2 sum = momentumOf(*before, before->arrows.back());
    QVERIFY(near(momentumOf(*after, after->arrows.back()), sum, 1e-6));
    QVERIFY(length(momentumOf(*after, after->arrows.front())) < 0.99 * length(sum));
}

void TestMomentumInset::momentaInOneLineLieSideBySide()
{
    const MomentumInset inset = insetOf(moving({3.0, 0.0}, {-1.0, 0.0}));
    QCOMPARE(inset.arrows.size(), std::size_t{3});
    for (std::size_t i = 1; i < 3; ++i) {
        // Each has a height of its own, the sum on top, and room for a label between them.
        QVERIFY(inset.arrows[i].from.y() < inset.arrows[i - 1].from.y() - 12.0);
        QCOMPARE(inset.arrows[i].from.y(), inset.arrows[i].to.y());
    }
    QVERIFY(std::abs(inset.arrows[0].to.x() - inset.arrows[1].from.x()) < 1e-6);
    QVERIFY(std::abs(inset.arrows[1].to.x() - inset.arrows[2].to.x()) < 1e-6);
    // Of one way both lie in one line, and only the sum beside them.
    const MomentumInset chased = insetOf(moving({3.0, 0.0}, {1.0, 0.0}));
    QVERIFY(meet(chased.arrows[0].to, chased.arrows[1].from));
    QVERIFY(chased.arrows[2].from.y() < chased.arrows[0].from.y() - 12.0);
    // Many of them, to and fro and a little aslant, are still to be seen.
    Preset many = twoCircles();
    many.laws = {};
    many.circles.resize(mostMomenta, many.circles.front());
    for (std::size_t i = 0; i < many.circles.size(); ++i)
        many.circles[i].body.velocity = (i % 2 == 0 ? 1.0 : -0.9) * Vec2{3.0, 0.1};
    const MomentumInset full = insetOf(many);
    QCOMPARE(full.arrows.size(), mostMomenta + 1);
    QVERIFY(QLineF(full.arrows[0].from, full.arrows[0].to).length() > 20.0);
    for (const MomentumInset::Arrow &arrow : full.arrows)
        QVERIFY(full.frame.contains(arrow.from) && full.frame.contains(arrow.to));
}

void TestMomentumInset::labelsOfANarrowTriangleStandApart()
{
    // One slow to the right, the other eight times as fast upwards: the sum is almost the second.
    for (const double slow : {0.5, -0.5}) {
        const MomentumInset inset = insetOf(moving({slow, 0.0}, {0.0, 4.0}));
        const auto &[second, sum] = std::tie(inset.arrows[1], inset.arrows[2]);
        QVERIFY(!second.label.isEmpty() && !sum.label.isEmpty());
        QVERIFY(std::abs(second.labelAt.x() - sum.labelAt.x()) > 15.0);
    }
}

void TestMomentumInset::equalAndOppositeMakeZero()
{
    const MomentumInset inset = insetOf(moving({2.0, 1.0}, {-2.0, -1.0}));
    QCOMPARE(inset.arrows.size(), std::size_t{3});
    QVERIFY(meet(inset.arrows[2].from, inset.arrows[2].to));
    QCOMPARE(inset.arrows[2].label, QStringLiteral("Σ = 0"));
}

void TestMomentumInset::everythingLiesInTheFrame()
{
    const bool lawful = rc::check("arrows and labels stay in the frame", [] {
        const auto count = *rc::gen::inRange(2, 7);
        Preset preset = twoCircles();
        preset.laws = {};
        preset.circles.resize(static_cast<std::size_t>(count));
        for (PresetCircle &circle : preset.circles) {
            const auto part = [] { return *rc::gen::inRange(-30, 31) / 10.0; };
            const double x = part();
            circle.body.velocity = {x, *rc::gen::arbitrary<bool>() ? part() : 0.0};
            circle.body.radius = *rc::gen::inRange(1, 20) / 20.0;
        }
        const MomentumInset inset = insetOf(preset);
        RC_PRE(!inset.arrows.empty());
        RC_ASSERT(inset.scaleLength > 10.0 && inset.scaleLength <= 48.0 + 1e-9);
        for (const MomentumInset::Arrow &arrow : inset.arrows) {
            RC_ASSERT(inset.frame.adjusted(4, 4, -4, -4).contains(arrow.from));
            RC_ASSERT(inset.frame.adjusted(4, 4, -4, -4).contains(arrow.to));
            if (!arrow.label.isEmpty())
                RC_ASSERT(inset.frame.adjusted(6, 6, -6, -6).contains(arrow.labelAt));
        }
    });
    QVERIFY(lawful);
}

void TestMomentumInset::standsInACornerThatIsFree()
{
    const QPointF middle(350.0, 350.0);
    Preset preset = moving({1.0, 0.0}, {});
    const QRectF usual = insetOf(preset).frame;
    QVERIFY(usual.right() < middle.x() && usual.top() > middle.y()); // at the bottom left
    preset.circles[1].body.position = {-3.5, -3.5};
    const QRectF right = insetOf(preset).frame;
    QVERIFY(right.left() > middle.x() && right.top() > middle.y());
    preset.circles[0].body.position = {3.5, -3.5};
    const QRectF top = insetOf(preset).frame;
    QVERIFY(top.right() < middle.x() && top.bottom() < middle.y());
    const QRectF chip(10.0, 10.0, 100.0, 20.0);
    QVERIFY(!insetOf(preset, {700.0, 700.0}, {chip}).frame.intersects(chip));
    for (const QRectF &frame : {usual, right, top})
        QVERIFY(QRectF(0.0, 0.0, 700.0, 700.0).contains(frame));
}

void TestMomentumInset::isLeftOutWhereItHelpsNobody()
{
    const Preset preset = moving({1.0, 0.0}, {});
    QVERIFY(!insetOf(preset).arrows.empty());
    QVERIFY(insetOf(preset, {300.0, 300.0}).arrows.empty()); // it would hide the scene
    QVERIFY(insetOf(moving({}, {})).arrows.empty());
    Preset alone = preset;
    alone.circles.pop_back();
    QVERIFY(insetOf(alone).arrows.empty());
    Preset many = preset;
    many.laws.circles = CircleLaw::None;
    many.circles.resize(mostMomenta + 1, preset.circles.front());
    QVERIFY(insetOf(many).arrows.empty());
    many.circles.pop_back();
    QVERIFY(!insetOf(many).arrows.empty());
}

QTEST_MAIN(TestMomentumInset)
#include "test_momentum_inset.moc"
