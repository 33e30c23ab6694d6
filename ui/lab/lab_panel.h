// The accuracy lab: what a way of computing costs and how far off it is, measured beside the window. Presets
// that make a point each, or the scene in the window with methods of one's own choice.
#pragma once

#include "ui/lab/lab_plot.h"
#include "ui/lab/lab_worker.h"
#include "ui/panels/panel.h"

class QComboBox;
class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace thetalane {

class GhostBox;
class LabTable;
class MethodChoice;
class PlotView;
class PresetRow;
class ValueRow;

class LabPanel : public Panel {
    Q_OBJECT
public:
    // share: of the usual number of throws in the presets; tests take fewer.
    explicit LabPanel(const Context& context, QWidget* parent = nullptr, double share = 1);

    void choose(Preset preset); // and runs it
    void chooseOwn();           // shows the methods to choose from
    void cancel() { m_worker->cancel(); }

    bool running() const { return m_worker->running(); }
    std::shared_ptr<const LabResult> result() const { return m_result; } // null before the first

    void retranslate() override;

signals:
    void resultShown(); // for each news of the run

protected:
    void restyle() override;

private:
    void build(const Context& context);
    QWidget* makeDials();
    QWidget* makeProgress();
    QWidget* makeDiagram();
    void start(LabPlan plan);
    void runOwn();
    void runDials();
    void take(std::shared_ptr<const LabResult> result);
    void clear();
    void drop(); // what was asked last, and what was found
    void showProgress();
    void showPlot();
    void nameDiagrams();
    void stopOrAgain();
    void pointPicked(std::size_t series, std::size_t point);
    Diagram diagram() const;

    double m_share;
    LabWorker* m_worker;
    std::shared_ptr<const LabPlan> m_plan; // asked for last
    std::shared_ptr<const LabResult> m_result;
    LabPlot m_shown;

    QVBoxLayout* m_column = nullptr;
    PresetRow* m_presets = nullptr;
    QLabel* m_hint = nullptr;
    QWidget* m_dials = nullptr;
    ValueRow* m_speed = nullptr;
    ValueRow* m_perSecond = nullptr;
    QTimer* m_settled = nullptr; // a dial that is still being turned waits
    MethodChoice* m_methods = nullptr;
    QLabel* m_sentence = nullptr;
    QWidget* m_progress = nullptr;
    QProgressBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    QPushButton* m_stop = nullptr;
    GhostBox* m_ghosts = nullptr;
    QWidget* m_diagram = nullptr;
    QComboBox* m_diagrams = nullptr;
    PlotView* m_plot = nullptr;
    LabTable* m_table = nullptr;
};

} // namespace thetalane
