#include "ui/who/collision_tree_panel.h"

#include "core/bowling/pinfall.h"
#include "ui/count_text.h"
#include "ui/panels/pin_deck.h"
#include "ui/who/hit_tree_view.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

constexpr std::size_t mostRead = 20'000; // collisions of a run
constexpr std::size_t mostListed = 200;  // later hits

bool hasPins(const Scene& scene) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                       [](const Body& b) { return b.kind == BodyKind::Pin; });
}

} // namespace

CollisionTreePanel::CollisionTreePanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_chain(new QLabel(this))
    , m_empty(new QLabel(this))
    , m_key(new QLabel(this))
    , m_view(new HitTreeView(appearance()))
    , m_treeScroll(new QScrollArea(this))
    , m_standing(new QWidget(this))
    , m_deck(new PinDeck(appearance(), m_standing))
    , m_left(new QLabel(m_standing))
    , m_laterTitle(new QLabel(this))
    , m_later(new QListWidget(this))
    , m_leftOut(new QLabel(this))
    , m_column(new QVBoxLayout) {
    setObjectName(QStringLiteral("collisionTreePanel"));
    build();
    connect(m_view, &HitTreeView::chosen, this, &CollisionTreePanel::choose);
    connect(m_view, &HitTreeView::moved, this, [this](const QRect& where) {
        m_treeScroll->ensureVisible(where.center().x(), where.center().y(), where.width() / 2 + 8,
                                    where.height() / 2 + 8);
    });
    connect(m_later, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0 && !m_following)
            choose(m_tree->later[std::size_t(row)].collision);
    });
    connect(m_later, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
        choose(m_tree->later[std::size_t(m_later->row(item))].collision);
    });
    connect(&session(), &Session::runChanged, this, &CollisionTreePanel::takeRun);
    connect(&session(), &Session::progressed, this, &CollisionTreePanel::showWords);
    connect(&playhead(), &Playhead::timeChanged, this, &CollisionTreePanel::followTime);
    connect(&playhead(), &Playhead::selectionChanged, this, &CollisionTreePanel::followPlayhead);
    takeRun();
    restyle();
    retranslate();
}

void CollisionTreePanel::build() {
    const std::pair<QLabel*, const char*> labels[] = {
        {m_chain, "chainText"}, {m_empty, "noHits"},          {m_key, "treeKey"},
        {m_left, "leftText"},   {m_laterTitle, "laterTitle"}, {m_leftOut, "leftOutText"}};
    for (const auto& [label, name] : labels) {
        label->setObjectName(QLatin1String(name));
        label->setWordWrap(true);
    }
    setTerm(m_chain, "perfect-strike");
    setTerm(m_key, "impulse");
    setTerm(m_left, "leave");
    m_treeScroll->setObjectName(QStringLiteral("treeScroll"));
    m_treeScroll->setWidget(m_view);
    m_treeScroll->setWidgetResizable(true);
    m_treeScroll->setFrameShape(QFrame::NoFrame);
    m_treeScroll->setFocusPolicy(Qt::NoFocus);
    m_deck->setObjectName(QStringLiteral("standingDeck"));
    auto* standing = new QHBoxLayout(m_standing);
    standing->setContentsMargins(0, 0, 0, 0);
    standing->addWidget(m_deck);
    standing->addWidget(m_left, 1);
    m_later->setObjectName(QStringLiteral("laterHits"));
    m_later->setFrameShape(QFrame::NoFrame);
    m_later->setUniformItemSizes(true);
    m_later->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(m_column);
    m_column->addWidget(m_chain);
    m_column->addWidget(m_empty, 1);
    m_column->addWidget(m_treeScroll, 8);
    m_column->addWidget(m_key);
    m_column->addWidget(m_standing);
    m_column->addWidget(m_laterTitle);
    m_column->addWidget(m_later, 1);
    m_column->addWidget(m_leftOut);
    m_column->addStretch(0);
}

// A throw that is being aimed changes with every move of the mouse: nothing is made for nobody.
void CollisionTreePanel::takeRun() {
    m_stale = true;
    if (isVisible())
        showTree();
}

void CollisionTreePanel::showEvent(QShowEvent* event) {
    if (m_stale)
        showTree();
    Panel::showEvent(event);
}

// Of a long run, whoever looks late gets the tree of the chapter at hand's beginning: the first one is asked
// for.
void CollisionTreePanel::showTree() {
    m_stale = false;
    m_run = session().run();
    if (session().part().collisionsBefore > 0)
        if (auto first = session().chapter(RunAhead::Place(std::int64_t(1))))
            m_run = std::move(first);
    m_tree = std::make_shared<const HitTree>(hitTree(m_run->scene, m_run->timeline, mostRead));
    m_perfect = perfectLinks(m_run->scene, *m_tree);
    m_view->show(m_run, m_tree, m_perfect);
    m_view->setTime(playhead().time());
    showStanding();
    showLater();
    showWords();
    followPlayhead();
}

void CollisionTreePanel::retranslate() {
    m_empty->setText(tr("Nobody hits anybody."));
    m_key->setText(tr("Above an arrow the time [s], below it the impulse [N·s]. What has not happened yet is "
                      "grey; click an arrow to open the collision."));
    m_view->setToolTip(tr("Click an arrow, or go along them with the arrow keys, to open the collision"));
    m_deck->setTitle(tr("Left standing"));
    m_later->setAccessibleName(tr("Later hits"));
    m_later->setToolTip(tr("Hits of bodies that moved already; choose one to open it"));
    if (m_tree && !m_stale) // a body's name may be a word, of another width
        return showTree();
    showStanding();
    showLater();
    showWords();
}

void CollisionTreePanel::restyle() {
    Panel::restyle();
    const Appearance& a = appearance();
    const int unit = a.unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit);
    m_chain->setFont(a.font(Appearance::Size::Large));
    m_left->setFont(a.font(Appearance::Size::Normal));
    m_laterTitle->setFont(a.font(Appearance::Size::Normal, true));
    m_later->setFont(a.font(Appearance::Size::Normal));
    m_empty->setAlignment(Qt::AlignCenter);
    makeQuiet(*m_empty, a);
    m_empty->setFont(a.font(Appearance::Size::Normal));
    makeQuiet(*m_key, a);
    makeQuiet(*m_leftOut, a);
    m_treeScroll->setStyleSheet(
        QStringLiteral("QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }"
                       "QScrollBar::handle:horizontal { background: %1; border-radius: 4px; min-width: 32px; "
                       "margin: 1px; }"
                       "QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }"
                       "QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }")
            .arg(a.line().name()));
    m_later->setStyleSheet(
        QStringLiteral("QListWidget { background: transparent; border: none; outline: none; color: %1; }"
                       "QListWidget::item { border: none; min-height: %2px; padding: 0 4px; }"
                       "QListWidget::item:selected { background: %3; color: %1; }"
                       "QListWidget:focus { border: 1px solid %4; }")
            .arg(a.text().name(), QString::number(a.projector() ? 36 : 24), a.chosen().name(),
                 a.accent().name()));
    const int deck = a.projector() ? 108 : 76;
    m_deck->setFixedSize(deck, int(deck * 0.88));
    followTime(playhead().time());
    showWords();
}

QString CollisionTreePanel::chainText() const {
    if (!m_perfect)
        return {};
    const bool right = m_perfect->hand == Hand::Right;
    if (m_perfect->perfect)
        return right
                   ? tr("Perfect strike, right-handed: the ball touches only 1, 3, 5 and 9, and the pins do "
                        "the rest: 1 → 2 → 4 → 7, 3 → 6 → 10, 5 → 8.")
                   : tr("Perfect strike, left-handed: the ball touches only 1, 2, 5 and 8, and the pins do "
                        "the rest: 1 → 3 → 6 → 10, 2 → 4 → 7, 5 → 9.");
    return right ? tr("Of the ten links of the perfect strike, right-handed, %1 came about (amber).")
                       .arg(m_perfect->links)
                 : tr("Of the ten links of the perfect strike, left-handed, %1 came about (amber).")
                       .arg(m_perfect->links);
}

QString CollisionTreePanel::leftOutText() const {
    QStringList said;
    const std::size_t notDrawn = m_view->layoutOfTree().notDrawn;
    if (notDrawn > 0)
        said << tr("Drawn are the first %1 hits that set a body moving; %2 more are not.")
                    .arg(HitTreeView::mostDrawn)
                    .arg(countText(std::int64_t(notDrawn)));
    if (m_tree->later.size() > mostListed)
        said << tr("Listed are the first %1 later hits.").arg(mostListed);
    const std::int64_t all = session().part().collisionCount;
    const std::int64_t read = m_run->timeline.collisionCount() - std::int64_t(m_tree->leftOut);
    if (all > read)
        said << tr("Only the first %1 of %2 collisions were looked at.").arg(countText(read), countText(all));
    return said.join(u' ');
}

void CollisionTreePanel::showWords() {
    if (!m_tree)
        return;
    const bool any = !m_tree->edges.empty();
    // A chain is not broken between two lines.
    m_chain->setText(chainText().replace(QStringLiteral(" → "), QStringLiteral("\u00A0→\u00A0")));
    const QScrollBar* bar = m_treeScroll->horizontalScrollBar();
    m_treeScroll->setMaximumHeight(m_view->minimumSizeHint().height() + bar->sizeHint().height());
    m_chain->setVisible(any && m_perfect);
    m_empty->setVisible(!any);
    m_treeScroll->setVisible(any);
    m_key->setVisible(any);
    const QString missing = leftOutText();
    m_leftOut->setText(missing);
    m_leftOut->setVisible(!missing.isEmpty());
}

void CollisionTreePanel::showStanding() {
    if (!m_run)
        return;
    const Scene& scene = m_run->scene;
    m_standing->setVisible(hasPins(scene));
    if (!hasPins(scene))
        return;
    PinSet present;
    for (const Body& body : scene.bodies)
        if (const auto number = pinNumber(body))
            present.set(std::size_t(*number - 1));
    const PinSet left = present & ~fallenPins(scene, m_run->timeline);
    PinSet touched;
    for (const int body : pinsTouched(scene, m_run->timeline, m_run->timeline.endTime()))
        if (const auto number = pinNumber(scene.bodies[std::size_t(body)]))
            touched.set(std::size_t(*number - 1));
    m_deck->setStanding(left);
    QString text = left.none() ? tr("No pin is left standing.") : tr("Left standing: %1").arg(pinsText(left));
    if (const PinSet brushed = left & touched; brushed.any())
        text += u'\n' + tr("Touched, but too softly to tip: %1").arg(pinsText(brushed));
    m_left->setText(text);
}

void CollisionTreePanel::showLater() {
    if (!m_tree)
        return;
    m_following = true;
    m_later->clear();
    const std::size_t shown = std::min(mostListed, m_tree->later.size());
    for (std::size_t k = 0; k < shown; ++k) {
        const Hit& hit = m_tree->later[k];
        const QString pair =
            QStringLiteral("%1 – %2").arg(bodyName(m_run->scene, hit.from), bodyName(m_run->scene, hit.to));
        auto* item = new QListWidgetItem(
            QStringLiteral("%1 s    %2    %3 N·s")
                .arg(QString::number(hit.time, 'f', 4), pair, numberText(hit.impulse, 3)));
        item->setToolTip(m_view->sentence(hit));
        m_later->addItem(item);
    }
    m_following = false;
    m_laterTitle->setText(tr("Later hits: %1").arg(countText(std::int64_t(m_tree->later.size()))));
    m_laterTitle->setVisible(shown > 0);
    m_later->setVisible(shown > 0);
    // No more room than its rows: the tree has more use for it.
    m_later->setMaximumHeight(int(shown) * std::max(m_later->sizeHintForRow(0), 24) + 4);
    followTime(playhead().time());
}

// The numbers of a run's first chapter are those of the whole run.
void CollisionTreePanel::choose(std::size_t collision) {
    const auto number = std::int64_t(collision) + 1;
    if (playhead().selectedNumber() != number)
        playhead().selectNumber(number);
}

void CollisionTreePanel::followPlayhead() {
    if (m_stale || !m_tree)
        return;
    const auto number = playhead().selectedNumber();
    const auto open = number ? std::optional(std::size_t(*number - 1)) : std::nullopt;
    m_view->setOpen(open);
    m_following = true;
    int row = -1;
    for (std::size_t k = 0; open && k < std::size_t(m_later->count()); ++k)
        if (m_tree->later[k].collision == *open)
            row = int(k);
    m_later->setCurrentRow(row);
    m_following = false;
}

void CollisionTreePanel::followTime(double time) {
    if (m_stale || !m_tree)
        return;
    m_view->setTime(time);
    for (int row = 0; row < m_later->count(); ++row) {
        const bool done = m_tree->later[std::size_t(row)].time <= time;
        const QColor colour = done ? appearance().text() : appearance().faintText();
        if (m_later->item(row)->foreground().color() != colour)
            m_later->item(row)->setForeground(colour);
    }
}

} // namespace thetalane
