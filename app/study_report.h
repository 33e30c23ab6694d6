// A study of methods as a table for people, and as CSV.
#pragma once

#include "core/study/study.h"

#include <QList>
#include <QString>

namespace thetalane {

struct StudyConditions {
    QString date;    // ISO 8601, UTC
    QString machine; // processor, cores, system
    QString seed;    // of throws; empty for one scene
    QString call;
};
StudyConditions conditionsNow(const QString& seed, const QString& call);

void printStudy(const StudyResult& result, bool throws);
void printModels(const StudyResult& ablation, bool throws);

// A line each: engine,precision,step_s,cost_us,error_m,same_pins_percent,collisions, then more; a cell is
// empty where nothing was measured. Of models left out, errors are against the run with all models.
QString studyCsv(const QList<const StudyResult*>& results, const StudyConditions& conditions);

} // namespace thetalane
