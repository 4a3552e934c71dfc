#pragma once
/// \file
/// How violated vertices settle, once more: plainly, one vertex after the other, and with
/// the defects that the tests must refuse.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <variant>
#include <vector>

#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "key_diagonals.hpp"

namespace settling {

using certet::Coord3;
using certet::Lattice;
using certet::Sign;

/// The signs of a vertex's neighbours, by directions.
using LinkSigns = std::array<Sign, certet::direction_count>;

/// By floods, from the definition alone.
bool is_strict_disk(const LinkSigns& link);
/// The closure of the + part is a closed disk, which is not enough: two + parts that hang
/// together by zeros only count as one.
bool is_closed_disk(const LinkSigns& link);

/// The rule, with what may be forgotten.
struct Rule {
  std::function<bool(const LinkSigns&)> may_move = is_strict_disk;
  bool clamp = true, shorten = true;
  bool share = true;  ///< what two that would pass each other have to give up
  bool stay = true;   ///< rather than fall short by more than the cut is then moved
  std::int32_t long_alpha = 18688, short_alpha = 26112;  ///< in steps
  diagonals::Choice diagonals = diagonals::Choice::parity;
};

/// That of the method `key`, or with a defect of its diagonals.
inline Rule key_rule(diagonals::Choice diagonals = diagonals::Choice::lesser) {
  return {.long_alpha = 16384, .short_alpha = 24320, .diagonals = diagonals};
}

/// Tetrahedra by positions in steps, in the order of the stencils.
struct Tets {
  std::vector<Coord3> points;
  std::vector<std::array<std::uint32_t, 4>> tets;
};

/// Those of an engine's mesh.
inline Tets tets_of(const certet::Mesh& mesh) {
  Tets tets;
  tets.points.assign(mesh.points.begin(), mesh.points.end());
  for (const auto& tet : std::get<0>(mesh.tets)) tets.tets.push_back(tet);
  return tets;
}

/// A domain's samples, and what has become of them.
class Model {
 public:
  Model(const domains::Positional& domain, const Lattice& lattice, const Rule& rule);

  /// Of the samples; 0 counts as -.
  [[nodiscard]] bool sampled_plus(Coord3 v) const { return at(v).sampled; }
  [[nodiscard]] bool holds(Coord3 v) const;
  [[nodiscard]] Sign sign(Coord3 v) const { return holds(v) ? at(v).now : Sign::minus; }
  [[nodiscard]] Coord3 position(Coord3 v) const;
  /// All lattice points.
  [[nodiscard]] const std::vector<Coord3>& vertices() const { return vertices_; }
  [[nodiscard]] const certet::WarpFigures& figures() const { return figures_; }

  /// The mesh; fills `figures` in.
  Tets mesh();
  /// Whether each structured tetrahedron, moved, is as it was: none turned over, and flat
  /// only where its four corners are zero.
  [[nodiscard]] bool is_unfolded() const;

 private:
  struct Vertex {
    bool sampled = false, on_surface = false;
    Sign now = Sign::minus;
    int direction = -1;  ///< of the target
    std::int32_t distance = 0;
    int violating = 0;  ///< cuts
  };

  [[nodiscard]] std::size_t number(Coord3 v) const;
  [[nodiscard]] const Vertex& at(Coord3 v) const { return state_[number(v)]; }
  [[nodiscard]] std::int32_t alpha(int direction) const {
    return certet::is_long(direction) ? rule_.long_alpha : rule_.short_alpha;
  }
  [[nodiscard]] std::int32_t find_cut(Coord3 plus, Coord3 minus) const;
  [[nodiscard]] std::int32_t kept_cut(Coord3 plus, Coord3 minus) const;
  std::int32_t counted_cut(Coord3 plus, Coord3 minus);
  void find_target(Coord3 v);
  [[nodiscard]] int turn(Coord3 v) const;
  [[nodiscard]] std::int32_t shortened(Coord3 v) const;
  void settle(Coord3 v);
  template <class Visit>
  void for_each_tet(const Visit& visit) const;

  const domains::Positional& domain_;
  Lattice lattice_;
  Rule rule_;
  std::vector<Coord3> vertices_;
  std::vector<Vertex> state_;
  certet::WarpFigures figures_;
};

}  // namespace settling
