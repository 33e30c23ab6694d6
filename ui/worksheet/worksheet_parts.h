// The parts of the worksheet, each put on the paper where it stands. A part that asks and one that answers
// have the same places.
#pragma once

#include "ui/worksheet/paper.h"
#include "ui/worksheet/worksheet.h"

#include <optional>

namespace thetalane {

class WorksheetParts {
public:
    WorksheetParts(const WorksheetSubject& subject, Paper::Fill fill);

    void all(Paper& paper) const; // one page

private:
    void head(Paper& paper) const;
    void pictureAndGiven(Paper& paper) const;
    void answerFigures(Paper& paper) const;
    double given(Paper& paper, double x, double y, double width) const;
    void question(Paper& paper, int number, const QString& text) const;
    void exchange(Paper& paper) const;
    struct TableLine { // before and after; a total has no velocity
        QString name;
        double mass;
        std::optional<Vec2d> velocity[2];
        Vec2d momentum[2];
        double energy[2];
    };
    std::vector<TableLine> tableLines() const;
    void table(Paper& paper) const;
    void tableLine(Paper& paper, const TableLine& line, double y, double scale) const;
    void tableRules(Paper& paper, double top, double first, double row, std::size_t count) const;
    void tableHead(Paper& paper, double top) const;
    void tableCell(Paper& paper, int column, double top, const QString& text, bool bold, bool answer) const;
    void check(Paper& paper) const;
    WorkedLine reducedMass() const;
    QString title() const;
    QString momentumAnswer() const;
    bool asks() const { return m_fill == Paper::Fill::Blank; }

    const WorksheetSubject& m_subject;
    const Collision& m_collision;
    std::span<const Collision> m_pass;
    Paper::Fill m_fill;
    std::vector<WorkedStep> m_steps;
};

} // namespace thetalane
