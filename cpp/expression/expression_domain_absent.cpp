// Stands in for expression_domain.cpp where muParser was left out.

#include "certet/error.hpp"
#include "certet/expression.hpp"

namespace certet {

struct ExpressionDomain::State {
  Frame frame;
  Lattice lattice;
};

ExpressionDomain::ExpressionDomain(const std::string&, const Bounds&, double, std::int32_t) {
  throw Error(ErrorCode::bad_input, "the formula cannot be read: formulas were not built in");
}

ExpressionDomain::~ExpressionDomain() = default;
const Frame& ExpressionDomain::frame() const { return state_->frame; }
const Lattice& ExpressionDomain::lattice() const { return state_->lattice; }
double ExpressionDomain::longest_side() const { return 0; }
void ExpressionDomain::row(Coord3, std::span<Sign>) const {}
void ExpressionDomain::at(std::span<const Coord3>, std::span<Sign>) const {}
Extent ExpressionDomain::extent(const LatticeBox&) const { return Extent::outside; }

bool can_read_expressions() { return false; }

}  // namespace certet
