#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "report.hpp"

namespace certet::command {
namespace {

/// Digits in groups of three.
std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), 1, ',');
  return digits;
}

std::string bytes(std::uint64_t count) {
  if (count < 10'000) return fmt::format("{} bytes", count);
  double size = static_cast<double>(count) / 1024;
  for (const char* unit : {"KiB", "MiB", "GiB"}) {
    if (size < 1000) return fmt::format("{:.3g} {}", size, unit);
    size /= 1024;
  }
  return fmt::format("{:.3g} TiB", size);
}

class Lines {
 public:
  template <class... Values>
  void add(std::string_view title, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), "{:<11}{}\n", title,
                   fmt::format(format, std::forward<Values>(values)...));
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void add_histogram(Lines& lines, const Quality& quality) {
  const auto& bins = quality.histogram;
  const std::uint64_t most = *std::max_element(bins.begin(), bins.end());
  std::uint64_t all = 0;
  for (const std::uint64_t bin : bins) all += bin;
  if (most == 0) return;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    if (bins[b] == 0) continue;
    const double share = static_cast<double>(bins[b]) / static_cast<double>(most);
    lines.add("", "{:>3}-{:<3}° {:>6.2f} % {}", 5 * b, 5 * b + 5,
              100.0 * static_cast<double>(bins[b]) / static_cast<double>(all),
              std::string(static_cast<std::size_t>(40 * share + 0.5), '#'));
  }
}

void add_angles(Lines& lines, const Quality& quality) {
  lines.add("dihedral", "{:.3f}° to {:.3f}°", quality.min_dihedral, quality.max_dihedral);
}

void add_guarantee(Lines& lines, const MeshReport& report) {
  lines.add("proven", "{:.3f}° to {:.3f}°, theorem {}", report.bounds.min_dihedral,
            report.bounds.max_dihedral, report.bounds.theorem);
  if (report.cuts == Cuts::midpoint) return;
  lines.add("thresholds", "{}{}", name(report.used),
            report.used == report.asked
                ? ""
                : fmt::format(" (those of {} inverted {} dropped tetrahedra)",
                              name(report.asked), grouped(report.inverted_tets)));
}

}  // namespace

std::string table(const MeshReport& report) {
  Lines lines;
  lines.add("input", "{} ({})", report.input_name, report.input_kind);
  if (!report.output.empty() || report.dry_run)
    lines.add("output", "{} ({}, {}){}",
              report.output.empty() ? "none" : report.output, report.format,
              bytes(report.output_bytes), report.dry_run ? ", not written" : "");
  lines.add("lattice", "{} x {} x {} cells of size {:.6g}, cuts {}", report.cells[0],
            report.cells[1], report.cells[2], report.size, name(report.cuts));
  lines.add("mesh", "{} points, {} tetrahedra", grouped(report.points), grouped(report.tets));
  if (!report.dry_run) {
    lines.add("volume", "{:.9g}", report.written.world.volume);
    lines.add("checksum", "0x{:016x}", report.written.checksum);
    add_angles(lines, report.written.world);
    // In exact coordinates an angle on the edge between two bins is in its own.
    add_histogram(lines, report.written.lattice);
  }
  add_guarantee(lines, report);
  lines.add("seconds", "read {:.2f}, sample {:.2f}, cut {:.2f}, warp {:.2f}, count {:.2f}",
            report.read_seconds, report.sample_seconds, report.cut_seconds,
            report.warp_seconds, report.count_seconds);
  if (!report.dry_run)
    lines.add("", "emit {:.2f}, measure {:.2f}, write {:.2f}", report.written.emit_seconds,
              report.written.measure_seconds, report.written.write_seconds);
  lines.add("", "total {:.2f}", report.total_seconds);
  lines.add("memory", "needed {}, peak {}, limit {}", bytes(report.memory_needed),
            bytes(report.memory_peak), bytes(report.memory_limit));
  return std::move(lines).text();
}

std::string table(const CheckedFile& checked) {
  const CheckReport& report = checked.report;
  Lines lines;
  lines.add("mesh", "{}", checked.file);
  lines.add("", "{} points, {} tetrahedra, {} boundary faces", grouped(report.points),
            grouped(report.quality.tets), grouped(report.boundary_faces));
  lines.add("volume", "{:.9g}", report.quality.volume);
  add_angles(lines, report.quality);
  add_histogram(lines, report.quality);
  for (const std::string& failure : report.failures) lines.add("defect", "{}", failure);
  lines.add("verdict", "{}",
            report.failures.empty()
                ? "valid, positive, conforming and closed"
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
