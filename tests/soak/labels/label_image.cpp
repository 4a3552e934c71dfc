#include "label_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "disjoint_sets.hpp"
#include "seed.hpp"

namespace labelled {
namespace {

using Voxel = std::array<std::int64_t, 3>;

double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

template <class Visit>
void for_each_voxel(const LabelImage& image, const Visit& visit) {
  std::size_t n = 0;
  for (std::int64_t k = 0; k < image.size[2]; ++k)
    for (std::int64_t j = 0; j < image.size[1]; ++j)
      for (std::int64_t i = 0; i < image.size[0]; ++i) visit(n++, Voxel{i, j, k});
}

/// Gives the voxels of an image their labels.
class Painter {
 public:
  Painter(LabelImage& image, Random& random)
      : image_(image), random_(random), most_(between(random, 2, 12)),
        outside_(between(random, 0, 2) == 0 ? 0 : between(random, 10, 80)) {}

  void paint(std::size_t kind) {
    switch (kind) {
      case 0: return blocks(1);
      case 1: return blocks(between(random_, 2, 3));
      case 2: return sheets();
      case 3: return lone_voxels();
      case 4: return balls();
      default: return cells();
    }
  }

 private:
  /// One of the labels, or outside as often as this image has it.
  std::uint8_t any() {
    return between(random_, 1, 100) <= outside_ ? std::uint8_t{0} : some();
  }
  std::uint8_t some() { return static_cast<std::uint8_t>(between(random_, 1, most_)); }

  certet::Point3 somewhere() {
    certet::Point3 at;
    for (std::size_t a = 0; a < 3; ++a) at[a] = real(random_, 0, static_cast<double>(image_.size[a]));
    return at;
  }
  static double distance(const Voxel& v, const certet::Point3& from) {
    return std::hypot(static_cast<double>(v[0]) - from[0], static_cast<double>(v[1]) - from[1],
                      static_cast<double>(v[2]) - from[2]);
  }

  void blocks(int side) {
    const std::uint64_t seed = random_();
    for_each_voxel(image_, [&](std::size_t n, const Voxel& v) {
      Random own(mixed(seed, v[0] / side, v[1] / side, v[2] / side));
      std::swap(random_, own);
      image_.voxels[n] = any();
      std::swap(random_, own);
    });
  }

  /// One or two voxels thick, across an axis or aslant, one through the other.
  void sheets() {
    const std::uint8_t behind = any();
    std::ranges::fill(image_.voxels, behind);
    for (int count = between(random_, 1, most_); count > 0; --count) {
      certet::Point3 across{};
      if (between(random_, 0, 1) == 0) across[static_cast<std::size_t>(between(random_, 0, 2))] = 1;
      else for (double& c : across) c = real(random_, -1, 1);
      const double length = std::hypot(across[0], across[1], across[2]);
      const certet::Point3 through = somewhere();
      const double half = between(random_, 0, 1) == 0 ? 0.5 : 1;
      const std::uint8_t label = any();
      for_each_voxel(image_, [&](std::size_t n, const Voxel& v) {
        double off = 0;
        for (std::size_t a = 0; a < 3; ++a)
          off += across[a] * (static_cast<double>(v[a]) - through[a]) / length;
        if (std::abs(off) <= half) image_.voxels[n] = label;
      });
    }
  }

  /// Within another label, or alone.
  void lone_voxels() {
    const std::uint8_t behind = any();
    const int one_in = between(random_, 3, 60);
    for (std::uint8_t& voxel : image_.voxels)
      voxel = between(random_, 1, one_in) == 1 ? some() : behind;
  }

  void balls() {
    const certet::Point3 centre = somewhere();
    const double thick = real(random_, 0.6, 2.5);
    const bool whole = between(random_, 0, 1) == 0;
    for_each_voxel(image_, [&](std::size_t n, const Voxel& v) {
      const int shell = static_cast<int>(distance(v, centre) / thick);
      image_.voxels[n] = static_cast<std::uint8_t>(
          shell < most_ ? shell + 1 : whole ? most_ : 0);
    });
  }

  /// Of Voronoi, with a little noise in some.
  void cells() {
    std::vector<std::pair<certet::Point3, std::uint8_t>> seeds;
    for (int count = between(random_, 2, 2 * most_); count > 0; --count)
      seeds.emplace_back(somewhere(), any());
    const int one_in = between(random_, 0, 1) == 0 ? 0 : between(random_, 10, 50);
    for_each_voxel(image_, [&](std::size_t n, const Voxel& v) {
      image_.voxels[n] = std::ranges::min_element(seeds, {}, [&](const auto& seed) {
                           return distance(v, seed.first);
                         })->second;
      if (one_in != 0 && between(random_, 1, one_in) == 1) image_.voxels[n] = any();
    });
  }

  LabelImage& image_;
  Random& random_;
  const int most_;     ///< labels
  const int outside_;  ///< in a hundred
};

/// Puts labels into the first voxels until there are two.
void have_two_labels(LabelImage& image) {
  std::set<std::uint8_t> found(image.voxels.begin(), image.voxels.end());
  found.erase(0);
  std::uint8_t next = 1;
  for (std::size_t n = 0; found.size() < 2; ++n) {
    while (found.contains(next)) ++next;
    image.voxels[n] = next;
    found = {image.voxels.begin(), image.voxels.end()};
    found.erase(0);
  }
}

}  // namespace

LabelImage make_image(std::size_t kind, Random& random) {
  LabelImage image;
  const bool isotropic = between(random, 0, 1) == 0;
  for (std::size_t a = 0; a < 3; ++a) {
    image.size[a] = between(random, 3, 6);
    image.spacing[a] = isotropic ? 1 : between(random, 100, 160) / 100.0;
  }
  image.clear();
  Painter(image, random).paint(kind);
  have_two_labels(image);
  return image;
}

std::map<std::int32_t, VoxelPieces> LabelImage::pieces() const {
  DisjointSets faces(voxels.size()), corners(voxels.size());
  for_each_voxel(*this, [&](std::size_t n, const Voxel& v) {
    for (int at = 0; at < 27; ++at) {
      const Voxel other{v[0] + at % 3 - 1, v[1] + at / 3 % 3 - 1, v[2] + at / 9 - 1};
      if (!holds(other)) continue;
      const std::size_t m = number(other);
      if (voxels[m] != voxels[n]) continue;
      corners.join(n, m);
      const auto apart = std::abs(other[0] - v[0]) + std::abs(other[1] - v[1]) + std::abs(other[2] - v[2]);
      if (apart <= 1) faces.join(n, m);
    }
  });
  std::map<std::int32_t, VoxelPieces> found;
  for (std::size_t n = 0; n < voxels.size(); ++n) {
    if (voxels[n] == 0) continue;
    VoxelPieces& pieces = found[voxels[n]];
    pieces.by_corners += corners.root(n) == n;
    pieces.by_faces += faces.root(n) == n;
  }
  return found;
}

}  // namespace labelled
