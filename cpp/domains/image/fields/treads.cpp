#include "treads.hpp"

#include <utility>

#include "fields/field_tile.hpp"
#include "fields/for_each_tile.hpp"

namespace certet::fields {
namespace {

using Voxel = std::array<std::int64_t, 3>;

constexpr std::int64_t width = Treads::cube_width;
constexpr std::size_t voxels_of_cube = width * width * width;
/// Shorter ones smoothing alone makes a slope of.
constexpr std::int64_t shortest = 4;
constexpr std::int64_t longest = 32;
constexpr Material beyond = -1;

/// How the surface of a label goes on in the next column.
enum class Step { level, up, down, wall };

/// A tread, seen along an axis: columns first to last, from the lower end to the upper or
/// the other way.
struct Tread {
  std::int64_t first = 0, last = -1;
  bool rises = false, is_ramp = false;

  [[nodiscard]] std::int64_t length() const { return last - first + 1; }
  /// How far below the tread the surface is in a column, in 16384ths; less than 0: above.
  [[nodiscard]] std::int32_t depth(std::int64_t column) const {
    const std::int64_t twice = 2 * (column - first) + 1 - length();
    return static_cast<std::int32_t>((rises ? -twice : twice) * field_one / (2 * length()));
  }
};

/// The voxels of a cube and one more on every side; beyond the image its outermost go on.
class Surroundings {
 public:
  Surroundings(const MaterialImage& image, const Voxel& low) : low_(low) {
    image.read({{low[0] - 1, low[1] - 1, low[2] - 1}, wide}, voxels_);
  }

  [[nodiscard]] bool are_one() const {
    return std::ranges::all_of(voxels_, [&](Material m) { return m == voxels_.front(); });
  }
  /// A voxel of the cube, and the one before or behind it.
  [[nodiscard]] std::pair<Material, Material> pair(const Voxel& v, std::size_t axis, int way) const {
    constexpr std::array<std::int64_t, 3> strides{1, wide, wide * wide};
    std::int64_t at = 0;
    for (std::size_t a = 0; a < 3; ++a) at += (v[a] - low_[a] + 1) * strides[a];
    return {voxels_[static_cast<std::size_t>(at)],
            voxels_[static_cast<std::size_t>(at + way * strides[axis])]};
  }

 private:
  static constexpr std::int64_t wide = width + 2;
  Voxel low_;
  std::vector<Material> voxels_ = std::vector<Material>(wide * wide * wide);
};

/// The faces of a cube's voxels in one direction.
template <class MaterialAt>
class CubeFaces {
 public:
  CubeFaces(const MaterialAt& at, const Surroundings& around, const Voxel& low, const Voxel& high,
            std::size_t normal, int up)
      : at_(at), around_(around), low_(low), high_(high), normal_(normal), up_(up) {}

  /// Calls visit(voxel, above, depth) for each voxel whose surface towards the label above lies
  /// deeper than its face.
  template <class Visit>
  void for_each_deep(const Visit& visit) {
    find(0);
    find(1);
    for (std::size_t n = 0; n < voxels_of_cube; ++n)
      if (length_[n] != 0 && depth_[n] > 0) visit(n, above_[n], static_cast<std::uint16_t>(depth_[n]));
  }

 private:
  /// Along one of the two axes of the faces.
  void find(std::size_t which) {
    const std::size_t along = (normal_ + 1 + which) % 3, across = 3 - normal_ - along;
    Voxel v;
    for (v[normal_] = low_[normal_]; v[normal_] < high_[normal_]; ++v[normal_])
      for (v[across] = low_[across]; v[across] < high_[across]; ++v[across]) {
        Tread of_upper, of_lower;
        Material upper = beyond, lower = beyond;
        for (v[along] = low_[along]; v[along] < high_[along]; ++v[along]) {
          const auto [own, other] = around_.pair(v, normal_, up_);
          if (own == other || at_(moved(v, -1)) != own || at_(moved(v, 2)) != other) continue;
          if (other != upper || v[along] > of_upper.last) of_upper = tread(v, along, upper = other, true);
          if (own != lower || v[along] > of_lower.last) of_lower = tread(v, along, lower = own, false);
          keep(v, other, of_upper, v[along]);
          keep(v, other, of_lower, v[along]);
        }
      }
  }

  void keep(const Voxel& v, Material above, const Tread& tread, std::int64_t column) {
    if (!tread.is_ramp) return;
    std::size_t n = 0;
    for (std::size_t a = 3; a-- > 0;) n = n * width + static_cast<std::size_t>(v[a] % width);
    if (length_[n] != 0 && length_[n] <= tread.length()) return;
    length_[n] = tread.length();
    depth_[n] = tread.depth(column);
    above_[n] = above;
  }

  [[nodiscard]] Voxel moved(Voxel v, int upwards) const {
    v[normal_] += up_ * upwards;
    return v;
  }

  /// From one column to the next, of the surface between a label, above or below, and what
  /// is on the other side.  A step to another label there is none of a slope.
  [[nodiscard]] Step step(const Voxel& from, const Voxel& to, Material label, bool above) const {
    const auto is_below = [&](int height) { return (at_(moved(to, height)) == label) != above; };
    const Material rest = at_(moved(from, above ? 0 : 1));
    const auto goes_on = [&](int height) {
      return at_(moved(to, above ? height : height + 1)) == rest;
    };
    if (is_below(0)) {
      if (!is_below(1)) return Step::level;
      return !is_below(2) && goes_on(1) ? Step::up : Step::wall;
    }
    return !is_below(1) && is_below(-1) && goes_on(-1) ? Step::down : Step::wall;
  }

  [[nodiscard]] Tread tread(const Voxel& v, std::size_t along, Material label, bool above) const {
    const auto end = [&](int way, std::int64_t& last) {
      Voxel from = v, to = v;
      for (;; from = to) {
        last = from[along];
        to[along] += way;
        if (std::abs(to[along] - v[along]) > longest || at_(to) == beyond) return Step::wall;
        if (const Step found = step(from, to, label, above); found != Step::level) return found;
      }
    };
    Tread found;
    const Step before = end(-1, found.first);
    if (before == Step::wall) {
      found.last = v[along];
      return found;
    }
    const Step after = end(1, found.last);
    found.rises = after == Step::up;
    found.is_ramp = ((before == Step::down && after == Step::up) ||
                     (before == Step::up && after == Step::down)) &&
                    found.length() >= shortest && found.length() <= longest;
    return found;
  }

  const MaterialAt& at_;
  const Surroundings& around_;
  const Voxel &low_, &high_;
  std::size_t normal_;
  int up_;
  std::array<std::int64_t, voxels_of_cube> length_{};
  std::array<std::int32_t, voxels_of_cube> depth_{};
  std::array<Material, voxels_of_cube> above_{};
};

template <class MaterialAt>
std::vector<Share> shares_of(const MaterialAt& at, const Surroundings& around, const Voxel& low,
                             const Voxel& high) {
  std::array<Share, voxels_of_cube> all{};
  for (std::size_t normal = 0; normal < 3; ++normal)
    for (const int up : {-1, 1})
      CubeFaces(at, around, low, high, normal, up)
          .for_each_deep([&](std::size_t n, Material above, std::uint16_t depth) {
            if (depth > all[n].part) all[n] = {static_cast<std::uint16_t>(n), depth, above};
          });
  std::vector<Share> shares;
  for (const Share& share : all)
    if (share.part != 0) shares.push_back(share);
  return shares;
}

}  // namespace

Treads::Treads(const MaterialImage& image, const Context& context) {
  for (std::size_t a = 0; a < 3; ++a) counts_[a] = (image.size()[a] + cube_width - 1) / cube_width;
  cubes_.resize(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]));
  for_each_tile(context, cubes_.size(), [&](std::size_t c) {
    const auto n = static_cast<std::int64_t>(c);
    const Voxel low{cube_width * (n % counts_[0]), cube_width * (n / counts_[0] % counts_[1]),
                    cube_width * (n / counts_[0] / counts_[1])};
    Voxel high;
    for (std::size_t a = 0; a < 3; ++a) high[a] = std::min(low[a] + cube_width, image.size()[a]);
    const Surroundings around(image, low);
    if (around.are_one()) return;
    image.with_materials([&](const auto& material) {
      const auto at = [&](const Voxel& v) {
        for (std::size_t a = 0; a < 3; ++a)
          if (v[a] < 0 || v[a] >= image.size()[a]) return beyond;
        return material(v);
      };
      cubes_[c] = shares_of(at, around, low, high);
    });
  });
}

}  // namespace certet::fields
