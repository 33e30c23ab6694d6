// What changes if: the throw of now with one attribute varied, the outcomes side by side. Any of them becomes
// the throw.
#pragma once

#include "core/study/vary_throw.h"
#include "ui/panels/panel.h"

class QComboBox;
class QTableView;
class QTimer;
class QVBoxLayout;

namespace thetalane {

class LatestJob;
class NumberField;
class VaryModel;

class VaryBox : public Panel {
    Q_OBJECT
public:
    explicit VaryBox(const Context& context, QWidget* parent = nullptr);

    void choose(ThrowQuantity quantity);
    ThrowQuantity quantity() const;
    bool running() const; // outcomes are on their way

    void retranslate() override;

signals:
    void outcomesShown();

protected:
    void restyle() override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void takeRange(); // the usual one of the quantity
    void ask();
    void askIfSeen();
    void take(const VarySettings& settings, std::vector<VariedThrow> outcomes);
    void becomeThrow(int row);
    void showMessage();
    void showSentence();
    void fitTable();
    VarySettings settings() const;
    bool isSound() const;

    LatestJob* m_job;
    VaryModel* m_model;
    QTimer* m_settled;
    QLabel* m_title;
    QLabel* m_hint;
    QComboBox* m_quantities;
    QLabel* m_fromText;
    NumberField* m_from;
    QLabel* m_toText;
    NumberField* m_to;
    QLabel* m_message;
    QLabel* m_sentence;
    QTableView* m_table;
    QVBoxLayout* m_column;
};

} // namespace thetalane
