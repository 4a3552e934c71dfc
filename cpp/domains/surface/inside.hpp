#pragma once
/// \file
/// Which of its winding numbers make the inside of a surface.

#include <cstdint>
#include <optional>
#include <vector>

#include "certet/domain.hpp"
#include "certet/surface.hpp"
#include "rims.hpp"
#include "steady_rest.hpp"

namespace certet {

/// Inside is what a closed surface winds around; or what an odd number of its triangles
/// separate from the outside; or, within the box around an open surface, what it winds
/// around by more than one half.
enum class Rule { winding, parity, half };

/// Of a closed surface.  \throws Error `bad_input` where it is not.
Rule closed_rule(const TriangleSurface& surface);

/// Of any surface.  \throws Error `bad_input` where it is open, and a sheet of it has
/// one side alone.
Rule open_rule(const TriangleSurface& surface);

class Inside {
 public:
  /// Points in steps.
  Inside(const TriangleSurface& surface, const std::vector<Coord3>& points, Rule rule);
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;

  /// Of a moved point; `crossings` counts the triangles
  /// ahead where the ray along x leaves, less those where it enters.  On the surface is
  /// what an open one winds around by one half, to rounding; its rims are outside.
  [[nodiscard]] Sign at(int crossings, Coord3 p, exact::Nudge nudge) const {
    switch (rule_) {
      case Rule::winding: return crossings != 0 ? Sign::plus : Sign::minus;
      case Rule::parity: return crossings % 2 != 0 ? Sign::plus : Sign::minus;
      case Rule::half: break;
    }
    return at_half(crossings, p, nudge);
  }

  /// The winding number around a moved point; NaN on a rim.
  [[nodiscard]] double winding(int crossings, Coord3 p, exact::Nudge nudge) const {
    return crossings + rims_.rest(p, nudge);
  }

  /// What is known of a box, in steps, that the surface does not meet, with the
  /// crossings ahead of its middle.
  [[nodiscard]] Extent over(const IntegerBox& box, Coord3 middle, int crossings) const;

  [[nodiscard]] Rule rule() const { return rule_; }
  [[nodiscard]] std::uint64_t bytes() const {
    return rims_.bytes() + (steady_ ? steady_->bytes() : 0);
  }

 private:
  [[nodiscard]] Sign at_half(int crossings, Coord3 p, exact::Nudge nudge) const;

  Rule rule_;
  IntegerBox around_;  ///< the triangles
  Rims rims_;
  std::optional<SteadyRest> steady_;  ///< of an open surface
};

}  // namespace certet
