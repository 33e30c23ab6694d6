// A paint device without pixels: it notes in tiles what is painted, and where.
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QTransform>
#include <QWidget>

#include <array>
#include <cstdint>
#include <vector>

namespace thetalane {

class StrokeNotes : public QPaintEngine {
public:
    StrokeNotes(const QSize& size, int tile);

    int columns() const { return m_columns; }
    std::vector<std::uint64_t>& notes() { return m_notes; } // of each tile, row by row

    bool begin(QPaintDevice* device) override;
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState& state) override;

    using QPaintEngine::drawEllipse;
    using QPaintEngine::drawLines;
    using QPaintEngine::drawPoints;
    using QPaintEngine::drawPolygon;
    using QPaintEngine::drawRects;
    void drawLines(const QLineF* lines, int count) override;
    void drawRects(const QRectF* rects, int count) override;
    void drawEllipse(const QRectF& rect) override;
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override;
    void drawPoints(const QPointF* points, int count) override;
    void drawPath(const QPainterPath& path) override;
    void drawTextItem(const QPointF& at, const QTextItem& item) override;
    void drawPixmap(const QRectF& rect, const QPixmap& pixmap, const QRectF& source) override;
    void drawImage(const QRectF& rect, const QImage& image, const QRectF& source,
                   Qt::ImageConversionFlags flags) override;

private:
    // How it is painted: each a note of its own.
    enum Look { PenLook, BrushLook, FontLook, TransformLook, ClipLook, OtherLook, lookCount };

    std::uint64_t start(int kind) const; // of a stroke's note: with how it is painted
    std::uint64_t unique();              // like nothing before
    std::uint64_t noteOf(const QBrush& brush);
    std::uint64_t noteOf(const QPen& pen);
    void noteClip(const QPaintEngineState& state);
    void mark(const QRectF& box, std::uint64_t note, double more = 0); // of the painter's own coordinates
    void markLine(const QPointF& from, const QPointF& to, std::uint64_t note);
    void markPixels(const QRectF& box, std::uint64_t note);

    QSize m_size;
    int m_tile, m_columns, m_rows;
    std::vector<std::uint64_t> m_notes;
    std::array<std::uint64_t, lookCount> m_looks{};
    QTransform m_transform;
    double m_reach = 0; // of the pen, beyond what it draws along [px]
    bool m_filled = false;
};

// As large as `like`, with letters of the same size.
class NoteBoard : public QPaintDevice {
public:
    NoteBoard(const QWidget& like, int tile)
        : m_like(like)
        , m_engine(like.size(), tile) {}
    QPaintEngine* paintEngine() const override { return &m_engine; }
    StrokeNotes& engine() { return m_engine; }

protected:
    int metric(PaintDeviceMetric metric) const override;

private:
    const QWidget& m_like;
    mutable StrokeNotes m_engine;
};

} // namespace thetalane
