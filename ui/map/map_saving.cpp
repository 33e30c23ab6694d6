// A strike map into a file: a table, or a picture.
#include "core/format/map_csv.h"
#include "ui/map/map_panel.h"
#include "ui/plot/strike_map_figure.h"

#include <QBuffer>
#include <QFileDialog>
#include <QFileInfo>
#include <QPainter>
#include <QSaveFile>

namespace thetalane {
namespace {

constexpr QSize pictureSize(1380, 1020); // as of the command line

} // namespace

// Not modal: the lane goes on behind it.
void MapPanel::ask(const QString& title, const QString& filter, const QString& suffix,
                   bool (MapPanel::*saveAs)(const QString&)) {
    auto* dialog = new QFileDialog(this, title);
    dialog->setObjectName(QStringLiteral("mapSaveDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(filter);
    dialog->setDefaultSuffix(suffix);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, saveAs](const QString& path) { (this->*saveAs)(path); });
    dialog->open();
}

bool MapPanel::saveCsv(const QString& path) {
    return map() && save(path, mapCsv(*map()));
}

bool MapPanel::savePicture(const QString& path) {
    if (!map())
        return false;
    QImage image(pictureSize, QImage::Format_RGB32);
    QPainter painter(&image);
    painter.setFont(appearance().font(Appearance::Size::Normal));
    paintStrikeMap(painter, QRectF(image.rect()), *map());
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    return image.save(&buffer, "PNG") && save(path, bytes);
}

// Whole, or not at all: under another name first, then renamed.
bool MapPanel::save(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    const bool done =
        file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush() && file.commit();
    const QString name = QFileInfo(path).fileName(), why = done ? QString() : file.errorString();
    m_saved = [done, name, why] {
        return done ? tr("Saved: %1").arg(name) : tr("%1 cannot be written: %2").arg(name, why);
    };
    showState();
    return done;
}

} // namespace thetalane
