#include "ui/lessons/lesson_panel.h"

#include "ui/lessons/big_text.h"
#include "ui/lessons/card_button.h"
#include "ui/lessons/lesson_shelf.h"
#include "ui/lessons/lesson_text.h"
#include "ui/lessons/progress_dots.h"
#include "ui/lessons/question_view.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace thetalane {
namespace {

QPushButton* button(const char* name, QWidget* parent, const char* kind = nullptr) {
    auto* b = new QPushButton(parent);
    b->setObjectName(QLatin1String(name));
    if (kind)
        b->setProperty(kind, true);
    return b;
}

void setWords(QPushButton& b, const QString& text, const QString& toolTip) {
    b.setText(text);
    b.setToolTip(toolTip);
    b.setAccessibleName(text);
}

} // namespace

LessonPanel::LessonPanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_player(new LessonPlayer(context, this))
    , m_stack(new QStackedWidget(this)) {
    setObjectName(QStringLiteral("lessonPanel"));
    m_stack->addWidget(makeShelf());
    m_stack->addWidget(makeLesson(context));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);
    makeShortcuts();
    connect(m_player, &LessonPlayer::started, this, [this] {
        m_stack->setCurrentIndex(1);
        emit running(true);
    });
    connect(m_player, &LessonPlayer::left, this, &LessonPanel::showShelf);
    connect(m_player, &LessonPlayer::pageChanged, this, &LessonPanel::showPage);
    connect(m_player, &LessonPlayer::changed, m_changed, &QWidget::setVisible);
    connect(m_player, &LessonPlayer::showRequested, this, &LessonPanel::showRequested);
    restyle();
    retranslate();
}

QWidget* LessonPanel::makeShelf() {
    auto* inside = new QWidget;
    m_shelfColumn = new QVBoxLayout(inside);
    m_heading = new QLabel(inside);
    m_heading->setObjectName(QStringLiteral("lessonsHeading"));
    m_message = new QLabel(inside);
    m_message->setObjectName(QStringLiteral("lessonFileMessage"));
    m_shelfColumn->addWidget(m_heading);
    m_shelfColumn->addWidget(m_message);
    for (int k = 0; k < int(builtInLessons().size()); ++k) {
        auto* card = new CardButton(appearance(), QStringLiteral("lesson%1").arg(k), inside);
        connect(card, &QAbstractButton::clicked, this, [this, k] { giveLesson(k); });
        m_shelfColumn->addWidget(card);
        m_cards.push_back(card);
    }
    m_openFile = button("openLessonFile", inside, "quiet");
    connect(m_openFile, &QPushButton::clicked, this, &LessonPanel::chooseFile);
    m_shelfColumn->addWidget(m_openFile, 0, Qt::AlignLeft);
    m_shelfColumn->addStretch(1);
    m_shelf = new QScrollArea(this);
    m_shelf->setObjectName(QStringLiteral("lessonShelf"));
    m_shelf->setWidget(inside);
    m_shelf->setWidgetResizable(true);
    m_shelf->setFrameShape(QFrame::NoFrame);
    m_shelf->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_shelf->setFocusPolicy(Qt::NoFocus);
    return m_shelf;
}

QWidget* LessonPanel::makeLesson(const Context& context) {
    m_lesson = new QWidget;
    m_leave = button("leaveLesson", m_lesson, "quiet");
    m_title = new QLabel(m_lesson);
    m_title->setObjectName(QStringLiteral("lessonTitle"));
    m_title->setWordWrap(true);
    m_dots = new ProgressDots(appearance(), m_lesson);
    m_text = new BigText(appearance(), QStringLiteral("lessonText"));
    m_question = new QuestionView(context, [this] { return m_player->truth(); });
    m_body = new QStackedWidget(m_lesson);
    m_body->addWidget(m_text);
    m_body->addWidget(m_question);
    m_changed = new QWidget(m_lesson);
    m_changed->hide();
    m_changedNote = new QLabel(m_changed);
    m_changedNote->setObjectName(QStringLiteral("lessonChanged"));
    m_changedNote->setWordWrap(true);
    m_putBack = button("putLessonBack", m_changed);
    auto* changed = new QHBoxLayout(m_changed);
    changed->setContentsMargins(0, 0, 0, 0);
    changed->addWidget(m_changedNote, 1);
    changed->addWidget(m_putBack);
    m_back = button("lessonBack", m_lesson);
    m_next = button("lessonNext", m_lesson, "prominent");
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_back);
    foot->addWidget(m_next, 1);
    m_lessonColumn = new QVBoxLayout(m_lesson);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_leave);
    m_lessonColumn->addLayout(head);
    m_lessonColumn->addWidget(m_body, 1);
    m_lessonColumn->addWidget(m_changed);
    m_lessonColumn->addWidget(m_dots);
    m_lessonColumn->addLayout(foot);
    connect(m_leave, &QPushButton::clicked, m_player, &LessonPlayer::leave);
    connect(m_back, &QPushButton::clicked, m_player, &LessonPlayer::back);
    connect(m_next, &QPushButton::clicked, this, [this] {
        const bool isLast = m_player->page() + 1 == m_player->pageCount() && !m_player->travelling();
        isLast && !asks() ? m_player->leave() : goOn();
    });
    connect(m_question, &QuestionView::revealChanged, this, &LessonPanel::showPage);
    connect(m_putBack, &QPushButton::clicked, m_player, &LessonPlayer::putBack);
    connect(m_dots, &ProgressDots::chosen, m_player, &LessonPlayer::goTo);
    return m_lesson;
}

// Of the window, while a lesson is given: the class looks at the lane, and so may the focus.
void LessonPanel::makeShortcuts() {
    const auto add = [this](int key, auto&& turn) {
        auto* shortcut = new QShortcut(QKeySequence(key), this);
        shortcut->setEnabled(false);
        connect(shortcut, &QShortcut::activated, this, turn);
        connect(this, &LessonPanel::running, shortcut, &QShortcut::setEnabled);
    };
    add(Qt::Key_PageDown, [this] { goOn(); });
    add(Qt::Key_PageUp, [this] { m_player->back(); });
}

bool LessonPanel::asks() const {
    return m_player->isQuestion() && !m_question->isRevealed();
}

// A question is revealed before the next page tells.
void LessonPanel::goOn() {
    asks() ? m_question->reveal() : m_player->next();
}

bool LessonPanel::isShelf() const {
    return m_stack->currentIndex() == 0;
}

void LessonPanel::giveLesson(int index) {
    give(builtInLessons()[std::size_t(index)]);
}

void LessonPanel::give(const Lesson& lesson) {
    if (m_mayOpen && !m_mayOpen())
        return;
    m_error = nullptr;
    showError();
    if (lesson.question)
        m_question->setQuestion(*lesson.question, lesson.settings[lesson.question->setting].scene);
    m_player->start(lesson);
    m_next->setFocus();
}

void LessonPanel::chooseFile() {
    auto* dialog = new QFileDialog(this, tr("Open a lesson file"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilters({tr("Lesson files (*.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &LessonPanel::openFile);
    dialog->open();
}

bool LessonPanel::openFile(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        m_error = [text = name + QStringLiteral(": ") + file.errorString()] { return text; };
        showError();
        return false;
    }
    const auto read = readLesson(file.readAll());
    if (const auto* lesson = std::get_if<Lesson>(&read)) {
        give(*lesson);
        return true;
    }
    m_error = [name, e = std::get<std::vector<LessonError>>(read).front()] {
        return name + QStringLiteral(": ") + lessonErrorText(e);
    };
    showError();
    return false;
}

void LessonPanel::showError() {
    m_message->setText(m_error ? m_error() : QString());
    makeMessage(*m_message, appearance());
    if (m_error)
        m_shelf->ensureWidgetVisible(m_message);
}

void LessonPanel::showShelf() {
    emit asking(false);
    m_stack->setCurrentIndex(0);
    m_changed->hide();
    if (!m_cards.empty())
        m_cards.front()->setFocus();
    emit running(false);
}

void LessonPanel::showPage() {
    if (!m_player->running())
        return;
    const Lesson& lesson = m_player->lesson();
    m_title->setText(keptWords(inLanguageOfNow(lesson.title)));
    m_dots->setPages(m_player->pageCount(), m_player->questionPage());
    m_dots->setPage(m_player->page());
    if (const LessonStop* stop = m_player->stop())
        m_text->setWords(inLanguageOfNow(stop->text));
    m_body->setCurrentIndex(m_player->isQuestion() ? 1 : 0);
    m_changed->setVisible(m_player->isChanged());
    m_back->setEnabled(m_player->page() > 0);
    emit asking(asks());
    const bool isLast = m_player->page() + 1 == m_player->pageCount();
    setWords(*m_back, tr("Back"), tr("The page before (Page Up)"));
    if (asks())
        setWords(*m_next, tr("Reveal"), tr("Shows what happens, and why (Page Down)"));
    else if (isLast)
        setWords(*m_next, tr("Finish"), tr("Leaves the lesson; its scene stays, to go on with"));
    else
        setWords(*m_next, tr("Next"), tr("The next page (Page Down)"));
}

void LessonPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_player->running())
        return m_player->leave();
    Panel::keyPressEvent(event);
}

void LessonPanel::retranslate() {
    setAccessibleName(tr("Lessons"));
    m_heading->setText(tr("Lessons"));
    for (std::size_t k = 0; k < m_cards.size(); ++k) {
        const Lesson& lesson = builtInLessons()[k];
        m_cards[k]->setMark(QString::number(k + 1));
        const QString title = inLanguageOfNow(lesson.title);
        m_cards[k]->setWords(title, inLanguageOfNow(lesson.summary), tr("Give the lesson: %1").arg(title));
    }
    setWords(*m_openFile, tr("Open a lesson file…"), tr("A lesson that you wrote in a text editor"));
    setWords(*m_leave, tr("All lessons"), tr("Leaves the lesson; its scene stays, to go on with"));
    m_changedNote->setText(keptWords(tr("The scene was changed: the words may no longer fit.")));
    setWords(*m_putBack, tr("Put back"), tr("The scene of this page, as the lesson has it"));
    showError();
    showPage();
}

void LessonPanel::restyle() {
    Panel::restyle();
    using Size = Appearance::Size;
    const Appearance& look = appearance();
    const int unit = look.unit();
    m_shelfColumn->setContentsMargins(2 * unit, unit, 2 * unit, unit);
    m_shelfColumn->setSpacing(unit);
    m_heading->setFont(look.font(Size::Title, true));
    m_lessonColumn->setContentsMargins(2 * unit, unit / 2, 2 * unit, unit);
    m_lessonColumn->setSpacing(unit / 2);
    m_lesson->layout()->itemAt(0)->layout()->setSpacing(unit);
    m_leave->setFont(look.font(Size::Small));
    m_openFile->setFont(look.font(Size::Normal));
    m_title->setFont(look.font(Size::Normal, true));
    m_title->setStyleSheet(QStringLiteral("color: %1;").arg(look.quietText().name()));
    makeQuiet(*m_changedNote, look);
    m_putBack->setFont(look.font(Size::Small));
    for (QPushButton* b : {m_back, m_next})
        b->setFont(look.font(Size::Large, b == m_next));
    makeMessage(*m_message, look);
}

} // namespace thetalane
