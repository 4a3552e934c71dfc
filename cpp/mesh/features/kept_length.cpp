#include "kept_length.hpp"

#include <algorithm>
#include <cmath>

namespace certet::features {
namespace {

/// In long edges, between points of a curve at which it is measured.
constexpr double interval = 1.0 / 16;

using Ends = std::array<Coord3, 2>;

distance::TriangleTree tree_of(const std::vector<Ends>& edges) {
  std::vector<Vector> points;
  std::vector<distance::Triangle> segments;
  for (const Ends& edge : edges) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (const Coord3 end : edge) points.push_back(in_doubles(end));
    segments.push_back({first, first + 1, first + 1});
  }
  return {std::move(points), std::move(segments)};
}

std::vector<Ends> surface_edges(const Zone& zone) {
  std::vector<Ends> edges;
  for (Number v = 0; v < zone.size(); ++v)
    for (const auto& [next, last] : zone.fan(v))
      if (v < next || !zone.on_surface(next)) edges.push_back({zone.place(v), zone.place(next)});
  return edges;
}

/// Where along a curve an edge of its chain begins and ends, if both are exactly on it.
struct Piece {
  double from, to;
};

/// Those edges of a chain that follow the curve, and what of the curve they do.
void follow(const Zone& zone, const Curve& curve, const Chain& chain, std::vector<Ends>& edges,
            std::vector<Piece>& pieces) {
  constexpr double one_step = 1;
  for (std::size_t i = 0; i + 1 < chain.vertices.size(); ++i) {
    const Ends ends{zone.place(chain.vertices[i]), zone.place(chain.vertices[i + 1])};
    const CurvePoint from = curve.nearest(in_doubles(ends[0])), to = curve.nearest(in_doubles(ends[1]));
    if (from.away > one_step || to.away > one_step) continue;
    edges.push_back(ends);
    pieces.push_back({from.at, to.at});
    Piece& piece = pieces.back();
    if (!curve.is_loop()) {
      // Both ends may be one corner.
      if (i == 0 && in_doubles(ends[0]) == curve.points().front()) piece.from = 0;
      if (i + 2 == chain.vertices.size() && in_doubles(ends[1]) == curve.points().back())
        piece.to = curve.length();
      continue;
    }
    // On from the first, the shorter way.
    piece.to += std::round((piece.from - piece.to) / curve.length()) * curve.length();
  }
}

}  // namespace

FeatureFigures measure_features(const Zone& zone, const std::vector<Curve>& curves,
                                const std::vector<Chain>& chains) {
  FeatureFigures figures;
  const std::vector<Ends> all = surface_edges(zone);
  if (all.empty()) {
    for (const Curve& curve : curves) figures.length += curve.length() / long_edge;
    return figures;
  }
  const distance::TriangleTree surface = tree_of(all);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Curve& curve = curves[c];
    std::vector<Ends> edges;
    std::vector<Piece> pieces;
    follow(zone, curve, chains[c], edges, pieces);
    double followed = 0;
    for (const Piece& piece : pieces) followed += piece.to - piece.from;
    figures.followed_length += std::min(followed, curve.length()) / long_edge;
    std::optional<distance::TriangleTree> chain;
    if (!edges.empty()) chain = tree_of(edges);
    const double length = curve.length() / long_edge, parts = std::ceil(length / interval);
    figures.length += length;
    double kept = 0;
    for (double i = 0; i < parts; ++i) {
      const Vector place = curve.place((i + 0.5) / parts * curve.length());
      const double away = std::sqrt(surface.nearest(place).square) / long_edge;
      figures.greatest_distance = std::max(figures.greatest_distance, away);
      kept += chain && std::sqrt(chain->nearest(place).square) <= kept_distance * long_edge;
    }
    figures.kept_length += length * (kept / parts);
  }
  return figures;
}

}  // namespace certet::features
