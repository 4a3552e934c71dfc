#include "batch.hpp"

#include <algorithm>
#include <type_traits>

namespace certet {
namespace {

/// For each node, the last one that uses it; 0 for those that the root does not need.
std::vector<NodeId> last_uses(const Tape& tape, NodeId root) {
  std::vector<NodeId> last(root + 1, 0);
  last[root] = root + 1;
  for (NodeId id = root + 1; id-- > 0;) {
    if (last[id] == 0) continue;
    const Node& node = tape[id];
    for (std::size_t i = 0; i < static_cast<std::size_t>(operands_of(node.operation)); ++i)
      last[node.operands[i]] = std::max(last[node.operands[i]], id);
  }
  return last;
}

template <class Function>
void map(const Function& function, const double* a, double* out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = function(a[i]);
}

template <class Function>
void map(const Function& function, const double* a, bool a_uniform, const double* b,
         bool b_uniform, double* out, std::size_t count) {
  if (a_uniform == b_uniform) {
    for (std::size_t i = 0; i < count; ++i) out[i] = function(a[i], b[i]);
  } else if (a_uniform) {
    const double first = *a;
    for (std::size_t i = 0; i < count; ++i) out[i] = function(first, b[i]);
  } else {
    const double second = *b;
    for (std::size_t i = 0; i < count; ++i) out[i] = function(a[i], second);
  }
}

/// Either branch, or neither, may be uniform.
template <class Function>
void map(const Function& function, const double* c, bool c_uniform, const double* a,
         bool a_uniform, const double* b, bool b_uniform, double* out, std::size_t count) {
  const std::size_t c_step = c_uniform ? 0 : 1, a_step = a_uniform ? 0 : 1,
                    b_step = b_uniform ? 0 : 1;
  if (c_step + a_step + b_step == 3) {
    for (std::size_t i = 0; i < count; ++i) out[i] = function(c[i], a[i], b[i]);
  } else {
    for (std::size_t i = 0; i < count; ++i)
      out[i] = function(c[c_step * i], a[a_step * i], b[b_step * i]);
  }
}

}  // namespace

/// Places the nodes of a tape one after the other.
struct BatchFormula::Planner {
  /// Arrays that can be used again once nobody reads them any more.
  class Slots {
   public:
    std::uint32_t take() {
      if (free_.empty()) return count_++;
      const std::uint32_t slot = free_.back();
      free_.pop_back();
      return slot;
    }
    void give_back(std::uint32_t slot) { free_.push_back(slot); }
    [[nodiscard]] std::uint32_t count() const { return count_; }

   private:
    std::uint32_t count_ = 0;
    std::vector<std::uint32_t> free_;
  };

  const Tape& tape;
  Batch kind;
  std::vector<NodeId> last;
  std::vector<Place> places;
  Slots slots;

  Place leaf(const Node& node, std::vector<double>& constants) const {
    if (node.operation == Operation::constant) {
      constants.push_back(node.value);
      return {Place::constant, true, static_cast<std::uint32_t>(constants.size() - 1)};
    }
    const auto axis =
        static_cast<std::uint32_t>(node.operation) - static_cast<std::uint32_t>(Operation::x);
    return {Place::variable, kind == Batch::row && axis > 0, axis};
  }

  /// The result's array is chosen before those of the operands are given back,
  /// so that no loop writes what it reads.
  Step step(NodeId id) {
    const Node& node = tape[id];
    Step step{node.operation, {}, {Place::slot, true, slots.take()}};
    const auto count = static_cast<std::size_t>(operands_of(node.operation));
    for (std::size_t i = 0; i < count; ++i) {
      step.operands[i] = places[node.operands[i]];
      step.result.uniform &= step.operands[i].uniform;
    }
    for (std::size_t i = 0; i < count; ++i) release(node.operands[i], id);
    return step;
  }

  void release(NodeId operand, NodeId user) {
    if (last[operand] != user) return;
    last[operand] = 0;  // an operand that is used twice is given back once
    if (places[operand].kind == Place::slot) slots.give_back(places[operand].index);
  }
};

BatchFormula::BatchFormula(const Tape& tape, NodeId root, Batch kind) {
  Planner planner{tape, kind, last_uses(tape, root), std::vector<Place>(root + 1), {}};
  for (NodeId id = 0; id <= root; ++id) {
    if (planner.last[id] == 0) continue;
    if (operands_of(tape[id].operation) == 0) {
      planner.places[id] = planner.leaf(tape[id], constants_);
    } else {
      steps_.push_back(planner.step(id));
      planner.places[id] = steps_.back().result;
    }
  }
  root_ = planner.places[root];
  slots_ = planner.slots.count();
}

void BatchFormula::take(const Step& step, const std::array<Operand, 3>& operands, double* out,
                        std::size_t count) {
  const Operand &a = operands[0], &b = operands[1], &c = operands[2];
  with_function(step.operation, [&]<class Function>(const Function& function) {
    if constexpr (std::is_invocable_v<Function, double>)
      map(function, a.values, out, count);
    else if constexpr (std::is_invocable_v<Function, double, double>)
      map(function, a.values, a.uniform, b.values, b.uniform, out, count);
    else
      map(function, a.values, a.uniform, b.values, b.uniform, c.values, c.uniform, out, count);
  });
}

void BatchFormula::evaluate(const BatchPoints& points, std::size_t count, Workspace& workspace,
                            double* out) const {
  double* const slots = workspace.values_.get();
  const auto found = [&](const Place& place) {
    switch (place.kind) {
      case Place::constant: return Operand{&constants_[place.index], place.uniform};
      case Place::variable: return Operand{points[place.index], place.uniform};
      default: return Operand{slots + place.index * batch_limit, place.uniform};
    }
  };
  for (const Step& step : steps_) {
    std::array<Operand, 3> operands{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(operands_of(step.operation)); ++i)
      operands[i] = found(step.operands[i]);
    take(step, operands, slots + step.result.index * batch_limit,
         step.result.uniform ? 1 : count);
  }
  const Operand result = found(root_);
  if (result.uniform) std::fill_n(out, count, *result.values);
  else std::copy_n(result.values, count, out);
}

}  // namespace certet
