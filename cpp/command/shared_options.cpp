#include "shared_options.hpp"

#include <CLI/CLI.hpp>

#include "certet/formats.hpp"

namespace certet::command {

void declare_mesh_file(CLI::App& app, const std::string& name, const std::string& shown,
                       std::filesystem::path& file) {
  app.add_option(name, file, "Mesh: .vtu, .mesh, .meshb or .msh")->required()->option_text(shown);
}

CLI::Option* declare_output(CLI::App& app, const std::string& name, std::filesystem::path& file) {
  return app
      .add_option(name, file,
                  "Mesh: " + mesh_extensions() + "; its surfaces: " + surface_extensions())
      ->option_text("OUT");
}

void declare_origin(CLI::App& app, std::string& origin, const std::string& zero) {
  app.add_option("--origin", origin, "world: coordinates are the input's (default); 0: " + zero)
      ->check(CLI::IsMember({"world", "0"}))
      ->option_text("world|0");
}

void declare_format(CLI::App& app, std::string& format, bool& compress) {
  app.add_option("--format", format, format_names() + " (default: by the extension)")
      ->option_text("F");
  app.add_flag("--compress", compress, "Compress .vtu");
}

void declare_label_names(CLI::App& app, std::filesystem::path& file) {
  app.add_option("--label-names", file,
                 "Names of labels, as ITK-SNAP, 3D Slicer (.ctbl), MRIcron or FSL have them")
      ->option_text("FILE");
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
