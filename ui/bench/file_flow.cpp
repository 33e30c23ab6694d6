#include "ui/bench/file_flow.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

namespace thetalane {
namespace {

// Beside the file that is open; else where documents are.
QString placeToStart(const Desk& desk) {
    const QStringList recent = desk.recentFiles();
    const QString known = !desk.file().isEmpty() ? desk.file()
                          : recent.isEmpty()     ? QString()
                                                 : recent.front();
    return known.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                           : QFileInfo(known).absolutePath();
}

} // namespace

FileFlow::FileFlow(Desk& desk, QWidget& window)
    : QObject(&window)
    , m_desk(desk)
    , m_window(window) {}

void FileFlow::whenSafe(std::function<void()> action) {
    m_desk.isModified() ? ask(std::move(action)) : action();
}

void FileFlow::ask(std::function<void()> action) {
    if (m_question)
        m_question->close(); // the last wish counts
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Unsaved changes"), {}, QMessageBox::NoButton, &m_window);
    m_question = box;
    box->setObjectName(QStringLiteral("unsavedQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    const QString name = m_desk.documentName();
    box->setText(name.isEmpty() ? tr("The scene has changes that are not saved.")
                                : tr("“%1” has changes that are not saved.").arg(name));
    box->setInformativeText(tr("Without saving, the changes are lost."));
    auto* save =
        box->addButton(m_desk.file().isEmpty() ? tr("Save as…") : tr("Save"), QMessageBox::AcceptRole);
    auto* discard = box->addButton(tr("Do not save"), QMessageBox::DestructiveRole);
    auto* cancel = box->addButton(tr("Cancel"), QMessageBox::RejectRole);
    save->setObjectName(QStringLiteral("saveChanges"));
    discard->setObjectName(QStringLiteral("discardChanges"));
    cancel->setObjectName(QStringLiteral("keepEditing"));
    box->setDefaultButton(save);
    box->setEscapeButton(cancel);
    connect(box, &QMessageBox::buttonClicked, this, [this, save, discard, action](QAbstractButton* button) {
        if (button == save)
            saveThen(action);
        else if (button == discard)
            action();
    });
    box->open();
}

void FileFlow::saveThen(std::function<void()> action) {
    if (m_desk.file().isEmpty())
        return chooseAndSave(std::move(action));
    if (m_desk.save(m_desk.file()) && action)
        action();
}

void FileFlow::save() {
    saveThen({});
}

void FileFlow::saveAs() {
    chooseAndSave({});
}

void FileFlow::chooseAndSave(std::function<void()> then) {
    auto* dialog = new QFileDialog(&m_window, tr("Save the scene"));
    dialog->setObjectName(QStringLiteral("saveDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Scene files (*.json)"), tr("All files (*)")});
    dialog->setDefaultSuffix(QStringLiteral("json"));
    dialog->setDirectory(placeToStart(m_desk));
    const QString name = m_desk.documentName();
    dialog->selectFile((name.isEmpty() ? tr("scene") : name) + QStringLiteral(".json"));
    connect(dialog, &QFileDialog::fileSelected, this, [this, then](const QString& path) {
        if (m_desk.save(path) && then)
            then();
    });
    dialog->open();
}

void FileFlow::openNew() {
    whenSafe([this] { m_desk.openNew(); });
}

void FileFlow::open(const QString& path) {
    whenSafe([this, path] { m_desk.open(path); });
}

void FileFlow::chooseAndOpen() {
    auto* dialog = new QFileDialog(&m_window, tr("Open a scene file"));
    dialog->setObjectName(QStringLiteral("openDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Scene files (*.json)"), tr("All files (*)")});
    dialog->setDirectory(placeToStart(m_desk));
    connect(dialog, &QFileDialog::fileSelected, this, &FileFlow::open);
    dialog->open();
}

} // namespace thetalane
