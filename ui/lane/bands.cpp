#include "ui/lane/bands.h"

#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr int beyond = 2; // [px] where nothing shows, what is cut may end

// From row to row.
struct Rows {
    int top = 0;
    int bottom = 0; // the first that is not of it

    int count() const { return bottom - top; }
};

QRectF around(const QRectF& all, const Rows& rows) {
    return QRectF(all.left(), rows.top - beyond, all.width(), rows.count() + 2 * beyond);
}

// One row, as wide as everything that shows.
QPixmap rowOf(const QPainter& like, const QRectF& all, int row,
              const std::function<void(QPainter&, const QRectF&)>& paint) {
    const double ratio = like.device()->devicePixelRatioF();
    QPixmap pixmap(int(std::ceil(all.right() * ratio)), int(ratio));
    pixmap.setDevicePixelRatio(ratio);
    QPainter painter(&pixmap);
    painter.setRenderHints(like.renderHints());
    painter.translate(0, -row);
    paint(painter, around(all, {row, row + 1}));
    return pixmap;
}

} // namespace

void paintInBands(QPainter& painter, const QRectF& all, std::vector<double> borders, double spread,
                  const std::function<void(QPainter& painter, const QRectF& all)>& paint) {
    const double ratio = painter.device()->devicePixelRatioF();
    if (ratio != std::floor(ratio) || all.right() < 1) // a row is then no row of the screen's
        return paint(painter, all);
    const int top = int(std::floor(all.top())), bottom = int(std::ceil(all.bottom()));
    borders.insert(borders.end(), {double(bottom) + spread});
    std::sort(borders.begin(), borders.end());
    const auto changing = [&](int from, int to) { // these rows each by itself
        if (from >= to)
            return;
        painter.save();
        painter.setClipRect(QRectF(all.left(), from, all.width(), to - from), Qt::IntersectClip);
        paint(painter, around(all, {from, to}));
        painter.restore();
    };
    constexpr int worthwhile = 8;  // rows; fewer are not worth a picture
    int next = top, pending = top; // the rows from `pending` on are yet to be painted
    for (const double border : borders) {
        const int from = std::clamp(int(std::floor(border - spread)), next, bottom);
        if (from - next >= worthwhile) {
            changing(pending, next);
            const QPixmap row = rowOf(painter, all, next, paint);
            painter.drawTiledPixmap(QRectF(0, next, row.width() / ratio, from - next), row);
            pending = from;
        }
        next = std::clamp(int(std::ceil(border + spread)), next, bottom);
    }
    changing(pending, bottom);
}

} // namespace thetalane
