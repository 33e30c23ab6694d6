// The strike map: which throws strike. Computed beside the window while one looks; any of its throws can be
// thrown.
#pragma once

#include "ui/map/map_view.h"
#include "ui/map/map_worker.h"
#include "ui/panels/panel.h"

class QProgressBar;
class QPushButton;
class QTimer;
class QVBoxLayout;

namespace thetalane {

class MapControls;
class MapLegend;
class PinDeck;

class MapPanel : public Panel {
    Q_OBJECT
public:
    // cells: columns and rows; tests take fewer.
    explicit MapPanel(const Context& context, QWidget* parent = nullptr, int cells = 256);

    // The player's own deliveries, as they came to the pins.
    void setDots(std::vector<Entry> entries);

    bool running() const { return m_worker->running(); }
    void cancel() { m_worker->cancel(); }
    const std::shared_ptr<const StrikeMap>& map() const { return m_view->map(); }

    // Where they tell what went wrong, it stands in the panel.
    bool saveCsv(const QString& path);
    bool savePicture(const QString& path);

    void retranslate() override;

signals:
    void thrown(); // a throw of the map is on the lane, and plays

protected:
    void restyle() override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    QWidget* makePointed();
    QWidget* makeProgress();
    QWidget* makeButtons();
    void start();
    void startIfOther();
    void take(const MapNews& news);
    void showState();
    void showPointed();
    void showPresent();
    void throwIt(MapView::Place place);
    void stopOrAgain();
    void ask(const QString& title, const QString& filter, const QString& suffix,
             bool (MapPanel::*save)(const QString&));
    bool save(const QString& path, const QByteArray& bytes);

    MapWorker* m_worker;
    MapControls* m_controls;
    MapView* m_view;
    MapLegend* m_legend;
    std::optional<MapSettings> m_asked;
    MapNews m_news;
    std::vector<Entry> m_entries;
    std::function<QString()> m_saved; // what became of it, in the language of now
    QTimer* m_settled;                // a throw that is being aimed waits
    PinDeck* m_deck = nullptr;
    QLabel* m_pointed = nullptr;
    QWidget* m_progress = nullptr;
    QLabel* m_state = nullptr;
    QProgressBar* m_bar = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_csv = nullptr;
    QPushButton* m_picture = nullptr;
    QLabel* m_message = nullptr;
    QLabel* m_note = nullptr;
    QVBoxLayout* m_column = nullptr;
};

} // namespace thetalane
