#include "certet/formula.hpp"

#include <cmath>

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {
namespace {

using certet::Coord3;
using certet::Extent;
using certet::Sign;

/// What is known of a box holds for each point of it, row by row and one by one.
void judge_box(const certet::FormulaDomain& domain, const certet::LatticeBox& box) {
  const Extent extent = domain.extent(box);
  for (Coord3 p = box.low; p.z <= box.high.z; p.z += 2)
    for (p.y = box.low.y; p.y <= box.high.y; p.y += 2) {
      std::array<Sign, 3> row, single;
      domain.row({box.low.x, p.y, p.z}, row);
      std::array<Coord3, row.size()> positions;
      for (std::size_t i = 0; i < row.size(); ++i)
        positions[i] =
            certet::steps * Coord3{box.low.x + 2 * static_cast<std::int32_t>(i), p.y, p.z};
      domain.at(positions, single);
      if (row != single) throw Finding("a row has other signs than its points");
      for (const Sign sign : row)
        if ((extent == Extent::inside && sign != Sign::plus) ||
            (extent == Extent::outside && sign == Sign::plus))
          throw Finding("a point is not where its box is");
    }
}

}  // namespace

void formula(Bytes bytes) {
  const std::string formula(bytes.begin(), bytes.end());
  read_or_refuse([&] {
    const certet::FormulaDomain domain(formula, {{-1, -2, -1}, {1, 0.5, 1}}, 0.25, 1);
    for (std::int32_t at = -9; at < 9; at += 6)
      judge_box(domain, {{at, at, -at - 4}, {at + 4, at + 4, -at}});
    judge_box(domain, {{0, 0, 0}, {4, 0, 0}});
  });
}

}  // namespace fuzz
