#include "ui/window/shortcuts.h"

#include "ui/rail/rail_button.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QShortcut>
#include <QTabBar>

namespace thetalane {

bool usesLetters(const QWidget* w) {
    return qobject_cast<const QLineEdit*>(w) || qobject_cast<const QPlainTextEdit*>(w) ||
           qobject_cast<const QAbstractSpinBox*>(w);
}

bool usesArrows(const QWidget* w) {
    // What moves by the arrows without being one of Qt's own says so.
    return usesLetters(w) || qobject_cast<const QAbstractItemView*>(w) || qobject_cast<const QComboBox*>(w) ||
           qobject_cast<const QAbstractSlider*>(w) || qobject_cast<const QTabBar*>(w) ||
           qobject_cast<const RailButton*>(w) || (w && w->property("usesArrows").toBool());
}

// Only the Tab key brings the focus to a button. A field of text takes its letters by itself.
bool usesSpace(const QWidget* w) {
    return qobject_cast<const QAbstractButton*>(w) || qobject_cast<const QComboBox*>(w) ||
           (w && w->property("usesSpace").toBool());
}

Shortcuts::Shortcuts(QWidget* window)
    : QObject(window)
    , m_window(window) {}

void Shortcuts::add(Shortcut shortcut) {
    auto* key = new QShortcut(shortcut.keys, m_window);
    connect(key, &QShortcut::activated, this, shortcut.action);
    if (const auto givesWayTo = shortcut.givesWayTo)
        connect(qApp, &QApplication::focusChanged, key,
                [=](QWidget*, QWidget* now) { key->setEnabled(!givesWayTo(now)); });
    m_all.push_back(std::move(shortcut));
}

void Shortcuts::mention(const QKeySequence& keys, std::function<QString()> what) {
    m_all.push_back({keys, std::move(what)});
}

} // namespace thetalane
