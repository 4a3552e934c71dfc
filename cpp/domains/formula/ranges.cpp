#include <cmath>

#include "range.hpp"

namespace certet {
namespace {

Range range(const Node& node, const std::array<Range, 3>& box, const std::vector<Range>& known,
            RangeRule rule) {
  switch (node.operation) {
    case Operation::constant:
      if (std::isnan(node.value)) return {};
      return {node.value, node.value, false};
    case Operation::x: return box[0];
    case Operation::y: return box[1];
    case Operation::z: return box[2];
    default: break;
  }
  const std::array<Range, 3> operands{known[node.operands[0]], known[node.operands[1]],
                                      known[node.operands[2]]};
  const auto count = static_cast<std::size_t>(operands_of(node.operation));
  return rule(node.operation, std::span(operands).first(count),
              node.operands[0] == node.operands[1]);
}

}  // namespace

std::vector<Range> ranges(const Tape& tape, NodeId root, const std::array<Range, 3>& box,
                          RangeRule rule) {
  std::vector<Range> result;
  result.reserve(root + 1);
  for (NodeId id = 0; id <= root; ++id)
    result.push_back(range(tape[id], box, result, rule));
  return result;
}

}  // namespace certet
