#include "ui/help/term_help.h"

#include "ui/words/glossary.h"

#include <QApplication>
#include <QCursor>
#include <QHelpEvent>
#include <QToolTip>
#include <QWidget>

namespace thetalane {
namespace {

QString termOf(const QWidget* widget) {
    for (; widget; widget = widget->parentWidget())
        if (const QString term = widget->property(termProperty).toString(); !term.isEmpty())
            return term;
    return {};
}

// A tool tip of its own first, then what the term means. Rich text: the lines break by themselves.
QString tipFor(const QWidget& widget, const GlossaryEntry& entry) {
    const QString own = widget.toolTip();
    return (own.isEmpty() ? QString() : "<p>" + own.toHtmlEscaped() + "</p>") + "<p><b>" +
           entry.term.toHtmlEscaped() + "</b><br>" + entry.text.toHtmlEscaped() + " <i>(F1)</i></p>";
}

} // namespace

TermHelp::TermHelp(QWidget& window)
    : QObject(&window)
    , m_window(window) {
    qApp->installEventFilter(this);
}

QString TermHelp::termOfNow() const {
    const QString under = termOf(QApplication::widgetAt(QCursor::pos()));
    return under.isEmpty() ? termOf(QApplication::focusWidget()) : under;
}

bool TermHelp::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || widget->window() != &m_window)
        return false;
    // Not of what stands around it: a widget may have more to tell about itself, such as all its digits.
    const GlossaryEntry* entry = glossaryEntry(widget->property(termProperty).toString());
    if (!entry)
        return false;
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tipFor(*widget, *entry), widget);
    return true;
}

} // namespace thetalane
