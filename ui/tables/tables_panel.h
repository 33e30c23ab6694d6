// Tables and plots of the run: one view at a time, each to be copied, written as CSV or drawn as PNG; and a
// worksheet of the open collision to print.
#pragma once

#include "ui/panels/panel.h"

#include <vector>

class QComboBox;
class QGridLayout;
class QPushButton;
class QStackedWidget;

namespace thetalane {

class IconMark;
class TablePage;

class TablesPanel : public Panel {
    Q_OBJECT
public:
    enum class View { Collision, Bodies, Momentum, Centre, Course, Impulses };
    static constexpr int viewCount = 6;

    explicit TablesPanel(const Context& context, QWidget* parent = nullptr);

    View view() const;
    void choose(View view);

    void copy() const; // the present view, all digits, parted by tabs
    // Each says in the panel what became of it, and returns whether it was written.
    bool saveCsv(const QString& path);
    bool savePicture(const QString& path, double scale = 2); // times the size on screen
    bool saveWorksheet(const QString& path);                 // of the open collision, or of the first one

    void retranslate() override;

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void layButtons();
    void showChoice();
    void enableButtons();
    bool tell(const QString& path, const QString& fault);
    void askForCsv();
    void askForPicture();
    void askForWorksheet();
    QString suggestedName() const;

    QComboBox* m_chooser;
    QStackedWidget* m_pages;
    std::vector<TablePage*> m_views;
    QGridLayout* m_row;
    QPushButton* m_copy;
    QPushButton* m_csv;
    QPushButton* m_picture;
    QPushButton* m_worksheet;
    QLabel* m_message;
};

} // namespace thetalane
