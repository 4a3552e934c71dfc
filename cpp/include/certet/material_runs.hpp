#pragma once
/// \file
/// The materials of many tetrahedra, in little memory.

#include <cstdint>
#include <span>
#include <vector>

#include "certet/domain.hpp"

namespace certet {

/// The materials of a mesh's tetrahedra, layer by layer, as runs of equal ones: two
/// bytes for a run of up to 128 tetrahedra of one of the first 127 materials, which
/// is most of them.
class MaterialRuns {
 public:
  /// Nothing is kept.
  MaterialRuns() = default;
  /// For so many layers, which are empty at first.
  explicit MaterialRuns(std::int32_t layers) : layers_(static_cast<std::size_t>(layers)) {}

  /// Whether nothing is kept.
  [[nodiscard]] bool empty() const { return layers_.empty(); }

  /// Keeps the materials of a layer.  Several threads may do so for different layers.
  void put(std::int32_t layer, std::span<const Material> materials);

  /// The materials of a layer that was put; `out` is as long as they were.
  void get(std::int32_t layer, std::span<Material> out) const;

  /// Bytes that the object holds.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  /// Of a layer: for each run its material and its length less 1, seven bits to a byte,
  /// the lowest first; all but the last byte of a number have the eighth bit.
  std::vector<std::vector<std::uint8_t>> layers_;
};

}  // namespace certet
