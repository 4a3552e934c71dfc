// Whether a domain of smooth interfaces is what its definition says, point by point and
// edge by edge, against a plain model; and the same however it is asked.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "label_images.hpp"
#include "lattice_materials.hpp"
#include "materials.hpp"
#include "seed.hpp"

namespace certet {
namespace {

using label_images::blobs;
using label_images::noise;
using lattice_materials::Cuts;
using lattice_materials::domain_of;
using lattice_materials::LatticeMaterials;

using Voxel = std::array<int, 3>;

/// Fields without constants and treads, node by node.
class Model {
 public:
  explicit Model(const Image& image)
      : size_(image.size), voxels_(std::get<Buffer<std::uint16_t>>(image.voxels)) {}

  /// In 16384ths, by label; what is not near is not there.
  const std::map<int, int>& fields_at(const Voxel& v) const {
    auto& kept = kept_[v];
    if (!kept.empty()) return kept;
    const std::vector<int> taps =
        is_near_thin(v) ? std::vector<int>{0, 3, 10, 3, 0} : std::vector<int>{1, 4, 6, 4, 1};
    for_each_offset(2, [&](const Voxel& o) {
      int weight = 1;
      for (std::size_t a = 0; a < 3; ++a) weight *= taps[static_cast<std::size_t>(o[a] + 2)];
      if (weight != 0) kept[label(plus(v, o))] += 4 * weight;
    });
    hold(label(v), lead(v, kept[label(v)]), kept);
    return kept;
  }

  /// At a point in voxels, in 16384ths.
  [[nodiscard]] double field(int of, const Point3& p) const {
    double sum = 0;
    for_each_corner(p, [&](const Voxel& v, double weight) {
      const auto& fields = fields_at(v);
      if (const auto found = fields.find(of); found != fields.end()) sum += weight * found->second;
    });
    return sum;
  }

  /// The labels of the corners that a point lies between, by how great their fields are.
  [[nodiscard]] std::vector<std::pair<double, int>> ranking(const Point3& p) const {
    std::map<int, double> found;
    for_each_corner(p, [&](const Voxel& v, double) { found[label(v)] = 0; });
    std::vector<std::pair<double, int>> ranked;
    for (const auto& [of, none] : found) ranked.emplace_back(-field(of, p), of);
    std::ranges::sort(ranked);
    return ranked;
  }

 private:
  [[nodiscard]] int label(const Voxel& v) const {
    std::size_t at = 0;
    for (std::size_t a = 3; a-- > 0;)
      at = at * static_cast<std::size_t>(size_[a]) +
           static_cast<std::size_t>(std::clamp<std::int64_t>(v[a], 0, size_[a] - 1));
    return voxels_[at];
  }

  static Voxel plus(const Voxel& a, const Voxel& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  }

  template <class Visit>
  static void for_each_offset(int radius, const Visit& visit) {
    for (int z = -radius; z <= radius; ++z)
      for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) visit(Voxel{x, y, z});
  }

  [[nodiscard]] bool is_thin(const Voxel& v) const {
    for (int octant = 0; octant < 8; ++octant) {
      bool same = true;
      for (int o = 0; o < 8; ++o) {
        Voxel other = v;
        for (std::size_t a = 0; a < 3; ++a)
          if ((o >> a & 1) != 0) other[a] += (octant >> a & 1) != 0 ? 1 : -1;
        same = same && label(other) == label(v);
      }
      if (same) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_near_thin(const Voxel& v) const {
    bool thin = false;
    // Voxels beyond the border are none of their own, but go on.
    for_each_offset(1, [&](const Voxel& o) { thin = thin || is_thin(plus(v, o)); });
    return thin;
  }

  static Voxel further(Voxel v, std::size_t axis, int by) {
    v[axis] += by;
    return v;
  }

  /// How many in a row have a voxel's label.
  [[nodiscard]] int row(const Voxel& v, std::size_t axis) const {
    int count = 1;
    for (const int way : {-1, 1})
      for (int by = way; std::abs(by) < 4 && label(further(v, axis, by)) == label(v); by += way)
        ++count;
    return count;
  }

  /// Whether a voxel's row is of one or two, and those of its neighbours beside it.
  [[nodiscard]] bool is_part_of_something_slender(const Voxel& v, std::size_t axis) const {
    if (row(v, axis) > 2) return false;
    for (std::size_t beside = 0; beside < 3; ++beside)
      for (const int by : {-1, 1}) {
        const Voxel other = further(v, beside, by);
        if (beside != axis && label(other) == label(v) && row(other, axis) > 2) return false;
      }
    return true;
  }

  /// By how much the voxel's label, whose field is `own`, is ahead at least.
  [[nodiscard]] int lead(const Voxel& v, int own) const {
    int least = is_near_thin(v) ? 4096 : 256;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (row(v, axis) <= 2) least = std::max(least, 12288 - own);
      if (!is_part_of_something_slender(v, axis)) continue;
      const int slender = is_thin(v) ? 28160 - 7 * own / 4 : 26624 - 2 * own;
      least = std::max(least, std::min(slender, 20480));
    }
    return least;
  }

  static void hold(int own, int lead, std::map<int, int>& fields) {
    int best = 0;
    for (const auto& [of, value] : fields)
      if (of != own) best = std::max(best, value);
    const int ahead = best - fields[own], mixed = std::min(lead, 16384);
    const int more = std::max(0, lead - std::max(mixed, -ahead));
    const int mixing = ahead <= -mixed ? 0 : (mixed + ahead) * 16384 / (16384 + ahead);
    for (auto& [of, value] : fields)
      value += (of == own ? mixing + more : 0) - ((value * mixing) >> 14);
  }

  template <class Visit>
  static void for_each_corner(const Point3& p, const Visit& visit) {
    for (int c = 0; c < 8; ++c) {
      Voxel v{};
      double weight = 1;
      for (std::size_t a = 0; a < 3; ++a) {
        const double low = std::floor(p[a]);
        const int upper = c >> a & 1;
        v[a] = static_cast<int>(low) + upper;
        weight *= upper != 0 ? p[a] - low : 1 - (p[a] - low);
      }
      if (weight > 0) visit(v, weight);
    }
  }

  std::array<std::int64_t, 3> size_;
  const Buffer<std::uint16_t>& voxels_;
  mutable std::map<Voxel, std::map<int, int>> kept_;
};

std::vector<Image> images(std::uint64_t seed) {
  std::vector<Image> made;
  made.push_back(noise(seed, {13, 11, 19}, 3));
  made.push_back(blobs(seed, {21, 18, 14}, 5));
  made.push_back(label_images::thin_things());
  return made;
}

fields::Rules plain_rules() {
  fields::Rules rules;
  rules.keep_volumes = false;
  rules.slope_treads = false;
  return rules;
}

int label_of(const PlacedDomain& domain, Material material) {
  return material == 0 ? 0 : domain.labels()[static_cast<std::size_t>(material) - 1];
}

/// Fields closer than this may be rounded either way.
constexpr double close = 0.01;

TEST(Definition, PointsHaveTheLabelOfTheGreatestField) {
  std::mt19937_64 random(test_seed());
  for (const Image& image : images(test_seed())) {
    const Model model(image);
    const auto domain = domain_of(label_images::copy(image), 1, plain_rules());
    std::uniform_real_distribution<double> unit(0, 1);
    for (int n = 0; n < 1500; ++n) {
      Coord3 position{};
      for (std::int32_t* c : {&position.x, &position.y, &position.z})
        *c = between(random, -8 * steps, 8 * steps);
      const Point3 p = domain->frame().world(position);
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a)
        within = within && p[a] > -0.5 && p[a] < static_cast<double>(image.size[a]) - 0.5;
      Material found = 0;
      domain->materials_at({&position, 1}, {&found, 1});
      if (!within) continue;
      const auto ranking = model.ranking(p);
      if (ranking.size() > 1 && ranking[1].first - ranking[0].first < close) continue;
      ASSERT_EQ(label_of(*domain, found), ranking[0].second);
    }
  }
}

TEST(Definition, EdgesPartWhereFieldsAreEqual) {
  for (const Image& image : images(test_seed())) {
    const Model model(image);
    const auto domain = domain_of(label_images::copy(image), 1, plain_rules());
    const Cuts cuts(*domain);
    ASSERT_GT(cuts.edges.size(), 100U);
    for (std::size_t e = 0; e < cuts.edges.size(); e += 7) {
      const PartedEdge& edge = cuts.edges[e];
      const Coord3 first = steps * edge.first;
      Material of_first = 0;
      domain->materials_at({&first, 1}, {&of_first, 1});
      const auto ahead = [&](std::int32_t further) {
        const Point3 p = domain->frame().world(cuts.position(e, further));
        return model.field(label_of(*domain, of_first), p) -
               model.field(label_of(*domain, edge.of_last), p);
      };
      const Point3 last = domain->frame().world(steps * edge.last);
      bool within = true;
      for (std::size_t a = 0; a < 3; ++a)
        within = within && last[a] >= -0.5 && last[a] < static_cast<double>(image.size[a]) - 0.5;
      if (!within) continue;
      // Ends that have another label than that of the greatest field have no such cut.
      if (cuts.steps[e] != 0) {
        EXPECT_GT(ahead(0), -close);
      }
      if (cuts.steps[e] != steps - 1) {
        EXPECT_LT(ahead(1), close);
      }
    }
  }
}

/// At the centre of a cell a label whose voxels do not hang together joins nothing.
TEST(Definition, NothingIsJoinedAcrossAnEdge) {
  const auto image = label_images::image_of({6, 6, 6}, [](int i, int j, int k) {
    const bool meets = (i < 3) == (j < 3) && k > 0 && k < 5;
    return meets ? 1 : i < 3 ? 2 : 3;
  });
  const auto domain = domain_of(label_images::copy(image));
  const LatticeMaterials materials(*domain);
  int seen = 0;
  materials.for_each([&](Coord3 point, std::size_t number) {
    const Point3 p = domain->frame().world(steps * point);
    if (p[0] == 2.5 && p[1] == 2.5 && p[2] > 1 && p[2] < 4) {
      ++seen;
      EXPECT_NE(label_of(*domain, materials[number]), 1);
    }
  });
  EXPECT_GT(seen, 0);
}

TEST(Definition, AnswersAgreeWithEachOther) {
  std::mt19937_64 random(test_seed());
  for (const double size : {1.0, 0.5, 0.83})
    for (Image& image : images(test_seed())) {
      image.axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};
      const auto domain = domain_of(label_images::copy(image), size);
      int decided = 0;
      EXPECT_EQ(materials::first_contradiction(random, *domain, domain->lattice(), 60, decided), "");
    }
  const auto domain = domain_of(label_images::Balls(64).image());
  int decided = 0;
  EXPECT_EQ(materials::first_contradiction(random, *domain, domain->lattice(), 300, decided), "");
  EXPECT_GT(decided, 5);
}

TEST(Definition, ThreadsMakeNoDifference) {
  const Image image = blobs(test_seed(), {70, 45, 38}, 7);
  const auto one = domain_of(label_images::copy(image), 1, {}, 1);
  const LatticeMaterials materials(*one);
  const Cuts cuts(*one);
  for (const int threads : {2, 7}) {
    const auto other = domain_of(label_images::copy(image), 1, {}, threads);
    EXPECT_EQ(LatticeMaterials(*other).all(), materials.all());
    EXPECT_EQ(Cuts(*other).steps, cuts.steps);
  }
}

TEST(Definition, WhatCannotBeMeantIsRefused) {
  const auto image = std::make_shared<const Image>(blobs(1, {12, 12, 12}, 2));
  const auto code = [&](std::vector<LabelRange> labels, std::optional<double> sigma) {
    try {
      static_cast<void>(interface_domain(image, std::move(labels), {}, {sigma}));
    } catch (const Error& error) {
      return std::optional<ErrorCode>(error.code());
    }
    return std::optional<ErrorCode>();
  };
  EXPECT_EQ(code({}, 1.0), std::nullopt);
  EXPECT_EQ(code({}, 0.01), std::nullopt);
  EXPECT_EQ(code({}, 4.0), std::nullopt);
  EXPECT_EQ(code({}, 0.0), ErrorCode::bad_option);
  EXPECT_EQ(code({}, -1.0), ErrorCode::bad_option);
  EXPECT_EQ(code({}, 4.1), ErrorCode::bad_option);
  EXPECT_EQ(code({{77, 78}}, 1.0), ErrorCode::empty_domain);
  Context context;
  context.cancelled = true;
  EXPECT_THROW(interface_domain(image, {}, {}, {}, context), Error);
}

}  // namespace
}  // namespace certet
