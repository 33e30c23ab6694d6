// The games on the disk, the latest first; the one that is chosen is opened. A damaged one says what is
// wrong.
#pragma once

#include "ui/game/alley.h"
#include "ui/panels/panel.h"

class QComboBox;
class QLabel;
class QListWidget;

namespace thetalane {

class SavedGamesList : public Panel {
    Q_OBJECT
public:
    SavedGamesList(const Context& context, Alley& alley, QWidget* parent = nullptr);

    void refresh();
    void retranslate() override;

protected:
    void restyle() override;

private:
    void open(int row);

    Alley& m_alley;
    QLabel* m_heading;
    QListWidget* m_list;
    QLabel* m_message;
};

// The style of the lists of this room.
QString listStyle(const Appearance& appearance);
// The mark that says there is more to choose from; the style of panels takes Qt's own away.
void markAsChooser(QComboBox& box, const Appearance& appearance);

} // namespace thetalane
