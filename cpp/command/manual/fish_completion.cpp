#include <fmt/format.h>

#include <iomanip>
#include <sstream>

#include "pages.hpp"

namespace certet::command {
namespace {

std::string fish_literal(const std::string& text) {
  return (std::ostringstream() << std::quoted(text, '\'')).str();
}

std::string line(const std::string& condition, const OptionText& option) {
  std::string text = fmt::format("complete -c certet -n '{}'", condition);
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                   : fmt::format(" -s {}", name.substr(1));
  if (!option.value.empty()) text += " -r";
  if (!option.choices.empty()) {
    std::string list;
    for (const std::string& choice : option.choices) list += (list.empty() ? "" : " ") + choice;
    text += fmt::format(" -f -a {}", fish_literal(list));
  }
  return fmt::format("{} -d {}\n", text, fish_literal(option.description));
}

}  // namespace

std::string fish_completion(const std::vector<CommandText>& all) {
  std::string text = "# Completion of certet for fish; made from the program's own options.\n";
  for (const CommandText& command : all) {
    const std::string condition = command.name.empty()
                                      ? "__fish_use_subcommand"
                                      : "__fish_seen_subcommand_from " + command.name;
    if (!command.name.empty())
      text += fmt::format("complete -c certet -n __fish_use_subcommand -f -a {} -d {}\n",
                          command.name, fish_literal(command.description));
    for (const OptionText& option : command.options) text += line(condition, option);
  }
  return text;
}

}  // namespace certet::command
