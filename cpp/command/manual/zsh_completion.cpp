#include <fmt/format.h>

#include "pages.hpp"

namespace certet::command {
namespace {

/// Text within '…' and […]: both quote, and colons part fields.
std::string zsh_literal(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
    if (c == '\'') out += "\\''";
  }
  return out;
}

std::string value_of(const OptionText& option) {
  if (option.value.empty()) return {};
  std::string text = fmt::format(":{}:", zsh_literal(option.value));
  if (option.choices.empty()) return text + "_files";
  text += "(";
  for (const std::string& choice : option.choices)
    text += (text.ends_with('(') ? "" : " ") + choice;
  return text + ")";
}

std::string specifications(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options)
    for (const std::string& name : option.names)
      text += fmt::format(" \\\n        '{}[{}]{}'", name, zsh_literal(option.description),
                          value_of(option));
  return text;
}

}  // namespace

std::string zsh_completion(const std::vector<CommandText>& all) {
  std::string commands, branches;
  for (const CommandText& command : all) {
    if (command.name.empty()) continue;
    commands += fmt::format("    '{}:{}'\n", command.name, zsh_literal(command.description));
    branches += fmt::format("    {})\n      _arguments{} \\\n        '*:file:_files' ;;\n",
                            command.name, specifications(command));
  }
  return R"(#compdef certet
# Completion of certet for zsh; made from the program's own options.
_certet() {
  local -a commands
  commands=(
)" + commands + R"(  )
  if (( CURRENT == 2 )); then
    _describe command commands
    _arguments)" + specifications(all.front()) + R"(
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
)" + branches + R"(  esac
}
_certet "$@"
)";
}

}  // namespace certet::command
