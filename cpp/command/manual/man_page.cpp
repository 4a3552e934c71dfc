#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "pages.hpp"
#include "roff.hpp"

namespace certet::command {
namespace {

/// certet, certet-mesh, …
std::string page_name(const CommandText& command) {
  return command.name.empty() ? "certet" : fmt::format("certet-{}", command.name);
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string synopsis(const CommandText& command) {
  std::string line = bold("certet");
  if (command.name.empty()) return fmt::format("{} {} [{}]...", line, italic("COMMAND"), italic("OPTION"));
  line += fmt::format(" {}", bold(command.name));
  for (const OptionText& argument : command.arguments)
    line += argument.required ? fmt::format(" {}", italic(argument.value))
                              : fmt::format(" [{}]", italic(argument.value));
  return fmt::format("{} [{}]...", line, italic("OPTION"));
}

/// A tagged paragraph.
std::string entry(const OptionText& option) {
  std::string tag;
  for (const std::string& name : option.names) tag += fmt::format("{}{}", tag.empty() ? "" : ", ", bold(name));
  if (!option.value.empty()) tag += fmt::format("{}{}", tag.empty() ? "" : " ", italic(option.value));
  return fmt::format(".TP\n{}\n{}.\n", tag, roff(option.description));
}

std::string entries(const std::string& title, const std::vector<OptionText>& options) {
  if (options.empty()) return {};
  std::string text = fmt::format(".SH {}\n", title);
  for (const OptionText& option : options) text += entry(option);
  return text;
}

std::string commands(const std::vector<CommandText>& all) {
  std::string text = ".SH COMMANDS\n";
  for (const CommandText& command : all)
    if (!command.name.empty())
      text += fmt::format(".TP\n{}\n{}; see\n.BR {} (1).\n", bold(command.name),
                          roff(command.description), roff(page_name(command)));
  return text;
}

std::string see_also(const CommandText& command, const std::vector<CommandText>& all) {
  std::vector<std::string> names;
  for (const CommandText& other : all)
    if (other.name != command.name) names.push_back(page_name(other));
  std::ranges::sort(names);
  std::string text = ".SH SEE ALSO\n";
  for (const std::string& name : names)
    text += fmt::format(".BR {} (1){}\n", roff(name), name == names.back() ? "" : ",");
  return text;
}

}  // namespace

std::string man_page(const CommandText& command, const std::vector<CommandText>& all,
                     const std::string& date) {
  const std::string name = page_name(command);
  std::string text = fmt::format(".TH {} 1 {} \"certet {}\"\n", upper(name), date, CERTET_VERSION);
  text += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(command.description));
  text += fmt::format(".SH SYNOPSIS\n{}\n", synopsis(command));
  if (command.name.empty()) text += commands(all);
  text += entries("ARGUMENTS", command.arguments);
  text += entries("OPTIONS", command.options);
  if (!command.footer.empty()) text += ".SH NOTES\n";
  for (const std::string& paragraph : command.footer)
    text += fmt::format("{}{}\n", &paragraph == command.footer.data() ? "" : ".PP\n", roff(paragraph));
  return text + see_also(command, all);
}

}  // namespace certet::command
