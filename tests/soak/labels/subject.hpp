#pragma once
/// \file
/// A random domain of several labels, and what is promised of its mesh.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "certet/image.hpp"
#include "certet/method.hpp"
#include "certet/placed_domain.hpp"
#include "label_image.hpp"

namespace labelled {

/// Those of the images, several solids, and labels that lattice points have by chance, with
/// cuts anywhere, near the ends of edges, and next to the thresholds.
inline constexpr std::array<std::string_view, image_kinds.size() + 2> subject_kinds{
    image_kinds[0], image_kinds[1], image_kinds[2], image_kinds[3],
    image_kinds[4], image_kinds[5], "solids",       "random cuts"};

/// How fine the lattice of an image is.
enum class Fineness : std::uint8_t {
  spacing,  ///< the size is the spacing along every axis
  finer,    ///< it is no more than the least spacing
  coarser,  ///< voxels may be lost, and are named
};

/// An image, and what its labels are meshed with.
struct MeshedImage {
  std::shared_ptr<const certet::Image> image;
  std::map<std::int32_t, VoxelPieces> pieces;
  bool smooth = false;
  Fineness fineness{};
};

struct Subject {
  std::size_t kind = 0;
  certet::Method method{};
  std::unique_ptr<certet::Domain> domain;
  certet::Lattice lattice;
  certet::Frame frame;
  std::optional<MeshedImage> image;
};

/// Number `number` of the run with `seed`; depends on these two alone.
Subject make_subject(std::uint64_t seed, std::uint64_t number);

}  // namespace labelled
