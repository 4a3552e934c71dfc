#include "self_intersections.hpp"

#include <cmath>
#include <optional>

#include "box_tree.hpp"
#include "exact.hpp"
#include "rounding.hpp"

namespace certet {
namespace {

using exact::Corners;
using exact::Wide;

/// Six times the volume of the tetrahedron, as a sign.
int turn(Coord3 a, Coord3 b, Coord3 c, Coord3 d) {
  const Corners t{a, b, c};
  return exact::sign_of(exact::height(t, exact::normal(t), d));
}

/// How far from a to b the edge passes through the triangle, if it does.
std::optional<double> passes(Coord3 a, Coord3 b, const Corners& t, const exact::Normal& n) {
  const Wide from = exact::height(t, n, a), to = exact::height(t, n, b);
  if (exact::sign_of(from) * exact::sign_of(to) != -1) return std::nullopt;
  const int first = turn(a, b, t[0], t[1]), second = turn(a, b, t[1], t[2]),
            third = turn(a, b, t[2], t[0]);
  const bool left = first >= 0 && second >= 0 && third >= 0;
  const bool right = first <= 0 && second <= 0 && third <= 0;
  if (!left && !right) return std::nullopt;
  return static_cast<double>(from) / (static_cast<double>(from) - static_cast<double>(to));
}

class Search {
 public:
  Search(const TriangleSurface& surface, const Context& context)
      : surface_(surface), context_(context), round_(surface) {}

  SurfaceDefect run() {
    std::vector<IntegerBox> boxes;
    boxes.reserve(surface_.triangles.size());
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) {
      const Corners c = corners(t);
      IntegerBox box{c[0], c[0]};
      box.add({c[1], c[1]});
      box.add({c[2], c[2]});
      boxes.push_back(box);
    }
    BoxTree(std::move(boxes)).for_each_pair([&](std::uint32_t a, std::uint32_t b) {
      if (seen_++ % 0x10000 == 0) stop_if_cancelled(context_);
      if (!share_edge(a, b)) test_pair(a, b);
    });
    return found_;
  }

 private:
  [[nodiscard]] Corners corners(std::uint32_t triangle) const {
    const auto& t = surface_.triangles[triangle];
    return {round_(surface_.points[t[0]]), round_(surface_.points[t[1]]),
            round_(surface_.points[t[2]])};
  }

  /// Such a pair has no edge that passes through: most pairs are of this kind.
  [[nodiscard]] bool share_edge(std::uint32_t a, std::uint32_t b) const {
    int shared = 0;
    for (const std::uint32_t p : surface_.triangles[a])
      for (const std::uint32_t q : surface_.triangles[b]) shared += p == q;
    return shared >= 2;
  }

  void test_pair(std::uint32_t a, std::uint32_t b) {
    if (!check_edges(a, b)) check_edges(b, a);
  }

  /// Whether an edge of the first passes through the second.
  bool check_edges(std::uint32_t edges, std::uint32_t through) {
    const Corners from = corners(edges), to = corners(through);
    const exact::Normal n = exact::normal(to);
    for (std::size_t c = 0; c < 3; ++c)
      if (const auto at = passes(from[c], from[(c + 1) % 3], to, n)) {
        if (found_.count++ == 0) found_.first = between(edges, c, *at);
        return true;
      }
    return false;
  }

  [[nodiscard]] Point3 between(std::uint32_t triangle, std::size_t corner, double at) const {
    const auto& t = surface_.triangles[triangle];
    const Point3 &p = surface_.points[t[corner]], &q = surface_.points[t[(corner + 1) % 3]];
    return {p[0] + at * (q[0] - p[0]), p[1] + at * (q[1] - p[1]), p[2] + at * (q[2] - p[2])};
  }

  const TriangleSurface& surface_;
  const Context& context_;
  std::uint64_t seen_ = 0;  // pairs whose boxes meet
  Rounding round_;
  SurfaceDefect found_;
};

}  // namespace

SurfaceDefect find_self_intersections(const TriangleSurface& surface, const Context& context) {
  return Search(surface, context).run();
}

}  // namespace certet
