#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <type_traits>
#include <variant>

#include "certet/error.hpp"
#include "certet/voxelise.hpp"
#include "label_set.hpp"
#include "voxel_frame.hpp"

namespace certet {
namespace {

/// How far apart centres may lie, in voxels: files have spacings in single precision.
constexpr double tolerance = 1e-3;

[[noreturn]] void refuse_to_compare(const Image& first, const Image& second,
                                    const std::string& reason) {
  throw Error(ErrorCode::bad_input,
              "'" + first.name + "' and '" + second.name + "' cannot be compared: " + reason);
}

/// Where the grids lie together at the ends of their diagonals and axes, they do everywhere.
void check_places(const Image& first, const Image& second) {
  if (first.size != second.size) refuse_to_compare(first, second, "they differ in size");
  const VoxelFrame frame(first);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Point3 at{}, world = second.origin;
    for (std::size_t a = 0; a < 3; ++a) {
      at[a] = (corner >> a & 1) != 0 ? static_cast<double>(second.size[a] - 1) : 0;
      for (std::size_t r = 0; r < 3; ++r) world[r] += second.axes[r][a] * second.spacing[a] * at[a];
    }
    const Point3 found = frame.voxels(world);
    for (std::size_t a = 0; a < 3; ++a)
      if (!(std::abs(found[a] - at[a]) <= tolerance))
        refuse_to_compare(first, second, "their voxels do not lie in the same places");
  }
}

/// Counts the voxels of labels; these come in runs.
class OverlapCounts {
 public:
  void add(std::int32_t first, std::int32_t second) {
    if (first == 0 && second == 0) return;
    LabelOverlap& one = of(first);
    ++one.first;
    if (first == second) {
      ++one.second;
      ++one.both;
    } else {
      ++of(second).second;
    }
  }

  [[nodiscard]] std::vector<LabelOverlap> result() const {
    std::vector<LabelOverlap> all;
    for (const auto& [label, overlap] : counts_)
      if (label != 0) all.push_back(overlap);
    return all;
  }

 private:
  LabelOverlap& of(std::int32_t label) {
    if (latest_ == nullptr || latest_->label != label) {
      latest_ = &counts_[label];
      latest_->label = label;
    }
    return *latest_;
  }

  std::map<std::int32_t, LabelOverlap> counts_;
  LabelOverlap* latest_ = nullptr;
};

/// The voxels as labels of 32 bits, one after the other.
template <class T>
void check_labels(const Image& image, const Buffer<T>& voxels) {
  if constexpr (std::is_floating_point_v<T>)
    refuse_levels(image);
  else
    refuse_wide_labels(image, voxels, LabelSet({{0, std::int64_t{1} << 32}}));
}

}  // namespace

std::vector<LabelOverlap> compare_labels(const Image& first, const Image& second) {
  check_geometry(first);
  check_geometry(second);
  check_places(first, second);
  OverlapCounts counts;
  std::visit(
      [&](const auto& ones, const auto& others) {
        check_labels(first, ones);
        check_labels(second, others);
        for (std::size_t v = 0; v < ones.size(); ++v)
          counts.add(static_cast<std::int32_t>(ones[v]), static_cast<std::int32_t>(others[v]));
      },
      first.voxels, second.voxels);
  return counts.result();
}

}  // namespace certet
