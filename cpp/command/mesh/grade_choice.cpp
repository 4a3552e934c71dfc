#include "grade_choice.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <span>
#include <vector>

#include "option_values.hpp"
#include "refusal.hpp"
#include "report.hpp"
#include "size_choice.hpp"

namespace certet::command {
namespace {

/// What `TransitionAngles` of the certificate promises of tetrahedra of an octree.
constexpr double least_inside = 45, greatest_inside = 120;

/// LABEL=S,LABEL=S.
std::map<std::int32_t, double> parse_of_labels(const std::string& text) {
  std::map<std::int32_t, double> sizes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string one = text.substr(begin, end - begin);
    const std::size_t equals = one.find('=');
    const std::vector<LabelRange> labels =
        equals == one.npos ? std::vector<LabelRange>() : parse_labels(one.substr(0, equals));
    if (labels.size() != 1 || labels[0].first != labels[0].last)
      refuse("--interior-size takes labels and their greatest edges, like 3=2.5,7=1, not '" + text +
             "'");
    const double size = parse_positive("--interior-size", one.substr(equals + 1));
    if (!sizes.emplace(static_cast<std::int32_t>(labels[0].first), size).second)
      refuse("--interior-size has label " + one.substr(0, equals) + " twice");
    begin = end + 1;
  }
  return sizes;
}

/// As many levels as there are, where nothing but a size field says how many.
std::int32_t most_levels(const GradeChoice& choice, double size) {
  if (choice.max_size != 0) return levels_within(choice.max_size, size);
  const bool by_field =
      !choice.size_field.empty() && choice.levels == 0 && choice.of_labels.empty();
  return by_field ? most_grading_levels : choice.levels;
}

/// The grading of a mesh in this frame.
Grading grading_for(const GradeChoice& choice, const Frame& frame,
                    std::span<const std::int32_t> labels) {
  Grading grading;
  grading.levels = most_levels(choice, frame.size);
  if (choice.sizes) keep_within(*choice.sizes, frame, grading);
  if (choice.of_labels.empty()) return grading;
  grading.of_materials.assign(labels.size(), grading.levels);
  for (const auto& [label, most] : choice.of_labels) {
    const auto found = std::ranges::find(labels, label);
    if (found == labels.end())
      refuse(fmt::format("--interior-size names label {}, which the mesh has not", label));
    grading.of_materials[static_cast<std::size_t>(found - labels.begin())] =
        levels_within(most, frame.size);
  }
  for (const std::int32_t levels : grading.of_materials)
    grading.levels = std::max(grading.levels, levels);
  return grading;
}

}  // namespace

void declare_grade(CLI::App& app, GradeChoice& choice, RawGrade& raw) {
  app.add_option("--grade", choice.levels,
                 "Larger tetrahedra away from the surface and from where labels meet, which stay "
                 "as they are: by up to N levels, each of which doubles the edges (at most 3; "
                 "default: 0, all of one size)")
      ->check(CLI::Range(0, int{most_grading_levels}))
      ->option_text("N");
  app.add_option("--max-size", raw.max_size,
                 "Grades by as many levels as keep long edges within S, in world units; at most "
                 "8 times those at the surface")
      ->option_text("S");
  app.add_option("--interior-size", raw.of_labels,
                 "The same within single labels, like 3=2.5,7=1; all others as --grade or "
                 "--max-size has them, or of one size")
      ->option_text("LABEL=S,...");
  app.add_option("--size-field", choice.size_field,
                 "Grades by as many levels as keep long edges within a size that varies: a formula "
                 "of x, y and z (@FILE: in a file) or an image, both in world units; by 3 levels at "
                 "most, or as the other three have it, and nowhere finer than --size")
      ->option_text("FORMULA|IMAGE");
}

void check_grade(GradeChoice& choice, const RawGrade& raw, bool moves) {
  if (!raw.max_size.empty()) {
    if (choice.levels != 0) refuse("--grade and --max-size exclude each other");
    choice.max_size = parse_positive("--max-size", raw.max_size);
  }
  if (!raw.of_labels.empty()) choice.of_labels = parse_of_labels(raw.of_labels);
  if (!choice.size_field.empty()) check_size_field(choice.size_field);
  if (choice.any() && moves)
    refuse("--grade, --max-size, --interior-size and --size-field do not go with --optimise or "
           "--features: vertices move where all tetrahedra are of one size");
}

void open_size_field(GradeChoice& choice, std::uint64_t max_bytes) {
  if (!choice.size_field.empty()) choice.sizes = open_sizes(choice.size_field, max_bytes);
}

void grade(const GradeChoice& choice, const Frame& frame, Stuffing& stuffing, Context& context) {
  if (!choice.any()) return;
  const Grading grading = grading_for(choice, frame, stuffing.labels());
  if (grading.levels == 0) return;
  if (stuffing.labels().size() > 1 && !stuffing.has_interfaces())
    refuse("--grade, --max-size, --interior-size and --size-field go with several labels where they are cut "
           "apart, so not with --method paper");
  stuffing.grade(grading, context);
}

void add_grade(Lines& lines, const GradeReport& report, std::uint64_t tets, double size) {
  if (report.levels == 0) return;
  lines.add("graded", "{} levels, edges up to {:.6g}; in the place of {} tetrahedra of one size, "
            "{:.1f} %",
            report.levels, size * (1 << report.levels), grouped(report.uniform_tets),
            100 * static_cast<double>(tets) / static_cast<double>(report.uniform_tets));
  if (!report.size_field.empty())
    lines.add("", "within the size field {}", shortened_formula(report.size_field));
  lines.add("", "those that are not the lattice's: {}° to {}°, theorem TransitionAnglesInDegrees",
            least_inside, greatest_inside);
}

Json json_of(const GradeReport& report, double size) {
  Json json = {{"levels", report.levels},
          {"greatest_edge", size * (1 << report.levels)},
          {"uniform_tets", report.uniform_tets},
          {"interior",
           {{"theorem", "TransitionAnglesInDegrees"},
            {"min_dihedral", least_inside},
            {"max_dihedral", greatest_inside}}}};
  if (!report.size_field.empty()) json["size_field"] = report.size_field;
  return json;
}

}  // namespace certet::command
