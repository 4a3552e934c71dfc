#include "shared_options.hpp"

#include <CLI/CLI.hpp>

#include "certet/formats.hpp"

namespace certet::command {

void declare_mesh_file(CLI::App& app, const std::string& name, const std::string& shown,
                       std::filesystem::path& file) {
  app.add_option(name, file, "Mesh: .vtu, .mesh, .meshb or .msh")->required()->option_text(shown);
}

void declare_format(CLI::App& app, std::string& format, bool& compress) {
  app.add_option("--format", format, format_names() + " (default: by the extension)")
      ->option_text("F");
  app.add_flag("--compress", compress, "Compress .vtu");
}

void declare_threads(CLI::App& app, RunOptions& run) {
  app.add_option("--threads", run.threads, "Threads (default: as many as there are)")
      ->check(CLI::Range(0, 1024))
      ->option_text("N");
}

void declare_json(CLI::App& app, RunOptions& run) {
  app.add_option("--json", run.json, "Report for programs; - is stdout")->option_text("FILE|-");
}

}  // namespace certet::command
