#include "ui/tables/centre_page.h"

#include "core/timeline/history.h"
#include "ui/tables/centre_figure.h"
#include "ui/tables/sheet_table.h"

#include <QLabel>
#include <QVBoxLayout>

namespace thetalane {

CentrePage::CentrePage(const Context& context, QWidget* parent)
    : TablePage(context, "centrePage", parent)
    , m_figure(new CentreFigure(context.appearance, this))
    , m_numbers(new SheetTable(context.appearance, "centreNumbers", this))
    , m_note(new QLabel(this)) {
    m_note->setObjectName(QStringLiteral("centreNote"));
    m_note->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_figure, 1);
    column->addWidget(m_numbers);
    column->addWidget(m_note);
    restyle();
    retranslate();
}

void CentrePage::retranslate() {
    m_numbers->setAccessibleName(tr("Centre of mass"));
    m_numbers->setToolTip(tr("Follows the time; Ctrl+C copies it with every digit"));
    m_figure->retranslate();
    m_of.reset(); // what is said about the part, too
    refresh();
}

void CentrePage::restyle() {
    TablePage::restyle();
    makeQuiet(*m_note, appearance());
}

void CentrePage::showRun() {
    const auto times = shownTimes();
    if (m_of == session().run() && m_times == times)
        return;
    m_of = session().run();
    m_times = times;
    m_figure->setRun(m_of, history(m_of->scene, m_of->timeline, times.first, times.second, mostMoments));
    m_note->setText(partText());
    m_note->setVisible(!partText().isEmpty());
}

void CentrePage::showTime() {
    m_figure->setTime(playhead().time());
    m_numbers->setSheet(sheet());
}

Sheet CentrePage::sheet() const {
    const QString metre = QStringLiteral("m"), speed = QStringLiteral("m/s");
    Sheet sheet{{{QStringLiteral("x"), metre},
                 {QStringLiteral("y"), metre},
                 {QStringLiteral("vx"), speed},
                 {QStringLiteral("vy"), speed},
                 {QStringLiteral("v"), speed}},
                {}};
    const Scene& scene = session().scene();
    const auto states = session().timeline().stateAt(playhead().time());
    const CentreOfMass centre = centreOfMass(scene, states);
    double scale = 0; // against it a velocity is rounding or is not
    for (std::size_t b = 0; b < states.size(); ++b)
        scale += scene.bodies[b].mass * norm(states[b].velocity) / centre.mass;
    sheet.rows.push_back({numberCell(centre.position.x, metre), numberCell(centre.position.y, metre),
                          numberCellOf(centre.velocity.x, scale, speed),
                          numberCellOf(centre.velocity.y, scale, speed),
                          numberCellOf(norm(centre.velocity), scale, speed)});
    return sheet;
}

} // namespace thetalane
