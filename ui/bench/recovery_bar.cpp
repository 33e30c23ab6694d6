#include "ui/bench/recovery_bar.h"

#include "ui/panels/panel.h"
#include "ui/words/scene_text.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>

namespace thetalane {

RecoveryBar::RecoveryBar(const Context& context, FileFlow& flow, QWidget* parent)
    : QFrame(parent)
    , m_appearance(context.appearance)
    , m_flow(flow)
    , m_text(new QLabel(this))
    , m_recover(new QPushButton(this))
    , m_discard(new QPushButton(this))
    , m_close(new QToolButton(this)) {
    setObjectName(QStringLiteral("recoveryBar"));
    m_text->setObjectName(QStringLiteral("recoveryText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_recover->setObjectName(QStringLiteral("recoverButton"));
    m_discard->setObjectName(QStringLiteral("discardRecoveryButton"));
    m_close->setObjectName(QStringLiteral("closeRecovery"));
    m_close->setText(QStringLiteral("✕"));
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(m_text, 1);
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{m_recover, m_discard, m_close}) {
        button->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(button);
    }
    Desk& desk = flow.desk();
    connect(m_recover, &QPushButton::clicked, this,
            [this] { m_flow.whenSafe([this] { m_flow.desk().recover(0); }); });
    connect(m_discard, &QPushButton::clicked, this, [&desk] { desk.discardRecovery(0); });
    connect(m_close, &QToolButton::clicked, this, [this] {
        m_closed = true;
        showOffer();
    });
    connect(&desk, &Desk::changed, this, &RecoveryBar::showOffer);
    connect(&m_appearance, &Appearance::changed, this, &RecoveryBar::restyle);
    restyle();
    retranslate();
}

void RecoveryBar::retranslate() {
    m_recover->setText(tr("Bring back"));
    m_recover->setToolTip(tr("Open the scene as it was last edited; it is not saved yet"));
    m_discard->setText(tr("Discard"));
    m_discard->setToolTip(tr("The edits are deleted"));
    m_close->setToolTip(tr("Not now: ask again at the next start"));
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{m_recover, m_discard})
        button->setAccessibleName(button->text());
    m_close->setAccessibleName(m_close->toolTip());
    showOffer();
}

void RecoveryBar::showOffer() {
    const auto& all = m_flow.desk().recoverable();
    setVisible(!m_closed && !all.empty());
    if (all.empty())
        return;
    const Unsaved& unsaved = all.front();
    const bool korean = QLocale().language() == QLocale::Korean;
    QString name = unsaved.file.isEmpty()
                       ? sceneTitle(unsaved.scene, korean ? Language::Code::Korean : Language::Code::English)
                       : QFileInfo(unsaved.file).completeBaseName();
    if (name.isEmpty())
        name = tr("a scene without a name");
    QString text = tr("The program ended before “%1” was saved (edited %2).")
                       .arg(name, QLocale().toString(unsaved.time, QLocale::ShortFormat));
    if (all.size() > 1)
        text += u' ' + tr("There are %1 such scenes.").arg(all.size());
    m_text->setText(text);
    m_text->setAccessibleName(text);
}

void RecoveryBar::restyle() {
    const int unit = m_appearance.unit();
    layout()->setContentsMargins(2 * unit, unit / 2, unit, unit / 2);
    layout()->setSpacing(unit);
    setStyleSheet(panelStyle(m_appearance) +
                  QStringLiteral("#recoveryBar { background: %2; } #recoveryText { color: %1; }")
                      .arg(m_appearance.text().name(), m_appearance.wood().name()));
    for (QWidget* widget : std::initializer_list<QWidget*>{m_text, m_recover, m_discard})
        widget->setFont(m_appearance.font(Appearance::Size::Normal));
}

void RecoveryBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QFrame::changeEvent(event);
}

} // namespace thetalane
