/// \file
/// certet_graded_soak: meshes random domains of one and of several materials, grades each by
/// 1 to 3 levels and by sizes that are asked for at random, and judges the mesh beside the
/// uniform one.
///
///     certet_graded_soak [--count N] [--first N] [--seed S] [--threads N] [--plant NAME]
///                        [--report FILE.md]
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <sstream>

#include "../numbered_campaign.hpp"
#include "graded_trial.hpp"

namespace {

using graded::Verdict;

using Arguments = soak::NumberedArguments<graded::Plant>;

std::uint64_t tell_all(const Arguments& arguments) {
  const std::vector<Verdict> verdicts = soak::verdicts_of(arguments, graded::judge);
  std::uint64_t tets = 0, uniform = 0, several = 0, asked = 0, smaller = 0, faulty = 0;
  for (const Verdict& verdict : verdicts) {
    tets += verdict.tets;
    uniform += verdict.uniform_tets;
    several += verdict.several;
    asked += verdict.asked;
    smaller += verdict.smaller;
    faulty += !verdict.faults.empty();
  }
  std::ostringstream table;
  table << "seed " << arguments.seed << ", from " << arguments.first
        << "\n\n| graded meshes | of several materials | with sizes | with fewer tetrahedra than of "
           "one size | tetrahedra | of one size | with a fault |\n|---|---|---|---|---|---|---|\n| "
        << verdicts.size() << " | " << several << " | " << asked << " | " << smaller << " | " << tets
        << " | " << uniform << " | " << faulty << " |\n"
        << soak::faults_of<graded::Plant, Verdict>("certet_graded_soak", arguments, verdicts);
  soak::tell(arguments, table.str());
  return faulty;
}

}  // namespace

int main(int argc, char** argv) {
  return soak::campaign("certet_graded_soak", [&] {
    return soak::numbered_arguments<graded::Plant>(argc, argv, 100, graded::plant_names);
  }, tell_all);
}
