#pragma once
/// \file
/// NumPy arrays over memory of the library, and back.

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
#include <span>

#include "certet/image.hpp"

namespace certet::python {

namespace py = pybind11;

/// Rows of N numbers as an array of shape (n, N) that shares their memory and
/// keeps `owner` alive.
template <class T, std::size_t N>
py::array rows(std::span<const std::array<T, N>> values, const py::handle& owner) {
  const auto count = static_cast<py::ssize_t>(values.size());
  const auto width = static_cast<py::ssize_t>(N);
  const auto item = static_cast<py::ssize_t>(sizeof(T));
  return py::array(py::dtype::of<T>(), {count, width}, {width * item, item}, values.data(),
                   owner);
}

/// The voxels of a three-dimensional array, its first axis running fastest.
/// \throws Error `bad_input` for other shapes and types.
Voxels voxels(const py::array& array, std::array<std::int64_t, 3>& size);

}  // namespace certet::python
