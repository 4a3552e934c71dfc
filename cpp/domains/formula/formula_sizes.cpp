#include <algorithm>
#include <array>
#include <memory>

#include "batch.hpp"
#include "certet/formula.hpp"
#include "certet/size_fields.hpp"
#include "parse.hpp"

namespace certet {
namespace {

/// A formula of points.
struct Sizes {
  explicit Sizes(const std::string& text) : root(parse(text, tape)), batch(tape, root, Batch::points) {}

  void at(std::span<const Point3> points, std::span<double> out) const {
    BatchFormula::Workspace workspace(batch);
    std::array<std::array<double, batch_limit>, 3> coordinates;
    for (std::size_t begin = 0; begin < points.size(); begin += batch_limit) {
      const std::size_t count = std::min(points.size() - begin, batch_limit);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t i = 0; i < count; ++i) coordinates[a][i] = points[begin + i][a];
      const auto& [x, y, z] = coordinates;
      batch.evaluate({x.data(), y.data(), z.data()}, count, workspace, &out[begin]);
    }
  }

  Tape tape;
  NodeId root;
  BatchFormula batch;
};

}  // namespace

SizeField formula_sizes(const std::string& formula) {
  return {"formula '" + shortened_formula(formula) + "'",
          [sizes = std::make_shared<const Sizes>(formula)](
              std::span<const Point3> points, std::span<double> out) { sizes->at(points, out); }};
}

}  // namespace certet
