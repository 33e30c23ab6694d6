// What the colours of the strike map say: 0 to 9 pins down, and a strike.
#pragma once

#include "ui/appearance.h"

#include <QWidget>

namespace thetalane {

class MapLegend : public QWidget {
    Q_OBJECT
public:
    explicit MapLegend(const Appearance& appearance, QWidget* parent = nullptr);

    void setMarked(int pinsDown); // -1: none
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    const Appearance& m_appearance;
    QString m_title;
    int m_marked = -1;
};

} // namespace thetalane
