#include "surface_choice.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "certet/error.hpp"
#include "refusal.hpp"

namespace certet::command {
namespace {

/// The label that a word is, or is the name of.
std::int32_t label_of(const std::string& word, const LabelNames& names) {
  std::int32_t label = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, label);
  if (error == std::errc() && rest == end) return label;
  const auto named = std::ranges::find_if(names, [&](const auto& row) { return row.second == word; });
  if (named == names.end()) refuse("--surface: no region is called '" + word + "'");
  return named->first;
}

}  // namespace

void declare_surface_choice(CLI::App& app, std::string& text) {
  app.add_option("--surface", text,
                 "With .stl and .ply: the surface of region A alone or, of two, where they touch, "
                 "labels or names; interfaces: wherever two touch (default: the boundary of all)")
      ->option_text("A[,B]");
}

void check_surface_choice(const std::string& text, Format format) {
  if (!text.empty() && format != Format::stl && format != Format::ply)
    refuse("--surface goes with .stl and .ply; .vtp has all surfaces, each by itself");
}

void choose_surface(const std::string& text, const LabelNames& names, Survey& survey) {
  if (text.empty()) return;
  if (text == "interfaces") return keep_interfaces(survey);
  const std::size_t comma = text.find(',');
  std::vector<std::int32_t> labels{label_of(text.substr(0, comma), names)};
  if (comma != std::string::npos) labels.push_back(label_of(text.substr(comma + 1), names));
  keep_surface(survey, labels);
}

}  // namespace certet::command
