#include "ui/lessons/question_view.h"

#include "ui/lessons/card_button.h"
#include "ui/lessons/lesson_text.h"
#include "ui/panels/number_field.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

QLabel* wrappingLabel(const char* name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

void say(QLabel& label, const QString& words) {
    label.setText(keptWords(words));
    label.setAccessibleName(words);
    label.setVisible(!words.isEmpty());
}

} // namespace

QuestionView::QuestionView(const Context& context, std::function<std::optional<Vec2d>()> truth,
                           QWidget* parent)
    : Panel(context, parent)
    , m_truthSource(std::move(truth))
    , m_scroll(new QScrollArea(this))
    , m_again(new QPushButton)
    , m_column(new QVBoxLayout) {
    setObjectName(QStringLiteral("lessonQuestion"));
    auto* inside = new QWidget;
    inside->setLayout(m_column);
    m_text = wrappingLabel("questionText", inside);
    m_hint = wrappingLabel("questionHint", inside);
    m_verdict = wrappingLabel("questionVerdict", inside);
    m_why = wrappingLabel("questionWhy", inside);
    m_again->setObjectName(QStringLiteral("askAgain"));
    m_again->setProperty("quiet", true);
    m_column->addWidget(m_text);
    m_column->addWidget(m_hint);
    m_column->addWidget(m_verdict);
    m_column->addWidget(m_why);
    m_column->addWidget(m_again, 0, Qt::AlignLeft);
    m_column->addStretch(1);
    m_scroll->setWidget(inside);
    m_scroll->viewport()->installEventFilter(this); // it would be made as high as narrow text is
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_scroll);
    connect(m_again, &QPushButton::clicked, this, &QuestionView::askAgain);
    restyle();
    retranslate();
}

void QuestionView::setQuestion(const LessonQuestion& question, const Scene& scene) {
    m_question = question;
    m_scene = scene;
    build();
    askAgain();
}

void QuestionView::build() {
    delete m_answers;
    m_options.clear();
    m_fields.clear();
    m_fieldNames.clear();
    m_answers = new QWidget;
    auto* column = new QVBoxLayout(m_answers);
    column->setContentsMargins(0, 0, 0, 0);
    m_column->insertWidget(2, m_answers);
    for (std::size_t k = 0; k < m_question.options.size(); ++k) {
        auto* option = new CardButton(appearance(), QStringLiteral("option%1").arg(k), m_answers);
        connect(option, &QAbstractButton::clicked, this, [this, k] { choose(int(k)); });
        column->addWidget(option);
        m_options.push_back(option);
    }
    const int fields = m_question.kind == QuestionKind::Choice ? 0
                       : isVector(m_question.quantity.kind)    ? 2
                                                               : 1;
    for (int k = 0; k < fields; ++k) {
        auto* row = new QHBoxLayout;
        auto* name = new QLabel(m_answers);
        auto* number = new NumberField(appearance(), QStringLiteral("answer%1").arg(k), m_answers);
        number->setUnit(quantityUnit(m_question.quantity.kind));
        connect(number, &NumberField::edited, this, [this] {
            m_entered = true;
            showState();
        });
        connect(number, &NumberField::becameUnreadable, this, [this] {
            m_entered = true;
            showState();
        });
        // After the number was taken over, which Return does as well.
        connect(number->edit(), &QLineEdit::returnPressed, this, [this] {
            m_entered = true;
            QTimer::singleShot(0, this, [this] {
                if (!m_revealed)
                    reveal();
            });
        });
        row->addWidget(name);
        row->addWidget(number, 1);
        column->addLayout(row);
        m_fieldNames.push_back(name);
        m_fields.push_back(number);
    }
    restyle();
    retranslate();
}

void QuestionView::choose(int option) {
    if (m_revealed)
        return;
    m_chosen = option;
    showState();
}

std::optional<Vec2d> QuestionView::typed() const {
    for (const NumberField* f : m_fields)
        if (!f->unreadable().isEmpty())
            return std::nullopt;
    if (m_fields.empty() || !m_entered)
        return std::nullopt;
    return Vec2d{m_fields[0]->value(), m_fields.size() > 1 ? m_fields[1]->value() : 0};
}

void QuestionView::reveal() {
    const auto answer = typed();
    if (m_revealed || (m_entered && !answer))
        return showState();
    m_truth = m_truthSource();
    m_isRight = m_question.kind == QuestionKind::Choice
                    ? m_chosen == int(m_question.right)
                    : answer && m_truth && thetalane::isRight(m_question, *m_truth, *answer);
    m_revealed = true;
    showState();
    emit revealChanged();
}

void QuestionView::askAgain() {
    m_revealed = false;
    m_chosen = -1;
    m_entered = false;
    m_truth.reset();
    for (NumberField* f : m_fields)
        f->setValue(0);
    showState();
    emit revealChanged();
}

void QuestionView::showState() {
    for (std::size_t k = 0; k < m_options.size(); ++k) {
        const bool isChosen = m_chosen == int(k);
        auto state = isChosen ? CardButton::State::Chosen : CardButton::State::Plain;
        if (m_revealed && k == m_question.right)
            state = CardButton::State::Right;
        else if (m_revealed && isChosen)
            state = CardButton::State::Wrong;
        m_options[k]->setState(state);
        m_options[k]->setVisible(!m_revealed || isChosen || k == m_question.right); // to the point
    }
    QString unreadable;
    for (NumberField* f : m_fields) {
        f->setWrong(!f->unreadable().isEmpty());
        f->edit()->setReadOnly(m_revealed);
        if (unreadable.isEmpty())
            unreadable = f->unreadable();
    }
    m_again->setText(tr("Ask again"));
    m_again->setToolTip(tr("Hides the answer, for the next who predicts"));
    m_again->setAccessibleName(m_again->text());
    m_again->setVisible(m_revealed);
    // Options say for themselves that one is to be chosen.
    const bool types = !m_revealed && !m_fields.empty();
    say(*m_hint, !unreadable.isEmpty() ? unreadable
                 : types               ? tr("Type what you expect, then reveal.")
                                       : QString());
    showVerdict();
    fit();
}

void QuestionView::showVerdict() {
    say(*m_verdict, m_revealed ? verdictText() : QString());
    say(*m_why, m_revealed ? inLanguageOfNow(m_question.answer) : QString());
    const QColor colour = m_isRight ? appearance().textInk(Ink::Along) : appearance().text();
    m_verdict->setStyleSheet(QStringLiteral("color: %1;").arg(colour.name()));
}

QString QuestionView::verdictText() const {
    const bool isChoice = m_question.kind == QuestionKind::Choice;
    if (isChoice || !m_truth) // the marks beside the options say it
        return {};
    const QString truth = valueText(m_question.quantity.kind, *m_truth);
    if (m_isRight)
        return tr("✓ Right: %1").arg(truth);
    const auto answer = typed();
    return answer ? tr("✗ It is %1, not %2.").arg(truth, valueText(m_question.quantity.kind, *answer))
                  : tr("It is %1.").arg(truth);
}

bool QuestionView::isWhole() const {
    return m_scroll->widget()->height() <= m_scroll->viewport()->height();
}

void QuestionView::retranslate() {
    say(*m_text, inLanguageOfNow(m_question.text));
    for (std::size_t k = 0; k < m_options.size(); ++k) {
        m_options[k]->setMark(QString(QChar(u'A' + int(k))));
        const QString words = inLanguageOfNow(m_question.options[k]);
        m_options[k]->setWords(words, {}, tr("Choose: %1").arg(words));
    }
    const QString name = quantityName(m_scene, m_question.quantity);
    for (std::size_t k = 0; k < m_fields.size(); ++k) {
        const QString axis = m_fields.size() == 1 ? QString()
                             : k == 0             ? QStringLiteral("x")
                                                  : QStringLiteral("y");
        m_fieldNames[k]->setText(axis.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, axis));
        m_fields[k]->setWords(m_fieldNames[k]->text(), tr("What you expect; Return reveals the truth"));
    }
    showState();
}

void QuestionView::restyle() {
    Panel::restyle();
    const Appearance& look = appearance();
    const int unit = look.unit();
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(unit);
    makeQuiet(*m_hint, look);
    m_again->setFont(look.font(Appearance::Size::Small));
    m_verdict->setFont(look.font(Appearance::Size::Large, true));
    m_why->setFont(look.font(Appearance::Size::Large));
    m_text->setStyleSheet(QStringLiteral("color: %1;").arg(look.text().name()));
    m_why->setStyleSheet(m_text->styleSheet());
    for (QLabel* name : m_fieldNames)
        name->setFont(look.font(Appearance::Size::Normal));
    if (m_answers)
        m_answers->layout()->setSpacing(unit / 2);
    showVerdict();
    fit();
}

bool QuestionView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_scroll->viewport() && event->type() == QEvent::Resize)
        fit();
    return Panel::eventFilter(watched, event);
}

// The question in letters as large as its options leave room for; once answered, the answer comes first.
void QuestionView::fit() {
    using Size = Appearance::Size;
    const int largest = appearance().pixels(m_revealed ? Size::Normal : Size::Large);
    const QSize room = m_scroll->viewport()->size();
    QFont font = appearance().font(Size::Large, true);
    int height = 0;
    for (int pixels = largest; pixels >= appearance().pixels(Size::Normal); pixels -= 2) {
        font.setPixelSize(pixels);
        m_text->setFont(font);
        m_column->invalidate();
        height = m_column->totalHeightForWidth(room.width());
        if (height <= room.height())
            break;
    }
    m_scroll->widget()->resize(room.width(), std::max(height, room.height()));
    m_column->activate();
}

} // namespace thetalane
