#include "ui/worksheet/worksheet.h"

#include "ui/words/scene_text.h"
#include "ui/worksheet/worksheet_parts.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>

namespace thetalane {
namespace {

// The largest type at which everything stands on one page; of very many bodies the smallest that can be read.
double emFor(const WorksheetParts& parts, const Appearance& appearance) {
    constexpr double largest = 105, smallest = 60, step = 2.5; // [0.1 pt]
    double em = largest;
    for (; em > smallest; em -= step) {
        Paper measure(appearance, em, nullptr);
        parts.all(measure);
        if (measure.y() <= Paper::pageHeight - Paper::margin * 0.8)
            break;
    }
    return em;
}

} // namespace

QByteArray worksheetPdf(const WorksheetSubject& subject) {
    const Appearance appearance;
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF()));
    writer.setResolution(720);
    writer.setTitle(sceneTitle(subject.scene, subject.language));
    writer.setCreator(QStringLiteral("ThetaLane"));
    QPainter painter(&writer);
    for (const Paper::Fill fill : {Paper::Fill::Blank, Paper::Fill::Answer}) {
        if (fill == Paper::Fill::Answer)
            writer.newPage();
        const WorksheetParts parts(subject, fill);
        Paper paper(appearance, emFor(parts, appearance), &painter);
        parts.all(paper);
    }
    painter.end();
    return pdf;
}

QString writeWorksheet(const QString& path, const WorksheetSubject& subject) {
    const QByteArray pdf = worksheetPdf(subject);
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(pdf) == pdf.size() && file.flush() && file.commit())
        return {};
    return file.errorString();
}

} // namespace thetalane
