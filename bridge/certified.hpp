#pragma once
/// \file
/// The certified functions, called as they were extracted from the proofs.
/// This is the only place where C++ and OCaml meet.
///
/// All functions but `start` need a started runtime and belong to the thread
/// that started it.  They throw `Failure` when called from elsewhere or when an
/// integer does not fit in OCaml's 63 bits.  What a closure throws passes
/// through to the caller.  Closures may call certified functions in turn.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <vector>

#include "certet/lattice/coord3.hpp"
#include "certet/lattice/direction.hpp"
#include "certet/lattice/sign.hpp"
#include "certet/lattice/structured_tet.hpp"
#include "certet/stuffing.hpp"
#include "certet/lattice/warp.hpp"

namespace certified {

using certet::Coord3;
using certet::Sign;

class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Starts the OCaml runtime, which cannot be started anew, and binds it to the
/// calling thread.  Further calls from that thread do nothing.
void start();

/// alpha of long and of short edges, in 256ths.
struct Thresholds {
  std::int64_t long_edge, short_edge;
  friend constexpr bool operator==(const Thresholds&, const Thresholds&) = default;
};

/// A row of `AllDirections`.
struct Direction {
  Coord3 offset;
  bool is_long;
  std::int64_t length_squared;
};

/// The numbers that the certificate fixes.
struct Constants {
  std::int64_t step_bits, steps, midpoint_cut;
  Thresholds angle, embedding, no_warp, key;
  std::array<Direction, certet::direction_count> directions;
};
Constants constants();

/// `ThresholdSteps`.
std::int64_t threshold_steps(Thresholds thresholds, bool is_long);

/// `GetStructuredTet`.  `Failure` if a coordinate does not fit 32 bits.
certet::StructuredTet structured_tet(const certet::StructuredTetId& id);

/// `AllCases`.
std::vector<certet::StructuredTetCase> all_cases();

/// `CaseHandedness`.
bool right_handed(certet::StructuredTetCase orientation);

/// The caller's vertex: any number it likes, a handle.
using Handle = std::int64_t;
using GetSign = std::function<Sign(Handle)>;
using GetIntersection = std::function<Handle(Handle, Handle)>;

/// `GetUnstructuredTets`.
std::vector<std::array<Handle, 4>> unstructured_tets(
    const GetSign& get_sign, const GetIntersection& get_intersection,
    const std::array<Handle, 4>& vertices);

/// The key of the cut of an edge, from its + to its - end.
using GetKey = std::function<std::int64_t(Handle, Handle)>;

/// `GetKeyTets`.
std::vector<std::array<Handle, 4>> key_tets(const GetSign& get_sign,
                                            const GetIntersection& get_intersection,
                                            const GetKey& get_key,
                                            const std::array<Handle, 4>& vertices);

/// A material: a number, 0 for the outside.
using Material = std::int64_t;

/// The material of a vertex, or none on an interface.
using GetMaterial = std::function<std::optional<Material>(Handle)>;

/// A tetrahedron of a material.
template <class Vertex>
struct OfMaterial {
  Material material = 0;
  std::array<Vertex, 4> vertices{};
  friend constexpr auto operator<=>(const OfMaterial&, const OfMaterial&) = default;
};

/// `GetMaterialTets`; `shared` is the material of a tetrahedron whose vertices all lie on
/// interfaces.  Materials are not negative.
std::vector<OfMaterial<Handle>> material_tets(const GetMaterial& get_material,
                                              const GetIntersection& get_intersection,
                                              const std::array<Handle, 4>& vertices,
                                              Material shared);

/// What becomes of a vertex; direction -1: it stays.
struct Warping {
  int direction = -1;
  std::int64_t distance = 0;
  friend constexpr bool operator==(const Warping&, const Warping&) = default;
};

/// `Warp`; the closures get the number of a direction.
Warping warp(Thresholds thresholds, Sign sign, const std::function<Sign(int)>& neighbor_sign,
             const std::function<std::int64_t(int)>& cut);

/// `WarpedSign` and `WarpedPosition` of a lattice point v, in steps.
Sign warped_sign(Sign sign, Warping w);
Coord3 warped_position(Coord3 v, Warping w);

/// Some of the fourteen neighbours of a vertex: bit d for direction d.
using LinkSet = std::uint32_t;

/// `IsDisk` of the signs of the neighbours.
bool is_disk(const std::array<Sign, certet::direction_count>& link);

/// `DiskOf`: with just these neighbours +, the sets of neighbours that may be 0 if the
/// link is to be a strict disk; ascending.
std::vector<LinkSet> disks(LinkSet plus);

/// `InOnePiece`; the empty set is in none.
bool in_one_piece(LinkSet set);

/// `Bisect`; the closure gets steps from the + end.
std::int64_t bisect(const std::function<Sign(std::int64_t)>& sign);

/// `PointOnEdge`, in steps.
Coord3 point_on_edge(Coord3 a, Coord3 b, std::int64_t t);

/// `VoxelGrid`: half a long edge, the spacings of the voxels, and where the lattice's
/// origin lies in the image, in one unit.
struct VoxelGrid {
  std::int64_t half;
  Coord3 spacing, origin;
};

/// `VoxelSigns`: the sample of a label image at a lattice point; `holds` tells the voxels
/// of the image.
Sign voxel_sign(const VoxelGrid& grid, const std::function<bool(Coord3)>& holds, Coord3 point);

/// A domain: the sign of each lattice point, and the cut of each edge in steps
/// from its + end, given first.
struct Domain {
  std::function<Sign(Coord3)> sign;
  std::function<std::int64_t(Coord3 plus, Coord3 minus)> cut;
};

/// Four positions in steps.
using PlacedTet = std::array<Coord3, 4>;

/// `StuffTet` with `MeshPosition`: the tetrahedra that fill one structured one.
std::vector<PlacedTet> stuff_tet(Thresholds thresholds, const Domain& domain,
                                 const certet::StructuredTetId& id);

/// The whole mesh of the reference mesher, in its order.  The lattice's
/// outermost points count as outside.
std::vector<PlacedTet> stuff(Thresholds thresholds, const certet::Lattice& lattice,
                             const Domain& domain);

/// `IsWellShaped` with `WidestAngles`.
bool is_well_shaped(const PlacedTet& tet);

/// What is left between two vertices that move towards each other.
enum class Gap {
  level,   ///< `LevelGap`, the product's: they may come level
  strict,  ///< `StrictGap`
};

/// Where the diagonals of quadrilaterals end.
enum class Diagonals {
  by_parity,  ///< as the Parity Rule says: `PlacedNames`
  by_key,     ///< at the lesser of the mesh's cuts: `KeyNames`
};

/// The whole mesh by the warp that keeps the shape: `Settle` over all points of the
/// lattice `InTurn`, and the diagonals' names with `PlacedPosition`; in the order of `stuff`.
/// The lattice's outermost points count as outside, and so does what is sampled on the
/// surface: `OpenSigns` and `OpenCuts`.
std::vector<PlacedTet> settle(Thresholds thresholds, Gap gap, const certet::Lattice& lattice,
                              const Domain& domain, Diagonals diagonals = Diagonals::by_parity);

/// The whole mesh, graded by so many levels: `GradedOctree` and `GradedTetsWithin` of the
/// mesh that `settle` (with `Gap::level`) or `stuff` makes; in an order of its own.
std::vector<PlacedTet> grade(Thresholds thresholds, bool settles, int levels,
                             const certet::Lattice& lattice, const Domain& domain,
                             Diagonals diagonals = Diagonals::by_parity);

/// A domain of several materials: that of each lattice point, and the cut of each edge in
/// steps from the end of the higher one, given first.
struct MaterialDomain {
  std::function<Material(Coord3)> material;
  std::function<std::int64_t(Coord3 higher, Coord3 lower)> cut;
};

using PlacedMaterialTet = OfMaterial<Coord3>;

/// The whole mesh of several materials by the warp that keeps the shape: `SettleMaterials`
/// over all points of the lattice, `MaterialsInTurn`, and `SettledMaterialTets`; in the
/// order of `stuff`, without those of the outside.  The lattice's outermost points count as
/// outside.
std::vector<PlacedMaterialTet> settle_materials(Thresholds thresholds,
                                                const certet::Lattice& lattice,
                                                const MaterialDomain& domain);

/// The same where nobody moves and edges are cut in the middle, `MidpointCuts`.
std::vector<PlacedMaterialTet> halve_materials(
    const certet::Lattice& lattice, const std::function<Material(Coord3)>& material);

/// The mesh of `settle_materials` or, where nobody settles, of `halve_materials`, graded by so
/// many levels: names and what they stand for are the certificate's; cells are kept where
/// points are of more than one material, or moved.  In an order of its own.
std::vector<PlacedMaterialTet> grade_materials(Thresholds thresholds, bool settles, int levels,
                                               const certet::Lattice& lattice,
                                               const MaterialDomain& domain);

}  // namespace certified
