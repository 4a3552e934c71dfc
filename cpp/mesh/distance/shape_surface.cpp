#include "shape_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ball.hpp"
#include "certet/error.hpp"
#include "runs.hpp"
#include "vectors.hpp"

namespace certet::distance {
namespace {

TriangleTree tree_of(std::span<const TriangleCorners> triangles) {
  if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3)
    throw Error(ErrorCode::too_large, "a surface has too many triangles to measure distances from");
  std::vector<Point3> points;
  std::vector<Triangle> numbers;
  for (const TriangleCorners& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    numbers.push_back({first, first + 1, first + 2});
    for (const Coord3 corner : triangle) points.push_back(in_units(corner));
  }
  return {std::move(points), std::move(numbers)};
}

/// Asks for the probes of all balls until none is open.
void grow(std::span<Ball> balls, const Sides& sides) {
  Question question(sides);
  std::vector<Ball*> open;
  for (Ball& ball : balls)
    if (ball.is_open()) open.push_back(&ball);
  std::vector<std::size_t> first;
  while (!open.empty()) {
    question.clear();
    first.clear();
    for (const Ball* ball : open) {
      first.push_back(question.size());
      ball->add_probes(question);
    }
    question.ask();
    for (std::size_t i = 0; i < open.size(); ++i) open[i]->take(question, first[i]);
    std::erase_if(open, [](const Ball* ball) { return !ball->is_open(); });
  }
}

}  // namespace

ShapeSurface::ShapeSurface(const PlacedDomain& domain, bool materials, Context& context)
    : sides_{domain, materials} {
  const std::vector<TriangleCorners> triangles =
      materials ? std::vector<TriangleCorners>() : domain.triangles();
  if (triangles.empty() || !all_part(triangles, sides_, context)) {
    points_ = crossings(sides_, context);
    return;
  }
  triangles_.emplace(tree_of(triangles));
  points_ = points_of(triangles, context);
}

std::vector<double> ShapeSurface::distances(std::span<const Point3> points,
                                            Context& context) const {
  if (points_.empty())
    throw Error(ErrorCode::empty_domain, "the shape has no surface to measure distances from");
  std::vector<double> found(points.size());
  if (!triangles_) {
    by_answers(points, found, context);
    return found;
  }
  in_runs(points.size(), context, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      found[i] = std::sqrt(triangles_->nearest(points[i]).square);
  });
  return found;
}

void ShapeSurface::by_answers(std::span<const Point3> points, std::span<double> out,
                              Context& context) const {
  std::vector<Ball> balls(points.begin(), points.end());
  in_runs(points.size(), context, [&](std::size_t first, std::size_t last, std::size_t) {
    grow(std::span(balls).subspan(first, last - first), sides_);
  });
  reach_far_ones(balls, context);
  std::ranges::transform(balls, out.begin(), [](const Ball& ball) { return ball.radius(); });
}

/// Goes on from the nearest of the points at which the shape is measured.
void ShapeSurface::reach_far_ones(std::span<Ball> balls, Context& context) const {
  std::vector<std::size_t> far;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (balls[i].is_far()) far.push_back(i);
  if (far.empty()) return;
  std::vector<Point3> places;
  std::vector<Triangle> numbers;
  for (const ShapePoint& point : points_) {
    const auto number = static_cast<std::uint32_t>(places.size());
    places.push_back(point.at);
    numbers.push_back({number, number, number});
  }
  const TriangleTree tree(std::move(places), std::move(numbers));
  in_runs(far.size(), context, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      Ball& ball = balls[far[i]];
      ball.reach(tree.corners(tree.nearest(ball.centre()).triangle).a);
      grow({&ball, 1}, sides_);
    }
  });
}

}  // namespace certet::distance
