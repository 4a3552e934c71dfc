#pragma once
/// \file
/// The faces between two layers of voxels where labels meet, and the treads that they make.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certet/domain.hpp"
#include "fields/layers.hpp"

namespace certet::fields {

/// Two layers, seen so that the second lies above the first.  A tread is a row of faces
/// that have one label on one side, the same on all, and any others on the other.
class TreadFaces {
 public:
  explicit TreadFaces(const Layers& layers, std::size_t normal);

  /// Finds the treads between a layer and the next.
  void find(std::int64_t below);

  /// Calls visit(face, depth, upwards) for each face where the surface is deeper than it by
  /// that much, in 16384ths, seen upwards or downwards.
  template <class Visit>
  void for_each_deep(const Visit& visit) const {
    for (const Face& face : faces_) {
      if (!is_on_ramp(face) || !is_plain(face)) continue;
      for (const bool upwards : {false, true})
        if (const std::int32_t depth = depth_of(face, upwards); depth > 0)
          visit(face.at, depth, upwards);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  /// A tread along one axis with one label on one side.
  struct Tread {
    std::int64_t first, length;
    std::int32_t rise;  ///< 1: towards its last column, -1: towards its first, 0: it is no ramp
  };
  struct Face {
    std::int64_t at;                       ///< in the layer
    std::array<std::uint32_t, 4> treads;   ///< for each axis: with one label below, and above
  };
  /// From a column to the next, in which the tread does not go on.
  enum class Step { wall, up, down };

  void add(std::int64_t at);
  [[nodiscard]] Step step(std::int64_t from, std::int64_t to, bool above) const;
  void end(std::size_t tread, std::size_t kind);
  [[nodiscard]] bool is_on_ramp(const Face& face) const {
    bool some = false;
    for (std::size_t kind = 0; kind < treads_.size(); ++kind)
      some = some || treads_[kind][face.treads[kind]].rise != 0;
    return some;
  }
  /// Whether no label is one voxel thick there.
  [[nodiscard]] bool is_plain(const Face& face) const {
    return at(-1, face.at) == at(0, face.at) && at(2, face.at) == at(1, face.at);
  }
  /// By the shortest of its treads.
  [[nodiscard]] std::int32_t depth_of(const Face& face, bool upwards) const;

  [[nodiscard]] Material at(std::int64_t height, std::int64_t in_layer) const {
    return below_[height * layers_.layer_size() + in_layer];
  }

  const Layers& layers_;
  std::array<std::int64_t, 2> strides_;  ///< of the axes along which treads are sought
  const Material* below_ = nullptr;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> face_at_;  ///< of all places in the layer; or none
  std::array<std::vector<Tread>, 4> treads_;
};

}  // namespace certet::fields
