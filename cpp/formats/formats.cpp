#include "certet/formats.hpp"

#include <algorithm>
#include <string>

#include "certet/error.hpp"
#include "registry.hpp"

namespace certet {
namespace {

struct Entry {
  std::string_view extension;
  Format format;
  std::unique_ptr<MeshWriter> (*open)(const std::filesystem::path&, const MeshSize&);
  std::uint64_t (*bytes)(const MeshSize&);
  FileMesh (*read)(const std::filesystem::path&);
};

constexpr Entry registry[] = {
    {".vtu", Format::vtu, formats::open_vtu, formats::vtu_bytes, formats::read_vtu},
    {".mesh", Format::medit, formats::open_medit, formats::medit_bytes, formats::read_medit},
};

const Entry* entry_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const auto found = std::ranges::find(registry, std::string_view(extension), &Entry::extension);
  return found == std::end(registry) ? nullptr : &*found;
}

const Entry& entry_of(Format format) {
  return *std::ranges::find(registry, format, &Entry::format);
}

}  // namespace

std::optional<Format> format_of(const std::filesystem::path& file) {
  const Entry* entry = entry_of(file);
  if (entry == nullptr) return std::nullopt;
  return entry->format;
}

std::unique_ptr<MeshWriter> open_writer(const std::filesystem::path& file, Format format,
                                        const MeshSize& size) {
  return entry_of(format).open(file, size);
}

std::uint64_t file_bytes(Format format, const MeshSize& size) {
  return entry_of(format).bytes(size);
}

FileMesh read_mesh(const std::filesystem::path& file) {
  const Entry* entry = entry_of(file);
  if (entry == nullptr) {
    std::string known;
    for (const Entry& e : registry) known.append(known.empty() ? "" : ", ").append(e.extension);
    throw Error(ErrorCode::bad_input, "cannot read '" + file.string() +
                                          "': its extension is none of " + known);
  }
  return entry->read(file);
}

}  // namespace certet
