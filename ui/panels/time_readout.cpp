#include "ui/panels/time_readout.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

QString secondsText(double time) {
    return QString::number(time, 'f', 3) + QStringLiteral(" s");
}

} // namespace

TimeReadout::TimeReadout(const Context& context, QWidget* parent)
    : Panel(context, parent) {
    setObjectName(QStringLiteral("timeReadout"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&playhead(), &Playhead::timeChanged, this, qOverload<>(&QWidget::update));
    connect(&session(), &Session::runChanged, this, [this] { updateGeometry(); });
    connect(&session(), &Session::progressed, this, [this] { updateGeometry(); });
    restyle();
    retranslate();
}

void TimeReadout::retranslate() {
    setAccessibleName(tr("Present time"));
    setToolTip(tr("Present time, in seconds of the run"));
}

void TimeReadout::restyle() {
    updateGeometry();
    update();
}

// Said at each use: a font set on the widget would not outlast a change of the application's style sheet.
QFont TimeReadout::readoutFont() const {
    return appearance().font(Appearance::Size::Large);
}

QString TimeReadout::text() const {
    return secondsText(playhead().time());
}

double TimeReadout::cellWidth() const {
    const QFontMetricsF metrics(readoutFont());
    double widest = 0;
    for (char digit = '0'; digit <= '9'; ++digit)
        widest = std::max(widest, metrics.horizontalAdvance(QLatin1Char(digit)));
    return widest;
}

double TimeReadout::widthOf(const QString& text) const {
    const QFontMetricsF metrics(readoutFont());
    const double cell = cellWidth();
    double width = 0;
    for (const QChar c : text)
        width += c.isDigit() ? cell : metrics.horizontalAdvance(c);
    return width;
}

QSize TimeReadout::sizeHint() const {
    const double longest = std::max(widthOf(secondsText(playhead().end())), widthOf(secondsText(0)));
    return {int(std::ceil(longest)) + 2, std::max(24, int(std::ceil(QFontMetricsF(readoutFont()).height())))};
}

void TimeReadout::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(readoutFont());
    const QFontMetricsF metrics(readoutFont());
    const QString shown = text();
    const double cell = cellWidth();
    const double baseline = (height() + metrics.ascent() - metrics.descent()) / 2;
    double x = width() - widthOf(shown); // held at the right, where the unit stands
    for (const QChar c : shown) {
        const double advance = metrics.horizontalAdvance(c);
        painter.setPen(c == u's' ? appearance().quietText() : appearance().text());
        painter.drawText(QPointF(x + (c.isDigit() ? (cell - advance) / 2 : 0), baseline), c);
        x += c.isDigit() ? cell : advance;
    }
}

} // namespace thetalane
