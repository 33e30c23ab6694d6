// The divide between the lane and the cards.
#pragma once

#include <QSplitter>

#include <algorithm>

namespace thetalane {

// Until someone drags it, the cards take their share of a larger window: formulas like room.
class Divide : public QSplitter {
public:
    Divide()
        : QSplitter(Qt::Horizontal) {
        connect(this, &QSplitter::splitterMoved, this, [this] { m_byHand = true; });
    }

    QByteArray remembered() const { return m_byHand ? saveState() : QByteArray(); }
    void recall(const QByteArray& state) { m_byHand = !state.isEmpty() && restoreState(state); }

    // Of the width, for the cards.
    void setShare(double share) {
        m_share = share;
        spread();
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QSplitter::resizeEvent(event);
        spread();
    }

private:
    void spread() {
        if (m_byHand)
            return;
        const QWidget* cards = widget(1);
        const int share = std::clamp(int(width() * m_share), cards->minimumWidth(), cards->maximumWidth());
        setSizes({width() - share, share});
    }

    double m_share = 0.3;
    bool m_byHand = false;
};

} // namespace thetalane
