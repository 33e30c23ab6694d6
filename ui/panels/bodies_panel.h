// Every number of a scene's bodies, e, the walls, and how they are edited. What is wrong is said beside its
// field; the last good scene stays.
#pragma once

#include "ui/panels/panel.h"

#include <vector>

class QPushButton;
class QVBoxLayout;

namespace thetalane {

class BodyGroup;
class EditOptions;
class EditOptionsRow;
class ValueRow;
class WallGroup;

class BodiesPanel : public Panel {
    Q_OBJECT
public:
    static constexpr std::size_t mostShown = 12;

    // options: shared with whoever else edits; without them it has its own.
    BodiesPanel(const Context& context, EditOptions& options, QWidget* parent = nullptr);
    explicit BodiesPanel(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void takeRun();
    void showScene();
    void makeGroups(std::size_t count);
    void apply();
    void addBody();
    void removeBody(int index);
    void putOnOneLine(bool on);
    void change(const Scene& scene);
    void say(const QString& trouble);
    void showErrors();
    void showColours();
    QString elsewhere() const; // errors that belong to no field here

    EditOptions& m_options;
    QVBoxLayout* m_column;
    ValueRow* m_restitution;
    EditOptionsRow* m_editing;
    std::vector<BodyGroup*> m_groups;
    QPushButton* m_add;
    WallGroup* m_walls;
    QLabel* m_more;
    QLabel* m_message;
    QLabel* m_addMessage;
    std::vector<SceneError> m_errors;
    bool m_applying = false;
    bool m_stale = false; // hidden, and the scene has changed meanwhile
};

} // namespace thetalane
