#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "commands.hpp"
#include "kit.hpp"
#include "outputs.hpp"

namespace certet::command {
namespace {

constexpr const char* conformance_notes = R"(
The kit holds lattice, stencil, bisection, warp, link and whole-mesh cases, of
one material and of several, with the answers of the certified functions, so
that another implementation can check itself.  Its member read_me explains the rest.)";

/// The name of the kit in a folder.
constexpr const char* file_name = "certet-conformance.json";

Status write_kit(const std::string& output) {
  std::filesystem::path target = output;
  std::error_code failure;
  if (output != "-" && std::filesystem::is_directory(target, failure)) target /= file_name;
  if (output != "-") check_output(target);
  write_text(target.string(), std::string(conformance_kit()));
  return Status::ok;
}

}  // namespace

Run declare_conformance(CLI::App& app) {
  const auto output = std::make_shared<std::string>("-");
  app.add_option("-o,--output", *output, "Where the kit goes; - is stdout, the default")
      ->option_text("FILE|FOLDER|-");
  app.footer(conformance_notes);
  return [output] { return write_kit(*output); };
}

}  // namespace certet::command
