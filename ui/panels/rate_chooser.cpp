#include "ui/panels/rate_chooser.h"

#include "ui/panels/icon_button.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

int indexOf(double rate) {
    const auto& rates = Playhead::rates;
    const auto nearest = std::min_element(rates.begin(), rates.end(), [rate](double a, double b) {
        return std::abs(a - rate) < std::abs(b - rate);
    });
    return int(nearest - rates.begin());
}

} // namespace

QString rateText(double rate) {
    return rate < 1 ? QStringLiteral("1/%1×").arg(std::lround(1 / rate)) : QStringLiteral("%1×").arg(rate);
}

RateChooser::RateChooser(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_slower(new IconButton(context.appearance, Icon::Minus, "slowerButton", this))
    , m_faster(new IconButton(context.appearance, Icon::Plus, "fasterButton", this))
    , m_rate(new QLabel(this)) {
    m_rate->setObjectName(QStringLiteral("rateLabel"));
    m_rate->setAlignment(Qt::AlignCenter);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    for (QWidget* part :
         {static_cast<QWidget*>(m_slower), static_cast<QWidget*>(m_rate), static_cast<QWidget*>(m_faster)})
        layout->addWidget(part);
    connect(m_slower, &QAbstractButton::clicked, this, [this] { step(-1); });
    connect(m_faster, &QAbstractButton::clicked, this, [this] { step(1); });
    connect(&playhead(), &Playhead::rateChanged, this, &RateChooser::showRate);
    restyle();
    retranslate();
}

void RateChooser::retranslate() {
    m_slower->setWords(tr("Slower"), tr("Slower"));
    m_faster->setWords(tr("Faster"), tr("Faster"));
    m_rate->setToolTip(tr("How fast time goes"));
    m_rate->setAccessibleName(tr("How fast time goes"));
    showRate();
}

void RateChooser::restyle() {
    Panel::restyle();
    m_rate->setFont(font());
    m_rate->setFixedWidth(QFontMetrics(font()).horizontalAdvance(QStringLiteral("1/32×")) + 4);
}

void RateChooser::showRate() {
    const int index = indexOf(playhead().rate());
    m_rate->setText(rateText(playhead().rate()));
    m_slower->setEnabled(index > 0);
    m_faster->setEnabled(index + 1 < int(Playhead::rates.size()));
}

void RateChooser::step(int by) {
    const int index = std::clamp(indexOf(playhead().rate()) + by, 0, int(Playhead::rates.size()) - 1);
    playhead().setRate(Playhead::rates[std::size_t(index)]);
}

} // namespace thetalane
