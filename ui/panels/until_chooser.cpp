#include "ui/panels/until_chooser.h"

#include "ui/words/number_text.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

#include <algorithm>
#include <array>
#include <vector>

namespace thetalane {
namespace {

// A lesson's moment, a minute, ten minutes, an hour.
constexpr std::array choices{10.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0};

QString secondsText(double time) {
    return numberText(time, 6) + QStringLiteral(" s");
}

} // namespace

UntilChooser::UntilChooser(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_button(new QPushButton(this))
    , m_menu(new QMenu(this)) {
    m_button->setObjectName(QStringLiteral("untilButton"));
    m_button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the lane
    m_button->setProperty("quiet", true);
    m_button->setMenu(m_menu);
    m_menu->setObjectName(QStringLiteral("untilMenu"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_button);
    connect(m_menu, &QMenu::aboutToShow, this, &UntilChooser::fillMenu);
    connect(&session(), &Session::runChanged, this, &UntilChooser::showCurrent);
    connect(&session(), &Session::progressed, this, &UntilChooser::showCurrent);
    restyle();
    retranslate();
}

void UntilChooser::retranslate() {
    m_button->setAccessibleName(tr("End of the run"));
    showCurrent();
}

void UntilChooser::restyle() {
    Panel::restyle();
    m_button->setFont(appearance().font(Appearance::Size::Normal));
    m_menu->setFont(m_button->font());
    updateGeometry();
    emit resized();
}

QSize UntilChooser::sizeHint() const {
    return isHidden() ? QSize(0, 0) : m_button->sizeHint();
}

// The present one too, where it is none of ours.
void UntilChooser::fillMenu() {
    std::vector<double> ends(choices.begin(), choices.end());
    if (std::find(ends.begin(), ends.end(), session().until()) == ends.end())
        ends.push_back(session().until());
    std::sort(ends.begin(), ends.end());
    m_menu->clear();
    for (const double end : ends) {
        QAction* action = m_menu->addAction(secondsText(end));
        action->setObjectName(QStringLiteral("until-%1").arg(end));
        action->setCheckable(true);
        action->setChecked(end == session().until());
        connect(action, &QAction::triggered, this, [this, end] { playhead().runUntil(end); });
        if (action->isChecked())
            m_menu->setActiveAction(action);
    }
}

void UntilChooser::showCurrent() {
    const QString end = secondsText(session().until());
    const QString text = QStringLiteral("/ ") + end;
    m_button->setToolTip(tr("The run goes on until %1; choose a longer or a shorter one").arg(end));
    const bool shown = session().isLimitedByUntil() || session().until() != EngineSettings{}.until;
    if (m_button->text() == text && shown != isHidden())
        return;
    m_button->setText(text);
    setVisible(shown);
    updateGeometry();
    emit resized();
}

} // namespace thetalane
