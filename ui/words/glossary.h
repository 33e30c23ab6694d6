// The terms of the field, each explained in a sentence or two.
#pragma once

#include "ui/words/language.h"

#include <QObject>
#include <QString>
#include <QVariant>

#include <vector>

namespace thetalane {

// Both languages stand beside each other in glossary.json: who learns a term looks for the other one, too.
struct GlossaryEntry {
    QString id; // "restitution": widgets name their term by it
    QString term;
    QString otherTerm; // in the other language
    QString text;
};

// In an order in which they can be read: the collision and its five steps, momentum and energy, the lane, the
// game, the computation.
std::vector<GlossaryEntry> glossary(Language::Code language);

// In the language of now; nothing where there is no such term.
const GlossaryEntry* glossaryEntry(const QString& id);

// The dynamic property by which a widget says which term it, and what stands in it, is about; a model says it
// of a heading by this role.
inline constexpr const char* termProperty = "term";
inline constexpr int termRole = Qt::UserRole + 64;

inline void setTerm(QObject* about, const char* id) {
    about->setProperty(termProperty, QString::fromLatin1(id));
}

} // namespace thetalane
