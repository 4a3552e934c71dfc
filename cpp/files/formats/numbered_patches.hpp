#pragma once
/// \file
/// Patches of a format that numbers them and has no names.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "certet/survey.hpp"

namespace certet::formats {

/// Numbers patches from 1, in the order of `patch_names`, as our writers do.  A file
/// with another number means something else by them, and none of its faces is taken.
class NumberedPatches {
 public:
  static constexpr std::int32_t number_of(Patch patch) {
    return static_cast<std::int32_t>(patch) + 1;
  }

  void add(const std::array<std::uint64_t, 3>& face, std::int64_t number) {
    are_ours_ = are_ours_ && number >= 1 && std::cmp_less_equal(number, patch_names.size());
    if (number == number_of(Patch::border)) border_.push_back(face);
  }

  /// The faces of `border`.
  std::vector<std::array<std::uint64_t, 3>> take() {
    if (!are_ours_) return {};
    return std::move(border_);
  }

 private:
  bool are_ours_ = true;
  std::vector<std::array<std::uint64_t, 3>> border_;
};

}  // namespace certet::formats
