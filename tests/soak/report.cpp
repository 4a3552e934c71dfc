#include "report.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace soak {
namespace {

struct Row {
  std::uint64_t domains = 0, empty = 0, tets = 0, fell_back = 0, volumes = 0, thin = 0, faulty = 0;
  double min_dihedral = 180, max_dihedral = 0;

  void add(const Verdict& v) {
    ++domains;
    empty += v.tets == 0;
    tets += v.tets;
    fell_back += v.fell_back;
    volumes += v.volume_compared;
    thin += v.thin;
    faulty += !v.faults.empty();
    min_dihedral = std::min(min_dihedral, v.min_dihedral);
    max_dihedral = std::max(max_dihedral, v.max_dihedral);
  }
};

Row row_of(const Summary& summary, int kind) {
  Row row;
  for (const Verdict& v : summary.verdicts)
    if (kind < 0 || v.kind == static_cast<Kind>(kind)) row.add(v);
  return row;
}

void write_row(std::ostream& out, std::string_view name, const Row& row) {
  out << "| " << name << " | " << row.domains << " | " << row.empty << " | " << row.tets << " | "
      << row.fell_back << " | " << row.volumes << " | " << row.thin << " | "
      << row.min_dihedral << " | " << row.max_dihedral << " | " << row.faulty << " |\n";
}

void json_row(std::ostream& out, std::string_view name, const Row& row) {
  out << "  {\"kind\": \"" << name << "\", \"domains\": " << row.domains
      << ", \"empty\": " << row.empty << ", \"tets\": " << row.tets
      << ", \"fell_back\": " << row.fell_back << ", \"volumes\": " << row.volumes
      << ", \"thin_volumes\": " << row.thin << ", \"min_dihedral\": " << row.min_dihedral
      << ", \"max_dihedral\": " << row.max_dihedral << ", \"faulty\": " << row.faulty << "}";
}

}  // namespace

std::uint64_t faulty(const Summary& summary) { return row_of(summary, -1).faulty; }

std::string as_markdown(const Summary& summary) {
  constexpr int shown = 20;
  std::ostringstream out;
  out << "# Random domains, each mesh verified\n\nSeed " << summary.seed << ".\n\n"
      << "| kind | domains | empty | tetrahedra | fell back | volumes compared | of thin shapes | smallest angle | largest angle | with faults |\n"
      << "|---|---|---|---|---|---|---|---|---|---|\n";
  for (int kind = 0; kind < kind_count; ++kind)
    write_row(out, kind_names[static_cast<std::size_t>(kind)], row_of(summary, kind));
  write_row(out, "all", row_of(summary, -1));
  int left = shown;
  for (std::size_t i = 0; i < summary.verdicts.size() && left > 0; ++i)
    for (const std::string& fault : summary.verdicts[i].faults)
      if (left-- > 0)
        out << "\ncertet_soak --seed " << summary.seed << " --only " << summary.first + i << ": "
            << fault << "\n";
  return out.str();
}

std::string as_json(const Summary& summary) {
  std::ostringstream out;
  out << "{\"seed\": " << summary.seed << ",\n \"kinds\": [\n";
  for (int kind = 0; kind < kind_count; ++kind) {
    json_row(out, kind_names[static_cast<std::size_t>(kind)], row_of(summary, kind));
    out << (kind + 1 < kind_count ? ",\n" : "],\n \"all\":\n");
  }
  json_row(out, "all", row_of(summary, -1));
  out << ",\n \"faults\": [";
  bool first = true;
  for (std::size_t i = 0; i < summary.verdicts.size(); ++i)
    for (const std::string& fault : summary.verdicts[i].faults) {
      out << (first ? "\n" : ",\n") << "  {\"domain\": " << summary.first + i
          << ", \"fault\": " << std::quoted(fault) << "}";
      first = false;
    }
  out << "]}\n";
  return out.str();
}

}  // namespace soak
