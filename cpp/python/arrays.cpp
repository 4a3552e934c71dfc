#include "arrays.hpp"

#include <cstring>
#include <optional>
#include <string>

#include "certet/error.hpp"

namespace certet::python {
namespace {

template <class T>
Buffer<T> copy(const py::array& array) {
  const auto ordered = py::array_t<T, py::array::f_style | py::array::forcecast>::ensure(array);
  if (!ordered) throw py::error_already_set();
  Buffer<T> buffer(static_cast<std::size_t>(ordered.size()));
  std::memcpy(buffer.data(), ordered.data(), buffer.size() * sizeof(T));
  return buffer;
}

template <class T>
bool is(const py::array& array) {
  return py::isinstance<py::array_t<T>>(array);
}

/// Labels of 64 bits, if all fit 32.
Buffer<std::int32_t> narrowed(const py::array& array) {
  const auto wide = py::array_t<std::int64_t, py::array::f_style | py::array::forcecast>(array);
  Buffer<std::int32_t> buffer(static_cast<std::size_t>(wide.size()));
  for (std::size_t i = 0; i < buffer.size(); ++i) {
    const std::int64_t label = wide.data()[i];
    if (!std::in_range<std::int32_t>(label))
      throw Error(ErrorCode::bad_input, "the array has label " + std::to_string(label) +
                                            ", which does not fit 32 bits with a sign");
    buffer[i] = static_cast<std::int32_t>(label);
  }
  return buffer;
}

}  // namespace

Voxels voxels(const py::array& array, std::array<std::int64_t, 3>& size) {
  if (array.ndim() != 3)
    throw Error(ErrorCode::bad_input,
                "the array has " + std::to_string(array.ndim()) + " dimensions, not 3");
  if (array.size() == 0) throw Error(ErrorCode::bad_input, "the array has no voxels");
  for (std::size_t a = 0; a < 3; ++a) size[a] = array.shape(static_cast<py::ssize_t>(a));
  if (is<bool>(array) || is<std::uint8_t>(array)) return copy<std::uint8_t>(array);
  if (is<std::int8_t>(array)) return copy<std::int8_t>(array);
  if (is<std::uint16_t>(array)) return copy<std::uint16_t>(array);
  if (is<std::int16_t>(array)) return copy<std::int16_t>(array);
  if (is<std::uint32_t>(array)) return copy<std::uint32_t>(array);
  if (is<std::int32_t>(array)) return copy<std::int32_t>(array);
  if (is<std::int64_t>(array) || is<std::uint64_t>(array)) return narrowed(array);
  if (is<float>(array)) return copy<float>(array);
  if (is<double>(array)) return copy<double>(array);
  throw Error(ErrorCode::bad_input, "the array's numbers are of type '" +
                                        py::str(array.dtype()).cast<std::string>() +
                                        "', which no image has");
}

}  // namespace certet::python
