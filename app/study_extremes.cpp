// thetalane study extremes
#include "app/console.h"
#include "app/save_file.h"
#include "app/studies.h"
#include "app/study_words.h"
#include "app/text_table.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdio>

namespace thetalane {
namespace {

struct StudyCommandText {
    Q_DECLARE_TR_FUNCTIONS(StudyCommandText)
};

void tellProgress(ExtremeRow row) {
    const QByteArray line =
        QString("%1/%2 %3\n").arg(int(row) + 1).arg(int(ExtremeRow::Mirror) + 1).arg(rowTitle(row)).toUtf8();
    std::fwrite(line.constData(), 1, std::size_t(line.size()), stderr);
}

void printExtremes(const std::vector<ExtremeResult>& results) {
    using Align = Column::Align;
    const QList<Column> columns{{StudyCommandText::tr("Row"), Align::Left},
                                {StudyCommandText::tr("Case"), Align::Left},
                                {StudyCommandText::tr("Asked"), Align::Left},
                                {StudyCommandText::tr("Exact")},
                                {StudyCommandText::tr("Got")},
                                {StudyCommandText::tr("Error")},
                                {StudyCommandText::tr("Bound")},
                                {StudyCommandText::tr("Within"), Align::Left}};
    const QString yes = StudyCommandText::tr("yes"), no = StudyCommandText::tr("NO");
    printTable(columns, results.size(), [&](std::size_t i) {
        const ExtremeResult& r = results[i];
        const bool begins = i == 0 || results[i - 1].row != r.row;
        return QStringList{begins ? rowTitle(r.row) : QString(),
                           caseTitle(r),
                           measureTitle(r.asked),
                           QString::number(r.exact, 'g', 12),
                           QString::number(r.got, 'g', 12),
                           QString::number(r.error, 'g', 2),
                           QString::number(r.bound, 'g', 2),
                           r.within() ? yes : no};
    });
}

// The status to leave with: those beyond their bounds are told in one line.
int verdict(const std::vector<ExtremeResult>& results) {
    const auto within = std::count_if(results.begin(), results.end(), [](auto& r) { return r.within(); });
    printLine();
    printLine(StudyCommandText::tr("Within their bounds: %1 of %2").arg(within).arg(results.size()));
    if (const int status = finishOutput(); status != Done)
        return status;
    QStringList beyond;
    for (const ExtremeResult& r : results)
        if (!r.within())
            beyond << rowTitle(r.row) + " (" + caseTitle(r) + "): " + measureTitle(r.asked);
    return beyond.isEmpty() ? Done
                            : failure(StudyCommandText::tr("beyond their bounds: %1").arg(beyond.join("; ")));
}

} // namespace

int studyOfExtremes(bool quick, const QString& csvPath) {
    if (const auto status = csvPath.isEmpty() ? std::nullopt : cannotSave(csvPath))
        return *status;
    const auto results = studyExtremes(quick, tellProgress);
    if (!csvPath.isEmpty())
        if (const int status = saveFile(csvPath, extremesCsv(results).toUtf8()); status != Done)
            return status;
    printExtremes(results);
    return verdict(results);
}

} // namespace thetalane
