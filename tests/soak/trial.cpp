#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "certet/lattice/warp.hpp"
#include "domains.hpp"

namespace soak {
namespace {

using certet::Coord3;
using certet::Sign;
using domains::Level;
using domains::Positional;
using Random = std::mt19937_64;
using Matrix = std::array<std::array<double, 3>, 3>;

double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
bool chance(Random& random, int one_in) { return between(random, 1, one_in) == 1; }

std::unique_ptr<certet::Domain> owned(Positional domain) {
  return std::make_unique<Positional>(std::move(domain));
}

/// A turn by any angle, or one that permutes and turns round the axes; turned
/// inside out if `mirrored`.
Matrix axes(Random& random, bool mirrored) {
  Matrix m{};
  if (chance(random, 2)) {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::ranges::shuffle(order, random);
    for (std::size_t a = 0; a < 3; ++a) m[order[a]][a] = chance(random, 2) ? 1 : -1;
  } else {
    const double a = real(random, 0, 7), b = real(random, 0, 7), c = real(random, 0, 1);
    const double q[4] = {std::sqrt(1 - c) * std::sin(a), std::sqrt(1 - c) * std::cos(a),
                         std::sqrt(c) * std::sin(b), std::sqrt(c) * std::cos(b)};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      m[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]);
      m[i][j] = 2 * (q[i] * q[j] - q[k] * q[3]);
      m[i][k] = 2 * (q[i] * q[k] + q[j] * q[3]);
    }
  }
  const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  if ((determinant < 0) != mirrored)
    for (auto& row : m) row[2] = -row[2];
  return m;
}

certet::Point3 place(Random& random, double reach) {
  return {real(random, -reach, reach), real(random, -reach, reach), real(random, -reach, reach)};
}

/// Sums of waves, tori, gyroids, ellipsoids: within a ball that the lattice holds.
Level smooth(Random& random, const std::array<double, 3>& center, double radius) {
  const auto [x0, y0, z0] = center;
  Level ball = domains::sphere(x0, y0, z0, radius);
  const int shape = between(random, 0, 3);
  if (shape == 0) return ball;
  if (shape == 1) {
    const double minor = real(random, 0.25, 0.45) * radius;
    return domains::torus(x0, y0, z0, radius - minor, minor);
  }
  Level inner = domains::gyroid(real(random, 10, 30), real(random, 0.5, 1.2));
  if (shape == 3) {
    const certet::Point3 k = place(random, 0.5), l = place(random, 0.5);
    const double offset = real(random, -1, 1);
    inner = [=](double x, double y, double z) {
      return std::sin(k[0] * x + k[1] * y + k[2] * z) + std::sin(l[0] * x + l[1] * y + l[2] * z) -
             offset;
    };
  }
  return [=](double x, double y, double z) { return std::max(inner(x, y, z), ball(x, y, z)); };
}

std::unique_ptr<certet::Domain> sheets(Random& random) {
  const auto sheet = [&] {
    const certet::Point3 n = chance(random, 3) ? certet::Point3{0, 0, 1} : place(random, 1);
    return domains::slab(n[0], n[1], n[2] + 1e-3, real(random, -4, 4), real(random, 0.02, 2.5));
  };
  const Level a = sheet(), b = sheet();
  return owned(domains::of_level([=](double x, double y, double z) {
    return std::min(a(x, y, z), b(x, y, z));
  }));
}

std::unique_ptr<certet::Domain> checkerboard(Random& random) {
  const std::int32_t block = chance(random, 2) ? certet::steps * between(random, 1, 6)
                                               : between(random, certet::steps / 2, 400'000);
  const Coord3 from{between(random, 0, block), between(random, 0, block), between(random, 0, block)};
  const bool aligned = block % certet::steps == 0 && chance(random, 2);
  return owned(Positional([=](Coord3 p) {
    if (!aligned) p = p + from;
    const auto number = [=](std::int32_t c) { return (c >= 0 ? c : c - block + 1) / block; };
    return (number(p.x) + number(p.y) + number(p.z)) & 1 ? Sign::minus : Sign::plus;
  }));
}

std::unique_ptr<certet::Domain> on_surface(Random& random) {
  const auto whole = [&](int low, int high) { return double(between(random, low, high)); };
  switch (between(random, 0, 4)) {
    case 0: return owned(domains::of_level(domains::box(whole(-9, -1), whole(0, 9))));
    case 1: return owned(domains::of_level(domains::sphere(0, 0, 0, whole(2, 12))));
    case 2: return owned(domains::of_level(domains::slab(1, whole(0, 1), 0, 0, whole(1, 5))));
    case 3: return owned(domains::noise(random(), 200));
    default: return owned(domains::random_cuts(random(), 180, {0, certet::steps - 1, 1}));
  }
}

std::unique_ptr<certet::Domain> at_thresholds(Random& random) {
  std::vector<std::int32_t> cuts{0, certet::steps / 2, certet::steps - 1};
  const certet::Thresholds t = chance(random, 2) ? certet::angle_thresholds
                                                 : certet::embedding_thresholds;
  for (const int direction : {0, 6})
    for (const std::int32_t beside : {-1, 0, 1}) {
      cuts.push_back(t.in_steps(direction) + beside);
      cuts.push_back(certet::steps - t.in_steps(direction) + beside);
    }
  std::ranges::shuffle(cuts, random);
  cuts.resize(static_cast<std::size_t>(between(random, 1, static_cast<int>(cuts.size()))));
  return owned(domains::random_cuts(random(), chance(random, 2) ? 0 : 30, cuts));
}

/// An image of 3 to 12 voxels along each axis, anywhere, any way round.
certet::Image empty_image(Random& random) {
  certet::Image image;
  image.name = "soak";
  const double spacing = std::exp(real(random, -60, 60));
  const bool isotropic = chance(random, 3);
  for (std::size_t a = 0; a < 3; ++a) {
    image.size[a] = between(random, 3, 12);
    image.spacing[a] = spacing * (isotropic ? 1 : real(random, 0.6, 1.7));
  }
  image.origin = place(random, 50 * spacing);
  image.axes = axes(random, chance(random, 2));
  return image;
}

std::size_t voxel_count(const certet::Image& image) {
  return static_cast<std::size_t>(image.size[0] * image.size[1] * image.size[2]);
}

/// Labels 0 to 3, by voxel or in blocks; labels are in all eight corners.
void label(Trial& trial, Random& random) {
  certet::Image image = empty_image(random);
  const int block = between(random, 1, 4);
  const unsigned outside = static_cast<unsigned>(between(random, 20, 200));
  certet::Buffer<std::uint8_t> voxels(voxel_count(image));
  std::size_t at = 0;
  const std::uint64_t seed = random();
  for (std::int64_t k = 0; k < image.size[2]; ++k)
    for (std::int64_t j = 0; j < image.size[1]; ++j)
      for (std::int64_t i = 0; i < image.size[0]; ++i) {
        const std::uint64_t h = mixed(seed, i / block, j / block, k / block);
        const bool corner = i % (image.size[0] - 1) == 0 && j % (image.size[1] - 1) == 0 &&
                            k % (image.size[2] - 1) == 0;
        voxels[at++] = static_cast<std::uint8_t>(
            !corner && (h >> 8) % 256 < outside ? 0 : 1 + (h >> 32) % 3);
      }
  trial.labels = {image.size, image.spacing, image.origin, image.axes,
                  {voxels.begin(), voxels.end()}};
  const double finest = *std::ranges::min_element(image.spacing);
  image.voxels = std::move(voxels);
  const certet::ImageLattice lattice{chance(random, 2) ? 0 : finest * real(random, 0.5, 1.5),
                                     between(random, 1, 3)};
  auto domain = certet::label_domain(std::move(image), {}, lattice);
  trial.image = domain.get();
  trial.domain = std::move(domain);
}

/// Waves and a little noise; the level is a value that some voxels have exactly.
void level(Trial& trial, Random& random) {
  certet::Image image = empty_image(random);
  certet::Buffer<float> voxels(voxel_count(image));
  const certet::Point3 k = place(random, 1.5);
  const double noise = chance(random, 2) ? 0 : real(random, 0, 2);
  std::size_t at = 0;
  for (std::int64_t z = 0; z < image.size[2]; ++z)
    for (std::int64_t y = 0; y < image.size[1]; ++y)
      for (std::int64_t x = 0; x < image.size[0]; ++x)
        voxels[at++] = static_cast<float>(std::round(
            8 * (std::sin(k[0] * double(x)) + std::sin(k[1] * double(y)) +
                 std::sin(k[2] * double(z)) + noise * real(random, -1, 1))));
  const double highest = *std::max_element(voxels.begin(), voxels.end());
  const double finest = *std::ranges::min_element(image.spacing);
  image.voxels = std::move(voxels);
  const double value = std::min(highest - 1, std::round(real(random, -10, 10)));
  auto domain = certet::level_domain(std::move(image), value,
                                     {finest * real(random, 0.5, 1.5), between(random, 1, 3)});
  trial.image = domain.get();
  trial.domain = std::move(domain);
}

void make_domain(Trial& trial, Random& random) {
  const auto& n = trial.lattice.cells;
  const Coord3& o = trial.lattice.origin;
  switch (trial.kind) {
    case Kind::smooth: {
      const double radius = std::min({n[0], n[1], n[2]}) - 3.2;
      trial.domain = owned(domains::of_level(
          smooth(random, {o.x + n[0] - 0.3, o.y + n[1] + 0.1, o.z + n[2] - 0.2}, radius)));
      return;
    }
    case Kind::noise:
      trial.domain = owned(domains::noise(random(), chance(random, 2) ? 0 : 60));
      return;
    case Kind::sheet: trial.domain = sheets(random); return;
    case Kind::checkerboard: trial.domain = checkerboard(random); return;
    case Kind::on_surface: trial.domain = on_surface(random); return;
    case Kind::thresholds: trial.domain = at_thresholds(random); return;
    case Kind::labels: label(trial, random); return;
    case Kind::level: level(trial, random);
  }
}

}  // namespace

std::optional<int> LabelImage::at(const certet::Point3& world) const {
  std::int64_t index = 0, stride = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    double c = 0.5;
    for (std::size_t r = 0; r < 3; ++r) c += (world[r] - origin[r]) * axes[r][a] / spacing[a];
    if (std::abs(c - std::round(c)) < 1e-6) return std::nullopt;
    const auto i = static_cast<std::int64_t>(std::floor(c));
    if (i < 0 || i >= size[a]) return 0;
    index += i * stride;
    stride *= size[a];
  }
  return voxels[static_cast<std::size_t>(index)];
}

Trial make_trial(std::uint64_t seed, std::uint64_t number) {
  Trial trial;
  trial.seed = trial_seed(seed, number);
  Random random(trial.seed);
  trial.kind = static_cast<Kind>(number % kind_count);
  for (auto& cells : trial.lattice.cells) cells = between(random, 6, 24);
  const auto& n = trial.lattice.cells;
  trial.lattice.origin = {-n[0] & ~1, -n[1] & ~1, -n[2] & ~1};
  trial.frame.size = std::exp(real(random, -69, 69));  // 1e-30 to 1e30
  trial.frame.origin = place(random, 100 * trial.frame.size);
  trial.frame.axes = axes(random, false);
  const bool midpoint = chance(random, 3);
  const bool settles = chance(random, 2);
  const bool angles = settles || chance(random, 2);
  const auto settling_method =
      number / kind_count % 2 == 0 ? certet::Method::key : certet::Method::embedded;
  trial.method = midpoint  ? certet::Method::midpoint
                 : settles ? settling_method
                 : angles  ? certet::Method::angles
                           : certet::Method::embedding;
  trial.threads = between(random, 1, 2);
  make_domain(trial, random);
  if (trial.image != nullptr) {
    trial.lattice = trial.image->lattice();
    trial.frame = trial.image->frame();
  }
  return trial;
}

}  // namespace soak
