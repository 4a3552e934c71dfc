#include "reader.hpp"

#include <unistd.h>

#include <fstream>

namespace fuzz {
namespace {

namespace fs = std::filesystem;

fs::path place() {
  std::error_code ignored;
  const fs::path folder =
      fs::is_directory("/dev/shm", ignored) ? "/dev/shm" : fs::temp_directory_path();
  return folder / ("certet-fuzz-" + std::to_string(getpid()));
}

void write(const fs::path& path, Bytes bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw Finding("'" + path.string() + "' cannot be written");
}

}  // namespace

InputFile::InputFile(Bytes bytes, std::string_view extension) : path_(place()) {
  path_ += extension;
  write(path_, bytes);
}

InputFile::~InputFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

InputFolder::InputFolder() : path_(place()) { fs::create_directory(path_); }

InputFolder::~InputFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void InputFolder::put(std::string_view name, Bytes bytes) const { write(path_ / name, bytes); }

void judge_sentence(const certet::Error& error) {
  const std::string sentence = error.what();
  if (sentence.empty()) throw Finding("an error says nothing");
  if (sentence.find('\n') != sentence.npos)
    throw Finding("an error says more than one line: " + sentence);
}

}  // namespace fuzz
