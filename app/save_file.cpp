#include "app/save_file.h"

#include "app/console.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSaveFile>

namespace thetalane {
namespace {

int unwritten(const QSaveFile& file) {
    return failure(QCoreApplication::translate("SaveFile", "%1: cannot be written: %2")
                       .arg(oneLine(file.fileName()), oneLine(file.errorString())));
}

// A disk that fills up takes a part first, and tells why with the next piece.
bool writeAll(QIODevice& device, const QByteArray& bytes) {
    qint64 written = 0;
    while (written < bytes.size()) {
        const qint64 n = device.write(bytes.constData() + written, bytes.size() - written);
        if (n <= 0)
            return false;
        written += n;
    }
    return true;
}

} // namespace

int saveFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    file.setDirectWriteFallback(true); // a device, or a directory that takes no new names
    if (!file.open(QIODevice::WriteOnly) || !writeAll(file, bytes) || !file.flush() ||
        !file.commit()) // commit() alone may rename a file whose last bytes found no room
        return unwritten(file);
    return Done;
}

std::optional<int> cannotSave(const QString& path) {
    QSaveFile file(path);
    file.setDirectWriteFallback(false);
    if (file.open(QIODevice::WriteOnly)) {
        file.cancelWriting();
        return std::nullopt;
    }
    const QFileInfo there(path); // a device, perhaps
    const bool direct = there.exists() && !there.isDir() && there.isWritable();
    return direct ? std::nullopt : std::optional(unwritten(file));
}

} // namespace thetalane
