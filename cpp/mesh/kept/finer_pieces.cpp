#include "finer_pieces.hpp"

#include "budget.hpp"
#include "certet/error.hpp"
#include "engine/sampled_pieces.hpp"

namespace certet::core {

std::optional<std::uint64_t> pieces_at(const SizedShape& shape, double size, Method method,
                                       double most_cells, Context& context) {
  try {
    const std::unique_ptr<PlacedDomain> domain = shape.place(size);
    SearchBudget budget;
    budget.mixed = most_cells;
    if (!budget.pay_for(*domain)) return std::nullopt;
    return count_sampled_pieces(*domain, domain->lattice(), method, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::too_large) throw;
    return std::nullopt;
  }
}

}  // namespace certet::core
