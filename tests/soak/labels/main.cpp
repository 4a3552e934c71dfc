/// \file
/// certet_label_soak: meshes random domains of 2 to 12 labels, and judges each mesh as a
/// whole, by regions, and by interfaces.
///
///     certet_label_soak [--count N] [--first N] [--seed S] [--threads N] [--plant NAME]
///                       [--report FILE.md]
///
/// A long run may be parted by --first; seeds next to each other draw the same meshes, for
/// `mixed` adds the number to the seed.
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <algorithm>
#include <sstream>

#include "../numbered_campaign.hpp"
#include "label_trial.hpp"
#include "subject.hpp"

namespace {

using labelled::Verdict;

using Arguments = soak::NumberedArguments<labelled::Plant>;

/// A row of the table.
struct Row {
  Verdict sum = [] {
    Verdict none;
    none.meshes = 0;
    return none;
  }();
  std::uint64_t faulty = 0;

  void add(const Verdict& v) {
    sum += v;
    ++sum.meshes;
    sum.regions += v.regions;
    sum.interfaces += v.interfaces;
    sum.joined += v.joined;
    sum.lost += v.lost;
    sum.streamed += v.streamed;
    sum.region_pinches += v.region_pinches;
    sum.outer_pinches += v.outer_pinches;
    sum.parted += v.parted;
    faulty += !v.faults.empty();
  }
  void tell(std::ostream& out, std::string_view name) const {
    out << "| " << name << " | " << sum.meshes << " | " << sum.tets << " | " << sum.regions << " | "
        << sum.interfaces << " | " << sum.pieces << " | " << sum.tunnels << " | " << sum.cavities
        << " | " << sum.min_dihedral << " | " << sum.max_dihedral << " | " << sum.pairs << " | "
        << sum.joined << " | " << sum.lost << " | " << sum.streamed << " | " << sum.region_pinches << " | "
        << sum.outer_pinches << " | " << sum.parted << " | " << faulty << " |\n";
  }
};

std::uint64_t tell_all(const Arguments& arguments) {
  const std::vector<Verdict> verdicts = soak::verdicts_of(arguments, labelled::judge);
  constexpr std::size_t kinds = labelled::subject_kinds.size();
  std::array<Row, kinds> rows;
  Row all;
  for (std::size_t n = 0; n < verdicts.size(); ++n) {
    rows[(arguments.first + n) % kinds].add(verdicts[n]);
    all.add(verdicts[n]);
  }
  std::ostringstream table;
  table << "seed " << arguments.seed << ", from " << arguments.first
        << "\n\n| labels | meshes | tetrahedra | regions | interfaces | pieces | tunnels | cavities | "
           "least angle | greatest | pairs compared | pieces joined at a distance | labels lost and named | streamed | points where a "
           "region touches itself | where all together do | pieces that hang together by such | with "
           "a fault |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t kind = 0; kind < kinds; ++kind) rows[kind].tell(table, labelled::subject_kinds[kind]);
  all.tell(table, "all");
  table << soak::faults_of<labelled::Plant, Verdict>("certet_label_soak", arguments, verdicts);
  soak::tell(arguments, table.str());
  return all.faulty;
}

}  // namespace

int main(int argc, char** argv) {
  return soak::campaign("certet_label_soak", [&] {
    return soak::numbered_arguments<labelled::Plant>(argc, argv, 96, labelled::plant_names);
  }, tell_all);
}
