// Paints a row of outcomes: the pins left as a deck, a strike in its colour, the present value marked.
#pragma once

#include "ui/appearance.h"

#include <QStyledItemDelegate>

namespace thetalane {

class VaryDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit VaryDelegate(const Appearance& appearance, QObject* parent = nullptr);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

private:
    const Appearance& m_appearance;
};

} // namespace thetalane
