// A card to press: a mark, a line or more of text, a quieter one below. It says by shape as well as by colour
// what it is.
#pragma once

#include "ui/appearance.h"

#include <QAbstractButton>

namespace thetalane {

class CardButton : public QAbstractButton {
    Q_OBJECT
public:
    enum class State { Plain, Chosen, Right, Wrong };

    // name becomes the objectName.
    CardButton(const Appearance& appearance, const QString& name, QWidget* parent = nullptr);

    void setMark(const QString& mark); // a digit or a letter
    void setWords(const QString& words, const QString& below = {}, const QString& toolTip = {});
    QString words() const { return m_words; }
    QString below() const { return m_below; }
    void setState(State state);
    State state() const { return m_state; }

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Places {
        QRect mark, words, below;
        int height = 0;
    };
    Places placesFor(int width) const;
    QFont wordsFont() const;
    void paintMark(QPainter& painter, const QRect& where) const;

    const Appearance& m_appearance;
    QString m_mark;
    QString m_words;
    QString m_below;
    State m_state = State::Plain;
};

} // namespace thetalane
