#include "announced_counts.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
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

  /// `count` things of at least `bytes` each.
  void judge(std::uint64_t count, std::uint64_t bytes, const std::string& things) const {
    if (bytes != 0 && count > size / bytes)
      refuse("is too short for the " + std::to_string(count) + " " + things + " it announces");
  }
};

void judge_stl(const Head& head) {
  constexpr std::uint64_t before = 84, triangle = 50;
  const bool text = head.text.rfind("solid", 0) == 0 &&
                    head.text.find('\0') == std::string::npos;
  if (text) return;
  if (head.size < before) head.refuse("is too short for an STL file");
  std::uint32_t count = 0;
  std::memcpy(&count, head.text.data() + 80, 4);
  if (head.size - before < triangle * count)
    head.refuse("is too short for the " + std::to_string(count) + " triangles it announces");
}

/// A count as PLY and OFF write it; those that are none are greater than any file.
std::uint64_t count_of(std::istream& words) {
  std::uint64_t count = 0;
  std::string word;
  words >> word;
  if (word.empty() || word.size() > 18 ||
      !std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isdigit(c); }))
    return std::numeric_limits<std::uint64_t>::max();
  for (const char digit : word) count = 10 * count + static_cast<std::uint64_t>(digit - '0');
  return count;
}

std::uint64_t bytes_of(const std::string& ply_type) {
  static const std::map<std::string, std::uint64_t> bytes{
      {"char", 1},  {"uchar", 1},  {"int8", 1},  {"uint8", 1},   {"short", 2},
      {"ushort", 2}, {"int16", 2}, {"uint16", 2}, {"int", 4},    {"uint", 4},
      {"int32", 4}, {"uint32", 4}, {"float", 4}, {"float32", 4}, {"double", 8},
      {"float64", 8}};
  const auto found = bytes.find(ply_type);
  return found == bytes.end() ? 1 : found->second;
}

void judge_ply(const Head& head) {
  const std::size_t end = head.text.find("end_header");
  if (end == std::string::npos) head.refuse("has no end of its PLY header");
  std::istringstream lines(head.text.substr(0, end));
  bool text = true;
  std::string element;
  std::uint64_t count = 0, bytes = 0;
  const auto judge = [&] { head.judge(count, bytes, "elements '" + element + "'"); };
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, type;
    words >> word;
    if (word == "format") {
      words >> type;
      text = type == "ascii";
    } else if (word == "element") {
      judge();
      words >> element;
      count = count_of(words);
      bytes = 0;
    } else if (word == "property") {
      words >> type;
      if (type == "list") words >> type;  // of which only the count must be there
      bytes += text ? 2 : bytes_of(type);
    }
  }
  judge();
}

/// Lines with anything on them but a remark.
std::uint64_t lines_of(const fs::path& file) {
  std::uint64_t count = 0;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t word = line.find_first_not_of(" \t\r");
    count += word != std::string::npos && line[word] != '#' && line[word] != 'O';
  }
  return count == 0 ? 0 : count - 1;  // one of them has the counts
}

void judge_off(const Head& head) {
  std::string text;
  std::istringstream lines(head.text);
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.find('#')) + ' ';
  std::istringstream words(text);
  // The word OFF may be missing.
  const std::istream::pos_type begin = words.tellg();
  std::string magic;
  words >> magic;
  if (magic.find("OFF") == std::string::npos) words.seekg(begin);
  const std::uint64_t points = count_of(words), faces = count_of(words);
  head.judge(points, 6, "points");
  head.judge(faces, 4, "faces");
  // A point or a face is a line, and assimp reads as many as it was promised.
  if (lines_of(head.file) < points + faces)
    head.refuse("is too short for the " + std::to_string(points) + " points and " +
                std::to_string(faces) + " faces it announces");
}

/// In small letters, with the dot.
std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

bool is_surface_file(const fs::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".off";
}

void judge_announced_counts(const fs::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".stl") judge_stl(Head(file));
  if (extension == ".ply") judge_ply(Head(file));
  if (extension == ".off") judge_off(Head(file));
}

}  // namespace certet
