#include "ui/tables/table_page.h"

#include "ui/count_text.h"

#include <algorithm>

namespace thetalane {

TablePage::TablePage(const Context& context, const char* name, QWidget* parent)
    : Panel(context, parent) {
    setObjectName(QLatin1String(name));
    connect(&session(), &Session::runChanged, this, &TablePage::refresh);
    connect(&session(), &Session::chapterChanged, this, &TablePage::refresh);
    connect(&session(), &Session::progressed, this, [this] {
        if (!session().part().isWhole()) // how much there is of it is said
            refresh();
    });
    connect(&playhead(), &Playhead::selectionChanged, this, &TablePage::refresh);
    connect(&playhead(), &Playhead::timeChanged, this, [this] {
        if (isVisible())
            showTime();
    });
}

void TablePage::refresh() {
    m_stale = !isVisible();
    if (m_stale)
        return;
    showRun();
    showTime();
}

void TablePage::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    if (m_stale) {
        m_stale = false;
        showRun();
    }
    showTime();
}

std::optional<std::size_t> TablePage::selected() const {
    const auto selected = playhead().selected();
    return selected && *selected < session().timeline().collisions().size() ? selected : std::nullopt;
}

std::pair<double, double> TablePage::shownTimes() const {
    const RunPart part = session().part();
    const double to = part.last ? std::min(part.to, session().shownUntil()) : part.to;
    return {part.from, std::max(part.from, to)};
}

QString TablePage::partText() const {
    const RunPart part = session().part();
    const auto count = std::int64_t(session().timeline().collisions().size());
    if (part.isWhole() || count == 0)
        return {};
    const QString first = countText(part.collisionsBefore + 1),
                  last = countText(part.collisionsBefore + count);
    return part.ended ? tr("Collisions %1 to %2 of %3").arg(first, last, countText(part.collisionCount))
                      : tr("Collisions %1 to %2").arg(first, last);
}

} // namespace thetalane
