// One step of a collision: a header that opens it, the figure, the formulas, and a sentence.
#pragma once

#include "ui/steps/formula_view.h"
#include "ui/steps/step_figure.h"
#include "ui/steps/step_header.h"

#include <QLabel>
#include <QVariantAnimation>

namespace thetalane {

class StepCard : public QWidget {
    Q_OBJECT
public:
    StepCard(const Appearance& appearance, Stage stage, QWidget* parent = nullptr);

    Stage stage() const { return m_stage; }
    bool isOpen() const { return m_open; }
    void setOpen(bool open, bool animated);
    void setStep(const WorkedStep& step, std::shared_ptr<const Run> run, std::size_t collision);

    // How much is seen of it at once [px]: the figure leaves room for the first formulas.
    void setPageHeight(int page);

    int headerHeight() const { return m_header->sizeHint().height(); }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void chosen(thetalane::Stage stage);
    void grew(); // while it opens

protected:
    void resizeEvent(QResizeEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void applyAppearance();
    int bodyHeight(int width) const; // all of it, open
    void arrange();

    const Appearance& m_appearance;
    Stage m_stage;
    StepHeader* m_header;
    QWidget* m_body;
    StepFigure* m_figure;
    FormulaView* m_formulas;
    QLabel* m_sentence;
    QVariantAnimation m_animation;
    bool m_open = false;
    double m_opened = 0; // 0 closed, 1 open
};

} // namespace thetalane
