#include "ui/practice/vary_delegate.h"

#include "ui/panels/pin_deck.h"
#include "ui/plot/strike_map_figure.h"
#include "ui/practice/vary_model.h"

#include <QPainter>

namespace thetalane {

VaryDelegate::VaryDelegate(const Appearance& appearance, QObject* parent)
    : QStyledItemDelegate(parent)
    , m_appearance(appearance) {}

void VaryDelegate::paint(QPainter* p, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const Appearance& a = m_appearance;
    const QRectF cell = option.rect;
    const bool present = index.data(VaryModel::PresentRole).toBool();
    const bool clears = index.data(VaryModel::ClearsRole).toBool();
    p->save();
    if (present)
        p->fillRect(cell, a.chosen());
    if (index.column() == VaryModel::Value && present) // seen without colour, too
        p->fillRect(QRectF(cell.left(), cell.top(), a.unit() / 2.0, cell.height()), a.accent());
    if (clears && index.column() == VaryModel::Down) {
        p->setRenderHint(QPainter::Antialiasing);
        p->setPen(Qt::NoPen);
        p->setBrush(strikeColour());
        const double high = 1.7 * a.pixels(Appearance::Size::Normal);
        QRectF mark(0, 0, std::min(cell.width() - 4, 1.5 * high), high);
        mark.moveCenter(cell.center());
        p->drawRoundedRect(mark, high / 2, high / 2);
    }
    if (index.column() == VaryModel::Left && index.data(VaryModel::PossibleRole).toBool()) {
        paintPinDeck(*p, cell.adjusted(2, 3, -2, -3), PinSet(index.data(VaryModel::PinsRole).toUInt()), a);
    } else {
        const bool bold = present || (clears && index.column() == VaryModel::Down);
        p->setFont(a.font(Appearance::Size::Normal, bold));
        const bool onAmber = clears && index.column() == VaryModel::Down;
        p->setPen(onAmber && a.dark() ? a.window() : a.text());
        p->drawText(cell, Qt::AlignCenter, index.data(Qt::DisplayRole).toString());
    }
    p->setPen(QPen(a.line(), 1));
    p->drawLine(cell.bottomLeft(), cell.bottomRight());
    if (option.state & QStyle::State_Selected && option.widget && option.widget->hasFocus()) {
        p->setPen(QPen(a.accent(), a.lineWidth()));
        p->drawLine(cell.topLeft(), cell.topRight());
        p->drawLine(cell.bottomLeft(), cell.bottomRight());
    }
    p->restore();
}

} // namespace thetalane
