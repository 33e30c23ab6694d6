#include "ui/steps/step_panel.h"

#include "ui/count_text.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QVBoxLayout>

namespace thetalane {
namespace {

using Size = Appearance::Size;

// A triangle that points to the collision before or after, sharp at any size.
QIcon chevron(bool forward, const QColor& color, int pixels) {
    constexpr int ratio = 3;
    QPixmap pixmap(pixels * ratio, pixels * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color, pixels / 8.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const double near = pixels * (forward ? 0.36 : 0.64);
    const double far = pixels * (forward ? 0.66 : 0.34);
    const QPointF points[] = {{near, pixels * 0.2}, {far, pixels * 0.5}, {near, pixels * 0.8}};
    painter.drawPolyline(points, 3);
    return QIcon(pixmap);
}

// A triangle to play, two bars to hold.
QIcon playsStages(bool playing, const QColor& color, int pixels) {
    constexpr int ratio = 3;
    QPixmap pixmap(pixels * ratio, pixels * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double p = pixels;
    if (playing)
        for (const double x : {0.24, 0.56})
            painter.drawRect(QRectF(x * p, 0.16 * p, 0.2 * p, 0.68 * p));
    else
        painter.drawPolygon(QPolygonF{{0.24 * p, 0.12 * p}, {0.86 * p, 0.5 * p}, {0.24 * p, 0.88 * p}});
    return QIcon(pixmap);
}

QString coloured(const QColor& color, const QString& text) {
    return QStringLiteral("<span style=\"color:%1\">%2</span>").arg(color.name(), text);
}

} // namespace

StepPanel::StepPanel(const Context& context, QWidget* parent)
    : QWidget(parent)
    , m_session(context.session)
    , m_playhead(context.playhead)
    , m_appearance(context.appearance)
    , m_pages(new QStackedWidget(this))
    , m_player(context.playhead) {
    setObjectName("stepPanel");
    setFocusPolicy(Qt::StrongFocus);
    setMinimumWidth(320);
    auto* worked = new QWidget;
    auto* column = new QVBoxLayout(worked);
    column->setContentsMargins({});
    column->setSpacing(0);
    column->addWidget(makeHead());
    column->addWidget(makeCards(), 1);
    m_pages->addWidget(makeInvitation());
    m_pages->addWidget(worked);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_pages);

    connect(&m_playhead, &Playhead::selectionChanged, this, &StepPanel::showSelection);
    connect(&m_playhead, &Playhead::stageChanged, this, &StepPanel::showStage);
    connect(&m_player, &StagePlayer::playingChanged, this, &StepPanel::showPlaying);
    connect(&m_session, &Session::runChanged, this, &StepPanel::showSelection);
    connect(&m_session, &Session::chapterChanged, this, &StepPanel::showSelection);
    connect(&m_session, &Session::progressed, this, &StepPanel::showPlace);
    connect(&m_appearance, &Appearance::changed, this, &StepPanel::applyAppearance);
    applyAppearance();
    retranslate();
}

QWidget* StepPanel::makeHead() {
    auto* head = new QWidget;
    m_title = new QLabel;
    m_title->setObjectName("collisionTitle");
    m_title->setWordWrap(true); // of millions
    m_partners = new QLabel;
    m_partners->setObjectName("collisionPartners");
    setTerm(m_partners, "digits-left");
    m_partners->setTextFormat(Qt::RichText);
    m_partners->setWordWrap(true);
    const auto button = [](const char* name) {
        auto* b = new QToolButton;
        b->setObjectName(name);
        b->setAutoRaise(true);
        b->setFocusPolicy(Qt::TabFocus);
        return b;
    };
    m_play = button("playSteps");
    m_previous = button("previousCollision");
    m_next = button("nextCollision");
    connect(m_play, &QToolButton::clicked, &m_player, &StagePlayer::toggle);
    connect(m_previous, &QToolButton::clicked, this, [this] { m_playhead.stepCollisions(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { m_playhead.stepCollisions(1); });
    auto* top = new QHBoxLayout;
    top->setSpacing(0);
    top->addWidget(m_title, 1);
    top->addWidget(m_play);
    top->addWidget(m_previous);
    top->addWidget(m_next);
    auto* column = new QVBoxLayout(head);
    column->addLayout(top);
    column->addWidget(m_partners);
    m_instant = new InstantNote({m_session, m_playhead, m_appearance});
    column->addWidget(m_instant);
    return head;
}

QWidget* StepPanel::makeCards() {
    auto* inside = new QWidget;
    inside->setObjectName("stepCards");
    for (int i = 0; i < stageCount; ++i) {
        auto* card = new StepCard(m_appearance, Stage(i), inside);
        connect(card, &StepCard::chosen, &m_playhead, &Playhead::setStage);
        connect(card, &StepCard::grew, this, &StepPanel::arrangeCards);
        m_cards[std::size_t(i)] = card;
    }
    m_scroll = new QScrollArea;
    m_scroll->setObjectName("stepScroll");
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // or the formulas would break anew
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setWidget(inside);
    m_scroll->viewport()->installEventFilter(this);
    m_scroll->installEventFilter(this); // up and down step the stage here too
    inside->setAutoFillBackground(false);
    m_scroll->viewport()->setAutoFillBackground(false);
    return m_scroll;
}

QWidget* StepPanel::makeInvitation() {
    auto* page = new QWidget;
    m_invitation = new QLabel;
    m_invitation->setObjectName("invitation");
    m_hint = new QLabel;
    m_hint->setObjectName("invitationHint");
    for (QLabel* label : {m_invitation, m_hint}) {
        label->setWordWrap(true);
        label->setAlignment(Qt::AlignHCenter);
    }
    m_go = new QPushButton;
    m_go->setObjectName("goToFirstCollision");
    m_go->setCursor(Qt::PointingHandCursor);
    connect(m_go, &QPushButton::clicked, this, [this] {
        m_playhead.selectNumber(1);
        setFocus();
    });
    auto* column = new QVBoxLayout(page);
    column->addStretch(2);
    column->addWidget(m_invitation);
    column->addWidget(m_go, 0, Qt::AlignHCenter);
    column->addWidget(m_hint);
    column->addStretch(3);
    return page;
}

void StepPanel::applyAppearance() {
    const int unit = m_appearance.unit();
    m_title->setFont(m_appearance.font(Size::Large, true));
    m_partners->setFont(m_appearance.font(Size::Normal));
    m_invitation->setFont(m_appearance.font(Size::Large));
    m_hint->setFont(m_appearance.font(Size::Normal));
    m_go->setFont(m_appearance.font(Size::Large, true));
    m_go->setMinimumHeight(6 * unit);
    m_go->setStyleSheet(
        QStringLiteral("QPushButton { color: %1; background: %2; border: none; border-radius: %3px;"
                       " padding: 0 %4px; } QPushButton:hover { background: %5; }"
                       " QPushButton:focus { background: %5; border: 2px solid %6; }")
            .arg(m_appearance.card().name(), m_appearance.accent().name())
            .arg(unit / 2)
            .arg(3 * unit)
            .arg(m_appearance.accent().darker(120).name(), m_appearance.text().name()));
    m_hint->setStyleSheet(QStringLiteral("color: %1").arg(m_appearance.quietText().name()));
    const int side = m_appearance.projector() ? 50 : 34;
    for (QToolButton* b : {m_play, m_previous, m_next}) {
        b->setFixedSize(side, side);
        b->setIconSize({side / 2, side / 2});
    }
    for (QToolButton* b : {m_previous, m_next})
        b->setIcon(chevron(b == m_next, m_appearance.text(), side / 2));
    showPlaying();
    if (QLayout* head = m_title->parentWidget()->layout()) {
        head->setContentsMargins(2 * unit, unit, unit, unit);
        head->setSpacing(unit / 4);
    }
    m_scroll->verticalScrollBar()->setStyleSheet(
        QStringLiteral("QScrollBar { background: transparent; width: %1px; margin: 0; }"
                       "QScrollBar::handle { background: %2; border-radius: %3px; min-height: 40px; }"
                       "QScrollBar::add-line, QScrollBar::sub-line { height: 0; }"
                       "QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }")
            .arg(unit + 2)
            .arg(m_appearance.line().darker(112).name())
            .arg(unit / 2));
    QLayout* page = m_go->parentWidget()->layout();
    page->setContentsMargins(3 * unit, 2 * unit, 3 * unit, 2 * unit);
    page->setSpacing(2 * unit);
    showSelection();
}

void StepPanel::retranslate() {
    setAccessibleName(tr("The steps of the collision"));
    showPlaying();
    m_previous->setToolTip(tr("The collision before (Ctrl+←)"));
    m_previous->setAccessibleName(tr("The collision before"));
    m_next->setToolTip(tr("The next collision (Ctrl+→)"));
    m_next->setAccessibleName(tr("The next collision"));
    m_partners->setToolTip(
        tr("Digits left: so many decimal digits of this collision's triangle and velocities are "
           "right. Every collision makes the rounding errors before it grow."));
    m_go->setText(tr("Go to the first collision"));
    m_go->setToolTip(tr("Go to the first collision (Ctrl+→)"));
    m_go->setAccessibleName(m_go->text());
    showSelection();
}

void StepPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void StepPanel::showHead(const Collision& c) {
    const Scene& scene = m_session.scene();
    const auto name = [&](int body, Ink ink) {
        const bool ball = scene.bodies[std::size_t(body)].kind == BodyKind::Ball;
        const QString dot = ball ? QStringLiteral("●") : QStringLiteral("○");
        return coloured(m_appearance.textInk(ink),
                        QStringLiteral("%1&nbsp;%2").arg(dot, bodyName(scene, body).toHtmlEscaped()));
    };
    const QString second =
        c.isWall() ? coloured(m_appearance.textInk(Ink::Second), partnerName(scene, c).toHtmlEscaped())
                   : name(c.second, Ink::Second);
    QStringList facts{QStringLiteral("%1 → %2").arg(name(c.first, Ink::First), second),
                      QStringLiteral("<i>t</i>&nbsp;=&nbsp;%1&nbsp;s").arg(numberText(c.time))};
    if (const auto digits = m_trust.digitsLeft(m_session.run(), m_session.part().collisionsBefore == 0,
                                               *m_playhead.selected()))
        facts << coloured(m_appearance.quietText(),
                          tr("digits left: %1").arg(*digits).replace(' ', "&nbsp;"));
    m_partners->setText(facts.join(QStringLiteral(" · ")));
    m_instant->showCollision(*m_playhead.selected());
    showPlace();
}

void StepPanel::showPlaying() {
    const bool playing = m_player.playing();
    const int side = m_play->iconSize().width();
    m_play->setIcon(playsStages(playing, m_appearance.accent(), side));
    const QString words = playing ? tr("Hold this step (S)") : tr("Play the steps, each held a while (S)");
    m_play->setToolTip(words);
    m_play->setAccessibleName(words);
}

// How many there are is said when it is known.
void StepPanel::showPlace() {
    const auto number = m_playhead.selectedNumber();
    if (!number)
        return;
    const RunPart part = m_session.part();
    const QString text = countText(*number);
    m_title->setText(part.ended ? tr("Collision %1 of %2").arg(text, countText(part.collisionCount))
                                : tr("Collision %1").arg(text));
    m_previous->setEnabled(m_playhead.canStepCollisions(-1));
    m_next->setEnabled(m_playhead.canStepCollisions(1));
}

void StepPanel::invite(bool any) {
    m_invitation->setText(any ? tr("Open a collision and see, step by step, how it comes out.")
                              : tr("Nothing collides in this run."));
    m_hint->setText(any ? tr("Or press Ctrl+→, or click a collision on the time line.")
                        : tr("Change a velocity or a position so that two bodies meet."));
    m_go->setVisible(any);
}

void StepPanel::showSelection() {
    const auto run = m_session.run();
    const auto collisions = run->timeline.collisions();
    const auto selected = m_playhead.selected();
    invite(m_session.part().collisionCount > 0);
    if (!selected || *selected >= collisions.size()) {
        m_pages->setCurrentIndex(0);
        return;
    }
    const Collision& collision = collisions[*selected];
    showHead(collision);
    const auto steps = workedSteps(run->scene, collisions, *selected);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        m_cards[i]->setStep(steps[i], run, *selected);
        m_cards[i]->setOpen(Stage(i) == m_playhead.stage(), false);
    }
    const bool focusLeaves = m_go->hasFocus();
    m_pages->setCurrentIndex(1);
    if (focusLeaves)
        setFocus();
    arrangeCards();
}

void StepPanel::showStage() {
    for (StepCard* card : m_cards)
        card->setOpen(card->stage() == m_playhead.stage(), true);
    arrangeCards();
}

// One below the other, and the open one in sight: its header always, its body as far as there is room.
void StepPanel::arrangeCards() {
    const int width = m_scroll->viewport()->width();
    const int page = m_scroll->viewport()->height();
    int y = 0;
    int top = 0;
    int bottom = 0;
    for (StepCard* card : m_cards) {
        card->setPageHeight(page);
        const int height = card->heightForWidth(width);
        card->setGeometry(0, y, width, height);
        if (card->isOpen()) {
            top = y;
            bottom = y + height;
        }
        y += height;
    }
    m_scroll->widget()->resize(width, y);
    QScrollBar* bar = m_scroll->verticalScrollBar();
    if (bottom > bar->value() + page)
        bar->setValue(bottom - page);
    if (top < bar->value() || bottom - top > page)
        bar->setValue(top);
}

bool StepPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == m_scroll->viewport())
        arrangeCards();
    if (event->type() == QEvent::KeyPress && watched == m_scroll) {
        event->ignore();
        keyPressEvent(static_cast<QKeyEvent*>(event));
        if (event->isAccepted())
            return true;
    }
    return QWidget::eventFilter(watched, event);
}

void StepPanel::keyPressEvent(QKeyEvent* event) {
    const bool plain = event->modifiers() == Qt::NoModifier || event->modifiers() == Qt::KeypadModifier;
    if (m_playhead.selected() && plain && (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down)) {
        m_playhead.stepStage(event->key() == Qt::Key_Down ? 1 : -1);
        event->accept();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void StepPanel::paintEvent(QPaintEvent*) {
    QPainter(this).fillRect(rect(), m_appearance.window());
}

} // namespace thetalane
