#include "ui/who/hit_tree_layout.h"

#include <algorithm>
#include <unordered_map>

namespace thetalane {

HitTreeLayout layOut(const HitTree& tree, std::size_t most) {
    HitTreeLayout layout;
    const std::size_t drawn = std::min(most, tree.edges.size());
    layout.notDrawn = tree.edges.size() - drawn;
    std::unordered_map<int, std::vector<int>> hits; // of each body, in the order of time
    for (std::size_t k = 0; k < drawn; ++k)
        hits[tree.edges[k].from].push_back(int(k));

    std::vector<TreeNode> waiting; // the one to stand next is the last
    for (auto root = tree.roots.rbegin(); root != tree.roots.rend(); ++root)
        if (hits.count(*root))
            waiting.push_back({*root, 0, 0, -1, -1});
    int row = -1;
    while (!waiting.empty()) {
        TreeNode node = waiting.back();
        waiting.pop_back();
        // On its parent's line where it is the first child, which is placed right after its parent.
        const int before = int(layout.nodes.size()) - 1;
        if (node.parent < 0 || node.parent != before)
            ++row;
        node.row = row;
        layout.columns = std::max(layout.columns, node.column + 1);
        layout.nodes.push_back(node);
        const auto children = hits.find(node.body);
        if (children == hits.end())
            continue;
        for (auto edge = children->second.rbegin(); edge != children->second.rend(); ++edge)
            waiting.push_back({tree.edges[std::size_t(*edge)].to, node.column + 1, 0, before + 1, *edge});
    }
    layout.rows = row + 1;
    return layout;
}

} // namespace thetalane
