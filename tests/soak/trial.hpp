#pragma once
/// \file
/// A random domain with all that is needed to mesh and to judge it.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "certet/frame.hpp"
#include "certet/image.hpp"
#include "certet/stuffing.hpp"

namespace soak {

enum class Kind {
  smooth,        ///< level functions, with a volume to compare with
  noise,         ///< each position has its own random sign
  sheet,         ///< one or two thin layers
  checkerboard,  ///< blocks of alternating sign, aligned with the lattice or not
  on_surface,    ///< vertices exactly on the surface
  thresholds,    ///< cuts at, just below and just above the warping thresholds
  labels,        ///< a segmentation that touches every border of its image
  level,         ///< a grayscale image
};
inline constexpr int kind_count = 8;
inline constexpr std::array<std::string_view, kind_count> kind_names{
    "smooth", "noise", "sheet", "checkerboard", "on surface", "thresholds", "labels", "level"};

/// The voxels of a segmentation, seen without the library.
struct LabelImage {
  std::array<std::int64_t, 3> size;
  certet::Point3 spacing, origin;
  std::array<std::array<double, 3>, 3> axes;
  std::vector<std::uint8_t> voxels;  ///< label 1 to 3, or 0; the first axis runs fastest

  /// The label at a world point, 0 beyond the voxels; nothing where two voxels
  /// are equally near.
  [[nodiscard]] std::optional<int> at(const certet::Point3& world) const;
};

/// Number `number` of the run with `seed`; depends on these two alone.
struct Trial {
  Kind kind{};
  std::uint64_t seed = 0;  ///< of this trial
  std::unique_ptr<certet::Domain> domain;
  const certet::PlacedDomain* image = nullptr;  ///< the domain, if it is an image
  LabelImage labels;                           ///< of kind `labels`
  certet::Lattice lattice;
  certet::Frame frame;
  certet::Method method{};
  int threads = 1;
};

Trial make_trial(std::uint64_t seed, std::uint64_t number);

}  // namespace soak
