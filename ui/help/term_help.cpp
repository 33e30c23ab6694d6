#include "ui/help/term_help.h"

#include "ui/words/glossary.h"

#include <QApplication>
#include <QCursor>
#include <QHeaderView>
#include <QHelpEvent>
#include <QToolTip>
#include <QWidget>

namespace thetalane {
namespace {

// Of a table's heading the model knows, section by section.
QVariant headingData(const QWidget& widget, const QPoint& at, int role) {
    const auto* header = qobject_cast<const QHeaderView*>(widget.parentWidget());
    const int section = header && header->model() ? header->logicalIndexAt(at) : -1;
    return section < 0 ? QVariant() : header->model()->headerData(section, header->orientation(), role);
}

QString ownTerm(const QWidget& widget, const QPoint& at) {
    const QString heading = headingData(widget, at, termRole).toString();
    return heading.isEmpty() ? widget.property(termProperty).toString() : heading;
}

QString termOf(const QWidget* widget, const QPoint& global) {
    for (; widget; widget = widget->parentWidget())
        if (const QString term = ownTerm(*widget, widget->mapFromGlobal(global)); !term.isEmpty())
            return term;
    return {};
}

// A tool tip of its own first, then what the term means. Rich text: the lines break by themselves.
QString tipFor(const QWidget& widget, const QPoint& at, const GlossaryEntry& entry) {
    const QString heading = headingData(widget, at, Qt::ToolTipRole).toString();
    const QString own = heading.isEmpty() ? widget.toolTip() : heading;
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
    const QString under = termOf(QApplication::widgetAt(QCursor::pos()), QCursor::pos());
    return under.isEmpty() ? termOf(QApplication::focusWidget(), QCursor::pos()) : under;
}

bool TermHelp::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || widget->window() != &m_window)
        return false;
    // Not of what stands around it: a widget may have more to tell about itself, such as all its digits.
    const auto* help = static_cast<QHelpEvent*>(event);
    const GlossaryEntry* entry = glossaryEntry(ownTerm(*widget, help->pos()));
    if (!entry)
        return false;
    QToolTip::showText(help->globalPos(), tipFor(*widget, help->pos(), *entry), widget);
    return true;
}

} // namespace thetalane
