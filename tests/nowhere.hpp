#pragma once
/// \file
/// A writer that takes a mesh and keeps nothing.

#include "certet/write_mesh.hpp"

class Nowhere final : public certet::MeshWriter {
 public:
  void points(std::span<const certet::Point3>) override {}
  void tets(std::span<const certet::Tet<std::uint32_t>>, std::span<const std::int32_t>) override {}
  void tets(std::span<const certet::Tet<std::uint64_t>>, std::span<const std::int32_t>) override {}
  void finish() override {}
};
