#pragma once
/// \file
/// The faces that belong to one tetrahedron only.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/quality.hpp"
#include "certet/survey.hpp"

namespace certet::core {

/// The corners of the face opposite to each corner of a tetrahedron of positive
/// volume, counterclockwise as seen from outside.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> outward_faces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

template <class Index>
BoundaryFace face_of(const Tet<Index>& tet, std::uint64_t number, std::uint8_t opposite,
                     std::int32_t label = only_label) {
  const auto [a, b, c] = outward_faces[opposite];
  BoundaryFace face{{tet[a], tet[b], tet[c]}, number, opposite, Patch::surface, label};
  std::rotate(face.points.begin(), std::ranges::min_element(face.points), face.points.end());
  return face;
}

/// Orders faces by their points, whichever way round they are seen.
bool comes_before(const BoundaryFace& a, const BoundaryFace& b);
bool same_points(const BoundaryFace& a, const BoundaryFace& b);

/// A face between two tetrahedra of different labels, as the one of the lesser has it.
struct InnerFace {
  BoundaryFace face;
  std::int32_t behind;  ///< the other one's label
};

/// Sorts faces and takes out all that are there more than once; of those that are there
/// twice, with different labels, it adds what they are to `inner`.
void keep_single_faces(std::vector<BoundaryFace>& faces, std::vector<InnerFace>& inner);

/// Faces between labels, brought together by the labels.
std::vector<Interface> interfaces_of(std::vector<InnerFace> faces);

/// How often there is each label, as regions without names.
class RegionCounts {
 public:
  /// So many tetrahedra, and six times their volume in steps cubed, where it was measured.
  void add(std::int32_t label, std::uint64_t tets, const WideSum& six_volumes = {}) {
    Count& count = counts_[label];
    count.tets += tets;
    count.six_volumes += six_volumes;
  }
  void add(std::span<const std::int32_t> labels);
  RegionCounts& operator+=(const RegionCounts& other);
  [[nodiscard]] std::vector<Region> regions() const;

 private:
  struct Count {
    std::uint64_t tets = 0;
    WideSum six_volumes;
  };
  std::map<std::int32_t, Count> counts_;
};

}  // namespace certet::core
