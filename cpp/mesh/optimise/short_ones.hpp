#pragma once
/// \file
/// Which tetrahedra are short of the goal, of many of which few are.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace certet::optimising {

/// Those with a squared cosine beyond the goal's, in their order.  Many are compared at once.
class ShortOnes {
 public:
  ShortOnes(std::span<const float> worst, double goal)
      : worst_(worst), bar_(static_cast<float>(goal)) {
    // No number of single precision is between the bar and the goal.
    if (bar_ > goal) bar_ = std::nextafter(bar_, 0.0F);
  }

  [[nodiscard]] std::uint64_t count() const {
    std::uint64_t all = 0;
    for (std::size_t begin = 0; begin < worst_.size(); begin += at_once)
      all += static_cast<std::uint64_t>(count_in(part(begin)));
    return all;
  }

  /// Calls visit(number) for each.
  template <class Visit>
  void visit(const Visit& visit) const {
    for (std::size_t begin = 0; begin < worst_.size(); begin += at_once) {
      const std::span<const float> some = part(begin);
      if (count_in(some) == 0) continue;
      for (std::size_t i = 0; i < some.size(); ++i)
        if (some[i] > bar_) visit(begin + i);
    }
  }

 private:
  static constexpr std::size_t at_once = 256;

  [[nodiscard]] std::span<const float> part(std::size_t begin) const {
    return worst_.subspan(begin, std::min(at_once, worst_.size() - begin));
  }
  /// Without a branch, which compilers vectorise.
  [[nodiscard]] std::int32_t count_in(std::span<const float> some) const {
    std::int32_t count = 0;
    for (const float worst : some) count += worst > bar_ ? 1 : 0;
    return count;
  }

  std::span<const float> worst_;
  float bar_;
};

}  // namespace certet::optimising
