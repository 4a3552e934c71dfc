#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "certet/error.hpp"
#include "outputs.hpp"

namespace certet::command {
namespace {

constexpr const char* program_notes = R"(
Exit status: 0 all is well; 1 `check` or `report` found a defect; 2 wrong usage; 3 an
input that cannot be read; 4 nothing is inside; 5 too large for the memory or the
coordinate range; 6 an output cannot be written, or its numbers cannot hold the mesh;
7 a mesh outside its proven bounds (not written); 130 interrupted.  A run that fails says why in one sentence
on stderr and leaves no output.)";

/// CLI11 may say more than one sentence; the first line is the cause.
std::string first_line(const CLI::ParseError& error) {
  std::string line = error.what();
  line.resize(std::min(line.find('\n'), line.size()));
  return line.empty() ? "wrong usage" : line;
}

Run printing(std::string text) {
  return [text = std::move(text)] {
    write_text("-", text);
    return Status::ok;
  };
}

}  // namespace

CommandLine::CommandLine() : CommandLine("certet", subcommands) {}

CommandLine::CommandLine(const std::string& program, std::span<const Subcommand> commands)
    : app_("Tetrahedral meshes with proven angles, by isosurface stuffing", program),
      program_(program) {
  app_.set_version_flag("--version", program + " " CERTET_VERSION);
  app_.require_subcommand(1);
  app_.footer(program_notes);
  for (const Subcommand& command : commands) {
    CLI::App* app = app_.add_subcommand(command.name, command.description);
    runs_.emplace_back(app, command.declare(*app));
  }
}

Run CommandLine::parse(int argc, char** argv) {
  const auto parsed = [this] {
    return std::ranges::find_if(runs_, [](const auto& run) { return run.first->parsed(); });
  };
  try {
    app_.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return printing(parsed() == runs_.end() ? app_.help() : parsed()->first->help());
  } catch (const CLI::CallForVersion&) {
    return printing(program_ + " " CERTET_VERSION "\n");
  } catch (const CLI::ParseError& error) {
    throw Error(ErrorCode::bad_option, first_line(error));
  }
  return parsed()->second;
}

}  // namespace certet::command
