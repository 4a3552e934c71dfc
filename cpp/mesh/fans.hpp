#pragma once
/// \file
/// The triangles of a surface around one vertex.

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "groups.hpp"

namespace certet::core {

/// What a triangle is seen as from one of its corners: a step from one neighbour to
/// another; `sheet` is the surface that it is of.
struct FanStep {
  std::uint32_t sheet;
  std::uint64_t from, to;
  friend auto operator<=>(const FanStep&, const FanStep&) = default;
};

/// How many of the steps of one sheet, sorted, are gone when they are followed from a neighbour
/// until there is none or it is reached again, which is told.
struct Walk {
  std::size_t gone = 0;
  bool returned = false;
};
inline Walk walk_from(std::span<const FanStep> steps, std::uint64_t start) {
  Walk walk;
  for (std::uint64_t at = start; walk.gone < steps.size();) {
    const auto next = std::ranges::lower_bound(steps, at, {}, &FanStep::from);
    if (next == steps.end() || next->from != at) return walk;
    ++walk.gone;
    at = next->to;
    if (at == start) {
      walk.returned = true;
      return walk;
    }
  }
  return walk;
}

/// Whether the steps go once around.
inline bool is_closed_fan(std::span<const FanStep> steps) {
  const Walk walk = walk_from(steps, steps.front().from);
  return walk.returned && walk.gone == steps.size();
}

/// Whether they go from one neighbour to another without coming back.
inline bool is_open_fan(std::span<const FanStep> steps) {
  const auto is_start = [steps](const FanStep& step) {
    return std::ranges::find(steps, step.from, &FanStep::to) == steps.end();
  };
  const auto start = std::ranges::find_if(steps, is_start);
  if (start == steps.end()) return false;
  const Walk walk = walk_from(steps, start->from);
  return !walk.returned && walk.gone == steps.size();
}

/// An edge to a neighbour, and how often triangles run through it either way.
struct FanEdge {
  std::uint64_t end;
  std::uint64_t forwards, backwards;
  [[nodiscard]] std::uint64_t triangles() const { return forwards + backwards; }
};

/// Calls visit(edge) for the edges of one sheet's steps to higher points than the vertex, by
/// their ends.
template <class Visit>
void for_edges(std::uint64_t vertex, std::span<const FanStep> steps, const Visit& visit) {
  std::vector<std::uint64_t> ends;
  for (const FanStep& step : steps)
    for (const std::uint64_t end : {step.from, step.to})
      if (end > vertex) ends.push_back(end);
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const std::uint64_t end : ends)
    visit(FanEdge{end,
                  static_cast<std::uint64_t>(std::ranges::count(steps, end, &FanStep::from)),
                  static_cast<std::uint64_t>(std::ranges::count(steps, end, &FanStep::to))});
}

}  // namespace certet::core
