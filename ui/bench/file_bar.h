// For the top bar: the File menu, undo and redo, and their keys.
#pragma once

#include "ui/bench/file_flow.h"
#include "ui/context.h"

#include <QWidget>

class QAction;
class QMenu;
class QToolButton;

namespace thetalane {

class FileBar : public QWidget {
    Q_OBJECT
public:
    FileBar(const Context& context, FileFlow& flow, QWidget* parent = nullptr);

    void retranslate();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum Act { New, Open, Save, SaveAs, Undo, Redo, actCount };

    void restyle();
    void buildMenu();
    void showState();
    void fillRecent();

    const Appearance& m_appearance;
    FileFlow& m_flow;
    QToolButton* m_file;
    QToolButton* m_undo;
    QToolButton* m_redo;
    QMenu* m_menu;
    QMenu* m_recent;
    QAction* m_acts[actCount]{};
};

} // namespace thetalane
