#include "ui/tables/collision_page.h"

#include "ui/count_text.h"
#include "ui/tables/bodies_page.h"
#include "ui/tables/collision_sheet.h"
#include "ui/tables/sheet_table.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"

#include <QLabel>
#include <QScrollArea>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace thetalane {

CollisionPage::CollisionPage(const Context& context, QWidget* parent)
    : TablePage(context, "collisionPage", parent)
    , m_which(new QLabel)
    , m_numbers(new SheetTable(context.appearance, "collisionNumbers"))
    , m_checks(new SheetTable(context.appearance, "collisionChecks"))
    , m_none(new QLabel)
    , m_bodies(new BodiesPage(context))
    , m_scroll(new QScrollArea(this))
    , m_stack(new QStackedLayout(this)) {
    m_stack->setContentsMargins(0, 0, 0, 0);
    m_which->setObjectName(QStringLiteral("tableWhich"));
    m_which->setWordWrap(true);
    m_none->setObjectName(QStringLiteral("tableNone"));
    m_none->setWordWrap(true);
    m_scroll->setWidget(makeOpen());
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_stack->addWidget(m_scroll);
    m_stack->addWidget(makeNone());
    restyle();
    retranslate();
}

QWidget* CollisionPage::makeOpen() {
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_which);
    column->addWidget(m_numbers);
    column->addWidget(m_checks);
    column->addStretch(1);
    return inside;
}

QWidget* CollisionPage::makeNone() {
    auto* inside = new QWidget(this);
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_none);
    column->addWidget(m_bodies, 1);
    return inside;
}

void CollisionPage::retranslate() {
    m_none->setText(tr("No collision is open: these are all bodies now."));
    const QString tip = tr("All digits on hover; Ctrl+C copies the rows chosen, or all, with every digit");
    m_numbers->setAccessibleName(tr("Before and after the collision"));
    m_checks->setAccessibleName(tr("Checks of the collision"));
    m_numbers->setToolTip(tip);
    m_checks->setToolTip(tip);
    if (isVisible())
        showNumbers();
    else
        refresh();
}

void CollisionPage::restyle() {
    TablePage::restyle();
    m_which->setFont(appearance().font(Appearance::Size::Normal, true));
    makeQuiet(*m_none, appearance());
    const int unit = appearance().unit();
    m_scroll->widget()->layout()->setSpacing(unit);
}

void CollisionPage::showRun() {
    m_stack->setCurrentIndex(selected() ? 0 : 1);
    showNumbers();
}

void CollisionPage::showNumbers() {
    const auto open = selected();
    if (!open)
        return;
    const Scene& scene = session().scene();
    const auto collisions = session().timeline().collisions();
    m_which->setText(tr("Collision %1 of %2: %3, at %4 s")
                         .arg(countText(playhead().selectedNumber().value_or(0)),
                              countText(session().part().collisionCount),
                              contactName(scene, collisions[*open]), numberText(collisions[*open].time, 5)));
    m_numbers->setSheet(blockSheet(scene, collisions, *open));
    if (m_numbers->naturalWidth() > width())
        m_numbers->setSheet(narrowSheet(scene, collisions, *open));
    m_checks->setSheet(checkSheet(scene, collisions, *open));
}

void CollisionPage::resizeEvent(QResizeEvent* event) {
    TablePage::resizeEvent(event);
    if (isVisible())
        showNumbers();
}

Sheet CollisionPage::sheet() const {
    if (const auto open = selected())
        return collisionRecord(session().scene(), session().timeline().collisions(), *open);
    return m_bodies->sheet();
}

} // namespace thetalane
