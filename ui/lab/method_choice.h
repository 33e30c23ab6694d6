// The methods for a scene of one's own: a row for each family, and what is pressed in will be run.
#pragma once

#include "core/study/method.h"
#include "ui/panels/panel.h"

#include <vector>

class QPushButton;

namespace thetalane {

class FlowLayout;

class MethodChoice : public Panel {
    Q_OBJECT
public:
    explicit MethodChoice(const Context& context, QWidget* parent = nullptr);

    std::vector<Method> chosen() const; // in the order of ownMethods()

    void retranslate() override;

signals:
    void runAsked();

protected:
    void restyle() override;

private:
    struct Entry {
        Method method;
        QPushButton* button;
    };
    struct Family {
        QLabel* name;
        FlowLayout* flow;
        Method first;
    };

    void addFamilies();
    void showScene(); // models that it does not have cannot be left out
    void showChoice();

    std::vector<Entry> m_entries;
    std::vector<Family> m_families;
    QPushButton* m_run;
};

} // namespace thetalane
