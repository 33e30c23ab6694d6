// How many pins the ball and the other pins have touched (the paper's figure 14), and how many went down; of
// a rack also which, on a picture of the deck.
#pragma once

#include "ui/context.h"

#include <QWidget>

#include <vector>

namespace thetalane {

class PinBadge : public QWidget {
    Q_OBJECT
public:
    explicit PinBadge(const Context& context, QWidget* parent = nullptr);

    int touched() const { return m_touched; }
    int down() const { return m_down; }
    bool showsDeck() const { return !m_spots.empty(); }
    std::vector<int> standing() const; // bodies, of the deck's picture
    bool hasPins() const { return m_pins > 0; }
    QSize sizeHint() const override;

signals:
    void resized(); // its size hint changed

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void adoptRun();
    void adoptChapter();
    void showTime(double time);
    void retranslate();
    double deckWidth() const;
    void paintDeck(QPainter& painter, const QRectF& box) const;

    // One pin of the deck's picture: where it stood, and what became of it.
    struct Spot {
        int body = 0;
        Vec2d place;
        bool down = false;

        friend bool operator==(const Spot&, const Spot&) = default;
    };
    // All that it says.
    struct Said {
        int pins = 0, touched = 0, down = 0;
        std::vector<Spot> spots;

        friend bool operator==(const Said&, const Said&) = default;
    };

    Context m_context;
    std::shared_ptr<const Run> m_run;
    std::vector<double> m_changes; // the only times at which a count can change [s]
    std::ptrdiff_t m_change = -1;  // how many of them have passed
    int m_pins = 0;
    bool m_settled = false; // after the first of several chapters no pin was left
    bool m_later = false;   // the present chapter is not the first
    int m_touched = 0;
    int m_down = 0;
    std::vector<Spot> m_spots; // of a rack's pins; none of other scenes'
    Said m_said;               // by now
    QString m_touchedText;
    QString m_downText;
};

} // namespace thetalane
