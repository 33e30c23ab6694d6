#include "ui/lane/stroke_notes.h"

#include <QFont>
#include <QImage>
#include <QLineF>
#include <QPainterPath>
#include <QPen>
#include <QPixmap>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

namespace thetalane {
namespace {

constexpr double soft = 1.5; // [px] of an edge, and of rounding

void add(std::uint64_t& note, std::uint64_t value) {
    note = (std::rotl(note, 29) ^ value) * 0x9E3779B97F4A7C15ULL;
    note ^= note >> 32;
}
void add(std::uint64_t& note, double value) {
    add(note, std::bit_cast<std::uint64_t>(value));
}
void add(std::uint64_t& note, const QPointF& point) {
    add(note, point.x());
    add(note, point.y());
}
void add(std::uint64_t& note, const QRectF& rect) {
    add(note, rect.topLeft());
    add(note, rect.bottomRight());
}
void add(std::uint64_t& note, const QColor& colour) {
    add(note, std::bit_cast<std::uint64_t>(colour.rgba64()));
}
void add(std::uint64_t& note, const QPainterPath& path) {
    add(note, std::uint64_t(path.fillRule()));
    for (int k = 0; k < path.elementCount(); ++k) {
        const QPainterPath::Element element = path.elementAt(k);
        add(note, std::uint64_t(element.type));
        add(note, QPointF(element));
    }
}

QRectF boxOf(const QPointF* points, int count) {
    QPointF low = points[0], high = points[0];
    for (int k = 1; k < count; ++k) {
        low = {std::min(low.x(), points[k].x()), std::min(low.y(), points[k].y())};
        high = {std::max(high.x(), points[k].x()), std::max(high.y(), points[k].y())};
    }
    return {low, high};
}

} // namespace

StrokeNotes::StrokeNotes(const QSize& size, int tile)
    : QPaintEngine(AllFeatures)
    , m_size(size)
    , m_tile(tile)
    , m_columns((size.width() + tile - 1) / tile)
    , m_rows((size.height() + tile - 1) / tile)
    , m_notes(std::size_t(m_columns) * std::size_t(m_rows)) {}

bool StrokeNotes::begin(QPaintDevice*) {
    std::fill(m_notes.begin(), m_notes.end(), 0);
    return true;
}

std::uint64_t StrokeNotes::unique() {
    static std::atomic<std::uint64_t> last = 0;
    std::uint64_t note = 1;
    add(note, ++last);
    return note;
}

std::uint64_t StrokeNotes::noteOf(const QBrush& brush) {
    if (brush.gradient() || brush.style() == Qt::TexturePattern)
        return unique(); // rather painted once too often than looked through
    auto note = std::uint64_t(brush.style());
    add(note, brush.color());
    return note;
}

std::uint64_t StrokeNotes::noteOf(const QPen& pen) {
    std::uint64_t note = noteOf(pen.brush());
    add(note, std::uint64_t(pen.style()));
    add(note,
        std::uint64_t(pen.capStyle()) | std::uint64_t(pen.joinStyle()) | std::uint64_t(pen.isCosmetic()));
    add(note, pen.widthF());
    add(note, pen.dashOffset());
    if (pen.style() == Qt::CustomDashLine)
        for (const double part : pen.dashPattern())
            add(note, part);
    return note;
}

void StrokeNotes::noteClip(const QPaintEngineState& now) {
    std::uint64_t& note = m_looks[ClipLook];
    if (!now.isClipEnabled() || now.clipOperation() != Qt::IntersectClip)
        note = 0;
    if (!now.isClipEnabled())
        return;
    add(note, std::uint64_t(now.clipOperation()));
    for (const QRect& rect : now.clipRegion())
        add(note, QRectF(rect));
    add(note, now.clipPath());
}

void StrokeNotes::updateState(const QPaintEngineState& now) {
    const DirtyFlags dirty = now.state();
    if (dirty & DirtyTransform) {
        m_transform = now.transform();
        std::uint64_t& note = m_looks[TransformLook] = 0;
        for (const double part : {m_transform.m11(), m_transform.m12(), m_transform.m21(), m_transform.m22(),
                                  m_transform.dx(), m_transform.dy()})
            add(note, part);
    }
    if (dirty & DirtyPen)
        m_looks[PenLook] = noteOf(now.pen());
    if (dirty & (DirtyPen | DirtyTransform)) {
        const QPen pen = now.pen();
        const double grown = pen.isCosmetic() ? 1 : std::sqrt(std::abs(m_transform.determinant())) * 1.5;
        // Half its width, and as far again at a corner.
        m_reach = pen.style() == Qt::NoPen ? 0 : std::max(pen.widthF(), 1.0) * std::max(grown, 1.0);
    }
    if (dirty & (DirtyBrush | DirtyBrushOrigin)) {
        m_looks[BrushLook] = noteOf(now.brush());
        m_filled = now.brush().style() != Qt::NoBrush;
    }
    if (dirty & DirtyFont)
        m_looks[FontLook] = qHash(now.font());
    if (dirty & (DirtyOpacity | DirtyHints | DirtyCompositionMode)) {
        std::uint64_t& note = m_looks[OtherLook] = std::uint64_t(now.renderHints());
        add(note, now.opacity());
        add(note, std::uint64_t(now.compositionMode()));
    }
    if (dirty & (DirtyClipRegion | DirtyClipPath | DirtyClipEnabled))
        noteClip(now);
}

std::uint64_t StrokeNotes::start(int kind) const {
    auto note = std::uint64_t(kind);
    for (const std::uint64_t look : m_looks)
        add(note, look);
    return note;
}

void StrokeNotes::markPixels(const QRectF& box, std::uint64_t note) {
    const auto place = [&](double pixel, int count) {
        return int(std::clamp(std::floor(pixel / m_tile), -1.0, double(count)));
    };
    const int left = std::max(place(box.left(), m_columns), 0);
    const int right = std::min(place(box.right(), m_columns), m_columns - 1);
    const int top = std::max(place(box.top(), m_rows), 0);
    const int bottom = std::min(place(box.bottom(), m_rows), m_rows - 1);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column)
            add(m_notes[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)], note);
}

void StrokeNotes::mark(const QRectF& box, std::uint64_t note, double more) {
    const double reach = m_reach + soft + more;
    markPixels(m_transform.mapRect(box.normalized()).adjusted(-reach, -reach, reach, reach), note);
}

// In pieces: the box of a long slanted line is most of the view.
void StrokeNotes::markLine(const QPointF& from, const QPointF& to, std::uint64_t note) {
    const QPointF a = m_transform.map(from), way = m_transform.map(to) - a;
    const double reach = m_reach + soft;
    const QRectF view = QRectF(QPointF(), QSizeF(m_size)).adjusted(-reach, -reach, reach, reach);
    double first = 0, last = 1; // what is in sight of it
    const auto cut = [&](double start, double step, double low, double high) {
        if (step == 0) {
            if (start < low || start > high)
                last = -1;
            return;
        }
        const double in = (low - start) / step, out = (high - start) / step;
        first = std::max(first, std::min(in, out));
        last = std::min(last, std::max(in, out));
    };
    cut(a.x(), way.x(), view.left(), view.right());
    cut(a.y(), way.y(), view.top(), view.bottom());
    if (!(first <= last))
        return;
    const double length = std::max(std::abs(way.x()), std::abs(way.y())) * (last - first);
    const int pieces = 1 + int(length / m_tile);
    for (int k = 0; k < pieces; ++k) {
        const QPointF p = a + way * (first + (last - first) * k / pieces);
        const QPointF q = a + way * (first + (last - first) * (k + 1) / pieces);
        markPixels(QRectF(p, q).normalized().adjusted(-reach, -reach, reach, reach), note);
    }
}

void StrokeNotes::drawLines(const QLineF* lines, int count) {
    const std::uint64_t look = start(1);
    for (int k = 0; k < count; ++k) {
        std::uint64_t note = look;
        add(note, lines[k].p1());
        add(note, lines[k].p2());
        markLine(lines[k].p1(), lines[k].p2(), note);
    }
}

void StrokeNotes::drawRects(const QRectF* rects, int count) {
    const std::uint64_t look = start(2);
    for (int k = 0; k < count; ++k) {
        std::uint64_t note = look;
        add(note, rects[k]);
        mark(rects[k], note);
    }
}

void StrokeNotes::drawEllipse(const QRectF& rect) {
    std::uint64_t note = start(3);
    add(note, rect);
    mark(rect, note);
}

void StrokeNotes::drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) {
    std::uint64_t note = start(4 + int(mode));
    for (int k = 0; k < count; ++k)
        add(note, points[k]);
    if (m_filled && mode != PolylineMode)
        return mark(boxOf(points, count), note);
    for (int k = 0; k + 1 < count; ++k)
        markLine(points[k], points[k + 1], note);
    if (mode != PolylineMode)
        markLine(points[count - 1], points[0], note);
}

void StrokeNotes::drawPoints(const QPointF* points, int count) {
    std::uint64_t note = start(8);
    for (int k = 0; k < count; ++k) {
        std::uint64_t one = note;
        add(one, points[k]);
        mark({points[k], points[k]}, one);
    }
}

void StrokeNotes::drawPath(const QPainterPath& path) {
    std::uint64_t note = start(9);
    add(note, path);
    mark(path.controlPointRect(), note);
}

// Letters may hang over their line and their place.
void StrokeNotes::drawTextItem(const QPointF& at, const QTextItem& item) {
    std::uint64_t note = start(10);
    add(note, at);
    add(note, std::uint64_t(qHash(item.text())));
    const double high = item.ascent() + item.descent();
    mark({at.x(), at.y() - item.ascent(), item.width(), high}, note, high / 2);
}

void StrokeNotes::drawPixmap(const QRectF& rect, const QPixmap& pixmap, const QRectF& source) {
    std::uint64_t note = start(11);
    add(note, rect);
    add(note, source);
    add(note, std::uint64_t(pixmap.cacheKey()));
    mark(rect, note);
}

void StrokeNotes::drawImage(const QRectF& rect, const QImage& image, const QRectF& source,
                            Qt::ImageConversionFlags) {
    std::uint64_t note = start(12);
    add(note, rect);
    add(note, source);
    add(note, std::uint64_t(image.cacheKey()));
    mark(rect, note);
}

int NoteBoard::metric(PaintDeviceMetric metric) const {
    switch (metric) {
    case PdmWidth:
        return m_like.width();
    case PdmHeight:
        return m_like.height();
    case PdmWidthMM:
        return m_like.widthMM();
    case PdmHeightMM:
        return m_like.heightMM();
    case PdmNumColors:
        return m_like.colorCount();
    case PdmDepth:
        return m_like.depth();
    case PdmDpiX:
        return m_like.logicalDpiX();
    case PdmDpiY:
        return m_like.logicalDpiY();
    case PdmPhysicalDpiX:
        return m_like.physicalDpiX();
    case PdmPhysicalDpiY:
        return m_like.physicalDpiY();
    case PdmDevicePixelRatio:
        return 1; // places in the view's own pixels
    case PdmDevicePixelRatioScaled:
        return int(devicePixelRatioFScale());
    default:
        return QPaintDevice::metric(metric);
    }
}

} // namespace thetalane
