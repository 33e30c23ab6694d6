// One view of the tables: brought up to date while it is seen, and what it shows can be copied as a table.
#pragma once

#include "ui/panels/panel.h"
#include "ui/tables/sheet.h"

namespace thetalane {

class TablePage : public Panel {
    Q_OBJECT
public:
    TablePage(const Context& context, const char* name, QWidget* parent);

    virtual Sheet sheet() const = 0;

protected:
    virtual void showRun() = 0; // the run, its chapter, or the selected collision is another one
    virtual void showTime() {}  // the playhead moved
    void showEvent(QShowEvent* event) override;
    void refresh(); // now, or as soon as it is seen

    // The scene's collision that is open, in the present chapter; nothing where none is.
    std::optional<std::size_t> selected() const;
    // Of the chapter, as far as it is shown [s].
    std::pair<double, double> shownTimes() const;
    // "Collisions 12,501 to 25,000 of 1,000,000", or nothing where the run is kept whole.
    QString partText() const;

private:
    bool m_stale = true;
};

} // namespace thetalane
