#pragma once
/// \file
/// What the user typed.

#include <CLI/App.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"

namespace certet::command {

/// The whole command line: the definitions that parsing and help are made from.
class CommandLine {
 public:
  CommandLine();
  /// That of another program, of some subcommands.
  CommandLine(const std::string& program, std::span<const Subcommand> commands);

  /// What the arguments ask for; help and version are printed by it too.
  /// \throws Error `bad_option` with one sentence.
  Run parse(int argc, char** argv);

  [[nodiscard]] const CLI::App& app() const { return app_; }

 private:
  CLI::App app_;
  std::string program_;
  std::vector<std::pair<CLI::App*, Run>> runs_;
};

}  // namespace certet::command
