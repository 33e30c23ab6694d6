#include "ui/panels/panel.h"

#include <QEvent>
#include <QLabel>

namespace thetalane {
namespace {

const char* const fields = R"(
    QLineEdit { border: 1px solid %line; border-radius: 4px; padding: 0 6px; background: %card; color: %text;
                min-height: %fieldpx; selection-background-color: %accent; }
    QLineEdit:focus { border: 2px solid %accent; padding: 0 5px; }
    QLineEdit[wrong="true"] { border: 2px solid %error; padding: 0 5px; }
    QPushButton { border: 1px solid %line; border-radius: 4px; padding: 0 12px; background: %card;
                  color: %text; min-height: %fieldpx; }
    QPushButton:hover { border-color: %quiet; }
    QPushButton:focus { border: 2px solid %accent; padding: 0 11px; }
    QPushButton[prominent="true"] { background: %accent; color: %card; border: none; font-weight: bold;
                                    min-height: %bigpx; padding: 0 16px; }
    QPushButton[prominent="true"]:hover { background: %dark; }
    QPushButton[prominent="true"]:focus { border: 2px solid %text; }
    QPushButton[prominent="true"]:disabled { background: %line; color: %quiet; }
    QCheckBox::indicator:unchecked { border: 1px solid %quiet; border-radius: 3px; background: %card; }
    QCheckBox::indicator:unchecked:hover { border-color: %accent; }
    QCheckBox::indicator:checked { margin: 1px; }
    QPushButton[quiet="true"] { border: none; background: transparent; color: %accent; padding: 0 8px; }
    QPushButton[quiet="true"]:hover { text-decoration: underline; }
    QPushButton[quiet="true"]:focus { border: 2px solid %accent; padding: 0 6px; }
)";

const char* const choosers = R"(
    QComboBox { border: 1px solid %line; border-radius: 4px; padding: 0 8px; background: %card; color: %text;
                min-height: %fieldpx; }
    QComboBox:hover { border-color: %quiet; }
    QComboBox:focus { border: 2px solid %accent; padding: 0 7px; }
    QComboBox::drop-down { border: none; width: %drop; }
    QComboBox::down-arrow, QPushButton::menu-indicator { image: none; width: 0; }
    QPushButton[chooser="true"] { text-align: left; padding: 0 8px; }
    QPushButton[chooser="true"]:focus { padding: 0 7px; }
    QComboBox QAbstractItemView { background: %card; color: %text; border: 1px solid %line; outline: none;
                                  selection-background-color: %accent; selection-color: %card; }
    QComboBox QAbstractItemView::item { min-height: %fieldpx; padding: 0 8px; }
    QMenu { background: %card; color: %text; border: 1px solid %line; padding: 4px 0; }
    QMenu::item { min-height: %fieldpx; padding: 0 24px 0 28px; }
    QMenu::item:selected { background: %accent; color: %card; }
    QMenu::item:disabled { color: %quiet; background: transparent; padding-left: 12px; }
    QMenu::separator { height: 1px; background: %line; margin: 4px 0; }
)";

const char* const views = R"(
    QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; border: none; }
    QTableView { background: transparent; border: none; outline: none; selection-color: %text;
                 selection-background-color: %chosen; }
    QHeaderView, QHeaderView::section { background: transparent; color: %quiet; border: none;
                                        border-bottom: 1px solid %line; padding: 2px 4px; }
    QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
    QScrollBar::handle:vertical { background: %line; border-radius: 4px; min-height: 32px; margin: 1px; }
    QScrollBar::handle:vertical:hover { background: %quiet; }
    QScrollBar::add-line, QScrollBar::sub-line { height: 0; }
    QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
)";

} // namespace

QString panelStyle(const Appearance& a) {
    QString style = QLatin1String(fields) + QLatin1String(choosers) + QLatin1String(views);
    const int field = a.projector() ? 36 : 26;
    const auto put = [&style](const char* key, const QString& value) {
        style.replace(QLatin1String(key), value);
    };
    put("%line", a.line().name());
    put("%card", a.card().name());
    put("%text", a.text().name());
    put("%quiet", a.quietText().name());
    put("%accent", a.accent().name());
    put("%dark", a.accent().darker(115).name());
    put("%error", a.error().name());
    put("%chosen", a.chosen().name());
    put("%field", QString::number(field));
    put("%big", QString::number(field + a.unit()));
    put("%drop", QString::number(field - 4) + "px");
    return style;
}

Panel::Panel(const Context& context, QWidget* parent)
    : QWidget(parent)
    , m_context(context) {
    connect(&context.appearance, &Appearance::changed, this, [this] { restyle(); });
}

void Panel::restyle() {
    setFont(appearance().font(Appearance::Size::Normal));
    setStyleSheet(panelStyle(appearance()));
}

void Panel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void makeQuiet(QLabel& label, const Appearance& appearance) {
    label.setFont(appearance.font(Appearance::Size::Small));
    label.setStyleSheet(QStringLiteral("color: %1;").arg(appearance.quietText().name()));
}

void makeMessage(QLabel& label, const Appearance& appearance) {
    label.setFont(appearance.font(Appearance::Size::Small));
    label.setStyleSheet(QStringLiteral("color: %1;").arg(appearance.error().name()));
    label.setWordWrap(true);
    label.setVisible(!label.text().isEmpty());
}

} // namespace thetalane
