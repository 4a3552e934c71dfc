#include "check_report.hpp"
#include "pieces.hpp"
#include "table.hpp"

namespace certet::command {

namespace {

std::string covered(const CheckedFile& checked) {
  return checked.run ? fmt::format("; what the run wrote, within theorem {}",
                                   checked.run->bounds.theorem)
                     : "";
}

}  // namespace

std::string table(const CheckedFile& checked) {
  const CheckReport& report = checked.report;
  Lines lines;
  lines.add("mesh", "{}", checked.file);
  lines.add("", "{} points, {} tetrahedra, {} boundary faces", grouped(report.points),
            grouped(report.quality.tets), grouped(report.boundary_faces));
  lines.add("pieces", "{}", sentence(checked.pieces, report.quality.tets));
  if (checked.pieces.surface.vertices > 0)
    lines.add("surface", "{}", sentence(checked.pieces.surface));
  lines.add("volume", "{:.9g}", report.quality.volume);
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
