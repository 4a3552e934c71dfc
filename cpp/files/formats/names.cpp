#include "names.hpp"

#include <algorithm>
#include <set>

namespace certet::formats {
namespace {

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t longest(NameRule rule) {
  return rule == NameRule::identifier ? 80 : rule == NameRule::title ? 70 : 127;
}

/// How many bytes of UTF-8 begin a text as one character; 0 if they are damaged
/// or none that XML allows.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const std::size_t count = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || count > text.size()) return 0;
  unsigned code = lead & (0xffu >> (count + 1));
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  const bool overlong = code < (count == 4 ? 0x10000u : count == 3 ? 0x800u : 0x80u);
  const bool forbidden = (code >= 0xd800 && code <= 0xdfff) || code > 0x10ffff ||
                         code == 0xfffe || code == 0xffff;
  return overlong || forbidden ? 0 : count;
}

/// Only letters, digits and underscores.
std::string as_identifier(std::string_view name) {
  std::string result = name.empty() || !is_letter(name.front()) ? "region_" : "";
  for (const char c : name) result += is_letter(c) || is_digit(c) ? c : '_';
  return result;
}

/// Printable characters; damaged ones become question marks.
std::string as_text(std::string_view name) {
  std::string result;
  while (!name.empty()) {
    const std::size_t bytes = character_bytes(name);
    if (bytes == 0)
      result += '?';
    else if (name.front() == '"')
      result += '\'';
    else
      result += name.substr(0, bytes);
    name.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

/// Cuts a text between two characters.
void shorten(std::string& text, std::size_t length) {
  if (text.size() <= length) return;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) --length;
  text.resize(length);
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace

std::string escaped_xml(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '\'') result += "&apos;";
    else result += c;
  }
  return result;
}

std::string default_name(std::int32_t label) {
  return (label < 0 ? "region_minus_" : "region_") + std::to_string(std::abs(std::int64_t{label}));
}

std::vector<std::string> names_of(const std::vector<Region>& regions, NameRule rule) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const Region& region : regions) {
    const std::string wish = region.name.empty() ? default_name(region.label) : region.name;
    const std::string fit = rule == NameRule::identifier ? as_identifier(wish) : as_text(wish);
    std::string name = fit;
    shorten(name, longest(rule));
    std::string suffix(1, '_');
    suffix += std::to_string(std::abs(std::int64_t{region.label}));
    while (!taken.insert(lower_case(name)).second) {
      name = fit;
      shorten(name, longest(rule) - suffix.size());
      name += suffix;
      suffix += '_';
    }
    names.push_back(rule == NameRule::xml ? escaped_xml(name) : name);
  }
  return names;
}

std::vector<std::string> names_of_patches(const Survey& survey, NameRule rule) {
  std::vector<Region> patches;
  const auto add = [&](std::string_view name) {
    patches.push_back({static_cast<std::int32_t>(patches.size()) + 1, std::string(name), 0});
  };
  for (const std::string_view name : patch_names) add(name);
  for (const std::string& name : survey.named_patches) add(name);
  return names_of(patches, rule);
}

std::vector<std::string> names_of_interfaces(const Survey& survey, NameRule rule) {
  const auto name_of = [&](std::int32_t label) {
    const auto region = std::ranges::find(survey.regions, label, &Region::label);
    return region == survey.regions.end() || region->name.empty() ? default_name(label)
                                                                  : region->name;
  };
  std::vector<Region> pairs;
  for (const Interface& interface : survey.interfaces)
    pairs.push_back({static_cast<std::int32_t>(pairs.size()) + 1,
                     name_of(interface.labels[0]) + "-" + name_of(interface.labels[1]), 0});
  if (survey.named_patches.empty()) return names_of(pairs, rule);
  // Those of patches come first, so that they keep theirs.
  std::vector<Region> all;
  for (const std::string& name : survey.named_patches)
    all.push_back({static_cast<std::int32_t>(all.size()) + 1, name, 0});
  all.insert(all.end(), pairs.begin(), pairs.end());
  std::vector<std::string> names = names_of(all, rule);
  names.erase(names.begin(),
              names.begin() + static_cast<std::ptrdiff_t>(survey.named_patches.size()));
  return names;
}

}  // namespace certet::formats
