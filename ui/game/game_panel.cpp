#include "ui/game/game_panel.h"

#include "ui/game/new_game_page.h"
#include "ui/game/play_page.h"

#include <QStackedWidget>
#include <QVBoxLayout>

namespace thetalane {

GamePanel::GamePanel(const Context& context, Alley& alley, QWidget* parent)
    : Panel(context, parent)
    , m_alley(alley)
    , m_before(new NewGamePage(context, alley))
    , m_during(new PlayPage(context, alley))
    , m_pages(new QStackedWidget(this)) {
    setObjectName(QStringLiteral("gamePanel"));
    m_pages->addWidget(m_before);
    m_pages->addWidget(m_during);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);
    connect(&alley, &Alley::changed, this, &GamePanel::adopt);
    restyle();
    retranslate();
    adopt();
}

void GamePanel::retranslate() {
    setAccessibleName(tr("Bowling game"));
}

void GamePanel::adopt() {
    QWidget* wanted = m_alley.isOn() ? static_cast<QWidget*>(m_during) : m_before;
    if (m_pages->currentWidget() == wanted)
        return;
    m_pages->setCurrentWidget(wanted);
    if (wanted == m_before)
        m_before->refresh();
}

// Another program may have played meanwhile.
void GamePanel::showEvent(QShowEvent* event) {
    if (!m_alley.isOn())
        m_before->refresh();
    Panel::showEvent(event);
}

} // namespace thetalane
