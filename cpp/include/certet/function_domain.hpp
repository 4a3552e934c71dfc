#pragma once
/// \file
/// Domains given by a function of world coordinates.

#include <cstddef>
#include <utility>

#include "certet/domain.hpp"
#include "certet/frame.hpp"

namespace certet {

/// The points where a function is negative; where it is 0 is the surface, and
/// NaN counts as outside.  `Function` is callable as double(Point3), const, from
/// several threads at once.
///
///     const Frame frame{.size = 0.1};
///     const FunctionDomain ball([](Point3 p) { return …; }, frame);
template <class Function>
class FunctionDomain final : public Domain {
 public:
  FunctionDomain(Function function, const Frame& frame)
      : function_(std::move(function)), frame_(frame) {}

  [[nodiscard]] const Frame& frame() const { return frame_; }

  void row(Coord3 first, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = sign(steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0}));
  }

  void at(std::span<const Coord3> positions, std::span<Sign> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = sign(positions[i]);
  }

 private:
  [[nodiscard]] Sign sign(Coord3 position) const {
    return sign_of_level(function_(frame_.world(position)));
  }

  Function function_;
  Frame frame_;
};

}  // namespace certet
