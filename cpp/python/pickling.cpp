#include "pickling.hpp"

#include <pybind11/stl.h>

#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certet/error.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

/// To be changed with what a state holds.
std::string mark() {
  return std::string("1 ") + (std::endian::native == std::endian::little ? "little" : "big");
}

[[noreturn]] void refuse() {
  throw Error(ErrorCode::bad_input, "the pickled mesh is damaged, or of another version of certet");
}

template <class Values>
py::bytes bytes_of(const Values& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values.data()[0])};
}

/// A Buffer or a vector, of whole values.
template <class Values>
Values values_of(const py::handle& bytes) {
  using Value = std::remove_cvref_t<decltype(std::declval<Values>()[0])>;
  const auto text = bytes.cast<std::string_view>();
  if (text.size() % sizeof(Value) != 0) refuse();
  Values values(text.size() / sizeof(Value));
  if (!text.empty()) std::memcpy(values.data(), text.data(), text.size());
  return values;
}

py::tuple checked(const py::tuple& state, std::size_t size) {
  if (state.size() != size || !py::isinstance<py::str>(state[0]) ||
      state[0].cast<std::string>() != mark())
    refuse();
  return state;
}

using BorderBytes = std::array<std::byte, sizeof(BorderBox)>;

}  // namespace

py::tuple state_of(const PythonMesh& all) {
  const Mesh& mesh = all.mesh;
  std::vector<BorderBytes> border;
  for (const BorderBox& box : mesh.border) border.push_back(std::bit_cast<BorderBytes>(box));
  return py::make_tuple(
      mark(), bytes_of(mesh.points), mesh.tets.index(),
      std::visit([](const auto& tets) { return bytes_of(tets); }, mesh.tets), bytes_of(mesh.labels),
      mesh.frame.origin, mesh.frame.axes, mesh.frame.size, mesh.names, bytes_of(border),
      std::string(name(mesh.method)), all.notes, all.warnings);
}

std::shared_ptr<PythonMesh> mesh_of_state(const py::tuple& pickled) {
  const py::tuple state = checked(pickled, 13);
  auto all = std::make_shared<PythonMesh>();
  Mesh& mesh = all->mesh;
  mesh.points = values_of<Buffer<Coord3>>(state[1]);
  if (state[2].cast<int>() == 0)
    mesh.tets = values_of<Buffer<Tet<std::uint32_t>>>(state[3]);
  else
    mesh.tets = values_of<Buffer<Tet<std::uint64_t>>>(state[3]);
  mesh.labels = values_of<Buffer<std::int32_t>>(state[4]);
  mesh.frame = {state[5].cast<Point3>(), state[6].cast<std::array<std::array<double, 3>, 3>>(),
                state[7].cast<double>()};
  mesh.names = state[8].cast<LabelNames>();
  for (const BorderBytes& bytes : values_of<std::vector<BorderBytes>>(state[9]))
    mesh.border.push_back(std::bit_cast<BorderBox>(bytes));
  const auto method = method_named(state[10].cast<std::string>());
  if (!method || (!mesh.labels.empty() && mesh.labels.size() != mesh.tet_count())) refuse();
  mesh.method = *method;
  all->notes = state[11].cast<std::vector<std::string>>();
  all->warnings = state[12].cast<std::vector<std::string>>();
  all->world = world_points(mesh);
  return all;
}

py::tuple state_of(const FileMesh& mesh) {
  return py::make_tuple(mark(), bytes_of(mesh.points), bytes_of(mesh.tets), bytes_of(mesh.labels),
                        mesh.names, mesh.space, bytes_of(mesh.border));
}

std::shared_ptr<FileMesh> file_mesh_of_state(const py::tuple& pickled) {
  const py::tuple state = checked(pickled, 7);
  auto mesh = std::make_shared<FileMesh>();
  mesh->points = values_of<std::vector<Point3>>(state[1]);
  mesh->tets = values_of<std::vector<Tet<std::uint64_t>>>(state[2]);
  mesh->labels = values_of<std::vector<std::int32_t>>(state[3]);
  mesh->names = state[4].cast<LabelNames>();
  mesh->space = state[5].cast<std::string>();
  mesh->border = values_of<std::vector<std::array<std::uint64_t, 3>>>(state[6]);
  if (!mesh->labels.empty() && mesh->labels.size() != mesh->tets.size()) refuse();
  return mesh;
}

}  // namespace certet::python
