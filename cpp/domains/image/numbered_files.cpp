#include "numbered_files.hpp"

#include <cstdlib>
#include <sstream>

#include "image_file.hpp"

namespace certet {
namespace {

/// What a pattern says: what is before and behind the number, and how wide it is.
struct Pattern {
  std::string before, behind;
  std::size_t width = 0;
  char fill = ' ';
};

/// Of `%d`, `%5d`, `%05d`, once; nothing else has a meaning.
bool parse(const std::string& word, Pattern& pattern) {
  const std::size_t at = word.find('%');
  if (at == word.npos) return false;
  std::size_t end = at + 1;
  if (end < word.size() && word[end] == '0') pattern.fill = '0';
  while (end < word.size() && word[end] >= '0' && word[end] <= '9') ++end;
  if (end - at > 3 || end == word.size() || (word[end] != 'd' && word[end] != 'i')) return false;
  pattern.width = static_cast<std::size_t>(std::atoi(word.substr(at + 1, end - at - 1).c_str()));
  pattern.before = word.substr(0, at);
  pattern.behind = word.substr(end + 1);
  return pattern.behind.find('%') == word.npos;
}

std::string name(const Pattern& pattern, long number) {
  std::string digits = std::to_string(number);
  if (digits.size() < pattern.width)
    digits.insert(0, std::string(pattern.width - digits.size(), pattern.fill));
  return pattern.before + digits + pattern.behind;
}

}  // namespace

std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& header,
                                                  const std::string& text) {
  std::istringstream words(text);
  std::string word;
  long first = 0, last = 0, step = 1;
  Pattern pattern;
  if (!(words >> word >> first >> last) || !parse(word, pattern))
    return {header.parent_path() / text};
  words >> step;
  if (first < 0 || last < 0 || step == 0 || (last - first) / step < 0 ||
      (last - first) / step > most_files)
    refuse(header, "names its files by numbers that make no sense");
  std::vector<std::filesystem::path> files;
  for (long number = first; step > 0 ? number <= last : number >= last; number += step)
    files.push_back(header.parent_path() / name(pattern, number));
  return files;
}

}  // namespace certet
