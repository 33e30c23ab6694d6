// Every number of a scene's bodies, and e. What is wrong is said beside its field; the last good scene stays.
#pragma once

#include "ui/panels/panel.h"

#include <vector>

class QVBoxLayout;

namespace thetalane {

class BodyGroup;
class ValueRow;

class BodiesPanel : public Panel {
    Q_OBJECT
public:
    static constexpr std::size_t mostShown = 12;

    explicit BodiesPanel(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;

private:
    void showScene();
    void makeGroups(std::size_t count);
    void apply();
    void showErrors();
    void showColours();
    QString elsewhere() const; // errors that belong to no field here

    QVBoxLayout* m_column;
    ValueRow* m_restitution;
    std::vector<BodyGroup*> m_groups;
    QLabel* m_more;
    QLabel* m_message;
    std::vector<SceneError> m_errors;
    bool m_applying = false;
};

} // namespace thetalane
