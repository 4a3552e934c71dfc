#include "traced.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "engine/disjoint_sets.hpp"
#include "meeting.hpp"
#include "paths.hpp"

namespace certet::features {
namespace {

/// Between points of a curve.
constexpr double spacing = long_edge / 16;
/// Points so near to a corner are looked for anew once that is known: an edge of the mesh may lead
/// past it, over three faces.
constexpr double corner_room = 0.8 * long_edge;
/// Corners that are nearer to each other are one, and loops shorter than the second are none.
constexpr double one_corner = 0.3 * long_edge, least_loop = 2 * long_edge;

struct Corner {
  std::optional<Vector> place;
  std::uint32_t of;  ///< the first of those that are one
};

struct Line {
  std::vector<OnLine> points;
  std::uint32_t left, right;
  bool is_loop = false;
  std::optional<Vector> from, to;  ///< corners
};

std::vector<std::uint32_t> patches_of(const SeenSurface& surface, std::span<const Jump> jumps) {
  const auto count = static_cast<std::uint32_t>(surface.places.size());
  const auto is_seen = [&](std::uint32_t v) {
    return surface.doubtful[v] == 0 || surface.known[v] != 0;
  };
  DisjointSets sets(count);
  const auto visit_edges = [&](const auto& visit) {
    for (const auto& [a, b, c] : surface.triangles)
      for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) visit(v, w);
  };
  visit_edges([&](std::uint32_t v, std::uint32_t w) {
    const std::array<std::uint32_t, 2> ends{std::min(v, w), std::max(v, w)};
    if (is_seen(v) && is_seen(w) && !std::ranges::binary_search(jumps, ends, {}, &Jump::ends))
      sets.join(v, w);
  });
  // Where nothing was seen, that of a neighbour.
  std::vector<std::uint32_t> with(count, none);
  visit_edges([&](std::uint32_t v, std::uint32_t w) {
    if (!is_seen(v) && is_seen(w)) with[v] = std::min(with[v], w);
    if (!is_seen(w) && is_seen(v)) with[w] = std::min(with[w], v);
  });
  std::vector<std::uint32_t> patches(count, none);
  std::uint32_t number = 0;
  for (std::uint32_t v = 0; v < count; ++v)
    if (const std::uint32_t first = sets.find(v); patches[first] == none) patches[first] = number++;
  for (std::uint32_t v = 0; v < count; ++v) patches[v] = patches[sets.find(v)];
  for (std::uint32_t v = 0; v < count; ++v)
    if (with[v] != none) patches[v] = patches[with[v]];
  return patches;
}

class Tracer {
 public:
  Tracer(const PlacedDomain& domain, Context& context, Traced& traced, std::vector<Jump> jumps)
      : domain_(domain), context_(context), traced_(traced), jumps_(std::move(jumps)),
        paths_(find_paths(traced.surface, jumps_)) {}

  void run() {
    std::vector<OnLine> guesses;
    for (const Jump& jump : jumps_) guesses.push_back({jump.place, jump.wedge});
    refined_ = onto_lines(domain_, guesses, context_);
    find_corners();
    for (const Path& path : paths_.paths)
      if (auto line = line_of(path)) lines_.push_back(std::move(*line));
    make_dense();
    for (const Line& line : lines_) store(line);
    auto& corners = traced_.features.corners;
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  }

 private:
  void find_corners();
  [[nodiscard]] std::optional<Vector> corner_of(const Junction& junction) const;
  [[nodiscard]] std::optional<Line> line_of(const Path& path) const;
  [[nodiscard]] std::optional<Vector> place_of(std::uint32_t junction) const {
    return junction == none ? std::nullopt : corners_[corners_[junction].of].place;
  }
  void make_dense();
  void store(const Line& line);

  const PlacedDomain& domain_;
  Context& context_;
  Traced& traced_;
  std::vector<Jump> jumps_;
  Paths paths_;
  std::vector<std::optional<OnLine>> refined_;  ///< jumps
  std::vector<Corner> corners_;                 ///< junctions
  std::vector<Line> lines_;
};

std::optional<Vector> Tracer::corner_of(const Junction& junction) const {
  std::array<CornerFace, 3> faces{};
  std::array<Vector, 3> points{};
  Vector centre{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    // The two jumps at a corner of the triangle; the first goes out from it.
    Vector into{0, 0, 0};
    for (const std::uint32_t j : {junction.jumps[i], junction.jumps[(i + 2) % 3]}) {
      const Jump& jump = jumps_[j];
      const std::size_t side = jump.ends[0] == junction.corners[i] ? 0 : 1;
      const Wedge& wedge = refined_[j] ? refined_[j]->wedge : jump.wedge;
      into = into + wedge.into(side);
      faces[i].normal = wedge.normals[side];
      points[i] = refined_[j] ? refined_[j]->place : jump.place;
    }
    faces[i].into = unit(into);
    centre = centre + (1.0 / 3) * points[i];
  }
  const double volume = dot(faces[0].normal, cross(faces[1].normal, faces[2].normal));
  Vector guess = centre;
  if (std::fabs(volume) > 0.05) {
    Vector sum{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
      sum = sum + dot(points[i], faces[i].normal) *
                      cross(faces[(i + 1) % 3].normal, faces[(i + 2) % 3].normal);
    guess = (1 / volume) * sum;
    if (length(guess - centre) > 1.5 * long_edge) guess = centre;
  }
  return onto_corner(domain_, guess, faces);
}

void Tracer::find_corners() {
  for (std::uint32_t c = 0; c < paths_.junctions.size(); ++c) {
    corners_.push_back({corner_of(paths_.junctions[c]), c});
    if (!corners_[c].place) continue;
    for (std::uint32_t other = 0; other < c; ++other)
      if (corners_[other].of == other && corners_[other].place &&
          length(*corners_[other].place - *corners_[c].place) < one_corner) {
        corners_[c].of = other;
        break;
      }
  }
}

/// Where the mesh is blunt and the surface was not seen, a way around may lack a part.
void close(Line& line, const Path& path, double way) {
  constexpr double widest = 1.5 * long_edge;
  if (path.is_loop || path.from != none || path.to != none || way < least_loop) return;
  const Vector gap = line.points.front().place - line.points.back().place;
  line.is_loop = length(gap) < widest && dot(gap, line.points.back().along()) > 0;
}

std::optional<Line> Tracer::line_of(const Path& path) const {
  Line line;
  line.is_loop = path.is_loop;
  line.from = place_of(path.from);
  line.to = place_of(path.to);
  const Jump& first = jumps_[path.jumps.front()];
  const std::size_t on_left = path.first_on_left.front() != 0 ? 0 : 1;
  line.left = traced_.patches[first.ends[on_left]];
  line.right = traced_.patches[first.ends[1 - on_left]];
  double way = 0;
  std::optional<OnLine> spare;
  for (std::size_t i = 0; i < path.jumps.size(); ++i) {
    const auto& found = refined_[path.jumps[i]];
    if (!found) continue;
    OnLine point = *found;
    if (path.first_on_left[i] == 0) std::swap(point.wedge.normals[0], point.wedge.normals[1]);
    spare = point;
    const auto is_near = [&](const std::optional<Vector>& corner) {
      return corner && length(point.place - *corner) < corner_room;
    };
    if (is_near(line.from) || is_near(line.to)) continue;
    if (!line.points.empty()) {
      const Vector by = point.place - line.points.back().place;
      if (length(by) < spacing / 2) continue;
      if (dot(by, line.points.back().along()) <= 0) continue;
      way += length(by);
    }
    line.points.push_back(point);
  }
  if (!spare) return std::nullopt;
  close(line, path, way);
  if (line.is_loop) return way >= least_loop ? std::optional(line) : std::nullopt;
  // A way between triangles at one corner.
  if (line.points.empty()) {
    if (!line.from || !line.to || length(*line.to - *line.from) < one_corner) return std::nullopt;
    spare->place = 0.5 * (*line.from + *line.to);
    line.points.push_back(*spare);
    if (const auto found = onto_lines(domain_, line.points, context_); found[0]) line.points = {*found[0]};
    else return std::nullopt;
  }
  return line;
}

/// Points of curves between those that are known, so that their chords are short.
void Tracer::make_dense() {
  struct Gap {
    std::size_t line, after;  ///< the point with this number, counted from 1; 0 is the beginning
    Vector from, by;
  };
  std::vector<Gap> gaps;
  std::vector<OnLine> guesses;
  const auto fill = [&](std::size_t l, std::size_t after, const Vector& from, const Vector& to,
                        const Wedge& near_from, const Wedge& near_to) {
    const Vector by = to - from;
    const double parts = std::ceil(length(by) / spacing);
    for (double i = 1; i < parts; ++i) {
      gaps.push_back({l, after, from, by});
      guesses.push_back({from + (i / parts) * by, 2 * i < parts ? near_from : near_to});
    }
  };
  for (std::size_t l = 0; l < lines_.size(); ++l) {
    const Line& line = lines_[l];
    const auto& points = line.points;
    if (line.from) fill(l, 0, *line.from, points[0].place, points[0].wedge, points[0].wedge);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      fill(l, i + 1, points[i].place, points[i + 1].place, points[i].wedge, points[i + 1].wedge);
    const OnLine& last = points.back();
    if (line.to) fill(l, points.size(), last.place, *line.to, last.wedge, last.wedge);
    if (line.is_loop) fill(l, points.size(), last.place, points[0].place, last.wedge, points[0].wedge);
  }
  const auto found = onto_lines(domain_, guesses, context_);
  std::vector<Line> dense = lines_;
  for (Line& line : dense) line.points.clear();
  std::size_t g = 0;
  for (std::size_t l = 0; l < lines_.size(); ++l)
    for (std::size_t after = 0; after <= lines_[l].points.size(); ++after) {
      if (after > 0) dense[l].points.push_back(lines_[l].points[after - 1]);
      double farthest = 0;
      for (; g < gaps.size() && gaps[g].line == l && gaps[g].after == after; ++g) {
        if (!found[g]) continue;
        const double square = dot(gaps[g].by, gaps[g].by);
        const double share = dot(found[g]->place - gaps[g].from, gaps[g].by) / square;
        if (share <= farthest || share >= 1 ||
            length(found[g]->place - guesses[g].place) > 0.5 * std::sqrt(square))
          continue;
        farthest = share;
        dense[l].points.push_back(*found[g]);
      }
    }
  lines_ = std::move(dense);
}

void Tracer::store(const Line& line) {
  std::vector<std::pair<Coord3, Wedge>> points;
  const auto add = [&](const Vector& place, const Wedge& wedge) {
    if (const Coord3 p = in_steps(place); points.empty() || points.back().first != p)
      points.emplace_back(p, wedge);
  };
  if (line.from) add(*line.from, line.points.front().wedge);
  for (const OnLine& point : line.points) add(point.place, point.wedge);
  if (line.to) add(*line.to, line.points.back().wedge);
  if (line.is_loop) add(line.points.front().place, line.points.front().wedge);
  if (points.size() < 2) return;
  Features& features = traced_.features;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& [from, wedge] = points[i];
    const Coord3 to = points[i + 1].first;
    features.edges.push_back({from, to, line.left, line.right});
    if (line.left == line.right) continue;
    traced_.borders.push_back({line.left, in_doubles(from), in_doubles(to), wedge.into(0)});
    traced_.borders.push_back({line.right, in_doubles(from), in_doubles(to), wedge.into(1)});
  }
  if (line.is_loop) return;
  features.corners.push_back(points.front().first);
  features.corners.push_back(points.back().first);
}

/// Where a solid that samples tell of is cut off: across other edges there is but what is between
/// its samples.
MayJump rim_of(const Mesh& mesh, const SeenSurface& surface) {
  auto sides = std::make_shared<std::vector<Sides>>();
  for (const std::uint64_t v : surface.numbers) {
    Sides at = 0;
    for (const BorderBox& box : mesh.border) at |= box.sides_at(mesh.points[v]);
    sides->push_back(at);
  }
  return [sides](std::uint32_t v, std::uint32_t w) { return ((*sides)[v] | (*sides)[w]) != 0; };
}

}  // namespace

Traced trace(const Mesh& mesh, const PlacedDomain& domain, double angle, Context& context) {
  Traced traced;
  traced.surface = see_surface(mesh, domain, angle, context);
  const MayJump everywhere = [](std::uint32_t, std::uint32_t) { return true; };
  std::vector<Jump> jumps =
      find_jumps(traced.surface, domain, angle,
                 domain.is_sampled() ? rim_of(mesh, traced.surface) : everywhere, context);
  traced.patches = patches_of(traced.surface, jumps);
  Tracer(domain, context, traced, std::move(jumps)).run();
  return traced;
}

}  // namespace certet::features
