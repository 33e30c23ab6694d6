#include "ui/lessons/big_text.h"

#include "ui/lessons/lesson_text.h"

#include <QLabel>

namespace thetalane {

BigText::BigText(const Appearance& appearance, const QString& name, QWidget* parent)
    : QScrollArea(parent)
    , m_appearance(appearance)
    , m_label(new QLabel(this)) {
    setObjectName(name);
    setWidget(m_label);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_label->setObjectName(name + QStringLiteral("Label"));
    m_label->setTextFormat(Qt::PlainText);
    m_label->setWordWrap(true);
    m_label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    connect(&appearance, &Appearance::changed, this, &BigText::fit);
}

void BigText::setWords(const QString& words) {
    m_words = words;
    m_label->setText(keptWords(words));
    m_label->setAccessibleName(words);
    fit();
}

bool BigText::isWhole() const {
    return m_label->height() <= viewport()->height();
}

void BigText::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    fit();
}

void BigText::fit() {
    using Size = Appearance::Size;
    const int title = m_appearance.pixels(Size::Title), large = m_appearance.pixels(Size::Large);
    const int width = viewport()->width();
    QFont font = m_appearance.font(Size::Title);
    int height = 0;
    for (int pixels = title; pixels >= large; pixels -= 2) {
        font.setPixelSize(pixels);
        height = QFontMetrics(font)
                     .boundingRect(QRect(0, 0, width, 100'000), Qt::TextWordWrap, m_label->text())
                     .height() +
                 2;
        if (height <= viewport()->height())
            break;
    }
    m_label->setFont(font);
    m_label->setStyleSheet(QStringLiteral("color: %1;").arg(m_appearance.text().name()));
    m_label->setFixedSize(width, height);
}

} // namespace thetalane
