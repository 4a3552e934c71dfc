#pragma once
/// \file
/// Domains given by a formula.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "certet/bounds.hpp"
#include "certet/lattice.hpp"
#include "certet/placed_domain.hpp"
#include "certet/solid.hpp"

namespace certet {

/// Whether formulas were built in.
bool can_read_formulas();

/// The formula that a file holds, on lines as one likes; # begins a comment.
/// \throws Error `bad_input` with one sentence that names the file.
std::string read_formula(const std::filesystem::path& file);

/// A formula as a sentence quotes it: of one longer than 200 bytes, the part around one of them.
std::string shortened_formula(const std::string& formula, std::size_t around = 0);

/// Where a formula in x, y, z (world coordinates) is negative, within bounds.
/// Beyond the bounds all is outside, which closes the solid there; where the
/// formula gives NaN is outside too.
///
/// The formula is read as muParser reads it: + - * / ^ (to the right first, and
/// before a minus sign: -x^2 is -(x^2)), comparisons, && and || (true is 1), and
/// c ? a : b.  Functions: min max sum avg hypot length of any number of operands;
/// abs sign sqrt exp log (ln) log2 log10 sin cos tan asin acos atan sinh cosh tanh
/// asinh acosh atanh floor ceil round trunc rint not; atan2(y,x) pow(a,b) fmod(a,b);
/// clamp(v,low,high) mix(a,b,t) if(c,a,b); pi and e.  A smooth union of a and b,
/// rounded over about 1/k: -log(exp(-k*a)+exp(-k*b))/k.
///
/// Before it there may be definitions, each ending with a semicolon, of names that what
/// follows uses: r = hypot(x,y); max(r - 1, abs(z) - 2).  Each of them, and the formula, has at
/// most 20,000 bytes.
///
/// Points are computed in batches, and blocks of the lattice that interval
/// arithmetic proves to lie on one side are not computed at all.
class FormulaDomain final : public PlacedDomain {
 public:
  /// `size` and `margin` are those of `lattice_around`.
  /// \throws Error `bad_input` (a formula that cannot be read, with the position),
  /// and as `lattice_around`.
  FormulaDomain(const std::string& formula, const Bounds& bounds, double size,
                   std::int32_t margin);
  /// On a lattice that holds the bounds.
  FormulaDomain(const std::string& formula, const Bounds& bounds, const PlacedLattice& around);
  ~FormulaDomain() override;

  [[nodiscard]] const Frame& frame() const override;
  [[nodiscard]] const Lattice& lattice() const override;
  [[nodiscard]] double longest_side() const override;  ///< of the bounds

  void row(Coord3 first, std::span<Sign> out) const override;
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override;
  [[nodiscard]] Extent extent(const LatticeBox& box) const override;
  [[nodiscard]] std::span<const BorderBox> border() const override;  ///< the bounds

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same solid, to be put on a lattice with others.  \throws Error `bad_input` as
/// `FormulaDomain`.
Solid formula_solid(const std::string& formula, const Bounds& bounds);

}  // namespace certet
