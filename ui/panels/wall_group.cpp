#include "ui/panels/wall_group.h"

#include "ui/panels/edit_options_row.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panel.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>

namespace thetalane {
namespace {

constexpr const char* keys[] = {"Left", "Right", "Bottom", "Top"}; // in the order of `sides`

std::optional<double>& placeOf(Frame& frame, Side side) {
    return side == Side::Left     ? frame.left
           : side == Side::Right  ? frame.right
           : side == Side::Bottom ? frame.bottom
                                  : frame.top;
}

} // namespace

WallGroup::WallGroup(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_grid(new QGridLayout(this))
    , m_title(new QLabel(this))
    , m_eLabel(new QLabel(this))
    , m_e(new NumberField(appearance, QStringLiteral("wallRestitution"), this))
    , m_message(new QLabel(this)) {
    setObjectName(QStringLiteral("wallGroup"));
    m_message->setObjectName(QStringLiteral("wallMessage"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->addWidget(m_title, 0, 0, 1, 2);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const QString name = QStringLiteral("wall") + QLatin1String(keys[i]);
        m_boxes[i] = new QCheckBox(this);
        m_boxes[i]->setObjectName(name);
        m_places[i] = new NumberField(appearance, name + "Place", this);
        m_places[i]->setUnit(QStringLiteral("m"));
        const int row = 1 + int(i) / 2 * 2, column = int(i) % 2;
        m_grid->addWidget(m_boxes[i], row, column);
        m_grid->addWidget(m_places[i], row + 1, column);
        connect(m_boxes[i], &QCheckBox::clicked, this, [this, i](bool on) {
            if (on)
                return emit wanted(sides[i]);
            put(sides[i], std::nullopt);
            emit edited();
        });
        connect(m_places[i], &NumberField::edited, this, [this, i](double place) { take(i, place); });
        connect(m_places[i], &NumberField::becameUnreadable, this, &WallGroup::edited);
    }
    m_e->setStep(0.01, 0, 1);
    m_eLabel->setBuddy(m_e->edit());
    m_eLabel->setWordWrap(true);
    m_grid->addWidget(m_eLabel, 5, 0);
    m_grid->addWidget(m_e, 5, 1);
    m_grid->addWidget(m_message, 6, 0, 1, 2);
    m_grid->setColumnStretch(0, 1);
    m_grid->setColumnStretch(1, 1);
    connect(m_e, &NumberField::edited, this, [this](double e) {
        m_restitution = e;
        if (m_frame)
            m_frame->restitution = e;
        emit edited();
    });
    connect(m_e, &NumberField::becameUnreadable, this, &WallGroup::edited);
    connect(&appearance, &Appearance::changed, this, &WallGroup::restyle);
    restyle();
    retranslate();
    show({});
}

void WallGroup::restyle() {
    m_grid->setHorizontalSpacing(m_appearance.unit() * 2);
    m_grid->setVerticalSpacing(m_appearance.unit() / 4);
    m_title->setFont(m_appearance.font(Appearance::Size::Normal, true));
    for (QCheckBox* box : m_boxes)
        restyleCheckBox(*box, m_appearance);
    m_grid->setRowMinimumHeight(5, m_appearance.unit() * 5);
    makeQuiet(*m_eLabel, m_appearance);
    makeMessage(*m_message, m_appearance);
}

void WallGroup::retranslate() {
    m_title->setText(tr("Walls"));
    const QString names[] = {tr("Left, x"), tr("Right, x"), tr("Bottom, y"), tr("Top, y")};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        m_boxes[i]->setText(names[i]);
        m_boxes[i]->setAccessibleName(sideName(sides[i]));
        m_boxes[i]->setToolTip(tr("Whether there is a wall here; without one this side is open"));
        m_places[i]->setWords(sideName(sides[i]),
                              tr("Where the wall stands") + u'\n' + exactText(m_places[i]->value()));
    }
    m_eLabel->setText(tr("Coefficient of restitution e of the walls"));
    m_e->setWords(m_eLabel->text(), tr("0: perfectly inelastic, 1: elastic. Between bodies and walls."));
}

void WallGroup::show(const std::optional<Frame>& frame) {
    m_frame = frame;
    if (frame)
        m_restitution = frame->restitution;
    m_e->setValue(m_restitution);
    m_e->setEnabled(frame.has_value());
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto place = frame ? frame->side(sides[i]) : std::nullopt;
        m_boxes[i]->setChecked(place.has_value());
        m_places[i]->setEnabled(place.has_value());
        if (place)
            m_places[i]->setValue(*place);
    }
    showErrors({});
}

void WallGroup::put(Side side, std::optional<double> place) {
    Frame frame = m_frame.value_or(Frame{});
    frame.restitution = m_restitution;
    placeOf(frame, side) = place;
    const bool any = frame.left || frame.right || frame.bottom || frame.top;
    show(any ? std::optional(frame) : std::nullopt);
}

void WallGroup::take(std::size_t side, double place) {
    if (!m_frame)
        return;
    placeOf(*m_frame, sides[side]) = place;
    emit edited();
}

bool WallGroup::isUsable() const {
    bool usable = m_e->unreadable().isEmpty();
    for (const NumberField* field : m_places)
        usable = usable && (!field->isEnabled() || field->unreadable().isEmpty());
    return usable;
}

void WallGroup::addMessage(const QString& about, const QString& message) {
    const QString line = QStringLiteral("%1: %2").arg(about, message);
    m_message->setText(m_message->text().isEmpty() ? line : m_message->text() + u'\n' + line);
    m_message->show();
}

void WallGroup::showErrors(const std::vector<SceneError>& errors) {
    m_message->clear();
    m_message->hide();
    const auto complain = [this](NumberField& field, const QString& about, const QString& message) {
        field.setWrong(true);
        addMessage(about, message);
    };
    for (std::size_t i = 0; i < sides.size(); ++i) {
        NumberField& field = *m_places[i];
        field.setWrong(false);
        if (const QString why = field.unreadable(); field.isEnabled() && !why.isEmpty())
            complain(field, m_boxes[i]->text(), why);
        const std::string path = "frame." + QString::fromLatin1(keys[i]).toLower().toStdString();
        for (const SceneError& error : errors)
            if (error.path == path)
                complain(field, m_boxes[i]->text(), sceneErrorMessage(error));
    }
    m_e->setWrong(false);
    if (const QString why = m_e->unreadable(); !why.isEmpty())
        complain(*m_e, QStringLiteral("e"), why);
    for (const SceneError& error : errors)
        if (error.path == "frame.restitution")
            complain(*m_e, QStringLiteral("e"), sceneErrorMessage(error));
}

} // namespace thetalane
