#pragma once
/// \file
/// Domains that come from Python.

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <span>

#include "certet/bounded_function.hpp"

namespace certet::python {

namespace py = pybind11;

/// Where a Python function of points is negative, within bounds that cut it off.  It is called with arrays of
/// shape (n, 3) in world coordinates, by one thread at a time, and gives n
/// numbers.  What it raises ends the run.  The function must live as long as the domain, which
/// may be made and destroyed without Python's lock.
class PythonDomain final : public PlacedDomain {
 public:
  /// `size` and `margin` are those of `lattice_around`.  \throws Error as that one.
  PythonDomain(const py::object& function, const Bounds& bounds, double size, std::int32_t margin)
      : function_(function),
        bounds_(bounds),
        around_(lattice_around(bounds, size, margin)),
        border_{BorderBox::along_frame(around_.frame, bounds.low, bounds.high)} {}

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return certet::longest_side(bounds_); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  void row(Coord3 first, std::span<Sign> out) const override;
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override;

 private:
  /// `position(i)` is in steps.
  template <class Position>
  void call(const Position& position, std::span<Sign> out) const;

  const py::object& function_;
  Bounds bounds_;
  PlacedLattice around_;
  std::array<BorderBox, 1> border_;
};

}  // namespace certet::python
