// The lines of each step of a worked collision, from PairCollision's numbers; the words are in worked_steps.
#pragma once

#include "ui/words/instant.h"
#include "ui/words/worked_steps.h"

#include <algorithm>

namespace thetalane {

inline const QString alongAxis = QStringLiteral("x′");
inline const QString acrossAxis = QStringLiteral("y′");

inline Formula unit(const char* text) {
    return upright(QString::fromUtf8(text));
}

inline Formula valued(double value, Ink ink, const char* unitText) {
    return row({number(value, ink), unit(unitText)});
}

inline Formula operation(const char* text) {
    return op(QString::fromUtf8(text));
}

inline Formula square(Formula base) {
    return script(std::move(base), {}, upright("2"));
}

// Whose colour: the collision's two bodies have their own, x′ and y′ have theirs, and the others none.
Ink inkOf(const Collision& collision, int body, const QString& axis);

inline bool hasWall(std::span<const Collision> pass) {
    return std::any_of(pass.begin(), pass.end(), [](const Collision& c) { return c.isWall(); });
}

// Writes the lines of one collision; the inks and letters of its two bodies are settled once.
class LineWriter {
public:
    // `pass`: the collision itself, and those resolved together with it.
    LineWriter(const Scene& scene, const Collision& collision, std::span<const Collision> pass)
        : m_scene(scene)
        , m_collision(collision)
        , m_pass(pass)
        , m_s(collision.steps) {}

    std::vector<WorkedLine> contact() const;
    std::vector<WorkedLine> split() const;
    std::vector<WorkedLine> rotation() const;
    std::vector<WorkedLine> exchange() const;
    std::vector<WorkedLine> rotationBack() const;
    std::vector<WorkedLine> check() const;
    std::vector<WorkedLine> exchangeTogether() const; // of several
    std::vector<WorkedLine> checkTogether() const;

    bool isPartedFaster() const; // by the other impulses, than e asks

private:
    // The two bodies, or one at a wall, with what belongs to each.
    struct Party {
        int body;
        Ink ink;
        const Disc<double>& disc;
        const Vec2d& before;
        const Vec2d& rotated;
        const Vec2d& exchanged;
        const Vec2d& after;
    };
    Party first() const {
        return {m_collision.first, Ink::First,          m_s.first,      m_s.before.first,
                m_s.rotated.first, m_s.exchanged.first, m_s.after.first};
    }
    Party second() const {
        return {m_collision.second, Ink::Second,          m_s.second,      m_s.before.second,
                m_s.rotated.second, m_s.exchanged.second, m_s.after.second};
    }
    std::vector<Party> parties() const {
        return m_collision.isWall() ? std::vector{first()} : std::vector{first(), second()};
    }

    Formula of(const char* letter, const Party& p) const {
        return script(symbol(letter, p.ink), upright(indexName(m_scene, p.body), p.ink));
    }
    Formula v(const Party& p, const QString& axis, When when = When::Before) const {
        return velocitySymbol(m_scene, m_collision, p.body, axis, when);
    }
    static Formula letter(const char* text) { return symbol(QString::fromUtf8(text), Ink::Triangle); }
    static Formula function(const char* name) { return row({upright(name), letter("θ")}); }
    Formula cosine() const { return signedFactor(m_s.contact.cosTheta, Ink::Triangle); }
    Formula sine() const { return signedFactor(m_s.contact.sinTheta, Ink::Triangle); }

    WorkedLine leg(const char* name, const char* coordinate, double from, double to, double length) const;
    WorkedLine reach() const;
    WorkedLine turned(Formula left, Formula one, double oneValue, Ink oneInk, const char* sign, bool cosFirst,
                      Formula two, double twoValue, Ink twoInk, double result, Ink ink) const;
    WorkedLine exchanged(const Party& p, const Party& other) const;
    void momentum(std::vector<WorkedLine>& lines, const QString& axis, double Vec2d::*part) const;
    WorkedLine restitution() const;
    WorkedLine restitutionLeft() const;
    WorkedLine impulse() const;
    WorkedLine energy(When when) const;
    WorkedLine loss() const;
    Formula impulseOf(const Collision& collision) const;
    void law(std::vector<WorkedLine>& lines) const;
    WorkedLine gathered(const Party& p, bool along) const;
    WorkedLine passMomentum(const std::vector<PassBody>& bodies, const QString& axis, double Vec2d::*part,
                            When when) const;
    WorkedLine passEnergy(const std::vector<PassBody>& bodies, When when) const;
    WorkedLine share() const;

    const Scene& m_scene;
    const Collision& m_collision;
    std::span<const Collision> m_pass;
    const PairCollision<double>& m_s;
};

} // namespace thetalane
