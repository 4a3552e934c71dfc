#pragma once
/// \file
/// The conformance kit as the tests of the engine read it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "certet/lattice.hpp"
#include "certet/lattice/stencil.hpp"
#include "differences.hpp"
#include "domains.hpp"

namespace certet {

inline void from_json(const nlohmann::json& json, Coord3& p) {
  p = {json.at(0).get<std::int32_t>(), json.at(1).get<std::int32_t>(),
       json.at(2).get<std::int32_t>()};
}
inline void to_json(nlohmann::json& json, const Coord3& p) { json = {p.x, p.y, p.z}; }

}  // namespace certet

namespace conformance {

using certet::Coord3;
using certet::Lattice;
using certet::Sign;
using nlohmann::json;

inline const json& kit() {
  static const json kit = json::parse(std::ifstream(CERTET_KIT));
  return kit;
}

inline Sign sign_of(char c) {
  return c == '+' ? Sign::plus : c == '0' ? Sign::on_surface : Sign::minus;
}

template <std::size_t n>
std::array<Sign, n> signs_of(const std::string& text) {
  std::array<Sign, n> signs{};
  std::ranges::transform(text, signs.begin(), sign_of);
  return signs;
}

/// Expects an answer to be what the kit says; both are shown if it is not.
inline void expect(Differences& differences, const std::string& what, const json& answer,
                   const json& expected) {
  differences.expect(answer == expected, [&] {
    return what + ": " + answer.dump().substr(0, 200) + " instead of " +
           expected.dump().substr(0, 200);
  });
}

/// "3" for a corner, "14" for a cut.
inline std::string name_of(certet::StencilVertex v) {
  std::string name(1, static_cast<char>('1' + v.a));
  if (v.is_cut()) name += static_cast<char>('1' + v.b);
  return name;
}

/// The domain of a mesh case: an edge changes its sign after the cut.
inline domains::Positional domain_of(const json& c) {
  std::map<Coord3, Sign> signs;
  std::map<std::pair<Coord3, Coord3>, std::int32_t> cuts;
  const Coord3 origin = c.at("origin").get<Coord3>();
  for (const int shift : {0, 1}) {
    const json& grid = c.at(shift == 0 ? "even" : "odd");
    for (int k = 0; k < static_cast<int>(grid.size()); ++k) {
      const json& layer = grid[static_cast<std::size_t>(k)];
      for (int j = 0; j < static_cast<int>(layer.size()); ++j) {
        const auto& row = layer[static_cast<std::size_t>(j)].get_ref<const std::string&>();
        for (int i = 0; i < static_cast<int>(row.size()); ++i)
          signs[origin + 2 * Coord3{i, j, k} + Coord3{shift, shift, shift}] =
              sign_of(row[static_cast<std::size_t>(i)]);
      }
    }
  }
  for (const json& cut : c.at("cut"))
    cuts[{Coord3{cut[0], cut[1], cut[2]}, Coord3{cut[3], cut[4], cut[5]}}] =
        cut[6].get<std::int32_t>();
  return domains::Positional([=](Coord3 p) {
    const auto [a, b, t] = domains::edge_of(p);
    const auto sign = [&](Coord3 v) {
      const auto at = signs.find(v);
      return at == signs.end() ? Sign::minus : at->second;
    };
    if (t == 0) return sign(a);
    if (const auto cut = cuts.find({a, b}); cut != cuts.end())
      return t <= cut->second ? Sign::plus : Sign::minus;
    if (const auto cut = cuts.find({b, a}); cut != cuts.end())
      return certet::steps - t <= cut->second ? Sign::plus : Sign::minus;
    return Sign::minus;
  });
}

inline void expect_none(const Differences& differences, long at_least) {
  EXPECT_TRUE(differences.empty()) << differences;
  EXPECT_GE(differences.compared(), at_least);
}

}  // namespace conformance
