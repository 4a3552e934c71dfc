#include <fmt/format.h>

#include "pages.hpp"

namespace certet::command {
namespace {

std::string words(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& word : list) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// A branch for options with a value: its choices, or else a file.
std::string branch(const CommandText& command, const OptionText& option) {
  if (option.value.empty()) return {};
  std::string pattern;
  for (const std::string& name : option.names)
    pattern += fmt::format("{}'{} {}'", pattern.empty() ? "" : "|", command.name, name);
  const std::string reply = option.choices.empty()
                                ? "-f"
                                : fmt::format("-W '{}'", words(option.choices));
  return fmt::format("    {}) COMPREPLY=($(compgen {} -- \"$word\")); return ;;\n", pattern, reply);
}

std::string option_names(const CommandText& command) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return words(names);
}

}  // namespace

std::string bash_completion(const std::vector<CommandText>& all) {
  std::vector<std::string> commands;
  std::string values, options;
  for (const CommandText& command : all) {
    if (!command.name.empty()) commands.push_back(command.name);
    for (const OptionText& option : command.options) values += branch(command, option);
    options += fmt::format("    '{}') options='{}' ;;\n", command.name, option_names(command));
  }
  return R"(# Completion of certet for bash; made from the program's own options.
_certet() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command='' options=''
  [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]}
  case "$command $before" in
)" + values + R"(  esac
  case "$command" in
)" + options + R"(  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [ -z "$command" ]; then
    COMPREPLY=($(compgen -W ')" + words(commands) + R"(' -- "$word"))
  else
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _certet certet
)";
}

}  // namespace certet::command
