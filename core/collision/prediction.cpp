#include "core/collision/prediction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace thetalane {
namespace {

using Truth = PairCollision<double>;
using Pair = VelocityPair<double>;

bool isWall(const Truth& t) {
    return std::isinf(t.second.mass);
}

double energyScale(const Truth& t) {
    return energyOf(t, t.before);
}

double momentumScale(const Truth& t) {
    return t.first.mass * norm(t.before.first) + (isWall(t) ? 0 : t.second.mass * norm(t.before.second));
}

// One expectation against the truth, told about both bodies alike.
class Judge {
public:
    Judge(const Truth& truth, const Prediction& prediction)
        : t(truth)
        , p(prediction)
        , wall(isWall(truth))
        , bodies(wall ? 1 : 2)
        , speed(speedScale(truth))
        , turned(rotateIn(prediction.after, truth.contact)) {}

    Verdict verdict() {
        Verdict v;
        v.score = score();
        v.right = std::all_of(m_shares.begin(), m_shares.end(), [](double s) { return s <= exactShare; });
        if (!velocitiesRight())
            explainVelocities();
        explainNumbers();
        v.wrong = std::move(m_wrong);
        return v;
    }

private:
    Vec2d before(int b) const { return b == 0 ? t.before.first : t.before.second; }
    Vec2d after(int b) const { return b == 0 ? t.after.first : t.after.second; }
    Vec2d guess(int b) const { return b == 0 ? p.after.first : p.after.second; }
    double across(const Pair& pair, int b) const { return b == 0 ? pair.first.y : pair.second.y; }

    bool near(const Vec2d& a, const Vec2d& b) const { return norm(a - b) <= exactShare * speed; }
    bool velocitiesRight() const { return near(guess(0), after(0)) && (wall || near(guess(1), after(1))); }
    bool isUnchanged(int b) const { return near(guess(b), before(b)) && !near(after(b), before(b)); }
    bool isAll(const Pair& pair) const { return near(guess(0), pair.first) && near(guess(1), pair.second); }
    void say(Misconception what, int body = 0, double value = 0, double wanted = 0) {
        m_wrong.push_back({what, body, value, wanted});
    }

    int score() {
        for (int b = 0; b < bodies; ++b)
            m_shares.push_back(shareOf(norm(guess(b) - after(b)), speed));
        if (p.momentum && !wall)
            m_shares.push_back(shareOf(norm(*p.momentum - momentumOf(t, t.after)), momentumScale(t)));
        if (p.energyLost)
            m_shares.push_back(shareOf(std::abs(*p.energyLost - t.energyLoss), energyScale(t)));
        double sum = 0;
        for (const double share : m_shares)
            sum += std::clamp((worthlessShare - share) / (worthlessShare - exactShare), 0.0, 1.0);
        return int(std::lround(100 * sum / double(m_shares.size())));
    }
    // Of nothing, only nothing is right.
    static double shareOf(double error, double scale) {
        return scale > 0 ? error / scale : error > 0 ? 1 : 0;
    }

    // A pattern that says it all, or else the laws that are broken.
    void explainVelocities() {
        if (pattern())
            return;
        bool passes = false;
        if (const auto e = restitutionOf(t, p.after); e && *e < -exactShare) {
            say(Misconception::WentThrough);
            passes = true;
        }
        if (!wall)
            explainMomentum();
        explainEnergy(passes);
        explainAcross();
        for (int b = 0; b < bodies && !passes; ++b)
            if (norm(after(b)) > exactShare * speed && near(guess(b), -after(b)))
                say(Misconception::WrongWay, b);
    }

    bool pattern() {
        if (isUnchanged(0) && (wall || isUnchanged(1))) {
            say(Misconception::NothingChanged);
            return true;
        }
        if (wall)
            return false;
        if (isAll({t.after.second, t.after.first})) {
            say(Misconception::BodiesSwapped);
            return true;
        }
        // Head-on, that is a matter of e.
        if (isAll({t.before.second, t.before.first}) && (isAcrossOff(0) || isAcrossOff(1))) {
            say(Misconception::ExchangedWhole);
            return true;
        }
        if (t.first.mass != t.second.mass && isAll(withEqualMasses())) {
            say(Misconception::MassesIgnored);
            return true;
        }
        for (int b = 0; b < bodies; ++b)
            if (isUnchanged(b) && !isUnchanged(1 - b))
                say(Misconception::OnlyOneChanged, b);
        return false;
    }

    Pair withEqualMasses() const {
        return rotateBack(exchangeAlong(t.rotated, 1.0, 1.0, t.restitution), t.contact);
    }

    void explainMomentum() {
        const double scale = momentumScale(t);
        const double off = norm(momentumOf(t, p.after) - momentumOf(t, t.before));
        if (off > exactShare * scale)
            say(Misconception::MomentumNotKept, 0, norm(momentumOf(t, p.after)),
                norm(momentumOf(t, t.before)));
    }

    void explainEnergy(bool passes) {
        const auto e = restitutionOf(t, p.after);
        const double gained = energyOf(t, p.after) - energyOf(t, t.before);
        const bool above = e && *e > 1 + exactShare;
        if (gained > exactShare * energyScale(t))
            say(Misconception::EnergyGained, 0, energyOf(t, p.after), energyOf(t, t.before));
        if (e && !passes && std::abs(*e - t.restitution) > exactShare &&
            (above || gained <= exactShare * energyScale(t)))
            say(Misconception::RestitutionDiffers, 0, *e, t.restitution);
    }

    bool isAcrossOff(int b) const {
        return std::abs(across(turned, b) - across(t.rotated, b)) > exactShare * speed;
    }
    void explainAcross() {
        for (int b = 0; b < bodies; ++b)
            if (isAcrossOff(b))
                say(Misconception::TangentialChanged, b, across(turned, b), across(t.rotated, b));
    }

    void explainNumbers() {
        if (p.momentum && !wall && norm(*p.momentum - momentumOf(t, t.after)) > exactShare * momentumScale(t))
            say(Misconception::MomentumNumberWrong, 0, norm(*p.momentum), norm(momentumOf(t, t.after)));
        if (!p.energyLost)
            return;
        if (*p.energyLost < 0)
            say(Misconception::EnergyNumberNegative, 0, *p.energyLost, t.energyLoss);
        else if (std::abs(*p.energyLost - t.energyLoss) > exactShare * energyScale(t))
            say(Misconception::EnergyNumberWrong, 0, *p.energyLost, t.energyLoss);
    }

    const Truth& t;
    const Prediction& p;
    const bool wall;
    const int bodies;
    const double speed;
    const Pair turned;            // the prediction, along x′ and across
    std::vector<double> m_shares; // how far off each is, of its scale
    std::vector<Diagnosis> m_wrong;
};

} // namespace

Vec2d momentumOf(const Truth& t, const Pair& v) {
    return isWall(t) ? t.first.mass * v.first : t.first.mass * v.first + t.second.mass * v.second;
}

double energyOf(const Truth& t, const Pair& v) {
    const double second = isWall(t) ? 0 : t.second.mass * dot(v.second, v.second);
    return (t.first.mass * dot(v.first, v.first) + second) / 2;
}

std::optional<double> restitutionOf(const Truth& t, const Pair& after) {
    const double approach = t.rotated.second.x - t.rotated.first.x;
    if (!(approach > 0))
        return std::nullopt;
    const Pair turned = rotateIn(after, t.contact);
    return (turned.first.x - (isWall(t) ? 0 : turned.second.x)) / approach;
}

double speedScale(const Truth& t) {
    return std::max({norm(t.before.first), norm(t.before.second), norm(t.after.first), norm(t.after.second)});
}

Verdict judge(const Truth& truth, const Prediction& prediction) {
    return Judge(truth, prediction).verdict();
}

} // namespace thetalane
