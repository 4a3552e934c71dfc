#pragma once
/// \file
/// What the user asks for.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "certet/expression.hpp"
#include "certet/formats.hpp"
#include "certet/image.hpp"
#include "certet/stuffing.hpp"

namespace certet::command {

/// `certet mesh`
struct MeshOptions {
  std::filesystem::path input;  ///< empty if there is a formula
  std::string formula;
  Bounds bounds{};
  std::vector<LabelRange> labels;  ///< empty: all but 0
  std::optional<double> iso;
  double size = 0;  ///< 0: chosen by the input
  std::int32_t margin = 2;
  StuffingOptions stuffing;
  int threads = 0;
  std::uint64_t max_memory = 0;  ///< 0: by what is available
  bool dry_run = false;
  std::filesystem::path output;
  Format format = Format::vtu;
  std::string json;  ///< a file, - for stdout, or empty
};

/// `certet check`
struct CheckOptions {
  std::filesystem::path mesh;
  std::string json;
};

/// Text to be printed instead of a run: the help, or the version.
struct Notice {
  std::string text;
};

using Options = std::variant<Notice, MeshOptions, CheckOptions>;

/// \throws Error `bad_option` with one sentence.
Options parse_options(int argc, char** argv);

}  // namespace certet::command
