// The glossary and the sheet of keys.
#pragma once

#include "ui/panels/panel.h"
#include "ui/words/glossary.h"

#include <QKeySequence>

#include <functional>

class QLineEdit;
class QTextBrowser;

namespace thetalane {

struct KeyLine {
    QKeySequence keys;
    QString what;
};

class WordsPanel : public Panel {
    Q_OBJECT
public:
    // keys: those of the whole window, in the language of now.
    WordsPanel(const Context& context, std::function<std::vector<KeyLine>()> keys, QWidget* parent = nullptr);

    void showTerm(const QString& id);
    void showKeys();

    void retranslate() override;

protected:
    void restyle() override;

private:
    QString keysHtml() const;
    QString termsHtml() const;
    void fill();

    std::function<std::vector<KeyLine>()> m_keys;
    QLineEdit* m_search;
    QTextBrowser* m_text;
};

} // namespace thetalane
