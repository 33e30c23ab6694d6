#include "ui/words/method_text.h"

#include "ui/words/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace thetalane {
namespace {

struct MethodText {
    Q_DECLARE_TR_FUNCTIONS(MethodText)
};

QString withoutText(const std::vector<Model>& models) {
    QStringList names;
    for (const Model model : models)
        names << modelText(model);
    return MethodText::tr("without %1").arg(names.join(", "));
}

} // namespace

QString precisionText(Precision precision) {
    switch (precision) {
    case Precision::Float:
        return MethodText::tr("float (24 bits)");
    case Precision::Double:
        return MethodText::tr("double (53 bits)");
    case Precision::Quad:
        break;
    }
    return MethodText::tr("quad (113 bits)");
}

QString modelText(Model model) {
    switch (model) {
    case Model::Friction:
        return MethodText::tr("friction");
    case Model::Spin:
        return MethodText::tr("spin");
    case Model::Oil:
        return MethodText::tr("oil");
    case Model::Restitution:
        return MethodText::tr("loss between bodies (e = 1)");
    case Model::WallRestitution:
        return MethodText::tr("loss at the walls (e = 1)");
    case Model::Ties:
        break;
    }
    return MethodText::tr("the rule of ties");
}

QString stepText(double step) {
    const double parts = 1 / step;
    const bool whole = std::isfinite(parts) && std::abs(parts - std::round(parts)) < 1e-9 * parts;
    return whole ? QStringLiteral("1/%1 s").arg(std::llround(parts)) : numberText(step) + " s";
}

QString costText(double microseconds) {
    if (microseconds >= 1e6)
        return numberText(microseconds * 1e-6, 3) + " s";
    if (microseconds >= 1e3)
        return numberText(microseconds * 1e-3, 3) + " ms";
    return numberText(microseconds, 3) + QStringLiteral(" µs");
}

QString methodFamily(const Method& method) {
    switch (method.settings.kind) {
    case EngineKind::Event:
        return MethodText::tr("next event");
    case EngineKind::Swept:
        return method.settings.passes == 1 ? MethodText::tr("swept, one pass")
                                           : MethodText::tr("swept, %1 passes").arg(method.settings.passes);
    case EngineKind::Stepped:
        break;
    }
    return method.settings.approachingOnly ? MethodText::tr("paper's loop, approaching only")
                                           : MethodText::tr("paper's loop");
}

QString methodText(const Method& method) {
    const bool steps = method.settings.kind != EngineKind::Event;
    QStringList parts{methodFamily(method)};
    if (steps)
        parts << stepText(method.settings.step);
    if (!steps || method.settings.precision != Precision::Double)
        parts << precisionText(method.settings.precision);
    if (!method.without.empty())
        parts << withoutText(method.without);
    return parts.join(", ");
}

} // namespace thetalane
