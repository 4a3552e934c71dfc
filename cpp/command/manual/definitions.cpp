#include "definitions.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

namespace certet::command {
namespace {

/// CLI11 describes a choice among words as {word->number,...} or {word,...}.
std::vector<std::string> choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.find('}');
  std::vector<std::string> found;
  if (begin == type.npos || end == type.npos) return found;
  std::istringstream words(type.substr(begin + 1, end - begin - 1));
  for (std::string word; std::getline(words, word, ',');)
    found.push_back(word.substr(0, word.find("->")));
  return found;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) {
    text.value = option.get_option_text();
    if (text.value.empty()) text.value = option.nonpositional() ? "VALUE" : option.get_name(true);
  }
  text.description = option.get_description();
  text.choices = choices(option);
  text.required = option.get_required();
  return text;
}

std::vector<std::string> paragraphs(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  bool within = false;
  for (std::string line; std::getline(lines, line); within = !line.empty()) {
    if (line.empty()) continue;
    if (within)
      found.back().append(" ").append(line);
    else
      found.push_back(line);
  }
  return found;
}

CommandText text_of(const CLI::App& app, const std::string& name) {
  CommandText text{name, app.get_description(), {}, {}, paragraphs(app.get_footer())};
  for (const CLI::Option* option : app.get_options())
    (option->nonpositional() ? text.options : text.arguments).push_back(text_of(*option));
  return text;
}

}  // namespace

std::vector<CommandText> definitions(const CLI::App& app) {
  std::vector<CommandText> found{text_of(app, "")};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    found.push_back(text_of(*command, command->get_name()));
  return found;
}

}  // namespace certet::command
