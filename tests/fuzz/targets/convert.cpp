// What `certet convert` does with a mesh: what it wrote is read again, and must be the
// same mesh.

#include <algorithm>
#include <cmath>
#include <map>

#include "certet/formats.hpp"
#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {
namespace {

using certet::FileMesh;
using certet::Format;

constexpr std::array readable{Format::vtu,  Format::vtu_zlib, Format::medit, Format::medit_binary,
                              Format::gmsh, Format::gmsh22};
constexpr std::array written{Format::abaqus, Format::febio, Format::nastran, Format::dyna,
                             Format::mfem,   Format::xdmf, Format::vtkhdf, Format::tetgen, Format::stl, Format::ply};
constexpr std::array<std::string_view, 16> names{"a.vtu", "a.vtu", "a.mesh", "a.meshb",
                                                 "a.msh", "a.msh", "a.inp",  "a.feb",
                                                 "a.bdf", "a.k", "a.mfem", "a.xdmf", "a.vtkhdf",
                                                 "a.node", "a.stl", "a.ply"};

/// No two NaN need have the same bits.
bool has_nan(const FileMesh& mesh) {
  for (const certet::Point3& point : mesh.points)
    for (const double coordinate : point)
      if (std::isnan(coordinate)) return true;
  return false;
}

/// Those of a mesh without any are all the same, in formats that must have some.  Gmsh's are
/// positive: where one is not, all are counted anew.
bool labels_agree(const FileMesh& mesh, const FileMesh& copy) {
  if (copy.labels == mesh.labels) return true;
  if (std::ranges::all_of(mesh.labels, [](std::int32_t label) { return label > 0; }) &&
      !mesh.labels.empty())
    return false;
  std::map<std::int32_t, std::int32_t> there, back;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const std::int32_t one = mesh.labels.empty() ? 0 : mesh.labels[i];
    const std::int32_t other = copy.labels.empty() ? 0 : copy.labels[i];
    if (there.emplace(one, other).first->second != other) return false;
    if (back.emplace(other, one).first->second != one) return false;
  }
  return true;
}

void judge_copy(const FileMesh& mesh, const FileMesh& copy) {
  if (copy.points.size() != mesh.points.size() || copy.tets != mesh.tets)
    throw Finding("what was written is another mesh");
  if (!has_nan(mesh) && certet::checksum(mesh) != certet::checksum(copy))
    throw Finding("what was written has other points");
  if (!labels_agree(mesh, copy)) throw Finding("what was written has other labels");
}

}  // namespace

void convert(Bytes bytes) {
  if (bytes.empty()) return;
  const std::size_t to = bytes[0] % names.size();
  const InputFolder folder;
  read_mesh_or_refuse(bytes.subspan(1), [&](const FileMesh& mesh, certet::Context& context) {
    const auto path = folder.path() / names[to];
    const bool again = to < readable.size();
    certet::write(mesh, path, again ? readable[to] : written[to - readable.size()], context);
    if (!again) return;
    try {
      judge_copy(mesh, certet::read(path, context));
    } catch (const certet::Error& error) {
      throw Finding(std::string("what was written cannot be read: ") + error.what());
    }
  });
}

}  // namespace fuzz
