#pragma once
/// \file
/// Domains that come from Python.

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "certet/bounded_function.hpp"

namespace certet::python {

namespace py = pybind11;

/// A Python object that threads without Python's lock may copy and let go of.
using KeptFunction = std::shared_ptr<const py::object>;
/// To be called with the lock.
KeptFunction kept(py::object function);

/// Where a Python function of points is negative, within bounds that cut it off.  It is called with arrays of
/// shape (n, 3) in world coordinates, of `batch` points at most, by one thread at a time, and
/// gives n numbers.  What it raises ends the run.  It may be made and destroyed without Python's lock.
class PythonDomain final : public PlacedDomain {
 public:
  /// On a lattice that holds the bounds.
  PythonDomain(KeptFunction function, const Bounds& bounds, std::size_t batch,
               const PlacedLattice& around)
      : function_(std::move(function)),
        bounds_(bounds),
        batch_(batch),
        around_(around),
        border_{BorderBox::along_frame(around_.frame, bounds.low, bounds.high)} {}

  [[nodiscard]] const Frame& frame() const override { return around_.frame; }
  [[nodiscard]] const Lattice& lattice() const override { return around_.lattice; }
  [[nodiscard]] double longest_side() const override { return certet::longest_side(bounds_); }
  [[nodiscard]] std::span<const BorderBox> border() const override { return border_; }
  [[nodiscard]] std::size_t batch() const override { return batch_; }
  void row(Coord3 first, std::span<Sign> out) const override;
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override;

 private:
  /// `position(i)` is in steps.
  template <class Position>
  void ask(const Position& position, std::span<Sign> out) const;
  /// Once.
  template <class Position>
  void call(const Position& position, std::span<Sign> out) const;

  KeptFunction function_;
  Bounds bounds_;
  std::size_t batch_;
  PlacedLattice around_;
  std::array<BorderBox, 1> border_;
};

}  // namespace certet::python
