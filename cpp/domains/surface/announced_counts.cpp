#include "announced_counts.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include "certet/error.hpp"
#include "certet/surface.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// The beginning of a file, enough of it for any header.
struct Head {
  fs::path file;
  std::uint64_t size;
  std::string text;

  explicit Head(const fs::path& path) : file(path), size(fs::file_size(path)) {
    text.resize(static_cast<std::size_t>(std::min<std::uint64_t>(size, 1 << 16)));
    std::ifstream(path, std::ios::binary)
        .read(text.data(), static_cast<std::streamsize>(text.size()));
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(ErrorCode::bad_input, "'" + file.string() + "' " + reason);
  }
};

bool is_text(const Head& head) {
  return head.text.rfind("solid", 0) == 0 && head.text.find('\0') == std::string::npos;
}

void check_stl(const Head& head) {
  constexpr std::uint64_t before = 84, triangle = 50;
  if (is_text(head)) return;
  if (head.size < before) head.refuse("is too short for an STL file");
  // A binary file has numbers from there on, and a text none that is not printable.
  if (std::all_of(head.text.begin(), head.text.end(), [](unsigned char c) {
        return c >= ' ' || (c >= '\t' && c <= '\r');
      }))
    head.refuse("is text, but not an STL file: it does not begin with the word solid");
  std::uint32_t count = 0;
  std::memcpy(&count, head.text.data() + 80, 4);
  if (head.size - before < triangle * count)
    head.refuse("is too short for the " + std::to_string(count) + " triangles it announces");
}

}  // namespace

std::string surface_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_surface_file(const fs::path& file) {
  const std::string extension = surface_extension(file);
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".off";
}

bool is_text_stl(const fs::path& file) { return is_text(Head(file)); }

void check_announced_counts(const fs::path& file) {
  if (surface_extension(file) == ".stl") check_stl(Head(file));
}

}  // namespace certet
