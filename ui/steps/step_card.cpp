#include "ui/steps/step_card.h"

#include <QPainter>
#include <QStyle>

#include <cmath>

namespace thetalane {

StepCard::StepCard(const Appearance& appearance, Stage stage, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_stage(stage)
    , m_header(new StepHeader(appearance, stage, this))
    , m_body(new QWidget(this))
    , m_figure(new StepFigure(appearance, stage, m_body))
    , m_formulas(new FormulaView(appearance, m_body))
    , m_sentence(new QLabel(m_body)) {
    setObjectName(QStringLiteral("stepCard%1").arg(int(stage)));
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_sentence->setObjectName(QStringLiteral("stepSentence%1").arg(int(stage)));
    m_sentence->setWordWrap(true);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_sentence->setFocusPolicy(Qt::NoFocus);
    m_animation.setDuration(250);
    m_animation.setEasingCurve(QEasingCurve::InOutCubic);
    connect(m_header, &StepHeader::clicked, this, [this] { emit chosen(m_stage); });
    connect(&m_animation, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
        m_opened = value.toDouble();
        m_body->setVisible(m_opened > 0);
        updateGeometry();
        arrange();
        emit grew();
    });
    connect(&appearance, &Appearance::changed, this, &StepCard::applyAppearance);
    m_body->hide();
    applyAppearance();
}

void StepCard::applyAppearance() {
    m_sentence->setFont(m_appearance.font(Appearance::Size::Normal));
    updateGeometry();
    arrange();
    update();
}

void StepCard::setStep(const WorkedStep& step, std::shared_ptr<const Run> run, std::size_t collision) {
    m_header->setKey(step.lines[step.key]);
    m_formulas->setLines(step.lines);
    m_sentence->setText(step.sentence);
    m_figure->setCollision(std::move(run), collision);
    updateGeometry();
    arrange();
}

void StepCard::setOpen(bool open, bool animated) {
    if (open == m_open && m_animation.state() != QAbstractAnimation::Running)
        return;
    m_open = open;
    m_header->setCurrent(open);
    m_animation.stop();
    const bool moves = animated && isVisible() && !m_appearance.reducedMotion() &&
                       style()->styleHint(QStyle::SH_Widget_Animation_Duration) > 0;
    if (moves) {
        m_animation.setStartValue(m_opened);
        m_animation.setEndValue(open ? 1.0 : 0.0);
        m_animation.start();
    } else {
        m_opened = open ? 1 : 0;
        m_body->setVisible(open);
        arrange();
        emit grew();
    }
    update();
}

void StepCard::setPageHeight(int page) {
    m_figure->setMostHeight(page * 2 / 5);
}

int StepCard::bodyHeight(int width) const {
    const int unit = m_appearance.unit();
    const int inner = width - 4 * unit;
    return m_figure->heightForWidth(inner) + unit + m_sentence->heightForWidth(inner) + unit +
           m_formulas->heightForWidth(inner) + 2 * unit;
}

int StepCard::heightForWidth(int width) const {
    return headerHeight() + (m_opened > 0 ? int(std::lround(m_opened * bodyHeight(width))) : 0);
}

QSize StepCard::sizeHint() const {
    return {width(), heightForWidth(width())};
}

QSize StepCard::minimumSizeHint() const {
    return {200, heightForWidth(width())};
}

// The body keeps its full size while the card opens over it.
void StepCard::arrange() {
    const int unit = m_appearance.unit();
    const int inner = width() - 4 * unit;
    m_header->setGeometry(0, 0, width(), headerHeight());
    if (m_opened == 0)
        return;
    m_body->setGeometry(0, headerHeight(), width(), heightForWidth(width()) - headerHeight());
    int y = 0;
    const auto put = [&](QWidget* widget, int height) {
        widget->setGeometry(2 * unit, y, inner, height);
        y += height + unit;
    };
    put(m_figure, m_figure->heightForWidth(inner));
    put(m_sentence, m_sentence->heightForWidth(inner));
    put(m_formulas, m_formulas->heightForWidth(inner));
}

void StepCard::resizeEvent(QResizeEvent*) {
    arrange();
}

void StepCard::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (m_open || m_opened > 0) {
        painter.fillRect(rect(), m_appearance.card());
        painter.fillRect(QRectF(0, 0, m_appearance.projector() ? 5 : 3, height()), m_appearance.accent());
    }
    painter.fillRect(QRectF(0, height() - 1, width(), 1), m_appearance.line());
}

} // namespace thetalane
