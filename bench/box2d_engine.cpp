// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/gas_engine.h"

#include <box2d/box2d.h>

namespace cradle {

namespace {

b2Vec2 toBox2d(Vec2 v)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

class Box2dEngine final : public GasEngine
{
public:
    explicit Box2dEngine(const Preset &gas)
        : m_world(toBox2d(gas.gravity))
        , m_restitution(static_cast<float>(gas.restitution))
    {
        m_world.SetAllowSleeping(gas.restitution < 1.0);
        addWalls(static_cast<float>(gas.halfWidth));
        m_bodies.reserve(gas.circles.size());
        for (const PresetCircle &circle : gas.circles)
            addCircle(circle.body);
    }

    void step() override { m_world.Step(1.0F / 60.0F, 8, 3); }
    [[nodiscard]] int stepsPerFrame() const override { return 1; }

    void read(std::vector<Motion> &motions) const override
    {
        motions.clear();
        for (const b2Body *body : m_bodies) {
            const b2Vec2 position = body->GetPosition();
            const b2Vec2 velocity = body->GetLinearVelocity();
            motions.push_back({Vec2{position.x, position.y}, Vec2{velocity.x, velocity.y}});
        }
    }

private:
    void addFixture(b2Body &body, const b2Shape &shape)
    {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = 1.0F;
        fixture.friction = 0.0F;
        fixture.restitution = m_restitution;
        if (m_restitution == 1.0F)
            fixture.restitutionThreshold = 0.0F;
        body.CreateFixture(&fixture);
    }

    void addWalls(float h)
    {
        const b2BodyDef still;
        b2Body &walls = *m_world.CreateBody(&still);
        const b2Vec2 corners[] = {{-h, -h}, {h, -h}, {h, h}, {-h, h}};
        for (int i = 0; i < 4; ++i) {
            b2EdgeShape edge;
            edge.SetTwoSided(corners[i], corners[(i + 1) % 4]);
            addFixture(walls, edge);
        }
    }

    void addCircle(const Circle &circle)
    {
        b2BodyDef moving;
        moving.type = b2_dynamicBody;
        moving.position = toBox2d(circle.position);
        moving.linearVelocity = toBox2d(circle.velocity);
        moving.fixedRotation = true;
        b2CircleShape disc;
        disc.m_radius = static_cast<float>(circle.radius);
        m_bodies.push_back(m_world.CreateBody(&moving));
        addFixture(*m_bodies.back(), disc);
    }

    b2World m_world;
    float m_restitution;            ///< Box2D takes the larger of the two that meet
    std::vector<b2Body *> m_bodies; ///< the world owns them
};

} // namespace

std::unique_ptr<GasEngine> makeBox2d(const Gas &gas)
{
    return std::make_unique<Box2dEngine>(gas);
}

} // namespace cradle
