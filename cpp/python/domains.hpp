#pragma once
/// \file
/// Domains that come from Python.

#include <pybind11/numpy.h>

#include <utility>

#include "certet/bounds.hpp"
#include "certet/domain.hpp"
#include "certet/frame.hpp"

namespace certet::python {

namespace py = pybind11;

/// Where a Python function of points is negative, within bounds that cut it off.  It is called with arrays of
/// shape (n, 3) in world coordinates, by one thread at a time, and gives n
/// numbers.  What it raises ends the run.
class PythonDomain final : public Domain {
 public:
  PythonDomain(py::object function, const Frame& frame, const Bounds& bounds)
      : function_(std::move(function)), frame_(frame), bounds_(bounds) {}

  void row(Coord3 first, std::span<Sign> out) const override;
  void at(std::span<const Coord3> positions, std::span<Sign> out) const override;

 private:
  /// `position(i)` is in steps.
  template <class Position>
  void call(const Position& position, std::span<Sign> out) const;

  py::object function_;
  Frame frame_;
  Bounds bounds_;
};

}  // namespace certet::python
