#include "ui/window/top_bar.h"

#include "ui/panels/engine_chooser.h"
#include "ui/panels/icon_button.h"
#include "ui/panels/scene_chooser.h"

#include <QEvent>
#include <QHBoxLayout>
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
    , m_dark(new IconButton(context.appearance, Icon::Moon, "dark", this))
    , m_projector(barButton("projector", this))
    , m_korean(barButton("korean", this))
    , m_english(barButton("english", this)) {
    m_projector->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_row->addWidget(m_scenes);
    m_row->addWidget(m_reset);
    m_row->addStretch(1);
    m_row->addWidget(new EngineChooser(context, this));
    m_row->addStretch(1);
    for (QWidget* w : std::initializer_list<QWidget*>{m_dark, m_projector, m_korean, m_english})
        m_row->addWidget(w);

    Appearance& look = m_context.appearance;
    connect(m_scenes, &SceneChooser::openFileRequested, this, &TopBar::openFileRequested);
    connect(m_reset, &IconButton::clicked, &m_context.session, &Session::reset);
    connect(m_dark, &IconButton::clicked, &look, [&look] { look.setDark(!look.dark()); });
    connect(m_projector, &QToolButton::clicked, &look, &Appearance::setProjector);
    connect(m_korean, &QToolButton::clicked, this, [this] { m_language.use(Language::Code::Korean); });
    connect(m_english, &QToolButton::clicked, this, [this] { m_language.use(Language::Code::English); });
    connect(&look, &Appearance::changed, this, &TopBar::restyle);
    restyle();
    retranslate();
}

void TopBar::addFirst(QWidget* widget) {
    m_row->insertWidget(0, widget);
}

void TopBar::retranslate() {
    m_reset->setWords(tr("Reset the scene"), tr("Reset the scene (R)"));
    m_dark->setWords(tr("Dark or light"), tr("Dark or light (D)"));
    m_projector->setText(tr("Projector"));
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
    m_projector->setIcon(makeIcon(Icon::Projector, look.text(), look.quietText()));
    m_projector->setIconSize(QSize(2 * u, 2 * u));
}

void TopBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace thetalane
