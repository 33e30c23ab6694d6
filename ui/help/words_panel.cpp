#include "ui/help/words_panel.h"

#include <QLineEdit>
#include <QLocale>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace thetalane {

namespace {

// Arrows look the same in every language, and on the keys.
QString keyText(const QKeySequence& keys) {
    QString text = keys.toString(QKeySequence::PortableText);
    static const std::pair<const char*, const char16_t*> names[] = {
        {"Left", u"←"}, {"Right", u"→"}, {"Up", u"↑"}, {"Down", u"↓"}, {"Return", u"Enter"}};
    for (const auto& [name, sign] : names)
        if (text == QLatin1String(name) || text.endsWith(u'+' + QLatin1String(name)))
            text.replace(QLatin1String(name), QString::fromUtf16(sign));
    return text;
}

} // namespace

WordsPanel::WordsPanel(const Context& context, std::function<std::vector<KeyLine>()> keys, QWidget* parent)
    : Panel(context, parent)
    , m_keys(std::move(keys))
    , m_search(new QLineEdit(this))
    , m_text(new QTextBrowser(this)) {
    setObjectName("wordsPanel");
    m_search->setObjectName("searchTerms");
    m_search->setClearButtonEnabled(true);
    m_text->setObjectName("terms");
    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    m_text->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_search);
    column->addWidget(m_text, 1);
    connect(m_search, &QLineEdit::textChanged, this, &WordsPanel::fill);
    connect(m_text, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& url) { m_text->scrollToAnchor(url.fragment()); });
    restyle();
    retranslate();
}

void WordsPanel::retranslate() {
    m_search->setPlaceholderText(tr("Search the terms"));
    m_search->setToolTip(tr("Shows the terms that contain these letters"));
    m_search->setAccessibleName(tr("Search the terms"));
    m_text->setAccessibleName(tr("Terms and keys"));
    fill();
}

void WordsPanel::restyle() {
    Panel::restyle();
    // The window's tool buttons are to be hit; the one in the field has its height.
    setStyleSheet(styleSheet() +
                  QStringLiteral("QLineEdit QToolButton { min-height: 0; padding: 0; border: none; }"));
    const int u = appearance().unit();
    layout()->setContentsMargins(u, u, u, u);
    layout()->setSpacing(u);
    m_text->setFont(appearance().font(Appearance::Size::Normal));
    m_text->setStyleSheet("QTextBrowser { background: transparent; }");
    m_text->document()->setDocumentMargin(0);
    fill();
}

void WordsPanel::showTerm(const QString& id) {
    m_search->clear();
    m_text->scrollToAnchor(id);
}

void WordsPanel::showKeys() {
    m_search->clear();
    m_text->scrollToAnchor("keys");
}

QString WordsPanel::termsHtml() const {
    const bool korean = QLocale().language() == QLocale::Korean;
    const QString wanted = m_search->text().trimmed();
    QString html;
    for (const GlossaryEntry& e : glossary(korean ? Language::Code::Korean : Language::Code::English)) {
        if (!(e.term + ' ' + e.otherTerm + ' ' + e.text).contains(wanted, Qt::CaseInsensitive))
            continue;
        html += QString("<p><a name=\"%1\"></a><b>%2</b> &nbsp;<span style=\"color:%5\">%3</span><br>%4</p>")
                    .arg(e.id, e.term.toHtmlEscaped(), e.otherTerm.toHtmlEscaped(), e.text.toHtmlEscaped(),
                         appearance().quietText().name());
    }
    return html.isEmpty() ? "<p>" + tr("No term contains these letters.").toHtmlEscaped() + "</p>" : html;
}

QString WordsPanel::keysHtml() const {
    QString rows;
    for (const KeyLine& line : m_keys())
        if (!line.what.isEmpty())
            rows += QString("<tr><td style=\"padding-right:16px\"><b>%1</b></td><td>%2</td></tr>")
                        .arg(keyText(line.keys).toHtmlEscaped(), line.what.toHtmlEscaped());
    return "<table cellspacing=\"4\">" + rows + "</table>";
}

void WordsPanel::fill() {
    const bool searching = !m_search->text().trimmed().isEmpty();
    const QString size = QString::number(appearance().pixels(Appearance::Size::Large));
    const QString title = "<p style=\"font-size:" + size + "px\"><a name=\"%1\"></a><b>%2</b></p>";
    QString html = searching ? QString()
                             : QString("<p><a href=\"#terms\" style=\"color:%1\">%2</a> &nbsp; <a "
                                       "href=\"#keys\" style=\"color:%1\">%3</a></p>")
                                   .arg(appearance().accent().name(), tr("Terms").toHtmlEscaped(),
                                        tr("Keys").toHtmlEscaped());
    html += title.arg("terms", tr("Terms").toHtmlEscaped()) + termsHtml();
    if (!searching)
        html += title.arg("keys", tr("Keys").toHtmlEscaped()) + keysHtml();
    m_text->setHtml(html);
}

} // namespace thetalane
