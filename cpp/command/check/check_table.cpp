#include <algorithm>
#include <span>

#include "check_report.hpp"
#include "curved.hpp"
#include "pieces.hpp"
#include "table.hpp"

namespace certet::command {

namespace {

/// More regions or interfaces than these are not told one by one.
constexpr std::size_t most_rows = 12;

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

void add_rest(Lines& lines, std::size_t all) {
  if (all > most_rows) lines.add("", "and {} more, which --json tells", grouped(all - most_rows));
}

void add_regions(Lines& lines, const CheckedFile& checked) {
  const auto& all = checked.regions;
  if (all.size() < 2) return;
  lines.add("regions", "{}", grouped(all.size()));
  for (const RegionReport& region : std::span(all).first(std::min(all.size(), most_rows)))
    lines.add("", "{}: {} tetrahedra, volume {:.6g}, {:.3f}° to {:.3f}°, area {:.6g}{}{}",
              name_of(region.label, checked.names), grouped(region.quality.tets),
              region.quality.volume, region.quality.min_dihedral, region.quality.max_dihedral,
              region.area, pieces_of(region.pieces), faults_of(region.nonmanifold));
  add_rest(lines, all.size());
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
  for (const InterfaceReport& interface : std::span(all).first(std::min(all.size(), most_rows)))
    lines.add("", "{} | {}: {} triangles, area {:.6g}{}",
              name_of(interface.labels[0], checked.names),
              name_of(interface.labels[1], checked.names), grouped(interface.triangles),
              interface.area, faults_of(interface.nonmanifold));
  add_rest(lines, all.size());
}

std::string covered(const CheckedFile& checked) {
  return checked.run ? fmt::format("; what the run wrote, within theorem {}",
                                   checked.run->bounds.theorem)
                     : "";
}

}  // namespace

std::string name_of(std::int32_t label, const LabelNames& names) {
  const auto named = names.find(label);
  return named == names.end() ? std::to_string(label) : named->second;
}

std::string table(const CheckedFile& checked) {
  const CheckReport& report = checked.report;
  Lines lines;
  lines.add("mesh", "{}", checked.file);
  lines.add("", "{} points, {} tetrahedra, {} boundary faces", grouped(report.points),
            grouped(report.quality.tets), grouped(report.boundary_faces));
  if (checked.curved) add_curved(lines, *checked.curved);
  lines.add("pieces", "{}", sentence(checked.pieces, report.quality.tets));
  if (checked.pieces.surface.vertices > 0)
    lines.add("surface", "{}", sentence(checked.pieces.surface));
  lines.add("volume", "{:.9g}", report.quality.volume);
  add_regions(lines, checked);
  add_interfaces(lines, checked);
  add_angles(lines, report.quality);
  add_histogram(lines, report.quality);
  for (const std::string& failure : report.failures) lines.add("defect", "{}", failure);
  lines.add("verdict", "{}",
            report.failures.empty()
                ? "valid, positive, conforming and closed" + covered(checked)
                : fmt::format("{} broken", report.failures.size() == 1
                                               ? std::string("one property is")
                                               : fmt::format("{} properties are",
                                                             report.failures.size())));
  lines.add("seconds", "read {:.2f}, check {:.2f}, total {:.2f}", checked.read_seconds,
            checked.check_seconds, checked.total_seconds);
  lines.add("memory", "peak {}", bytes(checked.memory_peak));
  return std::move(lines).text();
}

}  // namespace certet::command
