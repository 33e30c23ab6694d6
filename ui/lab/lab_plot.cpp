#include "ui/lab/lab_plot.h"

#include "ui/lab/lab_words.h"
#include "ui/words/method_text.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace thetalane {
namespace {

struct LabPlotText {
    Q_DECLARE_TR_FUNCTIONS(LabPlotText)
};

// Okabe-Ito with a line of its own each.
const std::array palette{
    MethodStyle{QColor(0x00, 0x72, 0xB2), Qt::SolidLine, Marker::Circle},
    MethodStyle{QColor(0xD5, 0x5E, 0x00), Qt::DashLine, Marker::Square},
    MethodStyle{QColor(0x00, 0x9E, 0x73), Qt::DotLine, Marker::Diamond},
    MethodStyle{QColor(0xE6, 0x9F, 0x00), Qt::DashDotLine, Marker::Triangle},
    MethodStyle{QColor(0xCC, 0x79, 0xA7), Qt::DashDotDotLine, Marker::Star},
    MethodStyle{QColor(0x56, 0xB4, 0xE9), Qt::DashLine, Marker::Cross},
};

bool isGhost(const LabPlan& plan, std::size_t row) {
    return std::find(plan.ghosts.begin(), plan.ghosts.end(), row) != plan.ghosts.end();
}

class Builder {
public:
    explicit Builder(const LabResult& result)
        : m_result(result)
        , m_study(result.study) {}

    LabPlot throughPlot() {
        const LabDials& d = m_result.plan->dials;
        m_out.plot.x.title = LabPlotText::tr("way of a step v·h [m]");
        m_out.plot.y = {LabPlotText::tr("went through [%]"), false, -4.0, 100.0};
        PlotSeries expected{LabPlotText::tr("1 − 2(r₁ + r₂)/(v·h)"),
                            QColor(0x77, 0x77, 0x77),
                            Qt::SolidLine,
                            Marker::None,
                            {}};
        const double limit = wayThrough(), last = std::max(6 * limit, d.wayOfAStep());
        for (double x = 0.5 * limit; x <= last * 1.0001; x += last / 120)
            expected.points.push_back({x, 100 * std::max(0.0, 1 - limit / x), {}, expected.name, {}});
        add(std::move(expected), {});
        for (const EngineKind kind : {EngineKind::Stepped, EngineKind::Swept})
            addRows(kind, false, [&](const MethodResult& r) {
                const double way = d.speed * r.method.settings.step;
                return PlotPoint{way, 100 * (1 - r.sameTouched), label(r, d), hover(r), {}};
            });
        m_out.plot.lines.push_back({limit, false, QStringLiteral("2(r₁ + r₂)")});
        return std::move(m_out);
    }

    LabPlot twicePlot() {
        m_out.plot.x = {LabPlotText::tr("step [s]"), true, {}, {}};
        m_out.plot.y = {LabPlotText::tr("hit more than once [%]"), false, -4.0, 100.0};
        for (const bool approachingOnly : {false, true})
            addRows(EngineKind::Stepped, approachingOnly, [&](const MethodResult& r) {
                return PlotPoint{r.method.settings.step,
                                 100 * (1 - r.sameOrder),
                                 stepText(r.method.settings.step),
                                 hover(r),
                                 {}};
            });
        return std::move(m_out);
    }

    LabPlot ablationPlot() {
        m_out.plot.x = {LabPlotText::tr("cost of a throw [µs]"), false, {}, {}};
        m_out.plot.y = {LabPlotText::tr("other pins down [%]"), false, -4.0, 104.0};
        for (std::size_t row = 0; row < m_study.methods.size(); ++row) {
            const MethodResult& r = m_study.methods[row];
            if (r.cases == 0 || r.costRounds == 0)
                continue;
            const MethodStyle style = rowStyle(*m_result.plan, row);
            PlotPoint p{r.cost.median,
                        100 * (1 - r.sameDown),
                        {},
                        hover(r, row),
                        std::pair(r.cost.lower, r.cost.upper)};
            add({rowName(*m_result.plan, row), style.colour, Qt::NoPen, style.marker, {p}}, {row});
        }
        return std::move(m_out);
    }

    LabPlot overTimePlot() {
        m_out.plot.x = {LabPlotText::tr("time [s]"), false, 0.0, m_study.until};
        m_out.plot.y = {LabPlotText::tr("position error, median [m]"), true, {}, {}};
        constexpr std::size_t most = 6; // lines: of more rows those that are drawn over the lane
        const bool crowded = m_study.methods.size() > most;
        for (std::size_t row = 0; row < m_study.methods.size(); ++row) {
            const MethodResult& r = m_study.methods[row];
            const bool isTruth = m_result.plan->shifts.empty() && r.method == m_study.truth;
            if (r.cases == 0 || isTruth || (crowded && !isGhost(*m_result.plan, row)))
                continue;
            const MethodStyle style = rowStyle(*m_result.plan, row);
            PlotSeries series{rowName(*m_result.plan, row), style.colour, style.line, style.marker, {}};
            for (std::size_t k = 0; k < studyTimes; ++k) {
                const double t = m_study.until * double(k + 1) / double(studyTimes);
                const QString said =
                    LabPlotText::tr("%1\nafter %2 s: off by %3 m")
                        .arg(series.name, numberText(t, 3), numberText(r.errors[k].median, 2));
                series.points.push_back({t, r.errors[k].median, {}, said, {}});
            }
            add(std::move(series), std::vector<std::optional<std::size_t>>(studyTimes, row));
        }
        return std::move(m_out);
    }

    LabPlot workPrecision() {
        const bool throws = m_study.casesAsked > 1;
        m_out.plot = workPrecisionPlot(m_study, QString(), throws);
        for (std::size_t s = 0; s < m_out.plot.series.size(); ++s) {
            m_out.rows.emplace_back();
            for (std::size_t p = 0; p < m_out.plot.series[s].points.size(); ++p)
                m_out.rows.back().push_back(methodOfPoint(m_study, s, p));
        }
        return std::move(m_out);
    }

private:
    void add(PlotSeries series, std::vector<std::optional<std::size_t>> rows) {
        rows.resize(series.points.size());
        m_out.plot.series.push_back(std::move(series));
        m_out.rows.push_back(std::move(rows));
    }

    template <class Point> void addRows(EngineKind kind, bool approachingOnly, Point&& point) {
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < m_study.methods.size(); ++row) {
            const MethodResult& r = m_study.methods[row];
            if (r.cases > 0 && r.method.settings.kind == kind &&
                r.method.settings.approachingOnly == approachingOnly)
                rows.push_back(row);
        }
        if (rows.empty())
            return;
        const Method& method = m_study.methods[rows.front()].method;
        const MethodStyle style = methodStyle(method);
        PlotSeries series{methodFamily(method), style.colour, style.line, style.marker, {}};
        std::vector<std::optional<std::size_t>> behind;
        for (const std::size_t row : rows) {
            series.points.push_back(point(m_study.methods[row]));
            behind.push_back(row);
        }
        add(std::move(series), std::move(behind));
    }

    // The point of the dials says so; the others would crowd it.
    static QString label(const MethodResult& r, const LabDials& d) {
        return r.method.settings.step == d.step() ? stepText(d.step()) : QString();
    }

    QString hover(const MethodResult& r) const { return hover(r, std::size_t(&r - m_study.methods.data())); }
    QString hover(const MethodResult& r, std::size_t row) const {
        QString text = rowName(*m_result.plan, row) + '\n' +
                       LabPlotText::tr("same pins touched %1 · same contacts %2")
                           .arg(percentText(r.sameTouched), percentText(r.sameOrder));
        if (r.costRounds > 0)
            text += QStringLiteral(" · ") + costText(r.cost.median);
        return text;
    }

    const LabResult& m_result;
    const StudyResult& m_study;
    LabPlot m_out;
};

// How many ghosts before it would look the same. The rows that are not drawn may look like their family.
std::size_t alikeBefore(const LabPlan& plan, std::size_t row) {
    if (!isGhost(plan, row))
        return 0;
    const auto& all = plan.options.methods;
    const MethodStyle style = methodStyle(all[row]);
    return std::size_t(std::count_if(plan.ghosts.begin(), plan.ghosts.end(), [&](std::size_t other) {
        const MethodStyle s = methodStyle(all[other]);
        return other < row && s.colour == style.colour && s.line == style.line;
    }));
}

} // namespace

MethodStyle rowStyle(const LabPlan& plan, std::size_t row) {
    if (!plan.shifts.empty() || plan.preset == Preset::Friction)
        return palette[row % palette.size()];
    MethodStyle style = methodStyle(plan.options.methods[row]);
    const std::size_t before = alikeBefore(plan, row);
    if (before == 0)
        return style;
    constexpr std::array lines{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    style.colour = before % 2 == 1 ? style.colour.darker(150) : style.colour.lighter(135);
    const auto own = std::find(lines.begin(), lines.end(), style.line) - lines.begin();
    style.line = lines[(std::size_t(own) + before) % lines.size()];
    return style;
}

std::vector<Diagram> diagramsOf(const LabPlan& plan) {
    if (!plan.preset || plan.preset == Preset::SmallerStep)
        return {Diagram::WorkPrecision, Diagram::OverTime};
    switch (*plan.preset) {
    case Preset::Float:
        return {Diagram::OverTime, Diagram::WorkPrecision};
    case Preset::Butterfly:
        return {Diagram::OverTime};
    case Preset::Friction:
        return {Diagram::Point, Diagram::OverTime};
    default:
        return {Diagram::Point, Diagram::WorkPrecision, Diagram::OverTime};
    }
}

QString diagramName(const LabPlan& plan, Diagram diagram) {
    switch (diagram) {
    case Diagram::WorkPrecision:
        return LabPlotText::tr("Error against cost");
    case Diagram::OverTime:
        return LabPlotText::tr("Error over time");
    case Diagram::Point:
        break;
    }
    if (plan.preset == Preset::Through)
        return LabPlotText::tr("Went through, by the way of a step");
    return plan.preset == Preset::Twice ? LabPlotText::tr("Hit more than once, by step")
                                        : LabPlotText::tr("Pins changed against cost");
}

LabPlot labPlot(const LabResult& result, Diagram diagram) {
    Builder build(result);
    switch (diagram) {
    case Diagram::WorkPrecision:
        return build.workPrecision();
    case Diagram::OverTime:
        return build.overTimePlot();
    case Diagram::Point:
        break;
    }
    if (result.plan->preset == Preset::Through)
        return build.throughPlot();
    return result.plan->preset == Preset::Twice ? build.twicePlot() : build.ablationPlot();
}

} // namespace thetalane
