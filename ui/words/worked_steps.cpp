#include "ui/words/worked_steps.h"

#include "ui/words/scene_text.h"
#include "ui/words/worked_lines.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace thetalane {
namespace {

// Those of the two that another impulse of the pass drives across y′ as well.
QStringList drivenAcross(const Scene& scene, const Collision& c) {
    QStringList names;
    const auto look = [&](int body, const Vec2d& was, const Vec2d& is, const Vec2d& before) {
        if (std::abs(is.y - was.y) > 1e-9 * (norm(before) + norm(is)))
            names << bodyName(scene, body);
    };
    look(c.first, c.steps.rotated.first, c.steps.exchanged.first, c.steps.before.first);
    if (!c.isWall())
        look(c.second, c.steps.rotated.second, c.steps.exchanged.second, c.steps.before.second);
    return names;
}

QString togetherSentence(Stage stage, const Scene& scene, const Collision& c, const LineWriter& writer,
                         std::span<const Collision> pass) {
    QStringList said;
    if (stage == Stage::Exchange) {
        said << QCoreApplication::translate(
            "WorkedSteps",
            "%n contacts are resolved together: their impulses are found all at once, so that each contact "
            "keeps its own law of restitution along its own line of centres, and impulses that meet on a "
            "body add up.",
            nullptr, int(pass.size()));
        if (writer.isPartedFaster())
            said << QCoreApplication::translate("WorkedSteps",
                                                "Here the other impulses part the two faster than e asks.");
        const QStringList across = drivenAcross(scene, c);
        if (!across.isEmpty())
            said << QCoreApplication::translate(
                        "WorkedSteps",
                        "An impulse along another line strikes %1 too, so y′ changes there as well.")
                        .arg(across.join(QStringLiteral(", ")));
    } else {
        said << QCoreApplication::translate(
            "WorkedSteps", "Of contacts resolved together it is the momentum of them all that must be the "
                           "same, every body counted once; the law of restitution holds at each contact.");
        if (hasWall(pass))
            said << QCoreApplication::translate(
                "WorkedSteps", "A wall is among them: it takes up an impulse, and by just that the momentum "
                               "changes.");
    }
    return said.join(QLatin1Char(' '));
}

QString stageSentence(Stage stage, const Collision& c) {
    const PairCollision<double>& s = c.steps;
    const bool parting = s.impulse < 0;
    switch (stage) {
    case Stage::Contact:
        if (c.isWall())
            return QCoreApplication::translate(
                "WorkedSteps",
                "The wall W counts as a second body of infinite mass at rest; the line of centres stands "
                "square on it.");
        if (s.contact.Z == 0)
            return QCoreApplication::translate(
                "WorkedSteps",
                "The centres coincide, so there is no line of centres; θ = 0 is taken by rule.");
        return QCoreApplication::translate(
            "WorkedSteps",
            "The bodies touch when the distance Z between their centres is no longer greater than the "
            "sum of the radii; the triangle a, b, Z gives the direction θ of the line of centres.");
    case Stage::Split:
        return QCoreApplication::translate(
            "WorkedSteps",
            "Each velocity is an arrow; it is split into a component along x and one along y.");
    case Stage::Rotation:
        return QCoreApplication::translate(
            "WorkedSteps",
            "The axes are turned by θ, so that x′ lies on the line of centres and y′ across it; the "
            "velocities stay as they are, only their components are new.");
    case Stage::Exchange:
        if (c.isWall())
            return QCoreApplication::translate(
                "WorkedSteps",
                "Against an infinite mass the velocity along x′ turns round and keeps the fraction e; "
                "along the frictionless wall, y′, no force acts, so nothing changes there.");
        if (parting)
            return QCoreApplication::translate(
                "WorkedSteps",
                "These two were already moving apart; the paper's loop exchanges every overlapping pair "
                "all the same, and so drives them back together.");
        if (s.restitution == 0)
            return QCoreApplication::translate(
                "WorkedSteps",
                "With e = 0 both leave at the same velocity along x′; without friction the force acts "
                "along the line of centres only, so y′ does not change.");
        return QCoreApplication::translate(
            "WorkedSteps", "Without friction the force acts along the line of centres only: along x′ it is a "
                           "collision in one dimension, and across it, y′, nothing changes.");
    case Stage::RotationBack:
        return QCoreApplication::translate(
            "WorkedSteps",
            "The axes are turned back by θ, and the new components are read along x and y again.");
    case Stage::Check:
        if (c.isWall())
            return QCoreApplication::translate(
                "WorkedSteps",
                "The wall takes up the impulse, so the body's own momentum changes; what must hold is the "
                "ratio e of the speeds along x′.");
        return s.restitution == 1
                   ? QCoreApplication::translate(
                         "WorkedSteps", "The total momentum is the same before and after, and at e = 1 so is "
                                        "the kinetic energy.")
                   : QCoreApplication::translate(
                         "WorkedSteps", "The total momentum is the same before and after; kinetic energy is "
                                        "lost along x′ only.");
    }
    return {};
}

std::vector<WorkedLine> linesOf(const LineWriter& writer, Stage stage, bool together) {
    switch (stage) {
    case Stage::Contact:
        return writer.contact();
    case Stage::Split:
        return writer.split();
    case Stage::Rotation:
        return writer.rotation();
    case Stage::Exchange:
        return together ? writer.exchangeTogether() : writer.exchange();
    case Stage::RotationBack:
        return writer.rotationBack();
    case Stage::Check:
        return together ? writer.checkTogether() : writer.check();
    }
    return {};
}

// The line that says the step in short, for a card that is closed.
std::size_t keyLine(Stage stage, const std::vector<WorkedLine>& lines, const Collision& c, bool together) {
    if (together && stage == Stage::Exchange) // the velocities are the last lines: x′, then y′
        return lines.size() - (c.isWall() ? 2 : 4);
    return stage == Stage::Contact || stage == Stage::Check ? lines.size() - 1 : 0;
}

} // namespace

Ink inkOf(const Collision& collision, int body, const QString& axis) {
    if (axis == QStringLiteral("x′"))
        return Ink::Along;
    if (axis == QStringLiteral("y′"))
        return Ink::Across;
    return body == collision.first ? Ink::First : body == collision.second ? Ink::Second : Ink::Plain;
}

QString stageTitle(Stage stage) {
    switch (stage) {
    case Stage::Contact:
        return QCoreApplication::translate("WorkedSteps", "Contact");
    case Stage::Split:
        return QCoreApplication::translate("WorkedSteps", "Velocity split");
    case Stage::Rotation:
        return QCoreApplication::translate("WorkedSteps", "Rotation by θ");
    case Stage::Exchange:
        return QCoreApplication::translate("WorkedSteps", "Exchange along x′");
    case Stage::RotationBack:
        return QCoreApplication::translate("WorkedSteps", "Rotation back");
    case Stage::Check:
        return QCoreApplication::translate("WorkedSteps", "Check");
    }
    return {};
}

bool isWordName(const Body& body) {
    return body.id == "ball" || body.id == "cue";
}

QString bodyName(const Body& body) {
    if (body.id == "ball")
        return QCoreApplication::translate("BodyName", "ball");
    if (body.id == "cue")
        return QCoreApplication::translate("BodyName", "cue");
    return QString::fromStdString(body.id);
}

QString bodyName(const Scene& scene, int body) {
    return bodyName(scene.bodies[std::size_t(body)]);
}

QString partnerName(const Scene& scene, const Collision& collision) {
    return collision.isWall() ? sideName(collision.side) : bodyName(scene, collision.second);
}

QString indexName(const Scene& scene, int body) {
    constexpr int longest = 6;
    if (body < 0)
        return QStringLiteral("W");
    const QString name = bodyName(scene, body);
    return name.size() <= longest ? name : name.left(longest - 1) + QStringLiteral("…");
}

Formula velocitySymbol(const Scene& scene, const Collision& collision, int body, const QString& axis,
                       When when) {
    const QString name = indexName(scene, body);
    const Ink owner = inkOf(collision, body, {});
    const Ink ink = inkOf(collision, body, axis);
    std::vector<Formula> index{upright(name, owner)};
    if (!axis.isEmpty()) {
        if (name.size() > 1) // v_ball,x but v_Ax
            index.push_back(op(","));
        index.push_back(symbol(axis, ink));
    }
    return script(symbol("v", ink), row(std::move(index)), when == When::After ? symbol("′") : Formula{});
}

QString plainText(const WorkedLine& line, Digits digits) {
    QStringList parts;
    for (const Formula* f : {&line.left, &line.symbolic, &line.substituted, &line.result})
        if (!isEmpty(*f))
            parts << plainText(*f, digits);
    return parts.join(QStringLiteral(" = "));
}

std::vector<WorkedStep> workedSteps(const Scene& scene, std::span<const Collision> collisions,
                                    std::size_t index) {
    const Collision& collision = collisions[index];
    const auto pass = passOf(collisions, index);
    const bool together = pass.size() > 1;
    const LineWriter writer(scene, collision, pass);
    std::vector<WorkedStep> steps;
    for (int i = 0; i < stageCount; ++i) {
        const Stage stage = Stage(i);
        const bool joint = together && (stage == Stage::Exchange || stage == Stage::Check);
        WorkedStep step{stage, stageTitle(stage),
                        joint ? togetherSentence(stage, scene, collision, writer, pass)
                              : stageSentence(stage, collision),
                        linesOf(writer, stage, together), 0};
        step.key = keyLine(stage, step.lines, collision, together);
        steps.push_back(std::move(step));
    }
    return steps;
}

std::vector<WorkedStep> workedSteps(const Scene& scene, const Collision& collision) {
    return workedSteps(scene, std::span(&collision, 1), 0);
}

} // namespace thetalane
