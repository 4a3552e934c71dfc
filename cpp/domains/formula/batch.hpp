#pragma once
/// \file
/// A formula at many points at once, in loops over arrays.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tape.hpp"

namespace certet {

/// Which points make a batch.
enum class Batch {
  row,     ///< y and z are the same for all: what depends on them alone is computed once
  points,  ///< any
};

/// Coordinates of at most `batch_limit` points; of a row, y and z have one element.
using BatchPoints = std::array<const double*, 3>;

/// Few enough for the values of a formula to stay in the processor's cache.
inline constexpr std::size_t batch_limit = 256;

/// A tape made ready for batches of one kind.  Const calls may come from several
/// threads at once, each with a workspace of its own.
class BatchFormula {
 public:
  BatchFormula(const Tape& tape, NodeId root, Batch kind);

  class Workspace {
   public:
    explicit Workspace(const BatchFormula& formula)
        : values_(std::make_unique_for_overwrite<double[]>(formula.slots_ * batch_limit)) {}

   private:
    friend class BatchFormula;
    std::unique_ptr<double[]> values_;
  };

  /// The values at `count` points, those of Tape::evaluate bit for bit.
  void evaluate(const BatchPoints& points, std::size_t count, Workspace& workspace,
                double* out) const;

 private:
  /// Where an operand is found.
  struct Place {
    enum : std::uint8_t { constant, variable, slot } kind = constant;
    bool uniform = false;  ///< the same for all points of a batch
    std::uint32_t index = 0;
  };
  struct Step {
    Operation operation;
    std::array<Place, 3> operands;
    Place result;
  };
  struct Operand {
    const double* values;
    bool uniform;
  };

  struct Planner;

  static void take(const Step& step, const std::array<Operand, 3>& operands, double* out,
                   std::size_t count);

  std::vector<Step> steps_;
  std::vector<double> constants_;
  Place root_;
  std::size_t slots_ = 0;
};

}  // namespace certet
