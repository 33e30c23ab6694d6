#include "ui/appearance.h"

#include <QFontDatabase>

#include <array>

namespace thetalane {
namespace {

// One family in which Korean and Latin fit together; the system's where none of these is present.
QString family() {
    static const QString chosen = [] {
        const QStringList present = QFontDatabase::families();
        for (const char* name :
             {"Pretendard", "Noto Sans CJK KR", "Noto Sans KR", "NanumGothic", "Malgun Gothic"})
            if (present.contains(QLatin1String(name)))
                return QString::fromLatin1(name);
        return QFont().family();
    }();
    return chosen;
}

} // namespace

Appearance::Appearance(QObject* parent)
    : QObject(parent) {}

void Appearance::setProjector(bool on) {
    if (on == m_projector)
        return;
    m_projector = on;
    emit changed();
}

void Appearance::setReducedMotion(bool on) {
    if (on == m_reducedMotion)
        return;
    m_reducedMotion = on;
    emit changed();
}

void Appearance::setDark(bool on) {
    if (on == m_dark)
        return;
    m_dark = on;
    emit changed();
}

// On dark ground the same hues, lighter, so that they are told apart as well as on paper.
QColor Appearance::ink(Ink role) const {
    switch (role) {
    case Ink::First:
        return m_dark ? QColor(0x4D, 0xA8, 0xE0) : QColor(0x00, 0x72, 0xB2);
    case Ink::Second:
        return m_dark ? QColor(0xFF, 0x8A, 0x3D) : QColor(0xD5, 0x5E, 0x00);
    case Ink::Along:
        return m_dark ? QColor(0x2C, 0xC7, 0x9A) : QColor(0x00, 0x9E, 0x73);
    case Ink::Across:
        return m_dark ? QColor(0xE0, 0xA3, 0xC8) : QColor(0xCC, 0x79, 0xA7);
    case Ink::Triangle:
        return m_dark ? QColor(0xF2, 0xB9, 0x3B) : QColor(0xE6, 0x9F, 0x00);
    case Ink::Plain:
        break;
    }
    return text();
}

QColor Appearance::textInk(Ink role) const {
    if (m_dark)
        return ink(role);
    switch (role) {
    case Ink::First:
        return QColor(0x00, 0x5F, 0x95);
    case Ink::Second:
        return QColor(0xAD, 0x4A, 0x00);
    case Ink::Along:
        return QColor(0x00, 0x74, 0x54);
    case Ink::Across:
        return QColor(0x9C, 0x43, 0x75);
    case Ink::Triangle:
        return QColor(0x8A, 0x5C, 0x00);
    case Ink::Plain:
        break;
    }
    return text();
}

// Light; light on a projector; dark; dark on a projector.
QColor Appearance::pick(QRgb light, QRgb lightProjector, QRgb dark, QRgb darkProjector) const {
    return QColor::fromRgb(m_dark ? (m_projector ? darkProjector : dark)
                                  : (m_projector ? lightProjector : light));
}

QColor Appearance::window() const {
    return pick(0xF4F5F7, 0xFFFFFF, 0x14191F, 0x000000);
}
QColor Appearance::card() const {
    return pick(0xFFFFFF, 0xFFFFFF, 0x1F252C, 0x0E1216);
}
QColor Appearance::text() const {
    return pick(0x1E242B, 0x000000, 0xE8ECF0, 0xFFFFFF);
}
QColor Appearance::quietText() const {
    return pick(0x5A6570, 0x333A42, 0xA8B2BC, 0xC8D0D8);
}
QColor Appearance::faintText() const {
    return pick(0x758391, 0x5A6570, 0x76828E, 0x8E98A2);
}
QColor Appearance::noteGround() const {
    return pick(0xFBF0D4, 0xF5DFA8, 0x3D3218, 0x4A3A12);
}
QColor Appearance::line() const {
    return pick(0xD9DDE2, 0x9AA2AB, 0x3A434D, 0x66707A);
}
QColor Appearance::accent() const {
    return pick(0x005F95, 0x005F95, 0x6BB8EA, 0x7CC4F2);
}
QColor Appearance::hover() const {
    return pick(0xE8EEF3, 0xE3ECF3, 0x26303A, 0x1E2A34);
}
QColor Appearance::chosen() const {
    return pick(0xDCEAF4, 0xC4DDEE, 0x1F4158, 0x24506E);
}
QColor Appearance::error() const {
    return pick(0xB01E1E, 0xB01E1E, 0xFF9A90, 0xFFA79E);
}
QColor Appearance::errorGround() const {
    return pick(0xFCEDED, 0xFCEDED, 0x3B1F20, 0x3B1F20);
}
QColor Appearance::wood() const {
    return pick(0xF3E8D6, 0xF3E8D6, 0x3A3226, 0x2C261C);
}
QColor Appearance::woodLine() const {
    return pick(0xDFCDB0, 0xDFCDB0, 0x544834, 0x544834);
}
QColor Appearance::gutter() const {
    return pick(0xC9CDD2, 0xC9CDD2, 0x2A2F35, 0x20252A);
}
QColor Appearance::floor() const {
    return pick(0xFBFBFC, 0xFBFBFC, 0x171C22, 0x07090B);
}
QColor Appearance::pin() const {
    return pick(0xFFFFFF, 0xFFFFFF, 0x353D46, 0x2B323A);
}
QColor Appearance::onInk() const {
    return pick(0xFFFFFF, 0xFFFFFF, 0x10151A, 0x000000);
}

int Appearance::pixels(Size size) const {
    static constexpr std::array usual{11, 13, 16, 22};
    static constexpr std::array large{16, 20, 26, 36};
    return (m_projector ? large : usual)[std::size_t(size)];
}

QFont Appearance::font(Size size, bool bold) const {
    QFont f(family());
    f.setPixelSize(pixels(size));
    f.setBold(bold);
    return f;
}

// Symbols are set in a serif, as in a textbook.
QFont Appearance::formulaFont(int pixelSize, bool italic) const {
    static const QString serif = [] {
        const QStringList present = QFontDatabase::families();
        for (const char* name :
             {"STIX Two Text", "XITS", "Latin Modern Roman", "DejaVu Serif", "Noto Serif CJK KR"})
            if (present.contains(QLatin1String(name)))
                return QString::fromLatin1(name);
        return QStringLiteral("serif");
    }();
    QFont f(serif);
    f.setPixelSize(pixelSize);
    f.setItalic(italic);
    return f;
}

QPalette Appearance::palette() const {
    QPalette p;
    p.setColor(QPalette::Window, window());
    p.setColor(QPalette::WindowText, text());
    p.setColor(QPalette::Base, card());
    p.setColor(QPalette::AlternateBase, window());
    p.setColor(QPalette::Text, text());
    p.setColor(QPalette::Button, card());
    p.setColor(QPalette::ButtonText, text());
    p.setColor(QPalette::PlaceholderText, quietText());
    p.setColor(QPalette::Highlight, accent());
    p.setColor(QPalette::HighlightedText, card());
    p.setColor(QPalette::ToolTipBase, card());
    p.setColor(QPalette::ToolTipText, text());
    p.setColor(QPalette::Link, accent());
    p.setColor(QPalette::Disabled, QPalette::Text, quietText());
    p.setColor(QPalette::Disabled, QPalette::ButtonText, quietText());
    return p;
}

// What the palette cannot say: flat bars, quiet tabs, a focus that is seen.
QString Appearance::styleSheet() const {
    QString sheet = QStringLiteral(R"(
        QTabBar, QToolButton { font-size: @normalpx; }
        QToolTip { font-size: @normalpx; color: @text; background: @card; border: 1px solid @line; padding: 4px; }
        QTabWidget::pane { border: none; border-left: 1px solid @line; background: @window; }
        QTabBar { background: @window; }
        QTabBar::tab { background: @window; color: @quiet; border: none; border-bottom: @barpx solid transparent;
                       padding: @halfpx @unitpx; min-height: @tappx; }
        QTabBar::tab:selected { color: @text; border-bottom: @barpx solid @accent; }
        QTabBar::tab:hover { color: @text; }
        QTabBar::tab:focus { color: @accent; background: @hover; }
        QToolButton { background: transparent; border: 1px solid transparent; border-radius: 4px;
                      padding: @halfpx; min-height: @tappx; }
        QToolButton:hover { background: @hover; }
        QToolButton:pressed { background: @line; }
        QToolButton:checked { color: @accent; background: @hover; }
        QToolButton::menu-indicator { image: none; width: 0; }
        QMenu { background: @card; color: @text; border: 1px solid @line; padding: 4px 0; font-size: @normalpx; }
        QMenu::item { min-height: @tappx; padding: 0 24px 0 28px; }
        QMenu::item:selected { background: @accent; color: @card; }
        QMenu::item:disabled { color: @quiet; background: transparent; }
        QMenu::separator { height: 1px; background: @line; margin: 4px 0; }
        QToolButton:focus { border-color: @accent; }
        QSplitter::handle { background: @line; width: 1px; }
    )");
    const std::pair<const char*, QString> values[] = {
        {"@normalpx", QStringLiteral("%1px").arg(pixels(Size::Normal))},
        {"@text", text().name()},
        {"@card", card().name()},
        {"@line", line().name()},
        {"@window", window().name()},
        {"@quiet", quietText().name()},
        {"@accent", accent().name()},
        {"@hover", hover().name()},
        {"@halfpx", QStringLiteral("%1px").arg(unit() / 2)},
        {"@unitpx", QStringLiteral("%1px").arg(2 * unit())},
        {"@barpx", QStringLiteral("%1px").arg(m_projector ? 4 : 3)},
        {"@tappx", QStringLiteral("%1px").arg(m_projector ? 36 : 24)},
    };
    for (const auto& [name, value] : values)
        sheet.replace(QLatin1String(name), value);
    return sheet;
}

} // namespace thetalane
