// Stands in for formula_domain.cpp where muParser was left out.

#include "certet/error.hpp"
#include "certet/formula.hpp"
#include "certet/size_fields.hpp"

namespace certet {
namespace {

[[noreturn]] void refuse() {
  throw Error(ErrorCode::bad_input, "the formula cannot be read: formulas were not built in");
}

}  // namespace

struct FormulaDomain::State {
  Frame frame;
  Lattice lattice;
};

FormulaDomain::FormulaDomain(const std::string&, const Bounds&, double, std::int32_t) {
  refuse();
}
FormulaDomain::FormulaDomain(const std::string&, const Bounds&, const PlacedLattice&) {
  refuse();
}

FormulaDomain::~FormulaDomain() = default;
const Frame& FormulaDomain::frame() const { return state_->frame; }
const Lattice& FormulaDomain::lattice() const { return state_->lattice; }
std::span<const BorderBox> FormulaDomain::border() const { return {}; }
double FormulaDomain::longest_side() const { return 0; }
void FormulaDomain::row(Coord3, std::span<Sign>) const {}
void FormulaDomain::at(std::span<const Coord3>, std::span<Sign>) const {}
Extent FormulaDomain::extent(const LatticeBox&) const { return Extent::outside; }

Solid formula_solid(const std::string&, const Bounds&) { refuse(); }

SizeField formula_sizes(const std::string&) { refuse(); }

bool can_read_formulas() { return false; }

}  // namespace certet
