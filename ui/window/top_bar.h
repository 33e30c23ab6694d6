// The bar along the top: what is looked at, how it is computed, and how the window looks.
#pragma once

#include "ui/context.h"
#include "ui/words/language.h"

#include <QWidget>

class QAction;
class QHBoxLayout;
class QMenu;
class QToolButton;

namespace thetalane {

class IconButton;
class SceneChooser;

class TopBar : public QWidget {
    Q_OBJECT
public:
    TopBar(const Context& context, Language& language, QWidget* parent = nullptr);

    void addFirst(QWidget* widget); // at the left end

    SceneChooser& scenes() { return *m_scenes; }

signals:
    void openFileRequested();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void retranslate();
    void restyle();
    void buildViewMenu();
    void shorten();

    Context m_context;
    Language& m_language;
    QHBoxLayout* m_row;
    SceneChooser* m_scenes;
    IconButton* m_reset;
    QToolButton* m_view;
    QMenu* m_viewMenu;
    QAction* m_dark;
    QAction* m_stillness; // less motion
    QToolButton* m_projector;
    QToolButton* m_korean;
    QToolButton* m_english;
};

} // namespace thetalane
