#include "faces.hpp"

namespace certet::core {
namespace {

/// The other end of an edge, and whether the edge runs from there.
using EdgeKey = std::uint64_t;
EdgeKey edge_key(std::uint64_t highest, bool reversed) {
  return highest << 1 | (reversed ? 1 : 0);
}

}  // namespace

FaceFindings& FaceFindings::operator+=(const FaceFindings& behind) {
  overfull += behind.overfull;
  misoriented += behind.misoriented;
  if (!first_overfull) first_overfull = behind.first_overfull;
  if (!first_misoriented) first_misoriented = behind.first_misoriented;
  boundary.insert(boundary.end(), behind.boundary.begin(), behind.boundary.end());
  return *this;
}

EdgeFindings find_edges(std::uint64_t points, std::span<const Face> surface, Context& context) {
  Groups<EdgeKey> by_lowest(points);
  for (const Face& face : surface) {
    by_lowest.count(face.points[0], 2);
    by_lowest.count(face.points[1]);
  }
  by_lowest.lay_out();
  for (const auto& [p, reversed] : surface) {
    by_lowest.place(p[0], edge_key(p[1], reversed));
    by_lowest.place(p[1], edge_key(p[2], reversed));
    by_lowest.place(p[0], edge_key(p[2], !reversed));
  }

  EdgeFindings found;
  const auto same = [](EdgeKey a, EdgeKey b) { return a >> 1 == b >> 1; };
  for (std::size_t lowest = 0; lowest < by_lowest.size(); ++lowest) {
    stop_now_and_then(lowest, context);
    const std::span<EdgeKey> group = by_lowest[lowest];
    sort_group(group);
    for_runs(group, same, [&](std::span<EdgeKey> run) {
      std::int64_t balance = 0;
      for (const EdgeKey key : run) balance += (key & 1) != 0 ? -1 : 1;
      if (balance == 0) return;
      if (found.open++ == 0) found.first_open = {lowest, run.front() >> 1};
    });
  }
  return found;
}

}  // namespace certet::core
