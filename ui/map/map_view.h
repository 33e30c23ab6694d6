// The strike map to point at: cells, axes, the present throw as a cross, deliveries as dots.
#pragma once

#include "core/study/strike_map.h"
#include "ui/appearance.h"

#include <QPixmap>
#include <QWidget>

#include <memory>
#include <optional>

namespace thetalane {

class MapView : public QWidget {
    Q_OBJECT
public:
    struct Place { // of the map
        int column = 0;
        int row = 0;
        friend bool operator==(const Place&, const Place&) = default;
    };
    struct Values { // of its axes, SI
        double across = 0;
        double up = 0;
    };

    explicit MapView(const Appearance& appearance, QWidget* parent = nullptr);

    void setMap(std::shared_ptr<const StrikeMap> map); // null: none yet
    const std::shared_ptr<const StrikeMap>& map() const { return m_map; }
    void setPresent(std::optional<Values> values);
    void setDots(std::vector<Values> dots);

    // Of a coarse map: the cell that stands for it. Nothing beside the cells.
    std::optional<Place> placeAt(const QPointF& point) const;
    QPointF pointOf(const Values& values) const; // may lie beside the cells
    QPointF pointOf(const Place& place) const;   // its middle
    QRectF cells() const;
    std::optional<Place> pointed() const { return m_pointed; } // by mouse or keys
    bool shows(const Values& values) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

    void describe(const QString& text); // of the place that is pointed at
    void retranslate();

signals:
    void pointedChanged();
    void chosen(thetalane::MapView::Place place); // to be thrown

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void point(std::optional<Place> place);
    bool stepBy(int key, int cells);
    const QPixmap& picture();
    void paintAxes(QPainter& p) const;
    void paintPockets(QPainter& p) const;
    void paintMark(QPainter& p, const QPointF& at) const;
    double leftMargin() const;
    double bottomMargin() const;

    const Appearance& m_appearance;
    std::shared_ptr<const StrikeMap> m_map;
    std::optional<Values> m_present;
    std::vector<Values> m_dots;
    std::optional<Place> m_pointed;
    QPixmap m_picture;
};

} // namespace thetalane
