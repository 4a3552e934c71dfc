#include "thin_image.hpp"

#include <algorithm>
#include <random>

#include "seed.hpp"

namespace thin {
namespace {

using Random = std::mt19937_64;
using Voxel = std::array<std::int64_t, 3>;

/// A canvas of voxels; what is painted beyond it is lost.
class Painter {
 public:
  Painter(ThinImage& image, Random& random) : image_(image), random_(random) {}

  void paint() {
    switch (image_.kind) {
      case 0: return repeat(1, 3, [&] { vessel(); });
      case 1: return repeat(1, 6, [&] { bar(); });
      case 2: return scatter(between(random_, 20, 120), 0, 1);
      case 3: return repeat(1, 2, [&] { shell(); });
      case 4: return pores();
      default: return scatter(3, 0, 1);
    }
  }

 private:
  template <class Work>
  void repeat(int low, int high, const Work& work) {
    for (int n = between(random_, low, high); n > 0; --n) work();
  }

  [[nodiscard]] std::uint8_t* at(const Voxel& v) {
    return image_.holds(v) ? &image_.voxels[image_.number(v)] : nullptr;
  }
  void set(const Voxel& v, std::uint8_t value) {
    if (std::uint8_t* voxel = at(v)) *voxel = value;
  }
  Voxel somewhere() {
    Voxel v;
    for (std::size_t a = 0; a < 3; ++a) v[a] = between(random_, 0, static_cast<int>(image_.size[a]) - 1);
    return v;
  }

  /// One voxel wide, from face to face, and now and then from edge to edge.
  void vessel() {
    Voxel v = somewhere();
    for (int n = between(random_, 5, 25); n > 0; --n) {
      set(v, 1);
      const auto axis = static_cast<std::size_t>(between(random_, 0, 2));
      v[axis] += between(random_, 0, 1) == 0 ? 1 : -1;
      if (between(random_, 1, 8) == 1) v[(axis + 1) % 3] += between(random_, -1, 1);
    }
  }

  /// Along an axis, one or two voxels wide.
  void bar() {
    const auto axis = static_cast<std::size_t>(between(random_, 0, 2));
    Voxel from = somewhere();
    const int wide = between(random_, 1, 2);
    for (int n = between(random_, 2, 8); n > 0; --n, ++from[axis])
      for (int w = 0; w < wide; ++w) {
        Voxel v = from;
        v[(axis + 1) % 3] += w;
        set(v, 1);
      }
  }

  /// Two voxels thick.
  void shell() {
    const Voxel centre = somewhere();
    const double radius = between(random_, 25, 45) / 10.0;
    for (Voxel v{}; v[2] < image_.size[2]; ++v[2])
      for (v[1] = 0; v[1] < image_.size[1]; ++v[1])
        for (v[0] = 0; v[0] < image_.size[0]; ++v[0]) {
          double squared = 0;
          for (std::size_t a = 0; a < 3; ++a)
            squared += static_cast<double>((v[a] - centre[a]) * (v[a] - centre[a]));
          if (squared < radius * radius && squared >= (radius - 2) * (radius - 2)) set(v, 1);
        }
  }

  /// One of so many voxels becomes `value`.
  void scatter(int one_in, std::uint8_t from, std::uint8_t value) {
    for (std::uint8_t& voxel : image_.voxels)
      if (voxel == from && between(random_, 1, one_in) == 1) voxel = value;
  }

  void pores() {
    std::ranges::fill(image_.voxels, std::uint8_t{1});
    scatter(between(random_, 2, 12), 1, 0);
  }

  ThinImage& image_;
  Random& random_;
};

}  // namespace

ThinImage make_image(std::uint64_t seed, std::uint64_t number) {
  Random random(trial_seed(seed, number));
  ThinImage image;
  image.kind = number % image_kinds.size();
  const bool fine = between(random, 0, 2) == 0;
  for (std::size_t a = 0; a < 3; ++a) {
    image.size[a] = between(random, 4, image.kind == 3 ? 11 : 8);
    const double stretch = between(random, 0, 2) == 0 ? 1 : between(random, 100, 130) / 100.0;
    image.spacing[a] = (fine ? 0.5 : 1) * stretch;
  }
  const double finest = *std::ranges::min_element(image.spacing);
  image.lattice_size = finest * (between(random, 0, 2) != 0 ? 1 : between(random, 80, 100) / 100.0);
  image.clear();
  Painter(image, random).paint();
  if (std::ranges::count(image.voxels, 1) == 0) image.voxels.front() = 1;
  return image;
}

std::int64_t ThinImage::pieces() const {
  std::vector<std::uint8_t> left = voxels;
  std::int64_t count = 0;
  std::vector<std::int64_t> reached;
  const std::array<std::int64_t, 3> stride{1, size[0], size[0] * size[1]};
  for (std::size_t from = 0; from < left.size(); ++from) {
    if (left[from] == 0) continue;
    ++count;
    left[from] = 0;
    reached.assign(1, static_cast<std::int64_t>(from));
    while (!reached.empty()) {
      const std::int64_t v = reached.back();
      reached.pop_back();
      for (std::size_t a = 0; a < 3; ++a)
        for (const std::int64_t step : {-1, 1}) {
          const std::int64_t along = v / stride[a] % size[a] + step;
          const std::int64_t other = v + step * stride[a];
          if (along < 0 || along >= size[a] || left[static_cast<std::size_t>(other)] == 0) continue;
          left[static_cast<std::size_t>(other)] = 0;
          reached.push_back(other);
        }
    }
  }
  return count;
}

}  // namespace thin
