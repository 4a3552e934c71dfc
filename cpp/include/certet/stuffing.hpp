#pragma once
/// \file
/// The engine: from a domain to a mesh.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "certet/context.hpp"
#include "certet/domain.hpp"
#include "certet/grading.hpp"
#include "certet/lattice.hpp"
#include "certet/lattice/lattice_limits.hpp"
#include "certet/mesh.hpp"
#include "certet/method.hpp"
#include "certet/pieces.hpp"
#include "certet/placed_domain.hpp"
#include "certet/ranks.hpp"
#include "certet/warp_figures.hpp"

namespace certet {

/// Two tetrahedra, each by its number from the first of its layer on.
using TetPair = std::array<std::uint32_t, 2>;
/// Takes some pairs, and is called again for more.
using VisitTetPairs = std::function<void(std::span<const TetPair>)>;

/// A mesh that is decided and counted, but not yet written out: signs, cuts
/// and warped vertices of the lattice.  It is made of layers (one for each k of
/// the lattice); points and tetrahedra are numbered layer by layer, and a
/// tetrahedron of layer k uses points of the layers k and k+1 only, so that a
/// mesh larger than memory can be written slab by slab.
class Stuffing {
 public:
  /// Samples the domain, finds the cuts, warps and counts.  The domain must live as
  /// long as the object, which asks it for materials while it emits.
  /// \throws Error `too_large` (lattice outside the coordinate range, or out
  /// of memory), `cancelled`, `bad_option`; whatever the domain throws.
  Stuffing(const Domain& domain, const Lattice& lattice, Method method, Context& context);
  /// What this rank has of the same mesh: some of its layers, so many that all have about as much
  /// work, with numbers that are those of the whole; `point_count` and `tet_count` are of the whole.
  /// Besides its own layers it knows the points of the one behind them.  Several ranks that call
  /// it with the same make one mesh.
  /// \throws Error besides as `Ranks::gather`, and `bad_option` if there are more ranks than layers.
  Stuffing(const Domain& domain, const Lattice& lattice, Method method, Ranks& ranks,
           Context& context);
  /// Shares the layers of a mesh of which each rank has all: who is to write which.
  /// \throws Error `bad_option` if there are more ranks than layers.
  void divide(Ranks& ranks);
  ~Stuffing();
  Stuffing(Stuffing&&) noexcept;
  Stuffing& operator=(Stuffing&&) noexcept;

  [[nodiscard]] std::uint64_t point_count() const;
  [[nodiscard]] std::uint64_t tet_count() const;

  [[nodiscard]] const Lattice& lattice() const;
  /// The method that was used in the end, whose theorem covers the mesh.
  [[nodiscard]] Method method() const;
  /// All-zero tetrahedra that `Method::angles` had inverted; if there were any, the
  /// mesh was warped anew by `Method::embedding`.
  [[nodiscard]] std::uint64_t inverted_tets() const;
  /// What became of the violated vertices, if they settled (`Method::key`, `embedded`); else all is 0.
  [[nodiscard]] const WarpFigures& warp_figures() const;

  /// Number of layers; layers are numbered from 0.
  [[nodiscard]] std::int32_t layers() const;
  /// Those who make the mesh together; null: one has all.
  [[nodiscard]] Ranks* ranks() const;
  /// Whether all layers are known here.
  [[nodiscard]] bool knows_all() const;
  /// The layers of this rank, [own_begin(), own_end()): of one that has all, all.
  [[nodiscard]] std::int32_t own_begin() const;
  [[nodiscard]] std::int32_t own_end() const;
  /// The number of the first point (tetrahedron) of a layer; `layers()` gives
  /// the total.
  [[nodiscard]] std::uint64_t first_point(std::int32_t layer) const;
  [[nodiscard]] std::uint64_t first_tet(std::int32_t layer) const;
  /// The layer behind the last one of which tetrahedra of the layers before `end` use points:
  /// end + 1, or up to 12 of a graded mesh, or `layers()`.
  [[nodiscard]] std::int32_t points_end(std::int32_t end) const;

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

  /// What the domain calls the materials: that of material m is labels()[m - 1].
  /// None: tetrahedra have no labels.
  [[nodiscard]] std::span<const std::int32_t> labels() const;
  /// Whether several materials are cut where they meet, so that the mesh itself decides
  /// what its tetrahedra are made of.
  [[nodiscard]] bool has_interfaces() const;
  /// Writes the materials of the tetrahedra of the layers [begin, end), as emit_tets writes
  /// them, of a mesh that has interfaces.
  void emit_materials(std::int32_t begin, std::int32_t end, std::span<Material> out,
                      Context& context) const;
  /// Of a mesh that has none: asks the domain for the materials of the tetrahedra of the layers [begin, end):
  /// `tets`, as emit_tets writes them.  `points` are those of the layers [begin,
  /// end + 1), or up to the last layer, as emit_points writes them.
  /// \throws Error `bad_option` if a size is another one, `cancelled`; what the
  /// domain throws.
  void emit_materials(std::int32_t begin, std::int32_t end, std::span<const Coord3> points,
                      std::span<const Tet<std::uint32_t>> tets, std::span<Material> out,
                      Context& context) const;
  void emit_materials(std::int32_t begin, std::int32_t end, std::span<const Coord3> points,
                      std::span<const Tet<std::uint64_t>> tets, std::span<Material> out,
                      Context& context) const;

  /// The same for some tetrahedra of the mesh, whose corners are at hand.
  void materials_of(std::span<const TetCorners> tets, std::span<Material> out) const;

  /// Counts the pieces of the mesh, and the faults of its surface, whatever the method; no
  /// tetrahedron is made.  Places are in the world of `frame`.  Takes some 20 bytes for each
  /// run of neighbouring lattice points inside, of which a row has most often one or two.
  /// \throws Error `cancelled`, `too_large` (out of memory, or 2^32 runs).
  [[nodiscard]] Pieces pieces(const Frame& frame, Context& context) const;

  /// Tells which tetrahedra of a layer share a face with each other, or with which of the next
  /// layer: each pair once, in no order that means anything.
  /// \throws Error `bad_option` of a mesh that has interfaces, of which `pieces` tells all.
  void visit_faces_within(std::int32_t layer, const VisitTetPairs& visit) const;
  void visit_faces_between(std::int32_t layer, const VisitTetPairs& visit) const;

  /// Takes the pieces that are not to stay out of the mesh, whose points and tetrahedra are
  /// numbered anew and otherwise as they were; none may be left.
  /// \returns what was taken out, as a mesh of its own.
  /// \throws Error as `pieces`; then nothing is changed.
  Stuffing keep(const KeepRule& rule, Context& context);

  /// Grades the mesh: away from its surface, and where no materials meet, tetrahedra become
  /// larger.  What touches the surface or an interface stays as it was, bit by bit; points and
  /// tetrahedra are numbered anew.  By no level grading is taken back; `keep` does so too.
  /// \throws Error `bad_option` (more levels than `most_grading_levels`, or several materials
  /// that do not meet in interfaces), `cancelled`, `too_large` (out of memory); then nothing is
  /// changed.
  void grade(const Grading& grading, Context& context);
  /// By how many levels the mesh is graded.
  [[nodiscard]] std::int32_t grading_levels() const;
  /// How many tetrahedra the mesh has when it is not graded.
  [[nodiscard]] std::uint64_t uniform_tet_count() const;

  /// The boxes at which the domain is cut off.
  [[nodiscard]] std::span<const BorderBox> border() const;
  /// Whether the domain is cut off anywhere.
  [[nodiscard]] bool has_border() const { return !border().empty(); }
  /// Whether a point of the mesh's surface, in steps, lies where the domain is cut off.
  /// A face of the boundary whose three points do is part of no surface of the shape.
  [[nodiscard]] bool is_on_border(Coord3 point) const;

  /// Bytes that the object holds.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  struct State;
  explicit Stuffing(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The mesh of a shape, in memory, by the method asked for or, where
/// `Method::angles` would turn over a tetrahedron that is dropped, by
/// `Method::embedding`: `Mesh::method` says which.
/// \throws Error `empty_domain` (nothing is inside at this size), `too_large`
/// (memory, coordinate range), `cancelled`; what the domain throws.
Mesh mesh(const PlacedDomain& domain, Method method, Context& context);
Mesh mesh(const PlacedDomain& domain, Method method = default_method);

/// The same of a mesh of the domain that has been counted already.  \throws Error as `emit`.
Mesh mesh(const PlacedDomain& domain, const Stuffing& stuffing, Context& context);

/// The whole mesh in memory, of a domain that does not know where it lies.  \throws Error as `Stuffing` and `emit`, and `empty_domain`.
Mesh stuff(const Domain& domain, const Lattice& lattice, const Frame& frame,
           Method method, Context& context);

/// Writes a counted mesh into memory, with labels if the domain has any.  \throws Error `too_large` (out of memory), and
/// as `checked_size` for the size of the frame.
Mesh emit(const Stuffing& stuffing, const Frame& frame, Context& context);

}  // namespace certet
