#include "domains.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "certet/error.hpp"

namespace certet::python {

KeptFunction kept(py::object function) {
  return {new py::object(std::move(function)), [](const py::object* object) {
            const py::gil_scoped_acquire locked;
            delete object;
          }};
}

template <class Position>
void PythonDomain::ask(const Position& position, std::span<Sign> out) const {
  for (std::size_t begin = 0; begin < out.size(); begin += batch_)
    call([&](std::size_t i) { return position(begin + i); },
         out.subspan(begin, std::min(batch_, out.size() - begin)));
}

template <class Position>
void PythonDomain::call(const Position& position, std::span<Sign> out) const {
  const py::gil_scoped_acquire locked;
  const auto count = static_cast<py::ssize_t>(out.size());
  py::array_t<double> points({count, py::ssize_t{3}});
  double* to = points.mutable_data();
  for (std::size_t i = 0; i < out.size(); ++i) to = std::ranges::copy(frame().world(position(i)), to).out;
  const py::array_t<double, py::array::c_style | py::array::forcecast> values = (*function_)(points);
  if (values.size() != count)
    throw Error(ErrorCode::bad_input, "the function gave " + std::to_string(values.size()) +
                                          " numbers for " + std::to_string(count) + " points");
  const double* point = points.data();
  for (std::size_t i = 0; i < out.size(); ++i, point += 3) {
    const double outside = beyond(bounds_, {point[0], point[1], point[2]});
    const double value = values.data()[i];
    out[i] = std::isnan(value) ? Sign::minus : sign_of_level(std::max(value, outside));
  }
}

void PythonDomain::row(Coord3 first, std::span<Sign> out) const {
  ask([first](std::size_t i) {
    return steps * (first + Coord3{2 * static_cast<std::int32_t>(i), 0, 0});
  }, out);
}

void PythonDomain::at(std::span<const Coord3> positions, std::span<Sign> out) const {
  ask([positions](std::size_t i) { return positions[i]; }, out);
}

}  // namespace certet::python
