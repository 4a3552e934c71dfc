#include "reader.hpp"

#include <unistd.h>

#include <fstream>

namespace fuzz {
namespace {

namespace fs = std::filesystem;

fs::path folder() {
  std::error_code ignored;
  return fs::is_directory("/dev/shm", ignored) ? "/dev/shm" : fs::temp_directory_path();
}

}  // namespace

InputFile::InputFile(Bytes bytes, std::string_view extension)
    : path_(folder() / ("certet-fuzz-" + std::to_string(getpid()))) {
  path_ += extension;
  std::ofstream file(path_, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw Finding("'" + path_.string() + "' cannot be written");
}

InputFile::~InputFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void judge_sentence(const certet::Error& error) {
  const std::string sentence = error.what();
  if (sentence.empty()) throw Finding("an error says nothing");
  if (sentence.find('\n') != sentence.npos)
    throw Finding("an error says more than one line: " + sentence);
}

}  // namespace fuzz
