// What a term means, wherever it stands: a pause of the mouse explains it, F1 opens the glossary at it.
#pragma once

#include <QObject>

class QWidget;

namespace thetalane {

class TermHelp : public QObject {
    Q_OBJECT
public:
    // Answers for everything inside the window.
    explicit TermHelp(QWidget& window);

    // What F1 asks about: the term under the mouse, or of the widget with the focus; may be empty.
    QString termOfNow() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget& m_window;
};

} // namespace thetalane
