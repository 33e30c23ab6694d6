#include "ui/lessons/lesson_caption.h"

#include "ui/lessons/lesson_text.h"
#include "ui/panels/panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace thetalane {

LessonCaption::LessonCaption(const Context& context, LessonPlayer& player, QWidget* parent)
    : QFrame(parent)
    , m_appearance(context.appearance)
    , m_player(player)
    , m_text(new QLabel(this))
    , m_open(new QPushButton(this))
    , m_back(new QPushButton(this))
    , m_next(new QPushButton(this)) {
    setObjectName(QStringLiteral("lessonCaption"));
    m_text->setObjectName(QStringLiteral("lessonCaptionText"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_open->setObjectName(QStringLiteral("captionToLesson"));
    m_open->setProperty("quiet", true);
    m_back->setObjectName(QStringLiteral("captionBack"));
    m_next->setObjectName(QStringLiteral("captionNext"));
    m_next->setProperty("prominent", true);
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(m_text, 1);
    for (QPushButton* button : {m_open, m_back, m_next}) {
        button->setFocusPolicy(Qt::TabFocus);
        layout->addWidget(button);
    }
    connect(m_open, &QPushButton::clicked, this, &LessonCaption::panelWanted);
    connect(m_back, &QPushButton::clicked, &player, &LessonPlayer::back);
    connect(m_next, &QPushButton::clicked, this, &LessonCaption::turn);
    connect(&player, &LessonPlayer::pageChanged, this, &LessonCaption::showPage);
    connect(&player, &LessonPlayer::left, this, &LessonCaption::showPage);
    connect(&m_appearance, &Appearance::changed, this, &LessonCaption::restyle);
    restyle();
    retranslate();
}

void LessonCaption::setPanelInFront(bool inFront) {
    m_panelInFront = inFront;
    showPage();
}

// A question is answered in its own panel.
void LessonCaption::turn() {
    if (m_player.isQuestion())
        emit panelWanted();
    else if (m_player.page() + 1 == m_player.pageCount() && !m_player.travelling())
        m_player.leave();
    else
        m_player.next();
}

void LessonCaption::showPage() {
    setVisible(m_player.running() && !m_panelInFront);
    if (!m_player.running())
        return;
    const LessonStop* stop = m_player.stop();
    const QString words = inLanguageOfNow(stop ? stop->text : m_player.lesson().question->text);
    m_text->setText(keptWords(words));
    m_text->setAccessibleName(words);
    m_back->setEnabled(m_player.page() > 0);
    m_back->setToolTip(tr("The page before (Page Up)"));
    const bool isLast = m_player.page() + 1 == m_player.pageCount();
    m_next->setText(m_player.isQuestion() ? tr("To the question") : isLast ? tr("Finish") : tr("Next"));
    m_next->setToolTip(isLast ? tr("Leaves the lesson; its scene stays, to go on with")
                              : tr("The next page (Page Down)"));
    m_next->setAccessibleName(m_next->text());
    m_open->setVisible(!m_player.isQuestion());
}

void LessonCaption::retranslate() {
    m_open->setText(tr("To the lesson"));
    m_open->setToolTip(tr("Brings the panel of the lesson to the front"));
    m_back->setText(tr("Back"));
    for (QPushButton* button : {m_open, m_back})
        button->setAccessibleName(button->text());
    showPage();
}

void LessonCaption::restyle() {
    using Size = Appearance::Size;
    const int unit = m_appearance.unit();
    layout()->setContentsMargins(2 * unit, unit / 2, 2 * unit, unit / 2);
    layout()->setSpacing(unit);
    setStyleSheet(
        panelStyle(m_appearance) +
        QStringLiteral("#lessonCaption { background: %1; border-bottom: 1px solid %2; } "
                       "#lessonCaptionText { color: %3; }")
            .arg(m_appearance.card().name(), m_appearance.line().name(), m_appearance.text().name()));
    m_text->setFont(m_appearance.font(Size::Large));
    m_open->setFont(m_appearance.font(Size::Small));
    for (QPushButton* button : {m_back, m_next})
        button->setFont(m_appearance.font(Size::Normal, button == m_next));
}

void LessonCaption::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QFrame::changeEvent(event);
}

} // namespace thetalane
