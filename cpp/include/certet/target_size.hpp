#pragma once
/// \file
/// The size that gives a number of tetrahedra.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace certet {

/// Chooses sizes by the counts so far, coarse ones first, until one has the target to a
/// fiftieth of it, or twelve were tried.  The sizes depend on the counts alone, so that the
/// answer is always the same.
class SizeSearch {
 public:
  /// `longest_side` is the solid's, in world units, as are all sizes.
  SizeSearch(std::uint64_t target, double longest_side);

  /// The size to count at next.
  [[nodiscard]] double next() const;
  /// What was counted there.
  void add(double size, std::uint64_t tets);
  [[nodiscard]] bool finished() const;
  /// The size that came nearest, once one was counted; 0 if none has a tetrahedron.
  [[nodiscard]] double best() const;
  [[nodiscard]] int tries() const { return static_cast<int>(tries_.size()); }

 private:
  struct Try {
    double size, tets;
  };
  [[nodiscard]] double distance(const Try& one) const;
  [[nodiscard]] double modelled() const;
  [[nodiscard]] double middle() const;

  double target_, first_;
  std::vector<Try> tries_;  ///< the nearest first
  double finer_ = 0;        ///< the largest size with enough tetrahedra
  double coarser_ = std::numeric_limits<double>::infinity();
};

/// The count that comes nearest to `target`.  `count_at(size)` counts and `tets_of` tells how
/// many tetrahedra that has; `tries` becomes the number of counts.  Never holds two of them
/// at a time.  \throws what `count_at` throws.
template <class CountAt, class TetsOf>
auto count_near(std::uint64_t target, double longest_side, const CountAt& count_at,
                const TetsOf& tets_of, int& tries) {
  SizeSearch search(target, longest_side);
  std::optional<decltype(count_at(0.0))> counted;
  double size = 0;
  while (!search.finished()) {
    size = search.next();
    counted.reset();
    counted.emplace(count_at(size));
    search.add(size, tets_of(*counted));
  }
  tries = search.tries();
  if (search.best() != 0 && size != search.best()) {
    counted.reset();
    counted.emplace(count_at(search.best()));
  }
  return std::move(*counted);
}

}  // namespace certet
