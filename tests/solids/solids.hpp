#pragma once
/// \file
/// Solids to try, and what is measured of their meshes.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "certet/materials_domain.hpp"
#include "certet/mesh.hpp"
#include "certet/shape.hpp"
#include "certet/stuffing.hpp"
#include "certet/surface.hpp"
#include "certet/survey.hpp"
#include "surface/surfaces.hpp"

namespace solids {

using certet::Bounds;
using certet::Method;
using certet::NamedSolid;
using certet::Point3;
using certet::Solid;
using certet::TriangleSurface;

inline Solid inside(TriangleSurface surface) {
  return certet::surface_solid(std::make_shared<const TriangleSurface>(std::move(surface)));
}

/// A box of triangles.
inline Solid block(Point3 low, Point3 high) { return inside(surfaces::box(low, high)); }

inline Solid ball(double radius) {
  return certet::shape_solid("sphere:" + std::to_string(radius));
}

/// In long edges cubed, by labels.
using Volumes = std::map<std::int32_t, double>;

using Corners = std::array<Point3, 3>;

inline double area(const Corners& t) {
  std::array<double, 3> u{}, v{};
  for (std::size_t a = 0; a < 3; ++a) {
    u[a] = t[1][a] - t[0][a];
    v[a] = t[2][a] - t[0][a];
  }
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]) / 2;
}

/// A mesh, its regions and interfaces, measured in world units.
struct Measured {
  certet::Mesh mesh;
  Volumes volumes;                                      ///< by labels
  std::map<std::array<std::int32_t, 2>, std::vector<Corners>> interfaces;
  std::vector<Corners> boundary;

  [[nodiscard]] double area_between(std::int32_t a, std::int32_t b) const {
    const auto found = interfaces.find({a, b});
    double sum = 0;
    if (found != interfaces.end())
      for (const Corners& triangle : found->second) sum += area(triangle);
    return sum;
  }
};

inline double volume(const std::array<Point3, 4>& p) {
  std::array<std::array<double, 3>, 3> e{};
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t a = 0; a < 3; ++a) e[v][a] = p[v + 1][a] - p[0][a];
  return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
          e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6;
}

inline Measured measured(const certet::PlacedDomain& domain, Method method = Method::embedded) {
  certet::Context context;
  Measured result{certet::mesh(domain, method, context), {}, {}, {}};
  const certet::Mesh& mesh = result.mesh;
  const auto world = [&](std::uint64_t point) {
    return mesh.frame.world(mesh.points[static_cast<std::size_t>(point)]);
  };
  const auto corners = [&](const certet::BoundaryFace& face) {
    return Corners{world(face.points[0]), world(face.points[1]), world(face.points[2])};
  };
  std::visit(
      [&]<class Index>(const certet::Buffer<certet::Tet<Index>>& tets) {
        for (std::size_t t = 0; t < tets.size(); ++t)
          result.volumes[mesh.labels[t]] +=
              volume({world(tets[t][0]), world(tets[t][1]), world(tets[t][2]), world(tets[t][3])});
        const certet::Survey found =
            certet::survey(mesh.points.size(), std::span<const certet::Tet<Index>>(tets),
                           mesh.labels, context);
        for (const certet::BoundaryFace& face : found.boundary)
          result.boundary.push_back(corners(face));
        for (const certet::Interface& one : found.interfaces)
          for (const certet::BoundaryFace& face : one.faces)
            result.interfaces[one.labels].push_back(corners(face));
      },
      mesh.tets);
  return result;
}

}  // namespace solids
