#include "subject.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "certet/bounded_function.hpp"
#include "certet/materials_domain.hpp"
#include "materials.hpp"
#include "seed.hpp"

namespace labelled {
namespace {

using certet::Point3;

double real(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

void place(Subject& subject, std::unique_ptr<certet::PlacedDomain> domain) {
  subject.lattice = domain->lattice();
  subject.frame = domain->frame();
  subject.domain = std::move(domain);
}

void image_subject(Subject& subject, Random& random) {
  const LabelImage made = make_image(subject.kind, random);
  const auto [least, most] = std::ranges::minmax(made.spacing);
  MeshedImage image{std::make_shared<const certet::Image>(made.image()), made.pieces(),
                    between(random, 0, 1) == 0, Fineness::spacing};
  certet::ImageLattice lattice{least, between(random, 1, 2),
                               subject.method == certet::Method::midpoint};
  if (const int choice = between(random, 0, 5); choice == 0) {
    lattice.size = least * real(random, 1.05, 1.8);
    image.fineness = Fineness::coarser;
  } else if (choice < 3 || least != most) {
    lattice.size = choice == 1 ? least / between(random, 1, 2) : least * real(random, 0.6, 1);
    image.fineness = Fineness::finer;
  }
  image.smooth ? place(subject, certet::interface_domain(image.image, {}, lattice))
               : place(subject, certet::label_domain(image.image, {}, lattice));
  subject.image = std::move(image);
}

/// Balls and boxes, of any number of which a point may be in.
certet::Solid any_solid(Random& random) {
  Point3 centre, half;
  for (std::size_t a = 0; a < 3; ++a) {
    centre[a] = real(random, -1, 1);
    half[a] = real(random, 0.1, 0.9);
  }
  certet::Bounds bounds;
  for (std::size_t a = 0; a < 3; ++a) {
    bounds.low[a] = centre[a] - half[a];
    bounds.high[a] = centre[a] + half[a];
  }
  const bool ball = between(random, 0, 1) == 0;
  return certet::function_solid(
      [=](const Point3& p) {
        double round = -1, edged = -1;
        for (std::size_t a = 0; a < 3; ++a) {
          const double off = std::abs(p[a] - centre[a]) / half[a];
          round += off * off;
          edged = std::max(edged, off - 1);
        }
        return ball ? round : edged;
      },
      bounds);
}

void solids_subject(Subject& subject, Random& random) {
  std::vector<certet::NamedSolid> solids;
  for (int n = between(random, 2, 12); n > 0; --n)
    solids.push_back({"solid " + std::to_string(n), any_solid(random)});
  std::vector<std::string> priority;
  if (between(random, 0, 1) == 0) priority.push_back(solids.front().name);
  place(subject, certet::materials_domain(solids, {real(random, 0.25, 0.6), 1}, priority));
}

void cuts_subject(Subject& subject, Random& random) {
  static const std::array<std::vector<std::int32_t>, 3> cuts{{
      {0, 3000, 9000, 17000, 30000, 42000, 60000, 65535},
      {0, 1, 18687, 18688, 26111, 26112, 39424, 46848, 65535},
      {16384, 16385, 17000, 18687},
  }};
  std::vector<std::int32_t> labels;
  for (std::int32_t label = between(random, 2, 12); label > 0; --label)
    labels.insert(labels.begin(), label);
  const auto outside = static_cast<unsigned>(between(random, 0, 1) == 0 ? 0 : between(random, 20, 200));
  const auto which = static_cast<std::size_t>(between(random, 0, 3));
  const std::uint64_t seed = random();
  for (auto& cells : subject.lattice.cells) cells = between(random, 4, 7);
  subject.domain = std::make_unique<materials::Positional>(
      which == 3 ? materials::noise(seed, labels, outside)
                 : materials::random_cuts(seed, labels, outside, cuts[which]));
}

}  // namespace

Subject make_subject(std::uint64_t seed, std::uint64_t number) {
  Random random(mixed(seed, number));
  Subject subject;
  subject.kind = number % subject_kinds.size();
  subject.method =
      between(random, 0, 3) == 0 ? certet::Method::midpoint : certet::Method::embedded;
  if (subject.kind < image_kinds.size()) image_subject(subject, random);
  else if (subject.kind == image_kinds.size()) solids_subject(subject, random);
  else cuts_subject(subject, random);
  return subject;
}

}  // namespace labelled
