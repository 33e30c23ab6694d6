// What all panels share: their words follow the language, their look follows the appearance.
#pragma once

#include "ui/context.h"

#include <QWidget>

class QLabel;

namespace thetalane {

// The style of fields, buttons, lists and scroll areas inside a panel.
QString panelStyle(const Appearance& appearance);

class Panel : public QWidget {
    Q_OBJECT
public:
    Panel(const Context& context, QWidget* parent);

    // Every text anew, in the language of now. A panel's constructor calls it, and so does LanguageChange.
    virtual void retranslate() = 0;

protected:
    // Sizes and colours anew; called by the panel's constructor and on Appearance::changed.
    virtual void restyle();
    void changeEvent(QEvent* event) override;

    Session& session() const { return m_context.session; }
    Playhead& playhead() const { return m_context.playhead; }
    const Appearance& appearance() const { return m_context.appearance; }

private:
    Context m_context;
};

// Small, quiet text; a message in the colour of errors, which takes no room while it is empty.
void makeQuiet(QLabel& label, const Appearance& appearance);
void makeMessage(QLabel& label, const Appearance& appearance);

} // namespace thetalane
