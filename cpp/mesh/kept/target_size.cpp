#include "certet/target_size.hpp"

#include <algorithm>
#include <cmath>

namespace certet {
namespace {

constexpr std::size_t most_counts = 12;
/// How many lattices, each twice as fine as the last, may have nothing inside.
constexpr std::size_t most_empty_counts = 6;
constexpr double tolerance = 0.02;
/// The first lattice has about so many cells along the longest side.
constexpr double first_cells = 16;

}  // namespace

SizeSearch::SizeSearch(std::uint64_t target, double longest_side)
    : target_(static_cast<double>(target)), first_(longest_side / first_cells) {}

void SizeSearch::add(double size, std::uint64_t tets) {
  const Try one{size, static_cast<double>(tets)};
  tries_.push_back(one);
  std::ranges::sort(tries_, {}, [this](const Try& t) { return distance(t); });
  if (one.tets >= target_) finer_ = std::max(finer_, size);
  else coarser_ = std::min(coarser_, size);
}

bool SizeSearch::finished() const {
  if (tries_.empty()) return false;
  if (best() == 0) return tries_.size() == most_empty_counts;
  return tries_.size() == most_counts ||
         std::abs(tries_.front().tets - target_) <= tolerance * target_;
}

double SizeSearch::best() const {
  return tries_.front().tets == 0 ? 0 : tries_.front().size;
}

/// By the model, a few times finer or coarser at most, and between the sizes that are known
/// to be too fine and too coarse.
double SizeSearch::next() const {
  if (tries_.empty()) return first_;
  if (best() == 0) return coarser_ / 2;
  const double most = tries_.size() == 1 ? 2 : 4;
  const double size = std::clamp(modelled(), best() / most, best() * most);
  return finer_ < size && size < coarser_ ? size : middle();
}

/// How far a count is from the target; none at all is the farthest.
double SizeSearch::distance(const Try& one) const {
  return one.tets == 0 ? std::numeric_limits<double>::infinity()
                       : std::abs(std::log(one.tets / target_));
}

/// tets * size^3 = inner + surface * size through the two nearest tries: the solid has
/// tetrahedra by its volume, and some more or less along its surface.
double SizeSearch::modelled() const {
  const auto scaled = [](const Try& t) { return t.tets * t.size * t.size * t.size; };
  const Try& nearest = tries_.front();
  const double simple = std::cbrt(scaled(nearest) / target_);
  if (tries_.size() < 2 || tries_[1].tets == 0 || tries_[1].size == nearest.size) return simple;
  const double surface =
      (scaled(tries_[1]) - scaled(nearest)) / (tries_[1].size - nearest.size);
  const double inner = scaled(nearest) - surface * nearest.size;
  double size = simple;
  for (int i = 0; i < 20; ++i) {
    const double tets = inner + surface * size;
    if (!(tets > 0)) return simple;
    size = std::cbrt(tets / target_);
  }
  return size;
}

double SizeSearch::middle() const {
  if (finer_ == 0) return coarser_ / 2;
  if (std::isinf(coarser_)) return finer_ * 2;
  return std::sqrt(finer_ * coarser_);
}

}  // namespace certet
