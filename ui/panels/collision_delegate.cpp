#include "ui/panels/collision_delegate.h"

#include "ui/panels/collision_model.h"

#include <QPainter>

namespace thetalane {

CollisionDelegate::CollisionDelegate(const Appearance& appearance, QObject* parent)
    : QStyledItemDelegate(parent)
    , m_appearance(appearance) {}

void CollisionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(option.font);
    if (option.state & QStyle::State_Selected)
        painter->fillRect(option.rect, option.palette.brush(QPalette::Highlight));
    painter->setPen(m_appearance.text());
    const QString text = index.data().toString();
    if (index.column() == CollisionModel::Bodies) {
        paintBodies(*painter, option.rect, text);
    } else {
        const QRect inner = option.rect.adjusted(2, 0, -4, 0);
        const QString fitted = option.fontMetrics.elidedText(text, Qt::ElideRight, inner.width());
        painter->drawText(inner, index.data(Qt::TextAlignmentRole).toInt(), fitted);
    }
    if (index.column() == CollisionModel::Number)
        paintInstant(*painter, option.rect, index.data(CollisionModel::InstantRole).toInt(),
                     index.data(CollisionModel::PassRole).toInt());
    painter->restore();
}

void CollisionDelegate::paintBodies(QPainter& painter, const QRect& cell, const QString& text) const {
    const QFontMetrics metrics(painter.font());
    const double radius = metrics.xHeight() / 2.0;
    const double middle = cell.center().y() + 0.5;
    const int gap = int(radius * 2) + 5;
    const QString arrow = QStringLiteral("→");
    const int cut = int(text.indexOf(arrow));
    const QString names[] = {text.left(cut).trimmed(), text.mid(cut + 1).trimmed()};
    const Ink inks[] = {Ink::First, Ink::Second};

    int x = cell.left() + m_appearance.unit();
    for (int i = 0; i < 2; ++i) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_appearance.ink(inks[i]));
        painter.drawEllipse(QPointF(x + radius, middle), radius, radius);
        x += gap;
        const int room = cell.right() - x;
        const QString name = metrics.elidedText(names[i], Qt::ElideRight, room);
        painter.setPen(m_appearance.text());
        painter.drawText(QRect(x, cell.top(), room, cell.height()), Qt::AlignVCenter | Qt::AlignLeft, name);
        x += metrics.horizontalAdvance(name) + 5;
        if (i == 0) {
            painter.setPen(m_appearance.quietText());
            painter.drawText(QRect(x, cell.top(), cell.right() - x, cell.height()),
                             Qt::AlignVCenter | Qt::AlignLeft, arrow);
            x += metrics.horizontalAdvance(arrow) + 5;
        }
    }
}

void CollisionDelegate::paintInstant(QPainter& painter, const QRect& cell, int instant, int pass) const {
    if (instant == CollisionModel::Alone)
        return;
    const double x = cell.left() + 4;
    const double middle = cell.center().y() + 0.5;
    const double foot = 4;
    painter.setPen(QPen(m_appearance.ink(Ink::Triangle), m_appearance.lineWidth()));
    const double from = instant == CollisionModel::First ? middle - 4 : cell.top();
    const double to = instant == CollisionModel::Last ? middle + 4 : cell.bottom() + 1;
    painter.drawLine(QPointF(x, from), QPointF(x, to));
    if (instant == CollisionModel::First)
        painter.drawLine(QPointF(x, from), QPointF(x + foot, from));
    if (instant == CollisionModel::Last)
        painter.drawLine(QPointF(x, to), QPointF(x + foot, to));

    // The passes, one below the other with a gap between: a bar for several, a point for one.
    const double thick = 2 * m_appearance.lineWidth();
    const bool opens = pass == CollisionModel::First || pass == CollisionModel::Alone;
    const bool closes = pass == CollisionModel::Last || pass == CollisionModel::Alone;
    const double top = opens ? middle - thick / 2 : cell.top();
    const double bottom = closes ? middle + thick / 2 : cell.bottom() + 1;
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_appearance.ink(Ink::Triangle));
    painter.drawRect(QRectF(x + foot + 1, top, thick, bottom - top));
}

} // namespace thetalane
