#pragma once
/// \file
/// Random fields, and what may be wrong with the mesh of one whose vertices settle.

#include <algorithm>
#include <string>
#include <vector>

#include "exact.hpp"
#include "settling_model.hpp"
#include "topology.hpp"

namespace settling {

using namespace certet;
using domains::Positional;

inline Tets engine_mesh(const Positional& domain, const Lattice& lattice, Method method,
                        WarpFigures& figures) {
  Context context;
  context.threads = 1;
  const Stuffing stuffing(domain, lattice, method, context);
  figures = stuffing.warp_figures();
  return tets_of(emit(stuffing, {}, context));
}

inline std::string angle_fault(const Tets& mesh, const exact::AngleRange& range) {
  for (const auto& [a, b, c, d] : mesh.tets) {
    const exact::Tet tet{mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]};
    if (exact::six_volume(tet) <= 0) return "a tetrahedron is not positive";
    for (const exact::Dihedral& angle : exact::dihedrals(tet))
      if (!range.contains(angle)) return "an angle is out of range";
  }
  return "";
}

/// The first thing that is wrong with a mesh of a model's samples.
inline std::string fault(const Model& model, const Tets& mesh,
                         const exact::AngleRange& range = exact::angles_range) {
  if (!model.is_unfolded()) return "a tetrahedron of the lattice is turned over";
  std::string what = angle_fault(mesh, range);
  if (what.empty()) what = topology::surface_fault(mesh);
  if (!what.empty()) return what;
  const topology::Shape samples = topology::of_samples(model);
  if (topology::of_mesh(mesh) != samples) return "the shape is another";
  if (topology::pieces_by_faces(mesh) != samples.pieces) return "a piece hangs by less than a face";
  return "";
}

/// How many meshes of fields by a rule have this fault.
template <class Field>
int wrong_meshes(const std::vector<Field>& fields, const Lattice& lattice, const Rule& rule,
                 const std::string& how, const exact::AngleRange& range = exact::angles_range) {
  int wrong = 0;
  for (const Field& field : fields) {
    Model model(field, lattice, rule);
    wrong += fault(model, model.mesh(), range) == how;
  }
  return wrong;
}

/// The corners of every tetrahedron, those of least coordinates first.
inline std::vector<exact::Tet> positions(const Tets& mesh) {
  std::vector<exact::Tet> placed;
  for (const auto& [a, b, c, d] : mesh.tets) {
    placed.push_back({mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]});
    std::ranges::sort(placed.back());
  }
  std::ranges::sort(placed);
  return placed;
}

/// In what a mesh, or the figures of its warp, are not exactly those of a model; nothing if so.
inline std::string difference(Model& model, const Tets& made, const WarpFigures& figures) {
  const Tets expected = model.mesh();
  if (figures != model.figures()) return "the figures are others";
  return positions(made) == positions(expected) ? "" : "the tetrahedra are others";
}

inline constexpr Lattice small{{-6, -8, -4}, {7, 8, 7}};

/// A number that depends on the seed and on the key.
inline double real(std::uint64_t seed, int key, double low, double high) {
  return low + (high - low) * static_cast<double>(mixed(seed, key) >> 11) * 0x1p-53;
}

/// A sum of three waves, along the axes.
inline domains::Level waves(std::uint64_t seed) {
  std::array<double, 3> frequency;
  std::array<double, 3> phase;
  for (int a = 0; a < 3; ++a) {
    frequency[static_cast<std::size_t>(a)] = real(seed, a, .3, 1.4);
    phase[static_cast<std::size_t>(a)] = real(seed, 3 + a, 0, 6);
  }
  const double level = real(seed, 6, -1.5, 1.5);
  return [=](double x, double y, double z) {
    return std::sin(frequency[0] * x + phase[0]) + std::sin(frequency[1] * y + phase[1]) +
           std::sin(frequency[2] * z + phase[2]) - level;
  };
}

/// Small boxes whose walls are near the quarters of edges, as those of voxels are.
inline domains::Level boxes(std::uint64_t seed) {
  return [=](double x, double y, double z) {
    const auto cell = [](double c) { return static_cast<int>(std::floor((c - 0.5) / 2)); };
    const std::uint64_t h = mixed(seed, cell(x), cell(y), cell(z));
    return h % 3 == 0 ? -1.0 : 1.0;
  };
}

/// A wall across long edges near their quarters, rough: neighbours that move onto it from
/// either side move past each other.
inline domains::Level rough_wall(std::uint64_t seed) {
  return [=](double x, double y, double z) {
    const auto nearest = [](double c) { return static_cast<int>(std::lround(c)); };
    const double rough = real(mixed(seed, nearest(y), nearest(z)), 0, -.065, .065);
    return std::max(x - .5 - rough, -4.5 - x);
  };
}

/// Fields of several kinds, so many of each: noise cut anywhere, at the thresholds, with
/// samples on the surface or near the quarters; waves, thin sheets, boxes, and rough walls.
inline std::vector<Positional> fields(std::uint64_t seed, int each) {
  std::vector<Positional> all;
  for (int n = 0; n < each; ++n) {
    const std::uint64_t own = mixed(seed, n);
    all.push_back(domains::random_cuts(own, 0, {0, 3000, 9000, 17000, 30000, 42000, 60000, 65535}));
    all.push_back(domains::random_cuts(own, 0, {0, 1, 18687, 18688, 26111, 26112, 39424, 46848, 65535}));
    all.push_back(domains::random_cuts(own, 60, {10, 20000, 32768, 50000}));
    all.push_back(domains::random_cuts(own, 0, {16384, 16385, 17000, 18687}));
    all.push_back(domains::of_level(boxes(mixed(own, 2))));
    all.push_back(domains::of_level(rough_wall(mixed(own, 3))));
    all.push_back(domains::of_level(waves(mixed(own, 1))));
    all.push_back(domains::of_level(
        domains::slab(real(own, 1, -1, 1), real(own, 2, -1, 1), real(own, 3, .1, 1),
                      real(own, 4, -1, 1), real(own, 5, .2, 3))));
  }
  return all;
}

}  // namespace settling
