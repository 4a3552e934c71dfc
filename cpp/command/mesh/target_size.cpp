#include "target_size.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace certet::command {
namespace {

constexpr std::size_t most_tries = 12;
/// How many lattices, each twice as fine as the last, may have nothing inside.
constexpr std::size_t most_empty_tries = 6;
constexpr double tolerance = 0.02;
/// The first lattice has about so many cells along the longest side.
constexpr double first_cells = 16;

struct Try {
  double size, tets;
};

/// Chooses sizes by the counts so far.
class Search {
 public:
  Search(double target, double first_size) : target_(target), first_size_(first_size) {}

  void add(const Try& one) {
    tries_.push_back(one);
    // The nearest stand first.
    std::ranges::sort(tries_, {}, [this](const Try& t) { return distance(t); });
    if (one.tets >= target_) finer_ = std::max(finer_, one.size);
    else coarser_ = std::min(coarser_, one.size);
  }

  [[nodiscard]] const Try& best() const { return tries_.front(); }
  [[nodiscard]] std::size_t count() const { return tries_.size(); }
  [[nodiscard]] bool finished() const {
    if (tries_.empty()) return false;
    if (best().tets == 0) return count() == most_empty_tries;
    return count() == most_tries || std::abs(best().tets - target_) <= tolerance * target_;
  }

  /// By the model, a few times finer or coarser at most, and between the sizes
  /// that are known to be too fine and too coarse.
  [[nodiscard]] double next_size() const {
    if (tries_.empty()) return first_size_;
    if (best().tets == 0) return coarser_ / 2;
    const double known = best().size;
    const double most = tries_.size() == 1 ? 2 : 4;
    const double size = std::clamp(modelled_size(), known / most, known * most);
    return finer_ < size && size < coarser_ ? size : middle();
  }

 private:
  /// How far a count is from the target; none at all is the farthest.
  [[nodiscard]] double distance(const Try& one) const {
    return one.tets == 0 ? std::numeric_limits<double>::infinity()
                         : std::abs(std::log(one.tets / target_));
  }

  /// tets * size^3 = inner + surface * size through the two nearest tries: the
  /// solid has tetrahedra by its volume, and some more or less along its surface.
  [[nodiscard]] double modelled_size() const {
    const auto scaled = [](const Try& t) { return t.tets * t.size * t.size * t.size; };
    const double simple = std::cbrt(scaled(best()) / target_);
    if (tries_.size() < 2 || tries_[1].tets == 0 || tries_[1].size == best().size) return simple;
    const double surface =
        (scaled(tries_[1]) - scaled(best())) / (tries_[1].size - best().size);
    const double inner = scaled(best()) - surface * best().size;
    double size = simple;
    for (int i = 0; i < 20; ++i) {
      const double tets = inner + surface * size;
      if (!(tets > 0)) return simple;
      size = std::cbrt(tets / target_);
    }
    return size;
  }

  [[nodiscard]] double middle() const {
    if (finer_ == 0) return coarser_ / 2;
    if (std::isinf(coarser_)) return finer_ * 2;
    return std::sqrt(finer_ * coarser_);
  }

  double target_, first_size_;
  std::vector<Try> tries_;
  double finer_ = 0;  ///< the largest size with enough tetrahedra
  double coarser_ = std::numeric_limits<double>::infinity();
};

}  // namespace

Counted count_near(std::uint64_t target, double longest_side,
                   const std::function<Counted(double size)>& count_at, int& tries) {
  Search search(static_cast<double>(target), longest_side / first_cells);
  std::optional<Counted> counted;
  double size = 0;
  while (!search.finished()) {
    size = search.next_size();
    counted.reset();
    counted.emplace(count_at(size));
    search.add({size, static_cast<double>(counted->stuffing.tet_count())});
  }
  tries = static_cast<int>(search.count());
  if (search.best().tets != 0 && size != search.best().size) {
    counted.reset();
    counted.emplace(count_at(search.best().size));
  }
  return std::move(*counted);
}

}  // namespace certet::command
