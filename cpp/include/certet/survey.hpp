#pragma once
/// \file
/// What many file formats say of a mesh beside its points and tetrahedra: the
/// regions that it is divided into, and its boundary.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certet/context.hpp"
#include "certet/labels.hpp"
#include "certet/material_runs.hpp"
#include "certet/mesh.hpp"
#include "certet/patch.hpp"
#include "certet/stuffing.hpp"

namespace certet {

/// The label of all tetrahedra of a mesh without labels.
inline constexpr std::int32_t only_label = 1;

/// The tetrahedra of one label.
struct Region {
  std::int32_t label = only_label;
  std::string name;  ///< empty if the label has none
  std::uint64_t tets = 0;
  double volume = 0;  ///< in long edges cubed; 0 where it was not measured
};

/// A face that belongs to one tetrahedron only, or to two of different labels.
struct BoundaryFace {
  /// Counterclockwise as seen from outside, from the lowest number on.
  std::array<std::uint64_t, 3> points;
  std::uint64_t tet;      ///< whose face it is
  std::uint8_t opposite;  ///< which of that one's corners it does not have
  bool is_cut_off = false;       ///< whether the shape goes on behind it
  Patch patch = Patch::surface;  ///< of a face of one tetrahedron
  std::int32_t label = only_label;  ///< of `tet`

  friend bool operator==(const BoundaryFace&, const BoundaryFace&) = default;
};

/// Where two regions touch each other.
struct Interface {
  std::array<std::int32_t, 2> labels;  ///< the lesser first
  /// Those of the tetrahedra of the lesser label, by growing numbers of points.
  std::vector<BoundaryFace> faces;

  friend bool operator==(const Interface&, const Interface&) = default;
};

struct Survey {
  std::vector<Region> regions;         ///< by growing labels; none is empty
  std::vector<BoundaryFace> boundary;  ///< by growing numbers of points
  std::vector<Interface> interfaces = {};  ///< by growing labels; none is empty
  /// Of the tetrahedra of a counted mesh, where they have labels.
  MaterialRuns materials = {};
  /// The names of patches behind those of `patch_names`: `Patch` counts on.
  std::vector<std::string> named_patches = {};
};

/// Surveys a mesh that is counted but not written, with memory for its boundary and
/// the runs of its materials alone.  A face of the boundary belongs to the patch of a
/// side if the domain is cut off at its three points, at most of them at this side, which is
/// called after the axes of `frame`, by which the mesh goes out; of several such sides to the
/// first.  Interfaces are found where the
/// mesh is made to have them (`Stuffing::has_interfaces`).  The result does not depend
/// on the number of threads.  Names are left empty.
/// \throws Error `cancelled`, `too_large` (out of memory); what the domain throws.
Survey survey(const Stuffing& stuffing, Context& context, const Frame& frame = {});

/// Surveys a mesh in memory of so many points; `labels` is empty or as long as `tets`.  Tetrahedra
/// that name a point which is not there, or one twice, have no faces.  All faces
/// belong to the patch `surface`.
/// \throws Error `cancelled`.
Survey survey(std::uint64_t points, std::span<const Tet<std::uint32_t>> tets,
              std::span<const std::int32_t> labels, Context& context);
Survey survey(std::uint64_t points, std::span<const Tet<std::uint64_t>> tets,
              std::span<const std::int32_t> labels, Context& context);

/// Surveys a mesh in memory, with its names and patches, those of `Mesh::patches` too; interfaces
/// only where its method cuts labels apart.
/// \throws Error `cancelled`, and as `name_patches`.
Survey survey(const Mesh& mesh, Context& context);

/// Puts the faces of the boundary into the patches of sides anew, by where the points of a mesh are now,
/// as vertices that moved onto a rim have joined faces to a side.  `frame` as above.
void find_sides(Survey& survey, const Mesh& mesh, const Frame& frame);

/// A triangle, and the patch that it is to be of.
struct PatchFace {
  std::array<std::uint64_t, 3> points;
  Patch patch;
};

/// Puts those faces of the boundary that have the points of one of `faces`, in any
/// order, into the patch of that one.
void set_patches(Survey& survey, std::vector<PatchFace> faces);

/// The faces of the boundary and of all interfaces.
std::uint64_t face_count(const Survey& survey);

/// Leaves of the boundary one region's surface, closed, as seen from outside of it; or, of
/// two labels, where their regions touch, as the lesser sees it.  Interfaces are none then.
/// \throws Error `bad_option` if there is no such region or interface.
void keep_surface(Survey& survey, std::span<const std::int32_t> labels);

/// Leaves of the boundary the interfaces alone, all together, each as its lesser label sees it;
/// as a set of its own there is none then.
/// \throws Error `bad_option` if no regions touch each other.
void keep_interfaces(Survey& survey);

/// Gives regions their names.
void name_regions(Survey& survey, const LabelNames& names);

}  // namespace certet
