// Where the nodes of the tree of hits stand: generations from left to right, the first that a body hits on
// its own line, the others below.
#pragma once

#include "core/bowling/hit_tree.h"

#include <vector>

namespace thetalane {

struct TreeNode {
    int body = 0;
    int column = 0;
    int row = 0;
    int parent = -1; // index into HitTreeLayout::nodes; -1: a root
    int edge = -1;   // index into HitTree::edges; -1: a root
};

struct HitTreeLayout {
    std::vector<TreeNode> nodes; // a parent before its children
    int columns = 0;
    int rows = 0;
    std::size_t notDrawn = 0; // edges beyond `most`
};

// The first edges in the order of time, at most `most`.
HitTreeLayout layOut(const HitTree& tree, std::size_t most);

} // namespace thetalane
