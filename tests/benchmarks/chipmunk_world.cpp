// Chipmunk. Restitution is the product of two: each body gets √e. Its slop of 0.1 is meant for pixels; here
// it is a thousandth of the smallest diameter. Ten iterations, as it comes. Of its two indices the cheaper
// one in our gases: the spatial hash, its cells a diameter wide, for a thousand bodies and more that move far
// in a step; else the tree, as it comes.
#include "tests/benchmarks/worlds.h"

#include <chipmunk/chipmunk.h>

#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace thetalane::benchmarks {
namespace {

class ChipmunkWorld : public World {
public:
    ChipmunkWorld(const Scene& scene, double h)
        : m_space(cpSpaceNew())
        , m_step(h) {
        cpSpaceSetCollisionSlop(m_space, smallestDiameter(scene) / 1000);
        if (scene.bodies.size() >= 1000 && highestSpeed(scene) * h > smallestDiameter(scene) / 5)
            cpSpaceUseSpatialHash(m_space, smallestDiameter(scene), 10 * int(scene.bodies.size()));
        const double root = std::sqrt(scene.restitution);
        m_shapes.reserve(scene.bodies.size() + 4);
        m_bodies.reserve(scene.bodies.size());
        for (const Body& b : scene.bodies)
            add(b, root);
        if (scene.frame)
            for (const WallBox& wall : wallBoxes(*scene.frame, 1))
                add(wall, root > 0 ? scene.frame->restitution / root : 0);
    }

    // The space first: to take out one shape after another costs it a search each.
    ~ChipmunkWorld() override {
        cpSpaceFree(m_space);
        for (cpShape* shape : m_shapes)
            cpShapeFree(shape);
        for (cpBody* body : m_bodies)
            cpBodyFree(body);
    }
    ChipmunkWorld(const ChipmunkWorld&) = delete;
    ChipmunkWorld& operator=(const ChipmunkWorld&) = delete;

    void step() override { cpSpaceStep(m_space, m_step); }

    void read(std::vector<BodyState>& states) const override {
        states.resize(m_bodies.size());
        for (std::size_t i = 0; i < m_bodies.size(); ++i) {
            const cpVect p = cpBodyGetPosition(m_bodies[i]), v = cpBodyGetVelocity(m_bodies[i]);
            states[i].position = {p.x, p.y};
            states[i].velocity = {v.x, v.y};
        }
    }

private:
    void add(const Body& body, double elasticity) {
        cpBody* made = cpSpaceAddBody(
            m_space, cpBodyNew(body.mass, cpMomentForCircle(body.mass, 0, body.radius, cpvzero)));
        cpBodySetPosition(made, cpv(body.position.x, body.position.y));
        cpBodySetVelocity(made, cpv(body.velocity.x, body.velocity.y));
        m_bodies.push_back(made);
        add(cpCircleShapeNew(made, body.radius, cpvzero), elasticity);
    }

    void add(const WallBox& wall, double elasticity) {
        const cpBB box{wall.middle.x - wall.half.x, wall.middle.y - wall.half.y, wall.middle.x + wall.half.x,
                       wall.middle.y + wall.half.y};
        add(cpBoxShapeNew2(cpSpaceGetStaticBody(m_space), box, 0), elasticity);
    }

    void add(cpShape* shape, double elasticity) {
        cpShapeSetElasticity(shape, elasticity);
        cpShapeSetFriction(shape, 0);
        m_shapes.push_back(cpSpaceAddShape(m_space, shape));
    }

    cpSpace* m_space;
    double m_step;
    std::vector<cpBody*> m_bodies;
    std::vector<cpShape*> m_shapes;
};

// A debug build says so on standard output, once, when it makes its first space.
bool isDebugBuild() {
    std::fflush(stdout);
    std::FILE* said = std::tmpfile();
    const int out = dup(STDOUT_FILENO);
    if (!said || out < 0)
        return false;
    dup2(fileno(said), STDOUT_FILENO);
    cpSpaceFree(cpSpaceNew());
    std::fflush(stdout);
    const bool debug = lseek(STDOUT_FILENO, 0, SEEK_CUR) > 0;
    dup2(out, STDOUT_FILENO);
    close(out);
    std::fclose(said);
    return debug;
}

} // namespace

std::unique_ptr<World> makeChipmunk(const Scene& scene, double h) {
    return std::make_unique<ChipmunkWorld>(scene, h);
}

std::string chipmunkName() {
    static const std::string name =
        std::string("Chipmunk ") + cpVersionString + (isDebugBuild() ? " (debug build)" : "");
    return name;
}

} // namespace thetalane::benchmarks
