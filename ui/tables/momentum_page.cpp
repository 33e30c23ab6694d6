#include "ui/tables/momentum_page.h"

#include "ui/tables/collision_sheet.h"
#include "ui/tables/momentum_figure.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QLabel>
#include <QVBoxLayout>

namespace thetalane {
namespace {

QString vectorText(const Vec2d& v, double scale) {
    const auto part = [scale](double x) {
        return isRounding(x, scale) ? QStringLiteral("0") : numberText(x); // what rounding leaves of nothing
    };
    return QStringLiteral("(%1, %2)").arg(part(v.x), part(v.y));
}

} // namespace

MomentumPage::MomentumPage(const Context& context, QWidget* parent)
    : TablePage(context, "momentumPage", parent)
    , m_figure(new MomentumFigure(context.appearance, this))
    , m_sums(new QLabel(this))
    , m_none(new QLabel(this)) {
    m_sums->setObjectName(QStringLiteral("momentumSums"));
    m_sums->setWordWrap(true);
    m_sums->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_none->setObjectName(QStringLiteral("momentumNone"));
    m_none->setWordWrap(true);
    m_none->setAlignment(Qt::AlignCenter);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_figure, 1);
    column->addWidget(m_sums);
    column->addWidget(m_none, 1);
    restyle();
    retranslate();
}

void MomentumPage::retranslate() {
    m_none->setText(tr("Open a collision to see its momenta: Ctrl+→ opens the next one."));
    m_figure->retranslate();
    refresh();
}

void MomentumPage::restyle() {
    TablePage::restyle();
    m_sums->setFont(appearance().font(Appearance::Size::Normal));
    makeQuiet(*m_none, appearance());
}

void MomentumPage::showRun() {
    const auto open = selected();
    m_figure->setVisible(open.has_value());
    m_sums->setVisible(open.has_value());
    m_none->setVisible(!open);
    if (!open)
        return;
    m_figure->setCollision(session().run(), *open);
    const PassSums sums = sumsOf(passOf(session().timeline().collisions(), *open));
    QString text = tr("Σp before = %1 kg·m/s").arg(vectorText(sums.momentumBefore, sums.momentumScale)) +
                   u'\n' + tr("Σp after = %1 kg·m/s").arg(vectorText(sums.momentumAfter, sums.momentumScale));
    if (sums.wall)
        text += u'\n' + tr("The wall takes up the difference.");
    m_sums->setText(text);
}

Sheet MomentumPage::sheet() const {
    Sheet sheet{{{tr("Body"), {}}}, {}};
    for (const QString& when : {tr("before"), tr("after")})
        for (const char* axis : {"px", "py"})
            sheet.columns.push_back({QLatin1String(axis) + u' ' + when, QStringLiteral("kg·m/s")});
    const auto open = selected();
    if (!open)
        return sheet;
    const auto add = [&](const QString& name, const Vec2d& before, const Vec2d& after) {
        sheet.rows.push_back({textCell(name), numberCell(before.x, {}), numberCell(before.y, {}),
                              numberCell(after.x, {}), numberCell(after.y, {})});
    };
    const auto pass = passOf(session().timeline().collisions(), *open);
    for (const PassBody& b : bodiesOf(pass))
        add(bodyName(session().scene(), b.body), b.mass * b.before, b.mass * b.after);
    const PassSums sums = sumsOf(pass);
    add(tr("Total"), sums.momentumBefore, sums.momentumAfter);
    return sheet;
}

} // namespace thetalane
