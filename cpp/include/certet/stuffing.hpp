#pragma once
/// \file
/// The engine: from a domain to a mesh.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/lattice_limits.hpp"
#include "certet/mesh.hpp"
#include "certet/structured_tet.hpp"
#include "certet/warp.hpp"
#include "certet/warp_figures.hpp"

namespace certet {

/// The piece of the lattice that is searched: the even points
/// origin + 2 (i,j,k), 0 <= i < cells[0] and so on, and the odd points
/// origin + 2 (i,j,k) + (1,1,1).  `origin` is an even point, in lattice units.
/// The outermost points (first and last index of each axis) count as outside
/// whatever the domain says, which closes the mesh.
struct Lattice {
  Coord3 origin{0, 0, 0};
  std::array<std::int32_t, 3> cells{0, 0, 0};
};

/// Where the cuts are put.
enum class Cuts {
  bisect,    ///< on the surface, found by bisection to one step
  midpoint,  ///< in the middle of each edge; no vertex is warped, and one that
             ///< lies on the surface counts as inside
};

/// Which theorems shall cover the mesh.
enum class Guarantee {
  pieces,     ///< violated vertices settle: angles as below, the mesh embeds, is a manifold,
              ///< and keeps the pieces, cavities and tunnels of the samples
  angles,     ///< the paper's rule, thresholds 73/256, 102/256: the same angles
  embedding,  ///< the paper's rule, thresholds 64/256, 105/256: the warped lattice never folds
};

/// "pieces", "angles" or "embedding".
std::string_view name(Guarantee guarantee);

/// What the caller chooses.
struct StuffingOptions {
  Cuts cuts = Cuts::bisect;
  Guarantee guarantee = Guarantee::pieces;
};

/// A mesh that is decided and counted, but not yet written out: signs, cuts
/// and warped vertices of the lattice.  It is made of layers (one for each k of
/// the lattice); points and tetrahedra are numbered layer by layer, and a
/// tetrahedron of layer k uses points of the layers k and k+1 only, so that a
/// mesh larger than memory can be written slab by slab.
class Stuffing {
 public:
  /// Samples the domain, finds the cuts, warps and counts.
  /// \throws Error `too_large` (lattice outside the coordinate range, or out
  /// of memory), `cancelled`, `bad_option`; whatever the domain throws.
  Stuffing(const Domain& domain, const Lattice& lattice,
           const StuffingOptions& options, Context& context);
  ~Stuffing();
  Stuffing(Stuffing&&) noexcept;
  Stuffing& operator=(Stuffing&&) noexcept;

  [[nodiscard]] std::uint64_t point_count() const;
  [[nodiscard]] std::uint64_t tet_count() const;

  [[nodiscard]] const Lattice& lattice() const;
  /// What holds in the end: `embedding` where `angles` was asked for and inverted something.
  [[nodiscard]] Guarantee guarantee() const;
  /// All-zero tetrahedra that the thresholds of `angles` had inverted; if there
  /// were any, the mesh was warped anew with those of `embedding`.
  [[nodiscard]] std::uint64_t inverted_tets() const;
  /// What became of the violated vertices, if they settled (`pieces`); else all is 0.
  [[nodiscard]] const WarpFigures& warp_figures() const;

  /// Number of layers; layers are numbered from 0.
  [[nodiscard]] std::int32_t layers() const;
  /// The number of the first point (tetrahedron) of a layer; `layers()` gives
  /// the total.
  [[nodiscard]] std::uint64_t first_point(std::int32_t layer) const;
  [[nodiscard]] std::uint64_t first_tet(std::int32_t layer) const;

  /// Writes the points of the layers [begin, end), positions in steps.
  /// `out.size()` is first_point(end) - first_point(begin).
  /// \throws Error `bad_option` if it is not; so do the next ones.
  void emit_points(std::int32_t begin, std::int32_t end, std::span<Coord3> out,
                   Context& context) const;
  /// Tells of the same points whether they lie on the surface: 1 for cuts and for
  /// corners that are zero, 0 for corners that are plus.
  void mark_surface(std::int32_t begin, std::int32_t end, std::span<std::uint8_t> out,
                    Context& context) const;
  /// Writes the tetrahedra of the layers [begin, end).
  /// `out.size()` is first_tet(end) - first_tet(begin).
  /// \throws Error `too_large` besides, if 32 bits do not hold the number of a point.
  void emit_tets(std::int32_t begin, std::int32_t end,
                 std::span<Tet<std::uint32_t>> out, Context& context) const;
  void emit_tets(std::int32_t begin, std::int32_t end,
                 std::span<Tet<std::uint64_t>> out, Context& context) const;

  /// Bytes that the object holds.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The whole mesh in memory.  \throws Error as `Stuffing` and `emit`, and `empty_domain`.
Mesh stuff(const Domain& domain, const Lattice& lattice, const Frame& frame,
           const StuffingOptions& options, Context& context);

/// Writes a counted mesh into memory.  \throws Error `too_large` (out of memory), and
/// as `checked_size` for the size of the frame.
Mesh emit(const Stuffing& stuffing, const Frame& frame, Context& context);

}  // namespace certet
