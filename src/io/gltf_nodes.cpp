#include "io/gltf_nodes.h"

#include <array>
#include <cmath>

namespace blysk::io::gltf {
namespace {

constexpr int kMaxDepth = 4096;       // real files stay below a hundred
constexpr double kMaxElement = 1e30;  // of a matrix: beyond it floats overflow

struct Node {
  Json json;
  int parent = kNone;
  std::vector<int> children;
};

std::string node_name(int index) { return "nodes[" + std::to_string(index) + "]"; }

// No node may have two parents or be its own ancestor, so that every walk ends.
void check_tree(Context& context, const std::vector<Node>& nodes) {
  enum class Mark : char { unseen, on_path, done };
  std::vector<Mark> marks(nodes.size(), Mark::unseen);
  std::vector<int> path;
  for (int start = 0; start < static_cast<int>(nodes.size()); ++start) {
    int at = start;
    for (; at != kNone && marks[static_cast<std::size_t>(at)] == Mark::unseen;
         at = nodes[static_cast<std::size_t>(at)].parent) {
      marks[static_cast<std::size_t>(at)] = Mark::on_path;
      path.push_back(at);
    }
    if (at != kNone && marks[static_cast<std::size_t>(at)] == Mark::on_path) {
      return context.fail(nodes[static_cast<std::size_t>(at)].json,
                          "the node is among its own descendants; nodes must form a tree");
    }
    for (const int seen : path) marks[static_cast<std::size_t>(seen)] = Mark::done;
    path.clear();
  }
}

std::vector<Node> read_nodes(Context& context, Json root) {
  std::vector<Node> nodes;
  for (const Json& json : context.list(root, "nodes")) {
    nodes.emplace_back().json = json;
    if (json.kind() != Json::Kind::object) context.fail(json, "must be an object");
  }
  for (int parent = 0; parent < static_cast<int>(nodes.size()) && !context.failed(); ++parent) {
    Node& node = nodes[static_cast<std::size_t>(parent)];
    for (const Json& json : context.list(node.json, "children")) {
      const int child = context.index(json, nodes.size(), "node");
      if (child == kNone) break;
      int& known = nodes[static_cast<std::size_t>(child)].parent;
      if (known != kNone) {
        context.fail(json, node_name(child) + " has the parents " + node_name(known) + " and " +
                               node_name(parent) + "; nodes must form a tree");
        break;
      }
      known = parent;
      node.children.push_back(child);
    }
  }
  if (!context.failed()) check_tree(context, nodes);
  return nodes;
}

Mat4 read_matrix(Context& context, Json node) {
  std::array<double, 16> columns{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  context.numbers(node, "matrix", columns);
  Mat4 matrix;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) matrix.m[row][column] = columns[column * 4 + row];
  }
  if (columns[3] != 0 || columns[7] != 0 || columns[11] != 0 || columns[15] != 1) {
    context.problem(node["matrix"], "its bottom row is not 0 0 0 1 and was taken as that");
  }
  return matrix;
}

Mat4 local_transform(Context& context, Json node) {
  if (node["matrix"]) return read_matrix(context, node);
  std::array<double, 3> t{0, 0, 0}, s{1, 1, 1};
  std::array<double, 4> r{0, 0, 0, 1};
  context.numbers(node, "translation", t);
  context.numbers(node, "rotation", r);
  context.numbers(node, "scale", s);
  return translation({t[0], t[1], t[2]}) * rotation_from_quaternion({r[0], r[1], r[2], r[3]}) *
         scaling({s[0], s[1], s[2]});
}

std::vector<int> scene_roots(Context& context, Json root, const std::vector<Node>& nodes) {
  std::vector<int> roots;
  const std::vector<Json> scenes = context.list(root, "scenes");
  const int chosen = context.index(root, "scene", scenes.size(), "scene");
  if (scenes.empty()) {
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
      if (nodes[static_cast<std::size_t>(i)].parent == kNone) roots.push_back(i);
    }
    return roots;
  }
  for (const Json& json :
       context.list(scenes[chosen == kNone ? 0 : static_cast<std::size_t>(chosen)], "nodes")) {
    roots.push_back(context.index(json, nodes.size(), "node"));
  }
  return roots;
}

Placement read_placement(Context& context, Json node, const NodeTargets& targets) {
  Placement placement;
  placement.json = node;
  placement.name = node["name"].text();
  placement.mesh = context.index(node, "mesh", targets.meshes, "mesh");
  placement.camera = context.index(node, "camera", targets.cameras, "camera");
  placement.light =
      context.index(extension(context, node, "KHR_lights_punctual"), "light", targets.lights, "light");
  return placement;
}

}  // namespace

bool usable(const Mat4& matrix) {
  for (const auto& row : matrix.m) {
    for (const double element : row) {
      if (!(std::abs(element) <= kMaxElement)) return false;
    }
  }
  return true;
}

NodePlaces place_nodes(Context& context, Json root, const NodeTargets& targets) {
  NodePlaces places;
  if (context.failed()) return places;
  const std::vector<Node> nodes = read_nodes(context, root);
  places.worlds.resize(nodes.size());
  const std::vector<int> roots = scene_roots(context, root, nodes);

  struct Waiting {
    int node, depth;
    Mat4 parent;
  };
  std::vector<Waiting> stack;
  for (auto i = roots.rbegin(); i != roots.rend(); ++i) stack.push_back({*i, 1, {}});
  while (!stack.empty() && !context.failed()) {
    const Waiting next = stack.back();
    stack.pop_back();
    const Node& node = nodes[static_cast<std::size_t>(next.node)];
    std::optional<Mat4>& world = places.worlds[static_cast<std::size_t>(next.node)];
    if (world) {
      context.fail(node.json, "the scene lists the node twice, or beside one of its ancestors");
      break;
    }
    if (next.depth > kMaxDepth) {
      context.fail(node.json,
                   "stands more than " + std::to_string(kMaxDepth) + " nodes deep; flatten the hierarchy");
      break;
    }
    Placement placement = read_placement(context, node.json, targets);
    world = placement.world = placement.mesh_to_world = next.parent * local_transform(context, node.json);
    if (!usable(*world)) {
      context.fail(node.json, "its transform is not finite, or has elements beyond 1e30");
      break;
    }
    for (auto i = node.children.rbegin(); i != node.children.rend(); ++i) {
      stack.push_back({*i, next.depth + 1, *world});
    }
    if (placement.mesh != kNone || placement.camera != kNone || placement.light != kNone) {
      places.placements.push_back(placement);
    }
  }
  return places;
}

}  // namespace blysk::io::gltf
