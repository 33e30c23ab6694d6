// The present time: "1.234 s", every digit in a place of its own, so that nothing shakes while it runs.
#pragma once

#include "ui/panels/panel.h"

namespace thetalane {

class TimeReadout : public Panel {
    Q_OBJECT
public:
    explicit TimeReadout(const Context& context, QWidget* parent = nullptr);

    QFont readoutFont() const;
    QString text() const;

    void retranslate() override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void restyle() override;

private:
    double cellWidth() const; // of the widest digit
    double widthOf(const QString& text) const;
};

} // namespace thetalane
