#include "ui/tables/tables_panel.h"

#include "ui/panels/icon_button.h"
#include "ui/tables/bodies_page.h"
#include "ui/tables/centre_page.h"
#include "ui/tables/collision_page.h"
#include "ui/tables/course_page.h"
#include "ui/tables/impulse_page.h"
#include "ui/tables/momentum_page.h"
#include "ui/words/language.h"
#include "ui/worksheet/worksheet.h"

#include <QApplication>
#include <QBuffer>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSaveFile>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

// Empty, or why not: whole or not at all.
QString writeWhole(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush() && file.commit())
        return {};
    return file.errorString();
}

// Language::use() sets the default locale, and a panel has no other way to it.
Language::Code languageOfNow() {
    return QLocale().language() == QLocale::Korean ? Language::Code::Korean : Language::Code::English;
}

constexpr int widths[] = {0, 1920, 3840}; // of a picture [px]; 0: twice the size on screen

} // namespace

TablesPanel::TablesPanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_chooser(new QComboBox(this))
    , m_pages(new QStackedWidget(this))
    , m_views({new CollisionPage(context), new BodiesPage(context), new MomentumPage(context),
               new CentrePage(context), new CoursePage(context), new ImpulsePage(context)})
    , m_row(new QGridLayout)
    , m_copy(new QPushButton(this))
    , m_csv(new QPushButton(this))
    , m_picture(new QPushButton(this))
    , m_worksheet(new QPushButton(this))
    , m_message(new QLabel(this)) {
    setObjectName(QStringLiteral("tablesPanel"));
    m_chooser->setObjectName(QStringLiteral("tableChooser"));
    m_message->setObjectName(QStringLiteral("tablesMessage"));
    m_message->setWordWrap(true);
    m_message->hide();
    for (TablePage* page : m_views) {
        m_pages->addWidget(page);
        m_chooser->addItem(QString());
    }
    const std::pair<QPushButton*, const char*> names[] = {{m_copy, "copyTable"},
                                                          {m_csv, "saveCsv"},
                                                          {m_picture, "savePicture"},
                                                          {m_worksheet, "saveWorksheet"}};
    for (const auto& [button, name] : names)
        button->setObjectName(QLatin1String(name));
    auto* top = new QGridLayout;
    top->addWidget(m_chooser, 0, 0);
    top->addWidget(new IconMark(appearance(), Icon::Down, this), 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    auto* column = new QVBoxLayout(this);
    column->addLayout(top);
    column->addWidget(m_pages, 1);
    column->addWidget(m_message);
    column->addLayout(m_row);

    connect(m_chooser, &QComboBox::currentIndexChanged, this, &TablesPanel::showChoice);
    connect(m_copy, &QPushButton::clicked, this, &TablesPanel::copy);
    connect(m_csv, &QPushButton::clicked, this, &TablesPanel::askForCsv);
    connect(m_picture, &QPushButton::clicked, this, &TablesPanel::askForPicture);
    connect(m_worksheet, &QPushButton::clicked, this, &TablesPanel::askForWorksheet);
    connect(&session(), &Session::runChanged, this, &TablesPanel::enableButtons);
    restyle();
    retranslate();
    enableButtons();
}

TablesPanel::View TablesPanel::view() const {
    return View(m_pages->currentIndex());
}

void TablesPanel::choose(View view) {
    m_chooser->setCurrentIndex(int(view));
}

void TablesPanel::showChoice() {
    m_pages->setCurrentIndex(std::max(0, m_chooser->currentIndex()));
    m_message->hide();
}

void TablesPanel::retranslate() {
    const QString names[] = {tr("Before and after"),
                             tr("All bodies now"),
                             tr("Momentum diagram"),
                             tr("Centre of mass"),
                             tr("Energy and momentum over time"),
                             tr("Impulse of each collision")};
    for (int k = 0; k < viewCount; ++k)
        m_chooser->setItemText(k, names[k]);
    m_chooser->setAccessibleName(tr("Table or plot"));
    m_chooser->setToolTip(tr("Which table or plot is shown"));
    const auto name = [](QPushButton* button, const QString& text, const QString& tip) {
        button->setText(text);
        button->setAccessibleName(tip);
        button->setToolTip(tip);
    };
    name(m_copy, tr("Copy"), tr("Copies the numbers shown, with every digit, for a spreadsheet (Ctrl+C)"));
    name(m_csv, tr("CSV…"), tr("Writes the numbers shown, with every digit, into a CSV file"));
    name(m_picture, tr("PNG…"), tr("Writes what is shown as a picture into a PNG file"));
    name(m_worksheet, tr("Worksheet…"),
         tr("Writes a worksheet of the open collision, or of the first one, with an answer page, as PDF"));
    m_message->hide();
    layButtons();
}

void TablesPanel::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    layout()->setContentsMargins(unit, unit, unit, unit);
    layout()->setSpacing(unit);
    m_row->setSpacing(unit / 2);
    for (QWidget* w :
         {static_cast<QWidget*>(m_chooser), static_cast<QWidget*>(m_copy), static_cast<QWidget*>(m_csv),
          static_cast<QWidget*>(m_picture), static_cast<QWidget*>(m_worksheet)})
        w->setFont(appearance().font(Appearance::Size::Normal));
    makeQuiet(*m_message, appearance());
    layButtons();
}

// Side by side, or two by two where that is too wide.
void TablesPanel::layButtons() {
    QPushButton* const buttons[] = {m_copy, m_csv, m_picture, m_worksheet};
    int needed = 2 * appearance().unit();
    for (QPushButton* b : buttons) {
        b->ensurePolished();
        needed += b->sizeHint().width() + m_row->spacing();
    }
    const int columns = needed <= width() ? 4 : 2;
    for (int k = 0; k < 4; ++k)
        m_row->addWidget(buttons[k], k / columns, k % columns);
}

void TablesPanel::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    layButtons();
}

// A table with rows chosen has taken the key already.
void TablesPanel::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy();
    else
        Panel::keyPressEvent(event);
}

void TablesPanel::enableButtons() {
    m_worksheet->setEnabled(!session().timeline().collisions().empty());
}

void TablesPanel::copy() const {
    QApplication::clipboard()->setText(tabbed(m_views[std::size_t(m_pages->currentIndex())]->sheet()));
}

bool TablesPanel::tell(const QString& path, const QString& fault) {
    const QString name = QFileInfo(path).fileName();
    m_message->setText(fault.isEmpty() ? tr("%1 is written.").arg(name)
                                       : tr("%1 cannot be written: %2").arg(name, fault));
    m_message->setStyleSheet(
        QStringLiteral("color: %1;")
            .arg((fault.isEmpty() ? appearance().quietText() : appearance().error()).name()));
    m_message->show();
    return fault.isEmpty();
}

bool TablesPanel::saveCsv(const QString& path) {
    return tell(path,
                writeWhole(path, commaSeparated(m_views[std::size_t(m_pages->currentIndex())]->sheet())));
}

bool TablesPanel::savePicture(const QString& path, double scale) {
    QWidget* page = m_pages->currentWidget();
    QImage image((QSizeF(page->size()) * scale).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(appearance().card());
    QPainter painter(&image);
    page->render(&painter, {}, {}, QWidget::DrawChildren);
    painter.end();
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return tell(path, writeWhole(path, png));
}

bool TablesPanel::saveWorksheet(const QString& path) {
    const auto collisions = session().timeline().collisions();
    if (collisions.empty())
        return false;
    const std::size_t index = std::min(playhead().selected().value_or(0), collisions.size() - 1);
    const std::int64_t number = session().part().collisionsBefore + std::int64_t(index) + 1;
    return tell(path, writeWorksheet(path, {session().scene(), collisions, index, number, languageOfNow()}));
}

QString TablesPanel::suggestedName() const {
    const QString id = session().sceneId();
    return id.isEmpty() ? QStringLiteral("thetalane") : id;
}

// None of them is modal to the program: the lane goes on behind it.
void TablesPanel::askForCsv() {
    auto* dialog = new QFileDialog(this, tr("Write a CSV file"), suggestedName() + ".csv");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->setNameFilter(tr("CSV files (*.csv)"));
    connect(dialog, &QFileDialog::fileSelected, this, &TablesPanel::saveCsv);
    dialog->open();
}

void TablesPanel::askForPicture() {
    auto* dialog = new QFileDialog(this, tr("Write a picture"), suggestedName() + ".png");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    QStringList filters{tr("PNG, twice the size on screen (*.png)")};
    for (const int width : {widths[1], widths[2]})
        filters << tr("PNG, %1 pixels wide (*.png)").arg(width);
    dialog->setNameFilters(filters);
    connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, filters](const QString& path) {
        const int width = widths[std::max<qsizetype>(0, filters.indexOf(dialog->selectedNameFilter()))];
        savePicture(path, width == 0 ? 2 : double(width) / m_pages->width());
    });
    dialog->open();
}

void TablesPanel::askForWorksheet() {
    auto* dialog = new QFileDialog(this, tr("Write a worksheet"), suggestedName() + ".pdf");
    dialog->setObjectName(QStringLiteral("worksheetDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    dialog->setNameFilter(tr("PDF files (*.pdf)"));
    connect(dialog, &QFileDialog::fileSelected, this, &TablesPanel::saveWorksheet);
    dialog->open();
}

} // namespace thetalane
