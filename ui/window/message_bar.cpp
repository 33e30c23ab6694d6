#include "ui/window/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace thetalane {

MessageBar::MessageBar(const Context& context, QWidget* parent)
    : QFrame(parent)
    , m_appearance(context.appearance)
    , m_text(new QLabel)
    , m_close(new QToolButton) {
    setObjectName("messageBar");
    m_text->setObjectName("messageText");
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_close->setObjectName("closeMessage");
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setText(QStringLiteral("✕"));
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    connect(&m_appearance, &Appearance::changed, this, &MessageBar::applyAppearance);
    connect(&context.session, &Session::runChanged, this, &QWidget::hide);
    applyAppearance();
    retranslate();
    hide();
}

void MessageBar::showError(std::function<QString()> text) {
    m_error = std::move(text);
    retranslate();
    show();
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QFrame::changeEvent(event);
}

void MessageBar::retranslate() {
    if (m_error)
        m_text->setText(m_error());
    m_text->setAccessibleName(m_text->text());
    m_close->setToolTip(tr("Close this message"));
    m_close->setAccessibleName(tr("Close this message"));
}

void MessageBar::applyAppearance() {
    const int u = m_appearance.unit();
    layout()->setContentsMargins(2 * u, u / 2, u, u / 2);
    m_text->setFont(m_appearance.font(Appearance::Size::Normal));
    m_text->setStyleSheet(QStringLiteral("color: %1").arg(m_appearance.error().name()));
    setStyleSheet(QStringLiteral("#messageBar { background: %1; }").arg(m_appearance.errorGround().name()));
}

} // namespace thetalane
