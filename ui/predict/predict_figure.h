// A collision to predict: the two at their contact with the arrows they come with, and the arrows a class
// expects, whose tips can be dragged. The truth is drawn only once it is revealed.
#pragma once

#include "core/collision/pair_collision.h"
#include "ui/appearance.h"

#include <QWidget>

#include <array>
#include <optional>

namespace thetalane {

class PredictFigure : public QWidget {
    Q_OBJECT
public:
    explicit PredictFigure(const Appearance& appearance, QWidget* parent = nullptr);

    // What is known before: the bodies, their velocities and their names. A wall has no name.
    struct Known {
        Disc<double> first, second;
        Contact<double> contact;
        double speed = 1; // the fastest of those that come [m/s]: sets the scale
        QString firstName, secondName;
        bool isWall = false;
    };
    void setKnown(const Known& known);
    void setGuess(const VelocityPair<double>& guess);
    const VelocityPair<double>& guess() const { return m_guess; }
    void reveal(const std::optional<VelocityPair<double>>& truth); // nothing: hides it
    void retranslate();

    QPointF tip(int body) const; // where its arrow can be grabbed [px]
    int chosen() const { return m_chosen; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void guessed(const thetalane::VelocityPair<double>& guess);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    int bodies() const { return m_known.isWall ? 1 : 2; }
    Vec2d& guessOf(int body) { return body == 0 ? m_guess.first : m_guess.second; }
    const Vec2d& guessOf(int body) const { return body == 0 ? m_guess.first : m_guess.second; }
    QPointF centre(int body) const;
    double pixelsPerMetre() const;
    double pixelsPerSpeed() const;
    void keepInside();
    int tipAt(QPointF where) const; // -1: none
    bool keyPressed(int key, Qt::KeyboardModifiers modifiers);
    void put(int body, const Vec2d& velocity);
    void paintBodies(QPainter& painter) const;
    void paintArrow(QPainter& painter, int body, const Vec2d& v, const QColor& colour, double width,
                    Qt::PenStyle style, bool filled) const;
    void paintTip(QPainter& painter, int body) const;
    void paintKey(QPainter& painter) const;

    const Appearance& m_appearance;
    Known m_known;
    VelocityPair<double> m_guess;
    std::optional<VelocityPair<double>> m_truth;
    int m_chosen = 0;
    int m_dragged = -1;
    VelocityPair<double> m_inside; // the guess that the scale is made for; it holds while a tip is dragged
};

} // namespace thetalane
