// A floor that is the same along the lane, but at a few heights: between them one row of pixels stands for
// all, and painting it once and copying it takes a fraction of painting it as a whole. The pixels are the
// same.
#pragma once

#include <QPainter>
#include <QRectF>

#include <functional>
#include <vector>

namespace thetalane {

// paint(painter, all): fills `all` [px], opaque, with what changes along y only at the borders [px]; what it
// cuts, it may cut where `all` ends. The painter works in pixels. A line at a border is at most `spread` away
// from it.
void paintInBands(QPainter& painter, const QRectF& all, std::vector<double> borders, double spread,
                  const std::function<void(QPainter& painter, const QRectF& all)>& paint);

} // namespace thetalane
