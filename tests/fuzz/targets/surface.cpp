#include "certet/surface.hpp"

#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void surface(Bytes bytes) {
  if (bytes.empty()) return;
  static constexpr std::array<std::string_view, 4> extensions{".stl", ".obj", ".ply", ".off"};
  const InputFile file = chosen_file(bytes, extensions);
  read_or_refuse([&] {
    const certet::TriangleSurface read = certet::read_surface(file.path());
    for (const auto& triangle : read.triangles)
      for (const std::uint32_t point : triangle)
        if (point >= read.points.size()) throw Finding("a triangle has a point that is not there");
    certet::inspect(read);
    certet::TriangleSurface repaired = read;
    const bool close_holes = bytes.back() % 2 != 0;
    const certet::SurfaceRepairs repairs = certet::repair_surface(repaired, {close_holes});
    static_cast<void>(sentences_on(repairs));
    certet::inspect(repaired);
    if (certet::is_closed(read) && !certet::is_closed(repaired))
      throw Finding("a closed surface was repaired and is open");
    const bool open = repairs.closed_holes.count != 0;
    if (open) certet::refuse_unclear(repaired);
    const auto domain = open ? certet::open_surface_domain(repaired, {})
                             : certet::surface_domain(repaired, {});
    std::array<certet::Sign, 8> signs;
    domain->row(domain->lattice().origin, signs);
  });
}

}  // namespace fuzz
