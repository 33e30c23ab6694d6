#include "ui/window/top_bar.h"

#include "ui/panels/engine_chooser.h"
#include "ui/panels/icon_button.h"
#include "ui/panels/scene_chooser.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

namespace thetalane {
namespace {

QToolButton* barButton(const char* name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setAutoRaise(true);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed); // the choosers give way
    return button;
}

} // namespace

TopBar::TopBar(const Context& context, Language& language, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_language(language)
    , m_row(new QHBoxLayout(this))
    , m_scenes(new SceneChooser(context, this))
    , m_reset(new IconButton(context.appearance, Icon::Reset, "reset", this))
    , m_view(barButton("view", this))
    , m_viewMenu(new QMenu(m_view))
    , m_dark(m_viewMenu->addAction(QString()))
    , m_stillness(m_viewMenu->addAction(QString()))
    , m_projector(barButton("projector", this))
    , m_korean(barButton("korean", this))
    , m_english(barButton("english", this)) {
    m_projector->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_row->addWidget(m_scenes);
    m_row->addWidget(m_reset);
    m_row->addStretch(1);
    m_row->addWidget(new EngineChooser(context, this));
    m_row->addStretch(1);
    for (QWidget* w : std::initializer_list<QWidget*>{m_view, m_projector, m_korean, m_english})
        m_row->addWidget(w);

    Appearance& look = m_context.appearance;
    connect(m_scenes, &SceneChooser::openFileRequested, this, &TopBar::openFileRequested);
    connect(m_reset, &IconButton::clicked, &m_context.session, &Session::reset);
    buildViewMenu();
    connect(m_projector, &QToolButton::clicked, &look, &Appearance::setProjector);
    connect(m_korean, &QToolButton::clicked, this, [this] { m_language.use(Language::Code::Korean); });
    connect(m_english, &QToolButton::clicked, this, [this] { m_language.use(Language::Code::English); });
    connect(&look, &Appearance::changed, this, &TopBar::restyle);
    restyle();
    retranslate();
}

void TopBar::buildViewMenu() {
    Appearance& look = m_context.appearance;
    m_view->setCheckable(false);
    m_view->setPopupMode(QToolButton::InstantPopup);
    m_view->setMenu(m_viewMenu);
    m_dark->setObjectName("dark");
    m_stillness->setObjectName("lessMotion");
    for (QAction* action : {m_dark, m_stillness})
        action->setCheckable(true);
    connect(m_dark, &QAction::triggered, &look, &Appearance::setDark);
    connect(m_stillness, &QAction::triggered, &look, &Appearance::setReducedMotion);
}

void TopBar::addFirst(QWidget* widget) {
    m_row->insertWidget(0, widget);
}

void TopBar::retranslate() {
    m_reset->setWords(tr("Reset the scene"), tr("Reset the scene (R)"));
    m_view->setToolTip(tr("Dark or light, and how much moves"));
    m_view->setAccessibleName(m_view->toolTip());
    m_dark->setText(tr("Dark (D)"));
    m_stillness->setText(tr("Less motion: nothing flies or turns by itself"));
    m_projector->setText(tr("Projector"));
    m_projector->setAccessibleName(tr("Projector"));
    m_projector->setToolTip(tr("Large type and lines for a projector (F11)"));
    m_korean->setText("한국어");
    m_english->setText("English");
    for (QToolButton* b : {m_korean, m_english})
        b->setToolTip(tr("Language of everything (L)"));
    m_korean->setChecked(m_language.code() == Language::Code::Korean);
    m_english->setChecked(m_language.code() == Language::Code::English);
}

void TopBar::restyle() {
    const Appearance& look = m_context.appearance;
    const int u = look.unit();
    m_row->setContentsMargins(u, u / 2, u, u / 2);
    m_row->setSpacing(u);
    m_projector->setChecked(look.projector());
    shorten();
    m_dark->setChecked(look.dark());
    m_stillness->setChecked(look.reducedMotion());
    m_view->setIcon(makeIcon(Icon::Moon, look.text(), look.quietText()));
    m_view->setIconSize(QSize(2 * u, 2 * u));
    m_projector->setIcon(makeIcon(Icon::Projector, look.text(), look.quietText()));
    m_projector->setIconSize(QSize(2 * u, 2 * u));
}

// Where the bar is short, the icon says it: the scene and the engine need their words more.
void TopBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    shorten();
}

void TopBar::shorten() {
    const bool isShort = width() < 120 * m_context.appearance.unit();
    m_projector->setToolButtonStyle(isShort ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
}

void TopBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace thetalane
