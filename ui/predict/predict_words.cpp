#include "ui/predict/predict_words.h"

#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QCoreApplication>

namespace thetalane {
namespace {

struct PredictWords {
    Q_DECLARE_TR_FUNCTIONS(PredictWords)
};

QString three(double value) {
    return numberText(std::abs(value) < 1e-9 ? 0 : value, 3);
}

QString lawText(const Diagnosis& d) {
    switch (d.what) {
    case Misconception::MomentumNotKept:
        if (three(d.wanted) == three(d.value))
            return PredictWords::tr("Momentum is not kept: yours points in another direction than before.");
        return PredictWords::tr("Momentum is not kept: %1 kg·m/s before, but %2 kg·m/s in your prediction.")
            .arg(three(d.wanted), three(d.value));
    case Misconception::EnergyGained:
        return PredictWords::tr("Kinetic energy came from nothing: %1 J before, %2 J in your prediction, as "
                                "if e were above 1.")
            .arg(three(d.wanted), three(d.value));
    case Misconception::RestitutionDiffers:
        return PredictWords::tr("They part with e = %1; here e = %2.").arg(three(d.value), three(d.wanted));
    case Misconception::MomentumNumberWrong:
        return PredictWords::tr("The total momentum is what it was before: %1 kg·m/s in all.")
            .arg(three(d.wanted));
    case Misconception::EnergyNumberWrong:
        return PredictWords::tr("The energy lost is %1 J, not %2 J.").arg(three(d.wanted), three(d.value));
    case Misconception::EnergyNumberNegative:
        return PredictWords::tr("A collision never gains kinetic energy: what is lost is 0 J or more.");
    default:
        return {};
    }
}

} // namespace

QString diagnosisText(const Scene& scene, const Collision& collision, const Diagnosis& d) {
    const bool isSecond = d.body == 1 && !collision.isWall();
    const QString body = bodyName(scene, isSecond ? collision.second : collision.first);
    switch (d.what) {
    case Misconception::NothingChanged:
        return PredictWords::tr("You let them go on as if they had not met.");
    case Misconception::OnlyOneChanged:
        return PredictWords::tr("You left %1 as it was; but action and reaction change both.").arg(body);
    case Misconception::WentThrough:
        return PredictWords::tr("They would go through each other: along x′ they still approach.");
    case Misconception::BodiesSwapped:
        return PredictWords::tr("Right arrows, but swapped: each body has the one of the other.");
    case Misconception::ExchangedWhole:
        return PredictWords::tr(
            "You exchanged the whole velocities; only their x′ components are exchanged.");
    case Misconception::MassesIgnored:
        return PredictWords::tr("Right for equal masses; but these masses differ.");
    case Misconception::TangentialChanged:
        return PredictWords::tr("You changed the y′ component of %1, but no force acts along y′.").arg(body);
    case Misconception::WrongWay:
        return PredictWords::tr("%1 goes just the other way.").arg(body);
    default:
        return lawText(d);
    }
}

QString scoreRule() {
    return PredictWords::tr("Every arrow and every number counts alike: all of its points within %1 %, none "
                            "beyond %2 %, evenly in between.")
        .arg(100 * exactShare)
        .arg(100 * worthlessShare);
}

QString praise(const Verdict& verdict) {
    if (verdict.right)
        return PredictWords::tr("All right!");
    return verdict.score >= 80   ? PredictWords::tr("Nearly right.")
           : verdict.score >= 40 ? PredictWords::tr("Partly right.")
                                 : PredictWords::tr("It comes out differently.");
}

} // namespace thetalane
