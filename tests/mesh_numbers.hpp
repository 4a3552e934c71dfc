#pragma once
/// \file
/// The numbers of the points of a mesh's tetrahedra, of whatever width they are.

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "certet/mesh.hpp"

inline std::vector<std::array<std::uint64_t, 4>> numbers_of(const certet::Mesh& mesh) {
  std::vector<std::array<std::uint64_t, 4>> all;
  std::visit(
      [&](const auto& tets) {
        for (const auto& [a, b, c, d] : tets) all.push_back({a, b, c, d});
      },
      mesh.tets);
  return all;
}
