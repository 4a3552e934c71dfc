#pragma once
/// \file
/// The patches of a solid of which signs alone are known.

#include <map>
#include <optional>
#include <vector>

#include "rays.hpp"
#include "sites.hpp"
#include "traced.hpp"

namespace certet::features {

class TracedPatches final : public Patches {
 public:
  TracedPatches(const Traced& traced, const Domain& domain);

  [[nodiscard]] std::uint32_t at(std::uint64_t vertex, const Vector& place) const override;
  /// On the surface, along the normal at the nearest vertex; beyond a sharp edge, on that.
  [[nodiscard]] Vector nearest(std::uint32_t patch, const Vector& point) const override;
  /// At the nearest vertex of a patch.
  [[nodiscard]] Vector normal(std::uint32_t patch, const Vector& point) const override;

 private:
  struct Patch {
    std::vector<std::uint32_t> vertices;
    std::vector<PatchBorder> borders;
    std::optional<distance::TriangleTree> vertex_tree, border_tree;
    std::map<Coord3, Vector> into;  ///< of the ends of borders, the sum of what meets there
  };

  /// The nearest point of a patch's border.
  struct Edge {
    Vector place, into;
    double away;
  };
  [[nodiscard]] std::optional<Edge> edge_near(const Patch& patch, const Vector& point) const;
  [[nodiscard]] std::uint32_t vertex_near(std::uint32_t patch, const Vector& point) const;

  const SeenSurface& surface_;
  const std::vector<std::uint32_t>& of_;
  const Domain& domain_;
  std::vector<Patch> patches_;
};

}  // namespace certet::features
