// Keys of the whole window: each with what it does, so that the sheet of keys cannot say anything else.
#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

#include <functional>
#include <vector>

class QWidget;

namespace thetalane {

// Widgets with the focus that use a key themselves.
bool usesArrows(const QWidget* widget);
bool usesSpace(const QWidget* widget);
bool usesLetters(const QWidget* widget);

struct Shortcut {
    QKeySequence keys;
    std::function<QString()> what; // in the language of now
    std::function<void()> action{};
    bool (*givesWayTo)(const QWidget*) = nullptr;
};

class Shortcuts : public QObject {
    Q_OBJECT
public:
    explicit Shortcuts(QWidget* window);

    void add(Shortcut shortcut);
    // A key that a widget answers by itself: only said.
    void mention(const QKeySequence& keys, std::function<QString()> what);

    const std::vector<Shortcut>& all() const { return m_all; }

private:
    QWidget* m_window;
    std::vector<Shortcut> m_all;
};

} // namespace thetalane
