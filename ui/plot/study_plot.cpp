#include "ui/plot/study_plot.h"

#include "ui/words/method_text.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

struct StudyPlotText {
    Q_DECLARE_TR_FUNCTIONS(StudyPlotText)
};

struct Family {
    QString name;
    std::vector<std::size_t> methods; // from the cheapest
};

bool isShown(const StudyResult& result, const MethodResult& r) {
    return r.cases > 0 && r.costRounds > 0 && !(r.method == result.truth);
}

std::vector<Family> familiesOf(const StudyResult& result) {
    std::vector<Family> families;
    for (std::size_t m = 0; m < result.methods.size(); ++m) {
        if (!isShown(result, result.methods[m]))
            continue;
        const QString name = methodFamily(result.methods[m].method);
        auto family =
            std::find_if(families.begin(), families.end(), [&](const Family& f) { return f.name == name; });
        if (family == families.end())
            family = families.insert(families.end(), {name, {}});
        family->methods.push_back(m);
    }
    for (Family& f : families)
        std::sort(f.methods.begin(), f.methods.end(), [&](std::size_t a, std::size_t b) {
            return result.methods[a].cost.median < result.methods[b].cost.median;
        });
    return families;
}

QString labelOf(const Method& method) {
    if (method.settings.kind != EngineKind::Event)
        return stepText(method.settings.step);
    constexpr const char* names[] = {"float", "double", "quad"};
    return names[int(method.settings.precision)];
}

PlotPoint pointOf(const MethodResult& r) {
    PlotPoint p{r.cost.median, r.error().median, labelOf(r.method)};
    p.spreadX = std::pair(r.cost.lower, r.cost.upper);
    p.hover = methodText(r.method) + '\n' +
              StudyPlotText::tr("cost %1 · error %2 m · same touched %3 %")
                  .arg(costText(r.cost.median), numberText(r.error().median, 2),
                       QString::number(100 * r.sameTouched, 'f', 1));
    return p;
}

} // namespace

// Okabe-Ito.
MethodStyle methodStyle(const Method& method) {
    switch (method.settings.kind) {
    case EngineKind::Event:
        return {QColor(0x00, 0x72, 0xB2), Qt::SolidLine, Marker::Circle};
    case EngineKind::Swept:
        return method.settings.passes == 1
                   ? MethodStyle{QColor(0x00, 0x9E, 0x73), Qt::DotLine, Marker::Diamond}
                   : MethodStyle{QColor(0xCC, 0x79, 0xA7), Qt::DashDotDotLine, Marker::Star};
    case EngineKind::Stepped:
        break;
    }
    return method.settings.approachingOnly
               ? MethodStyle{QColor(0xE6, 0x9F, 0x00), Qt::DashDotLine, Marker::Triangle}
               : MethodStyle{QColor(0xD5, 0x5E, 0x00), Qt::DashLine, Marker::Square};
}

Plot workPrecisionPlot(const StudyResult& result, const QString& title, bool throws) {
    Plot plot;
    plot.title = title;
    plot.x = {throws ? StudyPlotText::tr("cost of a throw [µs]") : StudyPlotText::tr("cost of a run [µs]"),
              true,
              {},
              {}};
    plot.y = {StudyPlotText::tr("position error at the end, median [m]"), true, {}, {}};
    for (const Family& f : familiesOf(result)) {
        const MethodStyle style = methodStyle(result.methods[f.methods.front()].method);
        PlotSeries series{f.name, style.colour, style.line, style.marker, {}};
        for (const std::size_t m : f.methods)
            series.points.push_back(pointOf(result.methods[m]));
        plot.series.push_back(std::move(series));
    }
    return plot;
}

std::size_t methodOfPoint(const StudyResult& result, std::size_t series, std::size_t point) {
    return familiesOf(result).at(series).methods.at(point);
}

} // namespace thetalane
