#pragma once
/// \file
/// Meshes of many pieces, which touch and hang together in every way.

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "certet/stuffing.hpp"
#include "domains.hpp"
#include "plain_pieces.hpp"

namespace piece_cases {

using namespace certet;
using domains::Positional;

inline const Frame frame{{3, -1, 2}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0.5};

inline plain::Mesh emitted(const Stuffing& stuffing) {
  Context context;
  const Mesh mesh = emit(stuffing, frame, context);
  plain::Mesh result;
  for (const Coord3& p : mesh.points) result.points.push_back(frame.world(p));
  for (const auto& t : std::get<0>(mesh.tets)) result.tets.push_back({t[0], t[1], t[2], t[3]});
  result.labels.assign(mesh.labels.begin(), mesh.labels.end());
  return result;
}

/// A mesh, and the domain that it may ask.
struct Case {
  std::unique_ptr<Positional> domain;
  Stuffing stuffing;
};

/// Noise, sparse noise, and blocks of a few cells, in lattices with more layers than one
/// task joins, or more cells along a row than a word has.
inline Case random_case(int n) {
  const std::uint64_t seed = mixed(test_seed(), n);
  const Positional noise = domains::random_cuts(seed, 20, {10, 9000, 20000, 32768, 50000});
  const auto in_blocks = [=](Coord3 p, int size, std::uint64_t parts) {
    const auto cell = [=](std::int32_t c) { return (c - 20000) >> size; };
    return mixed(seed, cell(p.x), cell(p.y), cell(p.z)) % parts == 0;
  };
  const Positional sparse([=](Coord3 p) {
    return in_blocks(p, 18, 4) ? noise.sign_at(p) : Sign::minus;
  });
  const Positional boxes([=](Coord3 p) {
    return in_blocks(p, 17, 3) ? Sign::plus : Sign::minus;
  });
  const std::array<const Positional*, 3> all{&noise, &sparse, &boxes};
  const std::array<Lattice, 3> lattices{{{{-6, -8, -40}, {6, 7, 38}},
                                         {{-70, -8, -6}, {72, 6, 7}},
                                         {{-6, -8, -4}, {9, 12, 9}}}};
  auto domain = std::make_unique<Positional>(*all[static_cast<std::size_t>(n) % 3]);
  Context context;
  Stuffing stuffing(*domain, lattices[static_cast<std::size_t>(n / 12) % 3],
          methods[static_cast<std::size_t>(n / 3) % 4].method, context);
  return {std::move(domain), std::move(stuffing)};
}

}  // namespace piece_cases
