#include "files.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "arrays.hpp"
#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "pickling.hpp"
#include "python_mesh.hpp"
#include "run.hpp"

namespace certet::python {
namespace {

namespace fs = std::filesystem;
using namespace py::literals;

Format chosen_format(const fs::path& file, const std::optional<std::string>& name) {
  const std::optional<Format> format = name ? format_named(*name) : format_of(file);
  if (!format)
    throw Error(ErrorCode::bad_option, "the format of '" + file.string() + "' is none of " +
                                           format_names());
  return *format;
}

/// \returns what the format cannot hold.
template <class AnyMesh>
std::vector<std::string> write_mesh(const AnyMesh& mesh, const fs::path& file,
                                    const std::optional<std::string>& format) {
  std::vector<std::string> losses;
  Context context;
  run(context, [&] { losses = write(mesh, file, chosen_format(file, format), context); });
  return losses;
}

std::shared_ptr<FileMesh> read_file(const fs::path& file) {
  auto mesh = std::make_shared<FileMesh>();
  Context context;
  run(context, [&] { *mesh = read(file, context); });
  return mesh;
}

py::dict told(const CheckReport& report) {
  return py::dict("failures"_a = report.failures, "points"_a = report.points,
                  "tets"_a = report.quality.tets, "boundary_faces"_a = report.boundary_faces);
}

template <class AnyMesh>
py::dict check_mesh(const AnyMesh& mesh) {
  Context context;
  CheckReport report;
  run(context, [&] { report = check(mesh, context); });
  return told(report);
}

py::dict quality_of_file(const FileMesh& mesh) {
  Quality found;
  Context context;
  run(context, [&] { found = quality(mesh); });
  return py::dict("tets"_a = found.tets, "volume"_a = found.volume,
                  "min_dihedral"_a = found.min_dihedral, "max_dihedral"_a = found.max_dihedral,
                  "histogram"_a = found.histogram);
}

template <class T, std::size_t N>
py::array shared(const std::vector<std::array<T, N>>& values, const py::object& owner) {
  return rows(std::span(values.data(), values.size()), owner);
}

}  // namespace

void declare_files(py::module_& module) {
  py::class_<FileMesh, std::shared_ptr<FileMesh>>(module, "FileMesh")
      .def_property_readonly(
          "points", [](const py::object& self) {
            return shared(self.cast<const FileMesh&>().points, self);
          })
      .def_property_readonly(
          "tets", [](const py::object& self) {
            return shared(self.cast<const FileMesh&>().tets, self);
          })
      .def_property_readonly("labels", [](const py::object& self) -> py::object {
        const auto& labels = self.cast<const FileMesh&>().labels;
        if (labels.empty()) return py::none();
        return py::array(py::dtype::of<std::int32_t>(),
                         {static_cast<py::ssize_t>(labels.size())},
                         {static_cast<py::ssize_t>(sizeof(std::int32_t))}, labels.data(), self);
      })
      .def_property_readonly(
          "middle_points", [](const py::object& self) -> py::object {
            const auto& mesh = self.cast<const FileMesh&>();
            if (mesh.middles.empty()) return py::none();
            return shared(mesh.middle_points, self);
          })
      .def_property_readonly(
          "middles", [](const py::object& self) -> py::object {
            const auto& mesh = self.cast<const FileMesh&>();
            if (mesh.middles.empty()) return py::none();
            return shared(mesh.middles, self);
          })
      .def_property_readonly("names", [](const FileMesh& mesh) { return mesh.names; })
      .def(py::pickle([](const FileMesh& mesh) { return state_of(mesh); },
                      [](const py::tuple& state) { return file_mesh_of_state(state); }))
      .def("quality", quality_of_file);
  module.def("read", read_file);
  module.def("write", [](const PythonMesh& mesh, const fs::path& file,
                         const std::optional<std::string>& format) {
    if (!mesh.middles) return write_mesh(mesh.mesh, file, format);
    std::vector<std::string> losses;
    Context context;
    run(context, [&] {
      losses = write(mesh.mesh, mesh.middles->nodes, file, chosen_format(file, format), context);
    });
    return losses;
  });
  module.def("write", write_mesh<FileMesh>);
  module.def("check", [](const PythonMesh& mesh) { return check_mesh(mesh.mesh); });
  module.def("check", [](const FileMesh& mesh) { return check_mesh(mesh); });
}

}  // namespace certet::python
