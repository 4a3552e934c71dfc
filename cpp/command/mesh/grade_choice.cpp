#include "grade_choice.hpp"

#include <CLI/CLI.hpp>

#include "option_values.hpp"
#include "refusal.hpp"
#include "report.hpp"

namespace certet::command {
namespace {

/// What `TransitionAngles` of the certificate promises of tetrahedra of an octree.
constexpr double least_inside = 45, greatest_inside = 120;

/// By how many levels edges of this size stay within what is asked for.
std::int32_t levels_for(const GradeChoice& choice, double size) {
  if (choice.max_size == 0) return choice.levels;
  std::int32_t levels = 0;
  while (levels < most_grading_levels && size * (2 << levels) <= choice.max_size) ++levels;
  return levels;
}

}  // namespace

void declare_grade(CLI::App& app, GradeChoice& choice, std::string& max_size) {
  app.add_option("--grade", choice.levels,
                 "Larger tetrahedra away from the surface and from where labels meet, which stay "
                 "as they are: by up to N levels, each of which doubles the edges (at most 3; "
                 "default: 0, all of one size)")
      ->check(CLI::Range(0, int{most_grading_levels}))
      ->option_text("N");
  app.add_option("--max-size", max_size,
                 "Grades by as many levels as keep long edges within S, in world units; at most "
                 "8 times those at the surface")
      ->option_text("S");
}

void check_grade(GradeChoice& choice, const std::string& max_size, bool moves) {
  if (!max_size.empty()) {
    if (choice.levels != 0) refuse("--grade and --max-size exclude each other");
    choice.max_size = parse_positive("--max-size", max_size);
  }
  if (choice.any() && moves)
    refuse("--grade and --max-size do not go with --optimise or --features: vertices move where "
           "all tetrahedra are of one size");
}

void grade(const GradeChoice& choice, double size, Stuffing& stuffing, Context& context) {
  const std::int32_t levels = levels_for(choice, size);
  if (levels == 0) return;
  if (stuffing.labels().size() > 1 && !stuffing.has_interfaces())
    refuse("--grade and --max-size go with several labels where they are cut apart, so not with "
           "--method paper");
  stuffing.grade({.levels = levels, .of_materials = {}, .at_points = {}}, context);
}

void add_grade(Lines& lines, const GradeReport& report, std::uint64_t tets, double size) {
  if (report.levels == 0) return;
  lines.add("graded", "{} levels, edges up to {:.6g}; in the place of {} tetrahedra of one size, "
            "{:.1f} %",
            report.levels, size * (1 << report.levels), grouped(report.uniform_tets),
            100 * static_cast<double>(tets) / static_cast<double>(report.uniform_tets));
  lines.add("", "those that are not the lattice's: {}° to {}°, theorem TransitionAnglesInDegrees",
            least_inside, greatest_inside);
}

Json json_of(const GradeReport& report, double size) {
  return {{"levels", report.levels},
          {"greatest_edge", size * (1 << report.levels)},
          {"uniform_tets", report.uniform_tets},
          {"interior",
           {{"theorem", "TransitionAnglesInDegrees"},
            {"min_dihedral", least_inside},
            {"max_dihedral", greatest_inside}}}};
}

}  // namespace certet::command
