// Box2D. It keeps lengths as floats, tolerates 5 mm of overlap, wants bodies of 0.1 to 10 m and moves none by
// more than 2 m a step. So lengths are scaled until the smallest diameter is 1 m, or less where the fastest
// body would go farther than that limit; masses are ratios, so they stay. (At the
// scene's own scale it is as fast in the rack, two to five times slower in a gas of 1,000, and less exact.)
// Collisions slower than a threshold
// are inelastic (1 m/s): the threshold is set to 0. Restitution is the larger of two: both get e. Iterations
// as its manual has them, 8 and 3. Continuous collision, which by default guards against static bodies alone,
// is left to bullets (here all bodies or none): the walls are too thick to be skipped, and in a gas of 10,000
// it would make a step nine times dearer.
#include "tests/benchmarks/worlds.h"

#include <box2d/box2d.h>

#include <algorithm>

namespace thetalane::benchmarks {
namespace {

class Box2dWorld : public World {
public:
    Box2dWorld(const Scene& scene, double h, bool bullets)
        : m_world(b2Vec2(0, 0))
        , m_scale(scaleFor(scene, h))
        , m_step(float(h)) {
        m_world.SetContinuousPhysics(bullets);
        m_bodies.reserve(scene.bodies.size());
        for (const Body& b : scene.bodies)
            add(b, scene.restitution, bullets);
        if (scene.frame)
            for (const WallBox& wall : wallBoxes(*scene.frame, 1))
                add(wall, scene.frame->restitution);
    }

    void step() override { m_world.Step(m_step, 8, 3); }

    void read(std::vector<BodyState>& states) const override {
        states.resize(m_bodies.size());
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const b2Vec2 p = m_bodies[i]->GetPosition(), v = m_bodies[i]->GetLinearVelocity();
            states[i].position = {p.x / m_scale, p.y / m_scale};
            states[i].velocity = {v.x / m_scale, v.y / m_scale};
        }
    }

private:
    // A struck body can be faster than the fastest at first.
    static double scaleFor(const Scene& scene, double h) {
        const double faster = 1.5 * highestSpeed(scene);
        return std::min(1 / smallestDiameter(scene), double(b2_maxTranslation) / (faster * h));
    }
    b2Vec2 scaled(Vec2d v) const { return {float(v.x * m_scale), float(v.y * m_scale)}; }

    void add(const Body& body, double restitution, bool bullet) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = scaled(body.position);
        def.linearVelocity = scaled(body.velocity);
        def.bullet = bullet;
        b2Body* made = m_world.CreateBody(&def);
        b2CircleShape circle;
        circle.m_radius = float(body.radius * m_scale);
        b2FixtureDef fixture = fixtureOf(circle, restitution);
        fixture.density = float(body.mass / (double(b2_pi) * circle.m_radius * circle.m_radius));
        made->CreateFixture(&fixture);
        m_bodies.push_back(made);
    }

    void add(const WallBox& wall, double restitution) {
        b2BodyDef def;
        def.position = scaled(wall.middle);
        b2PolygonShape box;
        const b2Vec2 half = scaled(wall.half);
        box.SetAsBox(half.x, half.y);
        const b2FixtureDef fixture = fixtureOf(box, restitution);
        m_world.CreateBody(&def)->CreateFixture(&fixture);
    }

    static b2FixtureDef fixtureOf(const b2Shape& shape, double restitution) {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.friction = 0;
        fixture.restitution = float(restitution);
        fixture.restitutionThreshold = 0;
        return fixture;
    }

    b2World m_world;
    double m_scale;
    float m_step;
    std::vector<b2Body*> m_bodies;
};

} // namespace

std::unique_ptr<World> makeBox2d(const Scene& scene, double h) {
    return std::make_unique<Box2dWorld>(scene, h, false);
}

std::unique_ptr<World> makeBox2dBullets(const Scene& scene, double h) {
    return std::make_unique<Box2dWorld>(scene, h, true);
}

std::string box2dName() {
    return "Box2D " THETALANE_BOX2D_VERSION; // as packaged: 2.4.1 itself says 2.4.0
}

} // namespace thetalane::benchmarks
