#include "surface_source.hpp"

#include <fmt/format.h>

#include <utility>

#include "certet/error.hpp"
#include "silence.hpp"

namespace certet::command {
namespace {

std::string counted(const SurfaceDefect& defect, const char* one, const char* many) {
  return fmt::format("{} {}", defect.count, defect.count == 1 ? one : many);
}

std::string place(const SurfaceDefect& defect) {
  const auto& [x, y, z] = defect.first;
  return fmt::format("{}at ({:.6g}, {:.6g}, {:.6g})", defect.count == 1 ? "" : "the first ", x,
                     y, z);
}

std::string remedy(const SurfaceDefects& defects) {
  if (defects.holes.count == 0) return "--repair drops it";
  return defects.holes.count == 1 ? "--repair closes it" : "--repair closes them";
}

/// Of an open surface inside is told by the winding number, whatever its edges say.
std::vector<std::string> notes_on(const TriangleSurface& surface,
                                  const SurfaceDefects& defects, bool open) {
  std::vector<std::string> notes;
  const bool by_parity = !open && defects.misoriented_edges.count != 0;
  if (by_parity)
    notes.push_back(fmt::format(
        "the triangles of '{}' do not agree which side is out along {}, {}; inside is what an "
        "odd number of triangles separate from the outside",
        surface.name, counted(defects.misoriented_edges, "edge", "edges"),
        place(defects.misoriented_edges)));
  if (defects.self_intersections.count != 0)
    notes.push_back(fmt::format(
        "the surface '{}' passes through itself in {}, {}; {}", surface.name,
        counted(defects.self_intersections, "pair of triangles", "pairs of triangles"),
        place(defects.self_intersections),
        by_parity ? "what is twice inside is outside"
                  : "what is inside more than once is inside"));
  if (defects.inside_out)
    notes.push_back(fmt::format(
        "the surface '{}' is inside out; what it encloses is meshed", surface.name));
  return notes;
}

std::string note_on(const SurfaceSize& size, const SurfaceMeasures& solid) {
  if (size.size == size.usual) return "";
  if (!size.limited())
    return fmt::format("the size {:.6g} is chosen for parts of the solid that are {:.3g} thick",
                       size.size, solid.thin);
  return fmt::format("the size {:.6g} is chosen for parts of the solid that are {:.3g} thick; "
                     "without --size it is not smaller, so that there are no more than some "
                     "{:.0f} million tetrahedra and {:.0f} million cells",
                     size.size, solid.thin, most_default_tets / 1e6, most_default_cells / 1e6);
}

}  // namespace

CheckedSurface open_surface(const std::filesystem::path& file, bool close_holes,
                           const Context& context) {
  CheckedSurface result;
  {
    const Silence silence;
    result.surface = read_surface(file);
  }
  const SurfaceRepairs repairs = repair_surface(result.surface, {close_holes}, context);
  result.notes = sentences_on(repairs);
  result.open = repairs.closed_holes.count != 0;
  const SurfaceDefects& defects = result.defects = inspect(result.surface, context);
  if (result.open) refuse_unclear(result.surface, context);
  else refuse_open(result.surface, defects, close_holes ? "" : remedy(defects));
  for (std::string& note : notes_on(result.surface, defects, result.open))
    result.notes.push_back(std::move(note));
  result.measures = measure(result.surface, context);
  result.size = default_size(result.surface, result.measures);
  result.size_note = note_on(result.size, result.measures);
  return result;
}

}  // namespace certet::command
