#pragma once
/// \file
/// Private to the bridge: the closures that a call hands to its stubs.

#include "certified.hpp"

namespace certified::closures {

struct Stencil {
  const GetSign& get_sign;
  const GetIntersection& get_intersection;
  const GetKey* get_key = nullptr;  ///< where diagonals follow the cuts
};

struct Warp {
  const std::function<Sign(int)>& neighbor_sign;
  const std::function<std::int64_t(int)>& cut;
};

struct Bisect {
  const std::function<Sign(std::int64_t)>& sign;
};

struct Voxels {
  const std::function<bool(Coord3)>& holds;
};

struct MaterialStencil {
  const GetMaterial& get_material;
  const GetIntersection& get_intersection;
};

struct MaterialMesh {
  const MaterialDomain& domain;
  std::vector<PlacedMaterialTet>& out;
};

struct Stuffing {
  const Domain& domain;
  std::vector<PlacedTet>& out;
};

}  // namespace certified::closures
