#include "tape.hpp"

#include <bit>
#include <type_traits>

namespace certet {
namespace {

double apply(Operation operation, double a, double b, double c) {
  double result = 0;
  with_function(operation, [&]<class Function>(const Function& function) {
    if constexpr (std::is_invocable_v<Function, double>) result = function(a);
    else if constexpr (std::is_invocable_v<Function, double, double>) result = function(a, b);
    else result = function(a, b, c);
  });
  return result;
}

}  // namespace

NodeId Tape::insert(const Node& node) {
  const Key key{node.operation, node.operands, std::bit_cast<std::uint64_t>(node.value)};
  const auto [entry, is_new] = known_.try_emplace(key, static_cast<NodeId>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return entry->second;
}

NodeId Tape::constant(double value) { return insert({Operation::constant, {}, value}); }

NodeId Tape::variable(std::size_t axis) {
  constexpr std::array axes{Operation::x, Operation::y, Operation::z};
  return insert({axes[axis], {}, 0});
}

NodeId Tape::add(Operation operation, NodeId a, NodeId b, NodeId c) {
  const std::array<NodeId, 3> operands{a, b, c};
  const auto count = static_cast<std::size_t>(operands_of(operation));
  bool constant_operands = true;
  for (std::size_t i = 0; i < count; ++i)
    constant_operands &= nodes_[operands[i]].operation == Operation::constant;
  if (constant_operands)
    return constant(apply(operation, nodes_[a].value, nodes_[b].value, nodes_[c].value));
  return insert({operation, operands, 0});
}

double Tape::evaluate(NodeId root, const Point3& point) const {
  std::vector<double> values(root + 1);
  for (NodeId id = 0; id <= root; ++id) {
    const Node& node = nodes_[id];
    const auto& [a, b, c] = node.operands;
    switch (node.operation) {
      case Operation::constant: values[id] = node.value; break;
      case Operation::x: values[id] = point[0]; break;
      case Operation::y: values[id] = point[1]; break;
      case Operation::z: values[id] = point[2]; break;
      default: values[id] = apply(node.operation, values[a], values[b], values[c]);
    }
  }
  return values[root];
}

}  // namespace certet
