#include "ui/tables/impulse_page.h"

#include "ui/count_text.h"
#include "ui/tables/time_view.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace thetalane {

ImpulsePage::ImpulsePage(const Context& context, QWidget* parent)
    : TablePage(context, "impulsePage", parent)
    , m_view(new TimeView(context.appearance, "impulsePlot", this))
    , m_note(new QLabel(this))
    , m_key(new QLabel(this)) {
    m_note->setObjectName(QStringLiteral("impulseNote"));
    m_key->setObjectName(QStringLiteral("impulseKey"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view, 1);
    for (QLabel* label : {m_key, m_note}) {
        label->setWordWrap(true);
        column->addWidget(label);
    }
    connect(m_view, &TimeView::barPicked, this,
            [this](std::size_t bar) { playhead().select(m_shown.at(bar)); });
    connect(m_view, &TimeView::timeChosen, this, [this](double time) {
        playhead().setPlaying(false);
        playhead().setTime(time);
    });
    restyle();
    retranslate();
}

void ImpulsePage::retranslate() {
    m_view->setAccessibleName(tr("Impulse of each collision over time"));
    m_view->setToolTip(tr("Click a bar to open that collision; press or drag elsewhere to move the time"));
    m_key->setText(tr("Round: two bodies. Square: a body and a wall. Coloured: the open collision."));
    refresh();
}

void ImpulsePage::restyle() {
    TablePage::restyle();
    makeQuiet(*m_note, appearance());
    makeQuiet(*m_key, appearance());
    refresh();
}

// In the order of time. The open one is always among them.
std::vector<std::size_t> ImpulsePage::toShow() const {
    const auto all = session().timeline().collisions();
    const auto [from, to] = shownTimes();
    std::vector<std::size_t> chosen;
    if (all.size() <= mostBars) {
        for (std::size_t k = 0; k < all.size(); ++k)
            chosen.push_back(k);
        return chosen;
    }
    long last = -1;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const long slot = to > from ? long((all[k].time - from) / (to - from) * double(mostBars - 1)) : 0;
        if (slot != last)
            chosen.push_back(k);
        else if (std::abs(all[k].steps.impulse) > std::abs(all[chosen.back()].steps.impulse))
            chosen.back() = k;
        last = slot;
    }
    if (const auto open = selected(); open && !std::binary_search(chosen.begin(), chosen.end(), *open))
        chosen.insert(std::upper_bound(chosen.begin(), chosen.end(), *open), *open);
    return chosen;
}

void ImpulsePage::showRun() {
    const Scene& scene = session().scene();
    const auto all = session().timeline().collisions();
    const auto [from, to] = shownTimes();
    m_shown = toShow();
    const auto open = selected();
    std::vector<TimeBar> bars;
    double most = 0, least = 0;
    for (const std::size_t k : m_shown) {
        const Collision& c = all[k];
        const std::int64_t number = session().part().collisionsBefore + std::int64_t(k) + 1;
        const QString what = tr("Collision %1: %2, %3 N·s, at %4 s")
                                 .arg(countText(number), contactName(scene, c), numberText(c.steps.impulse),
                                      numberText(c.time, 5));
        const bool isOpen = open == k;
        bars.push_back({c.time, c.steps.impulse,
                        isOpen ? appearance().ink(Ink::Second) : appearance().quietText(), c.isWall(), isOpen,
                        what});
        most = std::max(most, c.steps.impulse);
        least = std::min(least, c.steps.impulse);
    }
    Plot plot;
    plot.title = tr("Impulse of each collision");
    plot.x = {tr("Time [s]"), false, from, to};
    plot.y = {tr("Impulse [N·s]"), false, least < 0 ? 1.08 * least : 0, most > 0 ? 1.08 * most : 1};
    m_view->setPlot(std::move(plot), std::move(bars));
    QStringList said;
    if (!partText().isEmpty())
        said << partText();
    if (m_shown.size() < all.size())
        said << tr("%1 of %2 are drawn: of those close together the greatest.")
                    .arg(countText(std::int64_t(m_shown.size())), countText(std::int64_t(all.size())));
    if (all.empty())
        said << tr("Nothing collides in this scene.");
    m_note->setText(said.join(QStringLiteral(" · ")));
    m_note->setVisible(!said.isEmpty());
    m_key->setVisible(!all.empty());
}

void ImpulsePage::showTime() {
    m_view->setCursor(playhead().time(), true);
}

Sheet ImpulsePage::sheet() const {
    Sheet sheet{{{QStringLiteral("#"), {}},
                 {tr("Time"), QStringLiteral("s")},
                 {tr("First"), {}},
                 {tr("Second"), {}},
                 {tr("Impulse"), QStringLiteral("N·s")},
                 {tr("Energy lost"), QStringLiteral("J")}},
                {}};
    const Scene& scene = session().scene();
    std::int64_t number = session().part().collisionsBefore;
    for (const Collision& c : session().timeline().collisions())
        sheet.rows.push_back({textCell(QString::number(++number)), numberCell(c.time, {}),
                              textCell(bodyName(scene, c.first)), textCell(partnerName(scene, c)),
                              numberCell(c.steps.impulse, {}), numberCell(c.steps.energyLoss, {})});
    return sheet;
}

} // namespace thetalane
