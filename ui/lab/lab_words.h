// The lab in words: its presets, the rows of its table, and the sentence that says the point.
#pragma once

#include "ui/lab/run_lab.h"

#include <QString>

namespace thetalane {

QString presetName(Preset preset);     // "It went through"
QString presetQuestion(Preset preset); // what is done, for the tooltip

QString rowName(const LabPlan& plan, std::size_t row);
QString shiftText(double metres); // "1 µm"

// With the numbers of the result in it; of a part of the cases, where no more are done. Empty as long as
// there is nothing to say.
QString labSentence(const LabResult& result);

// How far it is, or how far it came: "12 of 60 throws", cancelled or done, and in what time.
QString labState(const LabResult& result);

// What a mark over the lane is about, in full: when and where, which body, which contact differs.
QString ghostText(const LabResult& result, const Ghost& ghost);
QString ghostShortText(const LabPlan& plan,
                       const Ghost& ghost); // "the paper's loop, 1/60 s: leaves at 0.12 s"

// No line ends between a number and its unit.
QString keptTogether(QString text);

QString percentText(double part); // "98.3 %"; 0 and 100 only where it is exactly that

} // namespace thetalane
