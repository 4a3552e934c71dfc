#pragma once
/// \file
/// Options that several subcommands have.

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

namespace certet::command {

/// A mesh to read, which must be named: the positional `name`, in the help called `shown`.
void declare_mesh_file(CLI::App& app, const std::string& name, const std::string& shown,
                       std::filesystem::path& file);

/// The option or positional `name`: the mesh to write.
CLI::Option* declare_output(CLI::App& app, const std::string& name, std::filesystem::path& file);

/// --origin, of a mesh that is written; `zero` says in the help what 0 means.
void declare_origin(CLI::App& app, std::string& origin, const std::string& zero);

/// --format and --compress, of a mesh that is written.
void declare_format(CLI::App& app, std::string& format, bool& compress);

/// --label-names, a file that has the names of labels.
void declare_label_names(CLI::App& app, std::filesystem::path& file);

/// How a run goes, and where it is told of.
struct RunOptions {
  int threads = 0;   ///< 0: as many as there are
  std::string json;  ///< of the report for programs: a file, - for stdout, or empty

  [[nodiscard]] bool has_json_file() const { return !json.empty() && json != "-"; }
};
void declare_threads(CLI::App& app, RunOptions& run);
void declare_json(CLI::App& app, RunOptions& run);
inline void declare_run(CLI::App& app, RunOptions& run) {
  declare_threads(app, run);
  declare_json(app, run);
}

}  // namespace certet::command
