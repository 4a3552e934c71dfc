#pragma once
/// \file
/// The program's subcommands and options, as manual and completion need them.

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace certet::command {

struct OptionText {
  std::vector<std::string> names;    ///< "-o", "--output"; empty for an argument
  std::string value;                 ///< what stands for the value; empty for a flag
  std::string description;
  std::vector<std::string> choices;  ///< the words that may follow; often none
  bool required = false;
};

struct CommandText {
  std::string name;  ///< empty for the program itself
  std::string description;
  std::vector<OptionText> arguments;
  std::vector<OptionText> options;
  std::vector<std::string> footer;  ///< paragraphs
};

/// The program first, then its subcommands in the order of the help.
std::vector<CommandText> definitions(const CLI::App& app);

}  // namespace certet::command
