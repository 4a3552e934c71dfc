#include <fstream>
#include <iterator>

#include "certet/formula.hpp"
#include "domains/refused_file.hpp"

namespace certet {

std::string read_formula(const std::filesystem::path& file) {
  constexpr std::size_t longest = std::size_t{16} << 20;
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) refuse(file, "is not a file");
  if (std::filesystem::file_size(file, failure) > longest) refuse(file, "is too long for a formula");
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof()) refuse(file, "cannot be read");
  std::string formula;
  bool comment = false;
  for (const char c : text) {
    if (c == '\0') refuse(file, "is not text");
    if (c == '\n') comment = false;
    if (c == '#') comment = true;
    if (!comment) formula += c >= 0 && c < ' ' ? ' ' : c;
  }
  const std::size_t begin = formula.find_first_not_of(' ');
  if (begin == formula.npos) refuse(file, "has no formula");
  return formula.substr(begin, formula.find_last_not_of(' ') - begin + 1);
}

}  // namespace certet
