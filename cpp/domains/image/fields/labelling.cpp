#include "labelling.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "fields/octants.hpp"

namespace certet::fields {
namespace {

/// A label of some corners of a cell.
struct Candidate {
  std::size_t label;  ///< its number in the block
  Octants corners;
};

/// The labels of the corners among which a point lies.
class Candidates {
 public:
  Candidates(const FieldCell& cell, const std::array<std::int64_t, 3>& within) {
    std::size_t upper = 0;  // axes along which the point is between two
    for (std::size_t a = 0; a < 3; ++a) upper |= static_cast<std::size_t>(within[a] != 0) << a;
    for (std::size_t corner = 0; corner < 8; ++corner)
      if ((corner & ~upper) == 0) add(cell.node(corner).own(), corner);
  }

  [[nodiscard]] const Candidate* begin() const { return all_.data(); }
  [[nodiscard]] const Candidate* end() const { return all_.data() + size_; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  void add(std::size_t label, std::size_t corner) {
    std::size_t i = 0;
    while (i < size_ && all_[i].label != label) ++i;
    if (i == size_) all_[size_++] = {label, 0};
    all_[i].corners = static_cast<Octants>(all_[i].corners | 1U << corner);
  }

  std::array<Candidate, 8> all_{};
  std::size_t size_ = 0;
};

/// The greatest so far; of equal ones the lowest label.
struct Greatest {
  std::int64_t value = std::numeric_limits<std::int64_t>::min();
  std::size_t label = 0;
  bool some = false;

  void add(std::int64_t other, std::size_t of) {
    if (some && (other < value || (other == value && of > label))) return;
    *this = {other, of, true};
  }
};

bool is_corner(const std::array<std::int64_t, 3>& within) {
  return (within[0] | within[1] | within[2]) == 0;
}

bool is_centre(const std::array<std::int64_t, 3>& within) {
  return within == std::array<std::int64_t, 3>{point_one / 2, point_one / 2, point_one / 2};
}

}  // namespace

Material Labelling::in_parted_cell(const FieldCell& cell,
                                   const std::array<std::int64_t, 3>& within) const {
  if (is_corner(within)) return cell.material(cell.node(0).own());
  const Node& nearest = cell.node(nearest_corner(within));
  if (force_ && nearest.at_risk()) return cell.material(nearest.own());
  const Candidates candidates(cell, within);
  if (candidates.size() == 1) return cell.material(candidates.begin()->label);
  const bool in_middle = is_centre(within);
  const bool unjoined = centres_ == Centres::unjoined && in_middle;
  Greatest of_all, of_groups;
  for (const Candidate& candidate : candidates) {
    const Corners values = cell.values(candidate.label);
    const std::int64_t value = in_middle ? std::accumulate(values.begin(), values.end(), 0)
                                         : trilinear(values, within);
    of_all.add(value, candidate.label);
    if (unjoined && hang_together(candidate.corners)) of_groups.add(value, candidate.label);
  }
  return cell.material(of_groups.some ? of_groups.label : of_all.label);
}

}  // namespace certet::fields
