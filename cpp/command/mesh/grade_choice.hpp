#pragma once
/// \file
/// Graded interiors: what is asked for, and what came of it.

#include <CLI/App.hpp>
#include <cstdint>
#include <map>
#include <string>

#include "certet/context.hpp"
#include "certet/stuffing.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// --grade or --max-size, and --interior-size.
struct GradeChoice {
  std::int32_t levels = 0;
  double max_size = 0;  ///< 0: as many levels as `levels` says
  std::map<std::int32_t, double> of_labels;  ///< the greatest edges within some labels

  [[nodiscard]] bool any() const { return levels != 0 || max_size != 0 || !of_labels.empty(); }
};

/// What --max-size and --interior-size say.
struct RawGrade {
  std::string max_size, of_labels;
};

void declare_grade(CLI::App& app, GradeChoice& choice, RawGrade& raw);
/// Reads these texts.  `moves` says whether vertices are to move, which they do where all
/// tetrahedra are of one size.
void check_grade(GradeChoice& choice, const RawGrade& raw, bool moves);

/// Grades a counted mesh whose long edges have this size, if it is to be.  \throws Error
/// `bad_option` where the mesh is not one that can be.
void grade(const GradeChoice& choice, double size, Stuffing& stuffing, Context& context);

/// What is told of a graded mesh.
struct GradeReport {
  std::int32_t levels = 0;  ///< 0: it is not graded
  std::uint64_t uniform_tets = 0;
};

void add_grade(Lines& lines, const GradeReport& report, std::uint64_t tets, double size);
Json json_of(const GradeReport& report, double size);

}  // namespace certet::command
