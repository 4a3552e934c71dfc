#pragma once
/// \file
/// A formula as a list of operations, each on results of earlier ones.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <vector>

#include "certet/frame.hpp"
#include "operation.hpp"

namespace certet {

/// The number of an operation on its tape.
using NodeId = std::uint32_t;

struct Node {
  Operation operation;
  std::array<NodeId, 3> operands{0, 0, 0};  ///< as many as the operation has, then 0
  double value = 0;                         ///< of a constant
};

/// What is written twice is computed once: an operation that is already there is
/// not added again, and one of constants alone becomes a constant.
class Tape {
 public:
  NodeId constant(double value);
  NodeId variable(std::size_t axis);  ///< 0: x, 1: y, 2: z
  NodeId add(Operation operation, NodeId a, NodeId b = 0, NodeId c = 0);

  /// Operands stand before what uses them.
  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  [[nodiscard]] const Node& operator[](NodeId id) const { return nodes_[id]; }

  /// Point by point: what all faster ways must agree with, bit for bit.
  [[nodiscard]] double evaluate(NodeId root, const Point3& point) const;

 private:
  /// Constants are told apart by their bits, so that -0 is not 0.
  using Key = std::tuple<Operation, std::array<NodeId, 3>, std::uint64_t>;
  NodeId insert(const Node& node);

  std::vector<Node> nodes_;
  std::map<Key, NodeId> known_;
};

}  // namespace certet
