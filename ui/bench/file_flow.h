// The conversation about files: which one, and what becomes of unsaved changes. Nothing here blocks: a
// question stands over its window, and what was to be done is done when it is answered.
#pragma once

#include "ui/bench/desk.h"

#include <QPointer>

#include <functional>

class QMessageBox;
class QWidget;

namespace thetalane {

class FileFlow : public QObject {
    Q_OBJECT
public:
    // window: what the dialogs belong to.
    FileFlow(Desk& desk, QWidget& window);

    Desk& desk() const { return m_desk; }

    // Does it at once, or after the changes are saved or given up; not at all if that is cancelled.
    void whenSafe(std::function<void()> action);

    void openNew();
    void chooseAndOpen();
    void open(const QString& path);
    void save();
    void saveAs();

private:
    void saveThen(std::function<void()> action);
    void chooseAndSave(std::function<void()> then);
    void ask(std::function<void()> action);

    Desk& m_desk;
    QWidget& m_window;
    QPointer<QMessageBox> m_question;
};

} // namespace thetalane
