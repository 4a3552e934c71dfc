#include "certet/optimise.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "buckets.hpp"
#include "certet/error.hpp"
#include "descent.hpp"
#include "engine/border.hpp"
#include "engine/parallel.hpp"
#include "freedom.hpp"
#include "mesh/boundary.hpp"
#include "onto_surface.hpp"
#include "short_ones.hpp"
#include "star.hpp"
#include "stars.hpp"
#include "worst_angles.hpp"

namespace certet::optimising {
namespace {

constexpr double long_edge = 2.0 * steps;

/// A squared cosine must fall by so much for a vertex to move: at first, and in the end.
constexpr double first_gain = 1e-3, last_gain = 1e-4;
/// How far from the worst angle others still count when a direction is chosen.
constexpr std::array<double, 3> bands{0.08, 0.02, 0.005};
constexpr double room = 2;  ///< degrees beyond the goal that neighbours of those that are left move for
constexpr int moves_at_once = 3;  ///< of a vertex, before the next one's turn
constexpr int passes_in_round = 30;

double squared_cosine(double degrees) {
  const double cosine = std::cos(degrees * (std::numbers::pi / 180));
  return cosine * cosine;
}

double reach_of(Place place) {
  switch (place) {
    case Place::inside: return interior_reach;
    case Place::surface: return surface_reach;
    case Place::seam: return seam_reach;
    case Place::corner: break;
  }
  return 0;
}

/// That of a vertex which may leave its surface.
Freedom loosened(const Freedom& freedom) {
  return {Place::inside, {}, freedom.held, {}};
}

/// What all vertices share while they move.
template <class Index>
struct Moving {
  const Mesh& mesh;
  std::span<const Tet<Index>> tets;
  Buffer<Coord3>& points;
  std::span<const Coord3> origins;  ///< where the points were
  std::span<float> worst;           ///< of tetrahedra, in squared cosines
  std::span<std::uint8_t> stirred;  ///< of vertices: something around has moved
  std::span<Place> places;          ///< of vertices that were to move
  std::span<std::uint8_t> left;     ///< of vertices: whether they left their surface
  bool labelled;                    ///< regions are cut apart by labels
  const Domain& domain;
  double goal;
  double aim;                       ///< as far as vertices move, once their turn has come
  double least_gain;
  bool loose;                       ///< vertices may leave their surfaces
  Bars least_bars;                  ///< of the mesh as it was
};

/// Finds how vertices may move.
template <class Index>
class FreedomFinder {
 public:
  explicit FreedomFinder(const Moving<Index>& moving) : moving_(moving) {}

  Freedom find(std::uint64_t vertex, std::span<const StarTet> around) {
    faces_.start(3 * around.size());
    for (const StarTet at : around) {
      const Tet<Index>& tet = moving_.tets[at.tet()];
      const std::int32_t label = moving_.labelled ? moving_.mesh.labels[at.tet()] : 0;
      for (std::size_t opposite = 0; opposite < 4; ++opposite) {
        if (opposite == at.corner()) continue;
        const auto& [a, b, c] = core::outward_faces[opposite];
        if (a == at.corner()) faces_.add(tet[b], tet[c], label);
        else if (b == at.corner()) faces_.add(tet[c], tet[a], label);
        else faces_.add(tet[a], tet[b], label);
      }
    }
    faces_.surfaces(found_);
    sheets_.clear();
    const Coord3 own = moving_.points[vertex];
    for (const VertexFace& face : found_) {
      const auto& [next, last] = face.others;
      sheets_.push_back({face,
                         {between(own, moving_.points[next]), between(own, moving_.points[last])},
                         face.outer && on_border(vertex) && on_border(next) && on_border(last)});
    }
    return freedom_of(sheets_, moving_.labelled);
  }

 private:
  [[nodiscard]] bool on_border(std::uint64_t point) const {
    return !moving_.mesh.border.empty() &&
           core::is_on_border(moving_.origins[point], moving_.mesh.border, Cuts::bisect);
  }

  const Moving<Index>& moving_;
  VertexFaces faces_;
  std::vector<VertexFace> found_;
  std::vector<Sheet> sheets_;
};

/// A vertex that is to move.
struct Vertex {
  std::uint64_t number;
  std::span<const StarTet> around;
  std::optional<Freedom> freedom = {};  ///< once it was needed
};

template <class Index>
class Mover {
 public:
  explicit Mover(Moving<Index>& moving) : moving_(moving), finder_(moving) {}

  bool improve(Vertex& vertex);

 private:
  void load(const Vertex& vertex);
  /// Where it may leave its surface it does so within `loose_reach`.
  bool descend(const Vertex& vertex, double worst, bool loose);
  bool try_at(const Vertex& vertex, const Vector& by, const Bars& bars, bool loose);
  bool put(const Vertex& vertex, Coord3 place);
  [[nodiscard]] bool is_near(const Vertex& vertex, Coord3 place, double reach) const {
    const Vector by = between(moving_.origins[vertex.number], place);
    return dot(by, by) <= reach * reach * (long_edge * long_edge);
  }
  /// As settling may leave a cut.
  [[nodiscard]] bool was_beside_surface(const Vertex& vertex) const {
    constexpr double as_bisection = 4;
    return !onto_surface(moving_.origins[vertex.number], *vertex.freedom, as_bisection,
                         moving_.domain);
  }

  Moving<Index>& moving_;
  FreedomFinder<Index> finder_;
  Star star_;
  std::vector<Vector> gradients_;
};

template <class Index>
void Mover<Index>::load(const Vertex& vertex) {
  star_.clear();
  for (const StarTet at : vertex.around) {
    TetCorners corners;
    for (std::size_t c = 0; c < 4; ++c) corners[c] = moving_.points[moving_.tets[at.tet()][c]];
    star_.add(at.tet(), corners, at.corner(), moving_.worst[at.tet()]);
  }
}

template <class Index>
bool Mover<Index>::improve(Vertex& vertex) {
  double worst = 0;
  for (const StarTet at : vertex.around)
    worst = std::max(worst, static_cast<double>(moving_.worst[at.tet()]));
  if (worst <= moving_.aim) return false;
  if (!vertex.freedom) {
    vertex.freedom = finder_.find(vertex.number, vertex.around);
    moving_.places[vertex.number] = vertex.freedom->place;
  }
  bool any = false;
  load(vertex);
  for (int move = 0; move < moves_at_once; ++move) {
    worst = star_.worst();
    if (worst <= moving_.aim) break;
    if (!descend(vertex, worst, false) &&
        !(moving_.loose && vertex.freedom->place != Place::inside &&
          descend(vertex, worst, true)))
      break;
    any = true;
  }
  return any;
}

template <class Index>
bool Mover<Index>::descend(const Vertex& vertex, double worst, bool loose) {
  const Freedom freedom = loose ? loosened(*vertex.freedom) : *vertex.freedom;
  const double bar = worst - moving_.least_gain;
  const Bars bars{std::min(bar, moving_.least_bars.acute), std::min(bar, moving_.least_bars.obtuse)};
  for (const double band : bands) {
    gradients_.clear();
    for (const Spoke& spoke : star_.spokes())
      if (spoke.worst >= worst - band) spoke.gradients(worst - band, gradients_);
    for (Vector& gradient : gradients_) gradient = freedom.part_of(gradient);
    if (gradients_.empty()) continue;
    const Vector shortest = shortest_in_hull(gradients_);
    const double slope = length(shortest);
    // Too slow to gain anything within a quarter of an edge.
    if (!(slope * (long_edge / 4) > moving_.least_gain)) continue;
    const double farthest =
        std::min(band / slope, long_edge * (loose ? loose_reach / 2 : interior_reach / 2));
    for (double far = farthest; far > farthest / 10; far /= 2)
      if (try_at(vertex, (-far / slope) * shortest, bars, loose)) return true;
  }
  return false;
}

template <class Index>
bool Mover<Index>::try_at(const Vertex& vertex, const Vector& by, const Bars& bars, bool loose) {
  const Coord3 own = moving_.points[vertex.number];
  const Coord3 place = moved(own, by);
  const auto keeps = [&](Coord3 at, double reach) {
    return is_near(vertex, at, reach) && star_.keeps(between(own, at), bars);
  };
  if (loose) {
    if (!keeps(place, loose_reach)) return false;
    moving_.left[vertex.number] = 1;
    return put(vertex, place);
  }
  if (!keeps(place, reach_of(vertex.freedom->place))) return false;
  if (vertex.freedom->place != Place::surface) return put(vertex, place);
  if (const auto on = onto_surface(place, *vertex.freedom, length(by), moving_.domain))
    return keeps(*on, surface_reach) && put(vertex, *on);
  return is_near(vertex, place, seam_reach) && was_beside_surface(vertex) && put(vertex, place);
}

template <class Index>
bool Mover<Index>::put(const Vertex& vertex, Coord3 place) {
  star_.move(between(moving_.points[vertex.number], place));
  moving_.points[vertex.number] = place;
  for (const Spoke& spoke : star_.spokes()) moving_.worst[spoke.tet] = static_cast<float>(spoke.worst);
  for (const StarTet at : vertex.around)
    for (const Index corner : moving_.tets[at.tet()]) moving_.stirred[corner] = 1;
  return true;
}

/// Marks those that share a tetrahedron with one that is marked.
template <class Index>
void mark_neighbours(std::span<const Tet<Index>> tets, std::span<std::uint8_t> marked) {
  constexpr std::uint8_t itself = 1, neighbour = 2;
  for (const Tet<Index>& tet : tets)
    if (std::ranges::any_of(tet, [&](Index corner) { return marked[corner] == itself; }))
      for (const Index corner : tet)
        if (marked[corner] == 0) marked[corner] = neighbour;
}

/// All vertices at tetrahedra short of the goal, again and again.
template <class Index>
bool run_round(Moving<Index>& moving, Context& context) {
  std::vector<std::uint8_t> marked(moving.points.size());
  bool any = false;
  ShortOnes(moving.worst, moving.goal).visit([&](std::size_t t) {
    any = true;
    for (const Index corner : moving.tets[t]) marked[corner] = 1;
  });
  if (!any) return false;
  if (moving.aim < moving.goal) mark_neighbours<Index>(moving.tets, marked);
  const Stars stars(moving.tets, marked);
  std::vector<Vertex> vertices;
  std::vector<Coord3> places;
  for (std::size_t i = 0; i < stars.vertices().size(); ++i) {
    const std::uint64_t v = stars.vertices()[i];
    vertices.push_back({v, stars.around(i)});
    places.push_back(moving.origins[v]);
    moving.stirred[v] = 1;
  }
  const Buckets buckets = buckets_of(places);
  std::atomic<bool> moved{false};
  for (int pass = 0; pass < passes_in_round; ++pass) {
    std::atomic<bool> moved_now{false};
    for (const std::vector<Bucket>& colour : buckets.colours)
      core::parallel_for(context, Stage::emit, static_cast<std::int64_t>(colour.size()),
                         [&](std::int64_t task) {
                           Mover<Index> mover(moving);
                           const Bucket bucket = colour[static_cast<std::size_t>(task)];
                           for (std::uint32_t i = bucket.begin; i < bucket.end; ++i) {
                             Vertex& vertex = vertices[buckets.order[i]];
                             if (moving.stirred[vertex.number] == 0) continue;
                             moving.stirred[vertex.number] = 0;
                             if (mover.improve(vertex)) moved_now = true;
                           }
                         });
    if (!moved_now) break;
    moved = true;
  }
  return moved;
}

/// \returns the number of rounds in which anything moved.
template <class Index>
int run_rounds(Moving<Index>& moving, int greatest, Context& context) {
  int rounds = 0;
  while (rounds < greatest && run_round(moving, context)) ++rounds;
  return rounds;
}

template <class Index>
OptimiseFigures optimise_all(Mesh& mesh, std::span<const Tet<Index>> tets,
                             const Domain& domain, const OptimiseGoal& goal, Context& context) {
  Buffer<Coord3> origins(mesh.points.size());
  std::ranges::copy(mesh.points, origins.begin());
  WorstAngles found = worst_angles(std::span<const Coord3>(mesh.points), tets, context);
  std::vector<std::uint8_t> stirred(mesh.points.size());
  std::vector<Place> places(mesh.points.size());
  std::vector<std::uint8_t> left(mesh.points.size());
  Moving<Index> moving{mesh,
                       tets,
                       mesh.points,
                       origins,
                       {found.of_tets.data(), found.of_tets.size()},
                       stirred,
                       places,
                       left,
                       facts(mesh.method).interfaces && !mesh.labels.empty(),
                       domain,
                       squared_cosine(goal.angle),
                       squared_cosine(goal.angle),
                       first_gain,
                       false,
                       {found.acute, found.obtuse}};
  const auto short_ones = [&] { return ShortOnes(moving.worst, moving.goal).count(); };
  OptimiseFigures figures;
  figures.goal = goal.angle;
  figures.short_before = short_ones();
  // The worst first, for whom vertices leave their surfaces last.
  moving.goal = moving.aim = squared_cosine(std::min(dire_angle, goal.angle));
  figures.rounds = run_rounds(moving, goal.rounds, context);
  moving.loose = true;
  figures.rounds += run_rounds(moving, goal.rounds, context);
  moving.loose = false;
  moving.goal = moving.aim = squared_cosine(goal.angle);
  figures.rounds += run_rounds(moving, goal.rounds, context);
  // Those that are left are hemmed in by others, which make room.
  moving.least_gain = last_gain;
  moving.aim = squared_cosine(goal.angle + room);
  figures.rounds += run_rounds(moving, goal.rounds, context);
  figures.short_after = short_ones();
  for (std::uint64_t v = 0; v < mesh.points.size(); ++v) {
    if (mesh.points[v] == origins[v]) continue;
    ++figures.moved;
    const double by = length(between(origins[v], mesh.points[v])) / long_edge;
    figures.greatest_move = std::max(figures.greatest_move, by);
    const Place place = places[v];
    if (place == Place::inside) continue;
    ++figures.moved_on_surface;
    figures.left_surface += left[v];
    figures.moved_on_seams += place == Place::seam;
    figures.greatest_move_on_surface = std::max(figures.greatest_move_on_surface, by);
  }
  return figures;
}

}  // namespace
}  // namespace certet::optimising

namespace certet {

OptimiseFigures optimise(Mesh& mesh, const Domain& domain, const OptimiseGoal& goal,
                         Context& context) {
  if (!(goal.angle > 0 && goal.angle <= greatest_goal))
    throw Error(ErrorCode::bad_option, "the angle to be reached is from 0 to 60 degrees");
  if (facts(mesh.method).cuts == Cuts::midpoint)
    throw Error(ErrorCode::bad_option,
                "vertices cannot move along a surface that passes the middles of edges");
  try {
    return std::visit(
        [&]<class Index>(const Buffer<Tet<Index>>& tets) {
          return optimising::optimise_all<Index>(mesh, tets, domain, goal, context);
        },
        mesh.tets);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "out of memory to optimise the mesh");
  }
}

}  // namespace certet
