#pragma once
/// \file
/// The files that the manual consists of, as text.

#include <string>
#include <vector>

#include "definitions.hpp"

namespace certet::command {

/// The page of a command; `all` are the program and its subcommands, `date` is
/// that of the release, YYYY-MM-DD.
std::string man_page(const CommandText& command, const std::vector<CommandText>& all,
                     const std::string& date);

/// Completion for the whole program.
std::string bash_completion(const std::vector<CommandText>& all);
std::string zsh_completion(const std::vector<CommandText>& all);
std::string fish_completion(const std::vector<CommandText>& all);

}  // namespace certet::command
