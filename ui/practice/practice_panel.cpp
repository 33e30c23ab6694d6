#include "ui/practice/practice_panel.h"

#include "ui/practice/spare_box.h"
#include "ui/practice/vary_box.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace thetalane {

PracticePanel::PracticePanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_column(new QVBoxLayout)
    , m_spares(new SpareBox(context))
    , m_varied(new VaryBox(context)) {
    setObjectName(QStringLiteral("practicePanel"));
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // the Tab key goes to what stands in it
    auto* inside = new QWidget(scroll);
    inside->setLayout(m_column);
    m_column->addWidget(m_spares);
    m_column->addWidget(m_varied);
    m_column->addStretch(1);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    connect(m_spares, &SpareBox::thrown, this, &PracticePanel::thrown);
    restyle();
    retranslate();
}

void PracticePanel::retranslate() {
    setAccessibleName(tr("Practice"));
}

void PracticePanel::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(2 * unit);
}

} // namespace thetalane
