#include "ui/tables/course_page.h"

#include "ui/count_text.h"
#include "ui/tables/time_view.h"

#include <QLabel>
#include <QVBoxLayout>

namespace thetalane {

CoursePage::CoursePage(const Context& context, QWidget* parent)
    : TablePage(context, "coursePage", parent)
    , m_energy(new TimeView(context.appearance, "energyPlot", this))
    , m_momentum(new TimeView(context.appearance, "momentumPlot", this))
    , m_note(new QLabel(this)) {
    m_note->setObjectName(QStringLiteral("courseNote"));
    m_note->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_energy, 1);
    column->addWidget(m_momentum, 1);
    column->addWidget(m_note);
    for (TimeView* view : {m_energy, m_momentum})
        connect(view, &TimeView::timeChosen, this, [this](double time) {
            playhead().setPlaying(false);
            playhead().setTime(time);
        });
    restyle();
    retranslate();
}

void CoursePage::retranslate() {
    const QString tip = tr("Press or drag to move the time");
    m_energy->setToolTip(tip);
    m_momentum->setToolTip(tip);
    m_energy->setAccessibleName(tr("Kinetic energy of all bodies over time"));
    m_momentum->setAccessibleName(tr("Momentum of all bodies over time"));
    showPlots();
}

void CoursePage::restyle() {
    TablePage::restyle();
    makeQuiet(*m_note, appearance());
    showPlots();
}

void CoursePage::showRun() {
    const auto times = shownTimes();
    if (m_of == session().run() && m_times == times)
        return;
    m_of = session().run();
    m_times = times;
    m_history = history(m_of->scene, m_of->timeline, times.first, times.second, mostMoments);
    showPlots();
}

void CoursePage::showTime() {
    for (TimeView* view : {m_energy, m_momentum})
        view->setCursor(playhead().time(), !m_history.moments.empty());
}

void CoursePage::showPlots() {
    Plot energy, momentum;
    energy.title = tr("Kinetic energy of all bodies");
    energy.x = {tr("Time [s]"), false, m_times.first, m_times.second};
    energy.y = {QStringLiteral("Ek [J]"), false, 0.0, {}};
    momentum.title = tr("Momentum of all bodies");
    momentum.x = energy.x;
    momentum.y = {QStringLiteral("p [kg·m/s]"), false, {}, {}};
    PlotSeries total{{}, appearance().text(), Qt::SolidLine, Marker::None, {}};
    // The inks are the two bodies'; a sum has none.
    PlotSeries px{QStringLiteral("px"), appearance().text(), Qt::SolidLine, Marker::None, {}};
    PlotSeries py{QStringLiteral("py"), appearance().quietText(), Qt::DashLine, Marker::None, {}};
    double most = 0;
    for (const SummedMoment& m : m_history.moments) {
        total.points.push_back({m.time, m.totals.energy, {}});
        px.points.push_back({m.time, m.totals.momentum.x, {}});
        py.points.push_back({m.time, m.totals.momentum.y, {}});
        most = std::max({most, std::abs(m.totals.momentum.x), std::abs(m.totals.momentum.y)});
    }
    // From zero: a sum that only rounding changes is then a level line, not a zigzag.
    if (most > 0)
        for (PlotSeries* s : {&px, &py})
            for (PlotPoint& p : s->points)
                if (std::abs(p.y) < 1e-12 * most)
                    p.y = 0;
    momentum.lines.push_back({0, true, {}});
    energy.series = {std::move(total)};
    momentum.series = {std::move(px), std::move(py)};
    m_energy->setPlot(std::move(energy));
    m_momentum->setPlot(std::move(momentum));
    QStringList said;
    if (!partText().isEmpty())
        said << partText();
    if (!m_history.everyEvent)
        said << tr("%1 moments, evenly spaced, stand for more events than that.")
                    .arg(countText(std::int64_t(m_history.moments.size())));
    m_note->setText(said.join(QStringLiteral(" · ")));
    m_note->setVisible(!said.isEmpty());
}

Sheet CoursePage::sheet() const {
    Sheet sheet{{{tr("Time"), QStringLiteral("s")},
                 {QStringLiteral("Ek"), QStringLiteral("J")},
                 {QStringLiteral("px"), QStringLiteral("kg·m/s")},
                 {QStringLiteral("py"), QStringLiteral("kg·m/s")}},
                {}};
    for (const SummedMoment& m : m_history.moments)
        sheet.rows.push_back({numberCell(m.time, {}), numberCell(m.totals.energy, {}),
                              numberCell(m.totals.momentum.x, {}), numberCell(m.totals.momentum.y, {})});
    return sheet;
}

} // namespace thetalane
