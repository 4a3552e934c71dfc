#include "treads.hpp"

#include <mutex>
#include <tuple>

#include "fields/for_each_tile.hpp"
#include "fields/layers.hpp"
#include "fields/tread_faces.hpp"

namespace certet::fields {
namespace {

using Voxel = std::array<std::int64_t, 3>;

constexpr std::int64_t layers_at_once = 8;

/// A share, and the direction of the face by which it was found.
struct Found {
  Share share;
  std::uint8_t direction;
};

/// The faces normal to one axis between some layers and the next ones.
class Slab {
 public:
  /// From layer `first` on.  Labels meet in no voxel that is not of `image.bounds()` or next to
  /// it.  Treads depend on one more layer before and behind their faces, and one more column.
  Slab(const MaterialImage& image, std::size_t normal, std::int64_t first)
      : normal_(normal),
        first_(first),
        last_(std::min({first + layers_at_once - 1, image.bounds().high[normal],
                        image.size()[normal] - 2})) {
    for (std::size_t a = 0; a < 3; ++a) {
      low_[a] = image.bounds().low[a] - 1;
      high_[a] = image.bounds().high[a] + 1;
    }
    low_[normal] = first_ - 1;
    high_[normal] = last_ + 2;
  }

  /// Calls visit(voxel, found) for each share.
  template <class Visit>
  void for_each(const MaterialImage& image, const Visit& visit) const {
    const Layers layers(image, normal_, low_, high_);
    TreadFaces faces(layers, normal_);
    for (std::int64_t below = first_; below <= last_; ++below) {
      faces.find(below);
      faces.for_each_deep([&](std::int64_t at, std::int32_t depth, bool upwards) {
        const std::int64_t other = upwards ? below + 1 : below;
        visit(layers.voxel(upwards ? below : below + 1, at),
              Found{{0, static_cast<std::uint16_t>(depth), layers.layer(other)[at]},
                    static_cast<std::uint8_t>(2 * normal_ + (upwards ? 1 : 0))});
      });
    }
  }

 private:
  std::size_t normal_;
  std::int64_t first_, last_;
  Voxel low_{}, high_{};
};

std::vector<Slab> all_slabs(const MaterialImage& image) {
  std::vector<Slab> slabs;
  for (std::size_t normal = 0; normal < 3; ++normal) {
    const std::int64_t last = std::min(image.bounds().high[normal], image.size()[normal] - 2);
    for (std::int64_t first = std::max<std::int64_t>(image.bounds().low[normal] - 1, 0);
         first <= last; first += layers_at_once)
      slabs.emplace_back(image, normal, first);
  }
  return slabs;
}

/// Of each voxel the greatest share; of equal ones that by the first direction.
std::vector<Share> greatest(std::vector<Found>& found) {
  std::ranges::sort(found, {}, [](const Found& f) {
    return std::tuple(f.share.voxel, -f.share.part, f.direction);
  });
  std::vector<Share> shares;
  for (const Found& one : found)
    if (shares.empty() || shares.back().voxel != one.share.voxel) shares.push_back(one.share);
  return shares;
}

}  // namespace

Treads::Treads(const MaterialImage& image, const Context& context) {
  for (std::size_t a = 0; a < 3; ++a) counts_[a] = (image.size()[a] + cube_width - 1) / cube_width;
  cubes_.resize(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]));
  std::vector<std::vector<Found>> found(cubes_.size());
  std::mutex mutex;
  const std::vector<Slab> slabs = all_slabs(image);
  for_each_tile(context, slabs.size(), [&](std::size_t s) {
    std::vector<std::pair<std::size_t, Found>> of_slab;
    slabs[s].for_each(image, [&](const Voxel& v, Found one) {
      std::int64_t n = 0;
      for (std::size_t a = 3; a-- > 0;) n = n * cube_width + v[a] % cube_width;
      one.share.voxel = static_cast<std::uint16_t>(n);
      of_slab.emplace_back(number(v[0] / cube_width, v[1] / cube_width, v[2] / cube_width), one);
    });
    const std::lock_guard lock(mutex);
    for (const auto& [cube, one] : of_slab) found[cube].push_back(one);
  });
  for (std::size_t c = 0; c < cubes_.size(); ++c) cubes_[c] = greatest(found[c]);
}

}  // namespace certet::fields
