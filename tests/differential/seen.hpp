#pragma once
/// \file
/// A domain as the certified functions see it.

#include <cstdint>

#include "certet/method.hpp"
#include "certified.hpp"
#include "domains.hpp"

inline certified::Diagonals diagonals_of(certet::Method method) {
  return certet::facts(method).diagonals_follow_cuts ? certified::Diagonals::by_key
                                                     : certified::Diagonals::by_parity;
}

/// By the cuts of a method.  `domain` outlives it.
inline certified::Domain seen_by(certet::Method method, const domains::Positional& domain) {
  using certet::Coord3;
  using certet::Sign;
  const bool midpoint_cuts = certet::facts(method).cuts == certet::Cuts::midpoint;
  const auto bisected = [&domain](Coord3 plus, Coord3 minus) {
    return certified::bisect([&](std::int64_t t) {
      return domain.sign_at(certified::point_on_edge(plus, minus, t));
    });
  };
  const std::int64_t midpoint = certified::constants().midpoint_cut;
  return {[=, &domain](Coord3 v) {
            const Sign sign = domain.sign_at(certified::warped_position(v, {}));
            // `InOrOut` of the certificate.
            return midpoint_cuts && sign == Sign::on_surface ? Sign::plus : sign;
          },
          [=](Coord3 plus, Coord3 minus) {
            return midpoint_cuts ? midpoint : bisected(plus, minus);
          }};
}
