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

/// A face of the boundary of which two points lie where the domain is cut off.
struct DoubtfulFace {
  std::array<std::uint64_t, 3> points;
  std::uint64_t third;  ///< its other point
};

/// Puts faces of the boundary into the patch `border`: those of which `is_on_border` tells
/// it of three points.  \returns those of which it does of two.
template <class IsOnBorder>
std::vector<DoubtfulFace> put_on_border(std::span<BoundaryFace> faces,
                                        const IsOnBorder& is_on_border) {
  std::vector<DoubtfulFace> doubtful;
  for (BoundaryFace& face : faces) {
    std::size_t count = 0;
    std::uint64_t third = 0;
    for (const std::uint64_t point : face.points)
      is_on_border(point) ? static_cast<void>(++count) : static_cast<void>(third = point);
    if (count == 3) face.patch = Patch::border;
    if (count == 2) doubtful.push_back({face.points, third});
  }
  return doubtful;
}

/// Where two materials and the outside meet, the boundary has a point between the two:
/// puts those faces on the border whose third point is such a one.
void put_on_border(Survey& survey, std::span<const DoubtfulFace> faces);

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
