#include <algorithm>
#include <vector>

#include "check_report.hpp"
#include "curved.hpp"
#include "pieces.hpp"
#include "table.hpp"

namespace certet::command {

namespace {

/// So many regions or interfaces are told one by one; of more, only so many that one should
/// know of.
constexpr std::size_t most_rows = 6, most_conspicuous = 4;

std::string pieces_of(const PieceCount& pieces) {
  if (pieces.by_faces == 1) return "";
  return fmt::format(", {} pieces by faces, {} by vertices", grouped(pieces.by_faces),
                     grouped(pieces.by_vertices));
}

std::string faults_of(const ManifoldFaults& faults) {
  if (faults.vertices == 0) return "";
  return fmt::format(", no manifold at {} edges and {} vertices", grouped(faults.edges),
                     grouped(faults.vertices));
}

std::string pair_of(const InterfaceReport& interface, const LabelNames& names) {
  return fmt::format("{} | {}", name_of(interface.labels[0], names),
                     name_of(interface.labels[1], names));
}

std::string told(const RegionReport& region, const LabelNames& names) {
  return fmt::format("{}: {} tetrahedra, volume {:.6g}, {:.3f}° to {:.3f}°, area {:.6g}{}{}",
                     name_of(region.label, names), grouped(region.quality.tets),
                     region.quality.volume, region.quality.min_dihedral,
                     region.quality.max_dihedral, region.area, pieces_of(region.pieces),
                     faults_of(region.nonmanifold));
}

std::string told(const InterfaceReport& interface, const LabelNames& names) {
  return fmt::format("{}: {} triangles, area {:.6g}{}", pair_of(interface, names),
                     grouped(interface.triangles), interface.area,
                     faults_of(interface.nonmanifold));
}

bool is_conspicuous(const RegionReport& region) {
  return region.pieces.by_faces > 1 || region.nonmanifold.vertices > 0;
}
bool is_conspicuous(const InterfaceReport& interface) {
  return interface.nonmanifold.vertices > 0;
}

/// All of a few; of many those that are not `sound`, which says what the others are.
template <class Part>
void add_parts(Lines& lines, const std::vector<Part>& all, const LabelNames& names,
               std::string_view sound) {
  std::vector<const Part*> shown;
  for (const Part& part : all)
    if (all.size() <= most_rows || is_conspicuous(part)) shown.push_back(&part);
  const std::size_t found = shown.size();
  if (all.size() > most_rows) shown.resize(std::min(found, most_conspicuous));
  for (const Part* part : shown) lines.add("", "{}", told(*part, names));
  if (shown.size() < found)
    lines.add("", "{} more like these", grouped(found - shown.size()));
  if (found < all.size())
    lines.add("", "{} {}{}; --json has all", grouped(all.size() - found),
              found == 0 ? "" : "others, ", sound);
}

void add_regions(Lines& lines, const CheckedFile& checked) {
  const auto& all = checked.regions;
  if (all.size() < 2) return;
  const auto volume = [](const RegionReport& region) { return region.quality.volume; };
  const auto [least, most] = std::ranges::minmax_element(all, {}, volume);
  lines.add("regions", "{}, of volumes from {:.6g} ({}) to {:.6g} ({})", grouped(all.size()),
            volume(*least), name_of(least->label, checked.names), volume(*most),
            name_of(most->label, checked.names));
  add_parts(lines, all, checked.names, "each in one piece, and a manifold");
}

void add_interfaces(Lines& lines, const CheckedFile& checked) {
  const auto& all = checked.interfaces;
  if (all.empty()) return;
  std::uint64_t triangles = 0;
  double area = 0;
  for (const InterfaceReport& interface : all)
    triangles += interface.triangles, area += interface.area;
  lines.add("interfaces", "{} of {} triangles, area {:.6g}", grouped(all.size()),
            grouped(triangles), area);
  add_parts(lines, all, checked.names, "each a manifold");
}

std::string covered(const CheckedFile& checked) {
  return checked.run ? fmt::format("; what the run wrote, within theorem {}",
                                   checked.run->bounds.theorem)
                     : "";
}

/// What most people look for stands before what it is made of.
void add_verdict(Lines& lines, const CheckedFile& checked) {
  const std::vector<std::string>& failures = checked.report.failures;
  lines.add("verdict", "{}",
            failures.empty() ? "valid, positive, conforming and closed" + covered(checked)
            : failures.size() == 1 ? "one property is broken"
                                   : fmt::format("{} properties are broken", failures.size()));
  for (const std::string& failure : failures) lines.add("defect", "{}", failure);
}

}  // namespace

std::string name_of(std::int32_t label, const LabelNames& names) {
  const auto named = names.find(label);
  return named == names.end() ? std::to_string(label) : named->second;
}

std::string table(const CheckedFile& checked) {
  constexpr std::size_t bins_together = 3;
  const CheckReport& report = checked.report;
  Lines lines;
  lines.add("mesh", "{}", checked.file);
  lines.add("", "{} points, {} tetrahedra, {} boundary faces", grouped(report.points),
            grouped(report.quality.tets), grouped(report.boundary_faces));
  add_verdict(lines, checked);
  if (checked.curved) add_curved(lines, *checked.curved);
  lines.add("pieces", "{}", sentence(checked.pieces, report.quality.tets));
  if (checked.pieces.surface.vertices > 0)
    lines.add("surface", "{}", sentence(checked.pieces.surface));
  lines.add("volume", "{:.9g}", report.quality.volume);
  add_regions(lines, checked);
  add_interfaces(lines, checked);
  add_angles(lines, report.quality);
  add_histogram(lines, report.quality, bins_together);
  lines.add("seconds", "read {:.2f}, check {:.2f}, total {:.2f}; memory peak {}",
            checked.read_seconds, checked.check_seconds, checked.total_seconds,
            bytes(checked.memory_peak));
  return std::move(lines).text();
}

}  // namespace certet::command
