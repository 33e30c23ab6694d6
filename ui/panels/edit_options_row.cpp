#include "ui/panels/edit_options_row.h"

#include "ui/panels/icon_button.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>

#include <array>

namespace thetalane {
namespace {

constexpr std::array spacings{0.0, 0.01, 0.05, 0.1}; // [m]; 0: follows the zoom

} // namespace

void restyleCheckBox(QCheckBox& box, const Appearance& appearance) {
    const int side = appearance.projector() ? 24 : 16;
    box.setFont(appearance.font(Appearance::Size::Normal));
    box.setMinimumHeight(appearance.projector() ? 36 : 24);
    box.setStyleSheet(
        QStringLiteral("QCheckBox { spacing: %2px; } QCheckBox::indicator { width: %1px; height: "
                       "%1px; } QCheckBox:focus { color: %3; }")
            .arg(side)
            .arg(appearance.unit() * 3 / 4)
            .arg(appearance.accent().name()));
}

EditOptionsRow::EditOptionsRow(const Appearance& appearance, EditOptions& options, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_options(options)
    , m_grid(new QGridLayout(this))
    , m_constantSize(new QCheckBox(this))
    , m_oneLine(new QCheckBox(this))
    , m_snap(new QCheckBox(this))
    , m_spacing(new QComboBox(this)) {
    m_constantSize->setObjectName(QStringLiteral("constantSize"));
    m_oneLine->setObjectName(QStringLiteral("oneLine"));
    m_snap->setObjectName(QStringLiteral("snap"));
    m_spacing->setObjectName(QStringLiteral("gridSpacing"));
    m_spacing->installEventFilter(this);
    for (std::size_t i = 0; i < spacings.size(); ++i)
        m_spacing->addItem({});
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->addWidget(m_snap, 2, 0);
    m_grid->addWidget(m_spacing, 2, 1);
    m_grid->addWidget(new IconMark(appearance, Icon::Down, this), 2, 1, Qt::AlignRight | Qt::AlignVCenter);
    m_grid->setColumnStretch(0, 1);
    m_grid->setColumnStretch(1, 1);
    connect(m_constantSize, &QCheckBox::clicked, &options, &EditOptions::setConstantSize);
    connect(m_oneLine, &QCheckBox::clicked, this, &EditOptionsRow::oneLineWanted);
    connect(m_snap, &QCheckBox::clicked, &options, &EditOptions::setSnap);
    connect(m_spacing, &QComboBox::activated, this, [this](int index) {
        m_options.setGrid(spacings[std::size_t(index)]);
        m_options.setSnap(true); // who chooses a grid wants it
    });
    connect(&options, &EditOptions::changed, this, &EditOptionsRow::showOptions);
    connect(&appearance, &Appearance::changed, this, &EditOptionsRow::restyle);
    restyle();
    retranslate();
    showOptions();
}

void EditOptionsRow::restyle() {
    m_grid->setHorizontalSpacing(m_appearance.unit());
    m_grid->setVerticalSpacing(m_appearance.unit() / 2);
    // Large letters need the width of the column for themselves.
    const bool large = m_appearance.projector();
    m_grid->addWidget(m_constantSize, 0, 0, 1, large ? 2 : 1);
    m_grid->addWidget(m_oneLine, large ? 1 : 0, large ? 0 : 1, 1, large ? 2 : 1);
    for (QCheckBox* box : {m_constantSize, m_oneLine, m_snap})
        restyleCheckBox(*box, m_appearance);
    m_spacing->setFont(m_appearance.font(Appearance::Size::Normal));
    m_spacing->setMinimumWidth(m_appearance.unit() * 8);
}

void EditOptionsRow::retranslate() {
    const auto say = [](QWidget& widget, const QString& name, const QString& toolTip) {
        widget.setAccessibleName(name);
        widget.setToolTip(toolTip);
    };
    m_constantSize->setText(tr("Constant size"));
    say(*m_constantSize, m_constantSize->text(),
        tr("On: a new mass leaves the radius as it is. Off: the radius follows the mass at the same density, "
           "by its cube root."));
    m_oneLine->setText(tr("One line (1-D)"));
    say(*m_oneLine, m_oneLine->text(), tr("All bodies on one line along x, with velocities along it only"));
    m_snap->setText(tr("Snap to grid"));
    say(*m_snap, m_snap->text(),
        tr("Bodies are put down on the grid, arrows on tenths of a m/s; Ctrl turns it round while dragging"));
    say(*m_spacing, tr("Spacing of the grid"), tr("Spacing of the grid"));
    for (std::size_t i = 0; i < spacings.size(); ++i)
        m_spacing->setItemText(int(i),
                               spacings[i] > 0 ? QStringLiteral("%1 m").arg(spacings[i]) : tr("By zoom"));
}

void EditOptionsRow::showOptions() {
    m_constantSize->setChecked(m_options.constantSize());
    m_oneLine->setChecked(m_options.oneLine());
    m_snap->setChecked(m_options.snap());
    for (std::size_t i = 0; i < spacings.size(); ++i)
        if (spacings[i] == m_options.grid())
            m_spacing->setCurrentIndex(int(i));
}

// A wheel that scrolls the panel must not change what passes under it.
bool EditOptionsRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && !m_spacing->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace thetalane
