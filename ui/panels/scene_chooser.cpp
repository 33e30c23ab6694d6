#include "ui/panels/scene_chooser.h"

#include "core/scene/builtin.h"
#include "ui/panels/icon_button.h"
#include "ui/words/scene_text.h"

#include <QGridLayout>
#include <QLocale>
#include <QMenu>
#include <QPushButton>

#include <algorithm>

namespace thetalane {
namespace {

// Language::use() sets the default locale, and a panel has no other way to it.
Language::Code languageOfNow() {
    return QLocale().language() == QLocale::Korean ? Language::Code::Korean : Language::Code::English;
}

QString toQString(std::string_view text) {
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

bool isBuiltinTitle(const Title& title) {
    const auto scenes = builtinScenes();
    return std::any_of(scenes.begin(), scenes.end(),
                       [&](const BuiltinScene& entry) { return entry.make().title == title; });
}

} // namespace

SceneChooser::SceneChooser(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_button(new QPushButton(this))
    , m_menu(new QMenu(this)) {
    m_button->setObjectName(QStringLiteral("sceneButton"));
    m_button->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the lane
    m_button->setMenu(m_menu);
    m_menu->setObjectName(QStringLiteral("sceneMenu"));
    m_button->setProperty("chooser", true);
    m_button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_button, 0, 0);
    layout->addWidget(new IconMark(appearance(), Icon::Down, this), 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    connect(&session(), &Session::runChanged, this, &SceneChooser::showCurrent);
    restyle();
    retranslate();
}

void SceneChooser::retranslate() {
    m_button->setAccessibleName(tr("Scene"));
    fillMenu();
    showCurrent();
}

void SceneChooser::restyle() {
    Panel::restyle();
    m_button->setFont(appearance().font(Appearance::Size::Normal));
    m_menu->setFont(appearance().font(Appearance::Size::Normal));
    fillMenu();
}

// Room for an ordinary title; a longer one is cut short rather than the window made wider.
QSize SceneChooser::sizeHint() const {
    return {appearance().unit() * 30, m_button->sizeHint().height()};
}

QSize SceneChooser::minimumSizeHint() const {
    return {appearance().unit() * 16, m_button->sizeHint().height()};
}

void SceneChooser::resizeEvent(QResizeEvent* event) {
    showCurrent();
    Panel::resizeEvent(event);
}

SceneChooser::Kind SceneChooser::kindOf(const Scene& scene) {
    return scene.lane ? Kind::Lane : scene.bodies.size() <= 2 ? Kind::TwoBodies : Kind::ManyBodies;
}

void SceneChooser::addHeading(Kind kind) {
    const QString words = kind == Kind::TwoBodies    ? tr("Two bodies")
                          : kind == Kind::ManyBodies ? tr("Many bodies")
                                                     : tr("The lane");
    if (!m_menu->isEmpty())
        m_menu->addSeparator();
    QAction* heading = m_menu->addAction(words);
    heading->setEnabled(false);
    heading->setFont(appearance().font(Appearance::Size::Small, true));
}

void SceneChooser::addScene(const BuiltinScene& entry, const Scene& scene) {
    const QString id = toQString(entry.id);
    QAction* action = m_menu->addAction(sceneTitle(scene, languageOfNow()));
    action->setObjectName(QStringLiteral("scene-") + id);
    action->setData(id);
    connect(action, &QAction::triggered, this, [this, id] { choose(id); });
}

void SceneChooser::fillMenu() {
    m_menu->clear();
    std::vector<std::pair<const BuiltinScene*, Scene>> scenes;
    for (const BuiltinScene& entry : builtinScenes())
        scenes.emplace_back(&entry, entry.make());
    for (const Kind kind : {Kind::TwoBodies, Kind::ManyBodies, Kind::Lane}) {
        addHeading(kind);
        for (const auto& [entry, scene] : scenes)
            if (kindOf(scene) == kind)
                addScene(*entry, scene);
    }
    m_menu->addSeparator();
    QAction* file = m_menu->addAction(tr("Open a file…"), this, &SceneChooser::openFileRequested);
    file->setObjectName(QStringLiteral("openFileAction"));
}

void SceneChooser::choose(const QString& id) {
    const auto open = [this, id] { session().openBuiltin(id); };
    m_guard ? m_guard(open) : open();
}

void SceneChooser::setInLesson(bool on) {
    m_inLesson = on;
    showCurrent();
}

void SceneChooser::showCurrent() {
    const Scene& scene = session().scene();
    QString title = sceneTitle(scene, languageOfNow());
    const bool edited = session().sceneId().isEmpty() && isBuiltinTitle(scene.title);
    if (m_inLesson)
        title = tr("The lesson's scene");
    else if (title.isEmpty())
        title = tr("A scene of one's own");
    const QString pattern = edited && !m_inLesson ? tr("%1 (edited)") : QStringLiteral("%1");
    m_button->setToolTip(tr("Choose a scene: %1").arg(pattern.arg(title)));
    // What has to go is the end of the title, not the mark behind it.
    const QFontMetrics metrics(appearance().font(Appearance::Size::Normal));
    const int room =
        m_button->width() - appearance().unit() * 6 - metrics.horizontalAdvance(pattern.arg(QString()));
    const QString cut = metrics.elidedText(title, Qt::ElideRight, std::max(room, appearance().unit() * 8));
    // A style sheet's padding does not move the text of a button with a menu; a space does.
    m_button->setText(QChar(0x2002) + pattern.arg(cut));
}

} // namespace thetalane
