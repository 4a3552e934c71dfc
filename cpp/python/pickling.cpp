#include "pickling.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certet/error.hpp"

namespace certet::python {
namespace {

namespace py = pybind11;

/// To be changed with what a state holds.
std::string mark() {
  return std::string("5 ") + (std::endian::native == std::endian::little ? "little" : "big");
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

/// Names of patches, and where they are.
using Words = std::vector<std::pair<std::string, std::string>>;

Words state_of(const std::vector<PatchChoice>& patches) {
  Words words;
  for (const PatchChoice& patch : patches) words.emplace_back(patch.name, text_of(patch.where));
  return words;
}

py::list state_of(const std::vector<FileSurface>& patches) {
  py::list state;
  for (const FileSurface& patch : patches)
    state.append(py::make_tuple(patch.name, bytes_of(patch.faces)));
  return state;
}

using BorderBytes = std::array<std::byte, sizeof(BorderBox)>;

/// Which middle nodes are bent, and by how much; nothing of tetrahedra of four nodes.
py::object state_of_middles(const std::optional<PythonMiddles>& middles) {
  if (!middles) return py::none();
  std::vector<std::uint64_t> nodes;
  std::vector<Coord3> bends;
  for (const Bend& bend : middles->nodes.bends()) {
    nodes.push_back(bend.node);
    bends.push_back(bend.by);
  }
  py::object figures = py::none();
  if (const auto& f = middles->curved)
    figures = py::make_tuple(f->edges, f->moved, f->on_surface, f->guarded, f->far, f->seams,
                             f->greatest_move, f->least_jacobian);
  return py::make_tuple(bytes_of(nodes), bytes_of(bends), figures);
}

std::optional<PythonMiddles> middles_of_state(const Mesh& mesh, const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto parts = state.cast<py::tuple>();
  const auto nodes = values_of<std::vector<std::uint64_t>>(parts[0]);
  const auto by = values_of<std::vector<Coord3>>(parts[1]);
  MiddleNodes middles = middle_nodes(mesh);
  if (nodes.size() != by.size() || (!nodes.empty() && nodes.back() >= middles.count()) ||
      !std::ranges::is_sorted(nodes))
    refuse();
  std::vector<Bend> bends;
  for (std::size_t i = 0; i < nodes.size(); ++i) bends.push_back({nodes[i], by[i]});
  middles.set_bends(std::move(bends));
  std::optional<CurveFigures> curved;
  if (const py::object told = parts[2]; !told.is_none()) {
    const auto f = told.cast<py::tuple>();
    const auto whole = [&](std::size_t i) { return f[i].cast<std::uint64_t>(); };
    curved = {whole(0), whole(1), whole(2), whole(3), whole(4), whole(5), f[6].cast<double>(),
              f[7].cast<double>()};
  }
  return placed(mesh, std::move(middles), curved);
}

py::object state_of_figures(const std::optional<OptimiseFigures>& figures) {
  if (!figures) return py::none();
  const OptimiseFigures& f = *figures;
  return py::make_tuple(f.goal, f.rounds, f.moved, f.moved_on_surface, f.left_surface,
                        f.moved_on_seams, f.greatest_move, f.greatest_move_on_surface,
                        f.short_before, f.short_after);
}

std::optional<OptimiseFigures> figures_of_state(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto f = state.cast<py::tuple>();
  if (f.size() != 10) refuse();
  const auto whole = [&](std::size_t i) { return f[i].cast<std::uint64_t>(); };
  return OptimiseFigures{f[0].cast<double>(), f[1].cast<int>(), whole(2), whole(3), whole(4),
                         whole(5), f[6].cast<double>(), f[7].cast<double>(), whole(8), whole(9)};
}

py::object state_of_kept(const std::optional<FeatureFigures>& kept) {
  if (!kept) return py::none();
  return py::make_tuple(kept->length, kept->followed_length, kept->kept_length, kept->greatest_distance, kept->corners,
                        kept->kept_corners, kept->moved, kept->greatest_move);
}

std::optional<FeatureFigures> kept_of_state(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto f = state.cast<py::tuple>();
  if (f.size() != 8) refuse();
  const auto real = [&](std::size_t i) { return f[i].cast<double>(); };
  const auto whole = [&](std::size_t i) { return f[i].cast<std::uint64_t>(); };
  return FeatureFigures{real(0), real(1), real(2), real(3), whole(4), whole(5), whole(6), real(7)};
}

std::vector<std::uint64_t> numbers_of(const WarpFigures& warp) {
  std::vector<std::uint64_t> numbers{warp.violated, warp.stayed, warp.shortened};
  for (const CutShift* shift : {&warp.long_edges, &warp.short_edges, &warp.missed})
    numbers.insert(numbers.end(), {shift->cuts, static_cast<std::uint64_t>(shift->greatest),
                                   shift->sum_of_squares});
  return numbers;
}

WarpFigures warp_of_numbers(const std::vector<std::uint64_t>& n) {
  if (n.size() != 12) refuse();
  const auto shift = [&n](std::size_t i) {
    return CutShift{n[i], static_cast<std::int32_t>(n[i + 1]), n[i + 2]};
  };
  return {n[0], n[1], n[2], shift(3), shift(6), shift(9)};
}

py::object state_of_dropped(const std::optional<DroppedPieces>& dropped) {
  if (!dropped) return py::none();
  return py::make_tuple(dropped->pieces, dropped->tets, dropped->volume);
}

std::optional<DroppedPieces> dropped_of_state(const py::object& state) {
  if (state.is_none()) return std::nullopt;
  const auto d = state.cast<py::tuple>();
  if (d.size() != 3) refuse();
  return DroppedPieces{d[0].cast<std::uint64_t>(), d[1].cast<std::uint64_t>(), d[2].cast<double>()};
}

}  // namespace

py::tuple state_of(const PythonMesh& all) {
  const Mesh& mesh = all.mesh;
  std::vector<BorderBytes> border;
  for (const BorderBox& box : mesh.border) border.push_back(std::bit_cast<BorderBytes>(box));
  return py::make_tuple(
      mark(), bytes_of(mesh.points), mesh.tets.index(),
      std::visit([](const auto& tets) { return bytes_of(tets); }, mesh.tets), bytes_of(mesh.labels),
      mesh.frame.origin, mesh.frame.axes, mesh.frame.size, mesh.names, bytes_of(border),
      std::string(name(mesh.method)), all.notes, all.warnings,
      state_of_middles(all.middles), state_of_figures(all.optimised), state_of(mesh.patches),
      all.features.angle, all.features.why, state_of_kept(all.kept),
      all.losses, numbers_of(all.warp), state_of_dropped(all.dropped));
}

std::shared_ptr<PythonMesh> mesh_of_state(const py::tuple& pickled) {
  const py::tuple state = checked(pickled, 22);
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
  all->middles = middles_of_state(mesh, state[13]);
  all->optimised = figures_of_state(state[14]);
  for (const auto& [patch, where] : state[15].cast<Words>())
    mesh.patches.push_back(patch_choice(patch, where));
  all->features.angle = state[16].cast<std::optional<double>>();
  all->features.why = state[17].cast<std::string>();
  all->kept = kept_of_state(state[18]);
  all->losses = state[19].cast<std::vector<std::string>>();
  all->warp = warp_of_numbers(state[20].cast<std::vector<std::uint64_t>>());
  all->dropped = dropped_of_state(state[21]);
  return all;
}

py::tuple state_of(const FileMesh& mesh) {
  return py::make_tuple(mark(), bytes_of(mesh.points), bytes_of(mesh.tets), bytes_of(mesh.labels),
                        mesh.names, mesh.space, bytes_of(mesh.border),
                        bytes_of(mesh.middle_points), bytes_of(mesh.middles),
                        state_of(mesh.patches));
}

std::shared_ptr<FileMesh> file_mesh_of_state(const py::tuple& pickled) {
  const py::tuple state = checked(pickled, 10);
  auto mesh = std::make_shared<FileMesh>();
  mesh->points = values_of<std::vector<Point3>>(state[1]);
  mesh->tets = values_of<std::vector<Tet<std::uint64_t>>>(state[2]);
  mesh->labels = values_of<std::vector<std::int32_t>>(state[3]);
  mesh->names = state[4].cast<LabelNames>();
  mesh->space = state[5].cast<std::string>();
  mesh->border = values_of<std::vector<std::array<std::uint64_t, 3>>>(state[6]);
  mesh->middle_points = values_of<std::vector<Point3>>(state[7]);
  mesh->middles = values_of<std::vector<std::array<std::uint64_t, 6>>>(state[8]);
  for (const py::handle& patch : state[9].cast<py::list>()) {
    const auto parts = patch.cast<py::tuple>();
    mesh->patches.push_back({0, parts[0].cast<std::string>(),
                             values_of<std::vector<std::array<std::uint64_t, 3>>>(parts[1])});
  }
  if (!mesh->labels.empty() && mesh->labels.size() != mesh->tets.size()) refuse();
  if (!mesh->middles.empty() && mesh->middles.size() != mesh->tets.size()) refuse();
  return mesh;
}

}  // namespace certet::python
