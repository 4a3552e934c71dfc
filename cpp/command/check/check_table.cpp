#include <algorithm>
#include <functional>
#include <span>
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

/// What one should know of a part: of a region in several pieces, or what is no manifold.
std::string conspicuous(const RegionReport& region) {
  return pieces_of(region.pieces) + faults_of(region.nonmanifold);
}
std::string conspicuous(const InterfaceReport& interface) {
  return faults_of(interface.nonmanifold);
}

std::string called(const RegionReport& region, const LabelNames& names) {
  return name_of(region.label, names);
}
std::string called(const InterfaceReport& interface, const LabelNames& names) {
  return pair_of(interface, names);
}

/// Of many the worst, by points that are no manifold; `sound` says what others are.
template <class Part>
void add_conspicuous(Lines& lines, const std::vector<Part>& all, const LabelNames& names,
                     std::string_view sound) {
  std::vector<const Part*> found;
  for (const Part& part : all)
    if (!conspicuous(part).empty()) found.push_back(&part);
  std::ranges::stable_sort(found, std::greater(),
                           [](const Part* part) { return part->nonmanifold.vertices; });
  const std::size_t shown = std::min(found.size(), most_conspicuous);
  for (const Part* part : std::span(found).first(shown))
    lines.add("", "{}: {}", called(*part, names), conspicuous(*part).substr(2));
  if (found.empty())
    lines.add("", "each {}; --json has all", sound);
  else if (shown < found.size())
    lines.add("", "{} more like these; --json has all", grouped(found.size() - shown));
  else
    lines.add("", "all others {}; --json has all", sound);
}

template <class Part>
void add_parts(Lines& lines, const std::vector<Part>& all, const LabelNames& names,
               std::string_view sound) {
  if (all.size() > most_rows) return add_conspicuous(lines, all, names, sound);
  for (const Part& part : all) lines.add("", "{}", told(part, names));
}

void add_regions(Lines& lines, const CheckedFile& checked) {
  const auto& all = checked.regions;
  if (all.size() < 2) return;
  const auto volume = [](const RegionReport& region) { return region.quality.volume; };
  const auto [least, most] = std::ranges::minmax_element(all, {}, volume);
  lines.add("regions", "{}, of volumes from {:.6g} ({}) to {:.6g} ({})", grouped(all.size()),
            volume(*least), name_of(least->label, checked.names), volume(*most),
            name_of(most->label, checked.names));
  add_parts(lines, all, checked.names, "in one piece, and a manifold");
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
  add_parts(lines, all, checked.names, "a manifold");
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
  if (checked.distance) add_distance(lines, *checked.distance);
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
