#pragma once
/// \file
/// Graded interiors: what is asked for, and what came of it.

#include <CLI/App.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "certet/context.hpp"
#include "certet/size_field.hpp"
#include "certet/stuffing.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// --grade or --max-size, --interior-size and --size-field.
struct GradeChoice {
  std::int32_t levels = 0;
  double max_size = 0;  ///< 0: as many levels as `levels` says
  std::map<std::int32_t, double> of_labels;  ///< the greatest edges within some labels

  std::string size_field;  ///< a formula or an image; empty: sizes are the same everywhere
  std::optional<SizeField> sizes = {};  ///< that one, once it is open

  [[nodiscard]] bool any() const {
    return levels != 0 || max_size != 0 || !of_labels.empty() || !size_field.empty();
  }
};

/// What --max-size and --interior-size say.
struct RawGrade {
  std::string max_size, of_labels;
};

void declare_grade(CLI::App& app, GradeChoice& choice, RawGrade& raw);
/// Reads these texts.  `moves` says whether vertices are to move, which they do where all
/// tetrahedra are of one size.
void check_grade(GradeChoice& choice, const RawGrade& raw, bool moves);

/// Opens the size field, if there is one.  \throws Error `bad_input`, `too_large`.
void open_size_field(GradeChoice& choice, std::uint64_t max_bytes);

/// Grades a counted mesh in this frame, if it is to be.  \throws Error
/// `bad_option` where the mesh is not one that can be, `bad_input` where the size field is not
/// positive or does not cover it.
void grade(const GradeChoice& choice, const Frame& frame, Stuffing& stuffing, Context& context);

/// What is told of a graded mesh.
struct GradeReport {
  std::int32_t levels = 0;  ///< 0: it is not graded
  std::uint64_t uniform_tets = 0;
  std::string size_field = {};  ///< empty: none
};

void add_grade(Lines& lines, const GradeReport& report, std::uint64_t tets, double size);
Json json_of(const GradeReport& report, double size);

}  // namespace certet::command
