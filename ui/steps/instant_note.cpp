#include "ui/steps/instant_note.h"

#include "ui/count_text.h"

#include <QEvent>
#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace thetalane {

using Size = Appearance::Size;

InstantLink::InstantLink(const Appearance& appearance, const QString& name, QWidget* parent)
    : QAbstractButton(parent)
    , m_appearance(appearance) {
    setObjectName(name);
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::TabFocus);
}

QSize InstantLink::sizeHint() const {
    const QFontMetrics metrics(m_appearance.font(Size::Normal));
    return {metrics.horizontalAdvance(text()) + 2 * m_appearance.unit(), m_appearance.projector() ? 36 : 24};
}

void InstantLink::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor accent = m_appearance.accent();
    QColor wash = accent;
    wash.setAlphaF(isChecked() || underMouse() ? 0.16f : 0.08f);
    painter.setPen(hasFocus() ? QPen(accent, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(wash);
    const QRectF pill = QRectF(rect()).adjusted(1, 1.5, -1, -1.5);
    painter.drawRoundedRect(pill, pill.height() / 2, pill.height() / 2);
    painter.setPen(accent);
    painter.setFont(m_appearance.font(Size::Normal));
    const QFontMetrics metrics(painter.font());
    const int room = width() - m_appearance.unit();
    painter.drawText(rect(), Qt::AlignCenter, metrics.elidedText(text(), Qt::ElideRight, room));
}

InstantNote::InstantNote(const Context& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_place(new QLabel(this))
    , m_why(new InstantLink(context.appearance, QStringLiteral("whyTogether"), this))
    , m_rule(new QLabel(this))
    , m_with(new QLabel(this)) {
    setObjectName(QStringLiteral("instantNote"));
    // Not Fixed: that would be the height for the width it has before it is laid out.
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_place->setObjectName(QStringLiteral("instantPlace"));
    m_rule->setObjectName(QStringLiteral("instantRule"));
    m_with->setObjectName(QStringLiteral("instantWith"));
    for (QLabel* label : {m_place, m_rule}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_rule->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_rule->setFocusPolicy(Qt::NoFocus);
    m_rule->hide();
    m_why->setCheckable(true);
    connect(m_why, &QAbstractButton::toggled, this, &InstantNote::explain);
    connect(&context.appearance, &Appearance::changed, this, &InstantNote::applyAppearance);
    applyAppearance();
    hide();
}

void InstantNote::applyAppearance() {
    const Appearance& look = m_context.appearance;
    const QString quiet = QStringLiteral("color: %1").arg(look.quietText().name());
    for (QLabel* label : {m_place, m_rule, m_with})
        label->setFont(look.font(Size::Normal));
    m_place->setStyleSheet(quiet);
    m_with->setStyleSheet(quiet);
    updateGeometry();
    arrange(width(), true);
}

void InstantNote::showCollision(std::size_t index) {
    const auto collisions = m_context.session.timeline().collisions();
    m_index = index;
    m_instant = instantOf(collisions, index);
    makeLinks();
    say();
    setVisible(m_instant.size > 1);
}

void InstantNote::explain(bool on) {
    m_why->setChecked(on);
    m_rule->setVisible(on);
    updateGeometry();
    arrange(width(), true);
    emit grew();
}

// One for each of the others in the pass; where they are very many, for those nearest in the list.
void InstantNote::makeLinks() {
    for (InstantLink* link : m_links) {
        link->hide();
        link->deleteLater(); // it may be the one that was pressed
    }
    m_links.clear();
    const std::size_t shown = std::min(m_instant.passSize, mostLinks + 1);
    const std::size_t last = m_instant.passBegin + m_instant.passSize - shown;
    const std::size_t half = mostLinks / 2;
    const std::size_t begin = std::clamp(m_index > half ? m_index - half : 0, m_instant.passBegin, last);
    for (std::size_t k = begin; k < begin + shown; ++k) {
        if (k == m_index)
            continue;
        auto* link = new InstantLink(m_context.appearance, QStringLiteral("passContact%1").arg(k), this);
        connect(link, &QAbstractButton::clicked, this, [this, k] { m_context.playhead.select(k); });
        link->setVisible(true);
        m_links.push_back(link);
    }
}

void InstantNote::say() {
    m_place->setText(instantText(m_instant, m_index));
    m_why->setText(instantQuestion(m_instant));
    m_why->setAccessibleName(instantQuestion(m_instant));
    const QString rule = instantRule(m_instant, m_context.session.run()->settings);
    m_why->setToolTip(rule);
    m_rule->setText(rule);
    const auto collisions = m_context.session.timeline().collisions();
    const int more = int(m_instant.passSize - 1 - m_links.size());
    m_with->setText(more > 0 ? tr("Together with, among %n others:", nullptr, more + int(m_links.size()))
                             : tr("Together with:"));
    m_with->setVisible(!m_links.empty());
    for (InstantLink* link : m_links) {
        const std::size_t k = link->objectName().mid(11).toULongLong();
        if (k >= collisions.size())
            continue; // another run is about to come
        link->setText(contactName(m_context.session.scene(), collisions[k]));
        const QString number = countText(m_context.session.part().collisionsBefore + std::int64_t(k) + 1);
        link->setToolTip(tr("Open collision %1, resolved together with this one").arg(number));
        link->setAccessibleName(tr("Open collision %1: %2").arg(number, link->text()));
    }
    updateGeometry();
    arrange(width(), true);
}

// Words and links one after the other, in as many rows as it takes.
int InstantNote::arrange(int width, bool place) const {
    const int unit = m_context.appearance.unit();
    const auto full = [&](QLabel* label, int y) {
        const int height = label->heightForWidth(width);
        if (place)
            label->setGeometry(0, y, width, height);
        return y + height;
    };
    int y = full(m_place, 0) + unit / 2;
    int x = 0, row = 0;
    const auto put = [&](QWidget* widget, QSize size) {
        size.setWidth(std::min(size.width(), width));
        if (x > 0 && x + size.width() > width) {
            y += row + unit / 2;
            x = row = 0;
        }
        row = std::max(row, size.height());
        if (place)
            widget->setGeometry(x, y, size.width(), size.height());
        x += size.width() + unit / 2;
    };
    if (!m_links.empty())
        put(m_with, {m_with->sizeHint().width(), m_why->sizeHint().height()});
    for (InstantLink* link : m_links)
        put(link, link->sizeHint());
    put(m_why, m_why->sizeHint());
    y += row;
    return m_rule->isHidden() ? y : full(m_rule, y + unit / 2);
}

int InstantNote::heightForWidth(int width) const {
    return arrange(width, false);
}

QSize InstantNote::sizeHint() const {
    return {240, heightForWidth(std::max(width(), 240))};
}

// A label within wants another height: when it is first shown, it is given its style.
bool InstantNote::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        updateGeometry();
        arrange(width(), true);
    }
    return QWidget::event(event);
}

void InstantNote::resizeEvent(QResizeEvent*) {
    arrange(width(), true);
}

void InstantNote::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void InstantNote::retranslate() {
    if (!isHidden())
        say();
}

} // namespace thetalane
