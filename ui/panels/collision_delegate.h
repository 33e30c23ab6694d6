// Paints a row of the list of collisions: dots in the colours of the two bodies, a bracket for the same
// instant.
#pragma once

#include "ui/appearance.h"

#include <QStyledItemDelegate>

namespace thetalane {

class CollisionDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    CollisionDelegate(const Appearance& appearance, QObject* parent);

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

private:
    void paintBodies(QPainter& painter, const QRect& cell, const QString& text) const;
    void paintInstant(QPainter& painter, const QRect& cell, int instant, int pass) const;

    const Appearance& m_appearance;
};

} // namespace thetalane
