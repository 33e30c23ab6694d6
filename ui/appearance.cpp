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

QColor Appearance::ink(Ink role) const {
    switch (role) {
    case Ink::First:
        return QColor(0x00, 0x72, 0xB2);
    case Ink::Second:
        return QColor(0xD5, 0x5E, 0x00);
    case Ink::Along:
        return QColor(0x00, 0x9E, 0x73);
    case Ink::Across:
        return QColor(0xCC, 0x79, 0xA7);
    case Ink::Triangle:
        return QColor(0xE6, 0x9F, 0x00);
    case Ink::Plain:
        break;
    }
    return text();
}

QColor Appearance::textInk(Ink role) const {
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

QColor Appearance::window() const {
    return m_projector ? QColor(0xFF, 0xFF, 0xFF) : QColor(0xF4, 0xF5, 0xF7);
}
QColor Appearance::card() const {
    return QColor(0xFF, 0xFF, 0xFF);
}
QColor Appearance::text() const {
    return m_projector ? QColor(0x00, 0x00, 0x00) : QColor(0x1E, 0x24, 0x2B);
}
QColor Appearance::quietText() const {
    return m_projector ? QColor(0x33, 0x3A, 0x42) : QColor(0x5A, 0x65, 0x70);
}
QColor Appearance::line() const {
    return m_projector ? QColor(0x9A, 0xA2, 0xAB) : QColor(0xD9, 0xDD, 0xE2);
}
QColor Appearance::accent() const {
    return QColor(0x00, 0x5F, 0x95);
}
QColor Appearance::error() const {
    return QColor(0xB0, 0x1E, 0x1E);
}
QColor Appearance::wood() const {
    return QColor(0xF3, 0xE8, 0xD6);
}
QColor Appearance::woodLine() const {
    return QColor(0xDF, 0xCD, 0xB0);
}
QColor Appearance::gutter() const {
    return QColor(0xC9, 0xCD, 0xD2);
}
QColor Appearance::floor() const {
    return QColor(0xFB, 0xFB, 0xFC);
}
QColor Appearance::pin() const {
    return QColor(0xFF, 0xFF, 0xFF);
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
        {"@hover", m_projector ? QStringLiteral("#E3ECF3") : QStringLiteral("#E8EEF3")},
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
