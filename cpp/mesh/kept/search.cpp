#include <algorithm>
#include <cstdlib>

#include "budget.hpp"
#include "certet/error.hpp"
#include "certet/kept.hpp"
#include "digits.hpp"

namespace certet {
namespace {

constexpr double most_tets = 1e7;
constexpr int most_tries = 16;

/// At least so many tetrahedra are expected: as many more as a surface has.
double least_tets(const MeshedSize& coarse, double size) {
  const double finer = coarse.size / size;
  return static_cast<double>(coarse.tets) * finer * finer;
}

/// Nothing where the mesh is too large or the budget too small.
std::optional<CountedShape> count_at(const SizedShape& shape, double size, Method method,
                                     core::SearchBudget& budget, Context& context) {
  std::shared_ptr<const PlacedDomain> domain = shape.place(size);
  if (!budget.pay_for(*domain)) return std::nullopt;
  Stuffing stuffing(*domain, domain->lattice(), method, context);
  if (static_cast<double>(stuffing.tet_count()) > most_tets) return std::nullopt;
  return CountedShape{std::move(domain), std::move(stuffing)};
}

}  // namespace

KeepingSizes find_keeping_size(const SizedShape& shape, const MeshedSize& coarse, Method method,
                               const std::function<bool(const CountedShape&, TriedSize&)>& keeps,
                               Context& context) {
  constexpr double finer = 1.25, much_finer = 1.5;
  core::SearchBudget budget;
  budget.cells /= shape.cost;
  budget.mixed /= shape.cost;
  KeepingSizes found;
  double size = coarse.size / finer;
  if (shape.thin > 0) size = std::min(size, shape.thin / finer);
  try {
    for (int n = 0; n < most_tries; ++n) {
      // As it is printed, so that it is this size that was tried.
      const double tried = std::strtod(core::digits(size, 4).c_str(), nullptr);
      if (least_tets(coarse, tried) > most_tets) break;
      const std::optional<CountedShape> counted = count_at(shape, tried, method, budget, context);
      if (!counted) break;
      found.finest = {tried, counted->stuffing.tet_count()};
      if (found.finest.tets > 0 && keeps(*counted, found.finest)) {
        found.kept = found.finest;
        break;
      }
      size /= found.finest.tets == 0 || n >= most_tries / 2 ? much_finer : finer;
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::too_large) throw;
  }
  return found;
}

}  // namespace certet
