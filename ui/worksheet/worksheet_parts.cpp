#include "ui/worksheet/worksheet_parts.h"

#include "ui/count_text.h"
#include "ui/steps/step_figure.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"
#include "ui/words/worked_lines.h"
#include "ui/worksheet/scene_picture.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

struct SheetText {
    Q_DECLARE_TR_FUNCTIONS(Worksheet)
};

constexpr double pixel = 8; // of a figure, on the paper [0.1 pt]

void paintFigure(Paper& paper, const FigureCanvas& canvas, QPointF corner) {
    paper.painter()->save();
    paper.painter()->translate(corner);
    paper.painter()->scale(pixel, pixel);
    paper.painter()->setClipRect(QRectF(QPointF(), canvas.size())); // a wall goes on beyond
    canvas.paint(*paper.painter());
    paper.painter()->restore();
}

} // namespace

WorksheetParts::WorksheetParts(const WorksheetSubject& subject, Paper::Fill fill)
    : m_subject(subject)
    , m_collision(subject.collisions[subject.index])
    , m_pass(passOf(subject.collisions, subject.index))
    , m_fill(fill)
    , m_steps(workedSteps(subject.scene, subject.collisions, subject.index)) {}

QString WorksheetParts::title() const {
    if (m_pass.size() > 1)
        return SheetText::tr("Worksheet: bodies that collide at once");
    return m_collision.isWall() ? SheetText::tr("Worksheet: collision with a wall")
                                : SheetText::tr("Worksheet: collision of two bodies");
}

void WorksheetParts::all(Paper& paper) const {
    head(paper);
    if (asks())
        pictureAndGiven(paper);
    else
        answerFigures(paper);
    question(paper, 1,
             m_collision.isWall()
                 ? SheetText::tr("Find θ, the direction of the line square on the wall (x′).")
                 : SheetText::tr("Find θ, the direction of the line of centres (x′)."));
    std::vector<WorkedLine> contact = m_steps[0].lines;
    contact.erase(contact.begin() + 3); // that they touch is known here
    paper.columns(contact, m_fill);
    question(paper, 2,
             SheetText::tr("Split the velocities before the collision along x′ and across it, y′."));
    paper.columns(m_steps[2].lines, m_fill);
    question(paper, 3,
             SheetText::tr("Along x′ it is a collision in one dimension: find the components after it."));
    exchange(paper);
    question(paper, 4, SheetText::tr("Turn back to x and y: find the velocities after the collision."));
    paper.columns(m_steps[4].lines, m_fill);
    question(paper, 5, SheetText::tr("Fill in the blanks of the table."));
    table(paper);
    question(paper, 6, SheetText::tr("Check the coefficient of restitution, the energy and the momentum."));
    check(paper);
}

void WorksheetParts::head(Paper& paper) const {
    const QColor ink = paper.appearance().text(), quiet = paper.appearance().quietText();
    const double left = Paper::margin, right = Paper::pageWidth - Paper::margin;
    const double big = 170 / paper.em();
    paper.text(left, paper.y() - 40, title(), ink, big, true);
    if (!asks()) {
        const QString answers = SheetText::tr("Answers");
        paper.text(right - paper.textWidth(answers, big, true), paper.y() - 40, answers,
                   paper.appearance().accent(), big, true);
    }
    paper.moveTo(paper.y() + 210);
    const double small = 90 / paper.em();
    const QString name = sceneTitle(m_subject.scene, m_subject.language);
    const QString which = SheetText::tr("Collision %1: %2, at %3 s")
                              .arg(countText(m_subject.number), contactName(m_subject.scene, m_collision),
                                   numberText(m_collision.time));
    paper.text(left, paper.y(), name.isEmpty() ? which : name + QStringLiteral(" · ") + which, quiet, small);
    paper.moveTo(paper.y() + 200);
    if (asks()) {
        double x = left;
        const std::pair<QString, double> fields[] = {
            {SheetText::tr("Class"), 0.2}, {SheetText::tr("Name"), 0.42}, {SheetText::tr("Date"), 0.24}};
        const double word = 100 / paper.em();
        for (const auto& [label, share] : fields) {
            const double wide = paper.textWidth(label, word) + 60;
            paper.text(x, paper.y(), label, ink, word);
            const double end = x + wide + share * paper.room();
            paper.line({x + wide, paper.y() + 125}, {std::min(end, right), paper.y() + 125}, ink, 5);
            x = end + 90;
        }
        paper.moveTo(paper.y() + 200);
    }
    paper.line({left, paper.y()}, {right, paper.y()}, paper.appearance().quietText(), 8);
    paper.moveTo(paper.y() + 60);
}

double WorksheetParts::given(Paper& paper, double x, double y, double width) const {
    const Scene& scene = m_subject.scene;
    const double size = std::min(95.0, paper.em());
    const FormulaLayout layout(paper.appearance(), int(size));
    double top = y;
    paper.text(x, top, SheetText::tr("What is given"), paper.appearance().text(), 1.1, true);
    top += 1.8 * paper.em();
    const auto write = [&](std::vector<Formula> parts) {
        const FormulaBox box = layout.box(row(std::move(parts)), width);
        if (paper.painter())
            paintFormula(*paper.painter(), box, {x, top + 0.95 * size}, paper.appearance());
        top += 1.42 * size + (box.broken ? box.height() - size : 0);
    };
    const auto body = [&](int index, const Disc<double>& disc, const Vec2d& before) {
        const Ink ink = inkOf(m_collision, index, {});
        const auto own = [&](const char* letter) {
            return script(symbol(letter, ink), upright(indexName(scene, index), ink));
        };
        const auto v = [&](const char* axis) {
            return velocitySymbol(scene, m_collision, index, axis, When::Before);
        };
        const auto is = [&](Formula left, double value) {
            return row({std::move(left), op("="), number(value, ink)});
        };
        write({own("m"), op("="), valued(disc.mass, ink, "kg")});
        write({is(own("x"), disc.position.x), op(","), is(own("y"), disc.position.y), unit("m")});
        write({is(v("x"), before.x), op(","), is(v("y"), before.y), unit("m/s")});
        top += 0.45 * size;
    };
    const PairCollision<double>& s = m_collision.steps;
    body(m_collision.first, s.first, s.before.first);
    if (!m_collision.isWall())
        body(m_collision.second, s.second, s.before.second);
    write({symbol("e"), op("="), number(s.restitution)});
    return top - y;
}

void WorksheetParts::question(Paper& paper, int number, const QString& text) const {
    paper.skip(0.55);
    const QString digit = QString::number(number);
    const double side = 1.45 * paper.em();
    if (paper.painter()) {
        paper.painter()->setPen(Qt::NoPen);
        paper.painter()->setBrush(paper.appearance().text());
        paper.painter()->drawEllipse(QRectF(Paper::margin, paper.y() + 0.02 * paper.em(), side, side));
    }
    paper.text(Paper::margin + (side - paper.textWidth(digit, 0.95, true)) / 2, paper.y() + 0.06 * paper.em(),
               digit, Qt::white, 0.95, true);
    paper.text(Paper::margin + 2 * paper.em(), paper.y(), text, paper.appearance().text(), 1.02, true);
    paper.skip(1.85);
}

void WorksheetParts::pictureAndGiven(Paper& paper) const {
    const double wide = 0.6 * paper.room(), high = 2000;
    const double top = paper.y();
    if (paper.painter()) {
        paintFigure(paper,
                    scenePicture(m_subject.scene, m_collision, m_pass, paper.appearance(),
                                 QSizeF(wide, high) / pixel),
                    {Paper::margin, top});
        paper.painter()->setBrush(Qt::NoBrush);
        paper.painter()->setPen(QPen(paper.appearance().line(), 6));
        paper.painter()->drawRect(QRectF(Paper::margin, top, wide, high));
    }
    const double list = given(paper, Paper::margin + wide + 150, top + 20, paper.room() - wide - 150);
    paper.moveTo(top + std::max(high, list));
}

// The contact with θ, the components after the exchange, and the momenta tip to tail.
void WorksheetParts::answerFigures(Paper& paper) const {
    const double gap = 80, wide = (paper.room() - 2 * gap) / 3, high = 1250;
    double x = Paper::margin;
    for (const Stage stage : {Stage::Contact, Stage::RotationBack, Stage::Check}) {
        if (paper.painter())
            paintFigure(paper,
                        stageFigure(m_subject.scene, m_subject.collisions, m_subject.index, stage,
                                    paper.appearance(), QSizeF(wide, high) / pixel),
                        {x, paper.y()});
        x += wide + gap;
    }
    paper.moveTo(paper.y() + high);
}

// Of several at once the impulses are given: to find them is a system of equations.
void WorksheetParts::exchange(Paper& paper) const {
    std::vector<WorkedLine> known, asked;
    for (const WorkedLine& line : m_steps[3].lines)
        (asks() && isEmpty(line.symbolic) && isEmpty(line.substituted) ? known : asked).push_back(line);
    if (!known.empty())
        paper.columns(known, Paper::Fill::Answer);
    paper.columns(asked, m_fill);
}

// μ = m_A m_B/(m_A + m_B), which the loss is written with.
WorkedLine WorksheetParts::reducedMass() const {
    const auto mass = [this](int body, Ink ink) {
        return script(symbol("m", ink), upright(indexName(m_subject.scene, body), ink));
    };
    const Formula a = mass(m_collision.first, Ink::First), b = mass(m_collision.second, Ink::Second);
    const double ma = m_collision.steps.first.mass, mb = m_collision.steps.second.mass;
    const Formula na = number(ma, Ink::First), nb = number(mb, Ink::Second);
    return {symbol(QString::fromUtf8("μ")), fraction(row({a, b}), row({a, op("+"), b})),
            fraction(row({na, operation("·"), nb}), row({na, op("+"), nb})),
            valued(ma * mb / (ma + mb), Ink::Plain, "kg")};
}

void WorksheetParts::check(Paper& paper) const {
    std::vector<WorkedLine> lines;
    for (const WorkedLine& line : m_steps[5].lines) {
        const QString left = plainText(line.left);
        const bool loss = left == QString::fromUtf8("E − E′");
        if (loss && m_pass.size() == 1 && !m_collision.isWall())
            lines.push_back(reducedMass());
        if (left == "e" || loss)
            lines.push_back(line);
    }
    double before = 0, lost = 0;
    for (const PassBody& b : bodiesOf(m_pass))
        before += b.mass * dot(b.before, b.before) / 2;
    for (const Collision& c : m_pass)
        lost += c.steps.energyLoss;
    if (before > 0)
        lines.push_back({fraction(row({symbol("E"), operation("−"),
                                       script(symbol("E"), {}, symbol(QString::fromUtf8("′")))}),
                                  symbol("E")),
                         {},
                         fraction(number(lost), number(before)),
                         row({number(100 * lost / before), unit("%")})});
    paper.columns(lines, m_fill);
    paper.skip(0.3);
    const QString asked =
        SheetText::tr("Is the total momentum the same before and after the collision? Why?");
    paper.text(Paper::margin, paper.y(), asked, paper.appearance().text());
    paper.skip(1.7);
    if (!asks()) {
        paper.skip(paper.paragraph(Paper::margin, paper.y(), paper.room(), momentumAnswer(),
                                   paper.appearance().accent()) /
                   paper.em());
        return;
    }
    for (int k = 0; k < 2; ++k) {
        paper.skip(1.6);
        paper.line({Paper::margin, paper.y()}, {Paper::pageWidth - Paper::margin, paper.y()},
                   paper.appearance().line(), 5);
    }
}

QString WorksheetParts::momentumAnswer() const {
    if (hasWall(m_pass))
        return SheetText::tr("No: the wall takes up an impulse, and by just that the momentum of the bodies "
                             "changes.");
    return SheetText::tr("Yes: only the bodies act on each other, with forces equal and opposite, so the "
                         "total momentum is kept.");
}

} // namespace thetalane
