// The look: colours by their meaning and sizes by their use. Projector mode is larger and higher in contrast.
#pragma once

#include "ui/words/formula.h"

#include <QColor>
#include <QFont>
#include <QObject>
#include <QPalette>

namespace thetalane {

class Appearance : public QObject {
    Q_OBJECT
public:
    explicit Appearance(QObject* parent = nullptr);

    bool projector() const { return m_projector; }
    void setProjector(bool on);

    // Dark, or light as paper. A projector's colours are stronger in both.
    bool dark() const { return m_dark; }
    void setDark(bool on);

    // For pictures, and for people who prefer it: nothing glides, everything is at once where it goes.
    bool reducedMotion() const { return m_reducedMotion; }
    void setReducedMotion(bool on);

    // Okabe-Ito, safe for colour-blind eyes; the same meaning on the lane, the cards, in formulas and tables.
    QColor ink(Ink role) const;     // for lines and fills
    QColor textInk(Ink role) const; // the same, dark enough for text on `card()`

    QColor window() const; // behind everything
    QColor card() const;   // cards and panels
    QColor text() const;
    QColor quietText() const;
    QColor faintText() const;   // of what has not happened yet, or cannot be pressed
    QColor noteGround() const;  // behind a note that something unusual is shown
    QColor line() const;        // hairlines
    QColor accent() const;      // the one obvious thing to press, the focus, the current stage
    QColor hover() const;       // behind what the mouse is over
    QColor chosen() const;      // behind what is chosen in a list
    QColor error() const;       // of text
    QColor errorGround() const; // behind it
    QColor wood() const;        // the lane
    QColor woodLine() const;
    QColor gutter() const;
    QColor floor() const; // of a scene without a lane
    QColor pin() const;
    QColor onInk() const; // text on a disc filled with an ink

    // Sizes in pixels: 11/13/16/22, in projector mode 16/20/26/36.
    enum class Size { Small, Normal, Large, Title };
    int pixels(Size size) const;
    QFont font(Size size, bool bold = false) const;
    QFont formulaFont(int pixelSize, bool italic) const;
    double lineWidth() const { return m_projector ? 3 : 2; }
    int unit() const { return m_projector ? 12 : 8; } // the spacing grid

    QPalette palette() const;   // for the application
    QString styleSheet() const; // for the application

signals:
    void changed();

private:
    QColor pick(QRgb light, QRgb lightProjector, QRgb dark, QRgb darkProjector) const;

    bool m_projector = false;
    bool m_dark = false;
    bool m_reducedMotion = false;
};

} // namespace thetalane
