#include "trimmed_source.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "certet/trimmed_domain.hpp"
#include "output_place.hpp"

namespace certet::command {
namespace {

/// A little more than what all of them have in common, so that none has a face in its faces.
Bounds room_in(const std::vector<OpenedSolid>& solids) {
  Bounds room = solids.front().solid.bounds;
  for (const OpenedSolid& one : solids)
    for (std::size_t a = 0; a < 3; ++a) {
      room.low[a] = std::max(room.low[a], one.solid.bounds.low[a]);
      room.high[a] = std::min(room.high[a], one.solid.bounds.high[a]);
    }
  const double more = longest_side(room) / 64;
  for (std::size_t a = 0; a < 3; ++a) {
    room.low[a] -= more;
    room.high[a] += more;
  }
  return room;
}

std::vector<Solid> in_axes(const std::vector<OpenedSolid>& opened,
                           std::optional<PatientAxes> output) {
  std::vector<Solid> solids;
  for (const OpenedSolid& one : opened) solids.push_back(in_axes(one, output));
  return solids;
}

}  // namespace

bool needs_bounds(const MeshOptions& options) {
  const auto needs = [](const SolidChoice& solid) {
    return !solid.formula.empty() || !solid.shape.empty();
  };
  return !options.formula.empty() || !options.shape.empty() ||
         std::ranges::any_of(options.materials, needs, &MaterialChoice::solid) ||
         std::ranges::any_of(options.without, needs);
}

Trimming open_trimming(const MeshOptions& asked, std::uint64_t max_bytes,
                       const Context& context) {
  MeshOptions options = asked;
  Trimming trimming;
  const auto open = [&](const SolidChoice& choice, std::vector<OpenedSolid>& solids) {
    solids.push_back(open_solid(choice, false, options, max_bytes, context));
  };
  // Formulas have their box from the others.
  std::ranges::stable_partition(options.inside,
                                [](const SolidChoice& solid) { return solid.formula.empty(); });
  for (const SolidChoice& choice : options.inside) {
    if (!choice.formula.empty() && !options.bounds) options.bounds = room_in(trimming.inside);
    open(choice, trimming.inside);
  }
  if (!trimming.inside.empty()) trimming.bounds = room_in(trimming.inside);
  if (!options.bounds) options.bounds = trimming.bounds;
  for (const SolidChoice& choice : options.without) open(choice, trimming.without);
  return trimming;
}

Source trimmed(Source whole, Trimming trimming, const MeshOptions& options) {
  for (const auto* solids : {&trimming.inside, &trimming.without})
    for (const OpenedSolid& one : *solids)
      whole.notes.insert(whole.notes.end(), one.notes.begin(), one.notes.end());
  const std::optional<PatientAxes> output = output_axes(options, whole);
  whole.place = [place = std::move(whole.place),
                 inside = in_axes(trimming.inside, output),
                 without = in_axes(trimming.without, output)](double size) {
    return placed(trimmed_domain(place(size).domain, inside, without));
  };
  if (whole.voxels) whole.voxels->cropped = true;
  whole.smoothing.reset();
  if (whole.pieces) whole.pieces = unknown_pieces;
  return whole;
}

}  // namespace certet::command
