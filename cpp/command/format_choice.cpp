#include "format_choice.hpp"

#include "refusal.hpp"

namespace certet::command {
namespace {

Format named(const std::string& name) {
  if (name == "mesh") return Format::medit;
  const auto format = format_named(name);
  if (!format) refuse("--format is one of " + format_names() + ", not '" + name + "'");
  return *format;
}

Format by_extension(const std::filesystem::path& output) {
  if (output.empty()) return Format::vtu;
  const auto format = format_of(output);
  if (!format)
    refuse("the extension of '" + output.string() +
           "' is that of no known format; name one with --format: " + format_names());
  return *format;
}

}  // namespace

Format choose_format(const std::filesystem::path& output, const std::string& name,
                     bool compress) {
  Format format = name.empty() ? by_extension(output) : named(name);
  if (compress && format == Format::vtu) format = Format::vtu_zlib;
  if (compress && format != Format::vtu_zlib) refuse("--compress goes with .vtu");
  if (format == Format::vtu_zlib && !can_compress())
    refuse("a .vtu file cannot be compressed: compression was not built in");
  return format;
}

}  // namespace certet::command
