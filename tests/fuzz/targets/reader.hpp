#pragma once
/// \file
/// What is asked of every reader: it succeeds, or it throws a certet::Error with
/// one sentence.

#include <array>
#include <filesystem>
#include <string>

#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "target.hpp"

namespace fuzz {

/// A file that is there while the object lives; in memory, where the system can.
class InputFile {
 public:
  InputFile(Bytes bytes, std::string_view extension);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A folder that is there, with its files, while the object lives.
class InputFolder {
 public:
  InputFolder();
  ~InputFolder();
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  void put(std::string_view name, Bytes bytes) const;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The first byte chooses; the rest is the file.
template <std::size_t count>
InputFile chosen_file(Bytes bytes, const std::array<std::string_view, count>& extensions) {
  return InputFile(bytes.subspan(1), extensions[bytes[0] % count]);
}

/// \throws Finding where an error does not say one sentence.
void judge_sentence(const certet::Error& error);

/// Reads, or is refused.  Whatever else is thrown goes through.
template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const certet::Error& error) {
    judge_sentence(error);
  }
}

/// Reads a mesh in one of the formats that are read, in one thread, and does something with
/// it; or is refused.  No bytes are no mesh.
template <class Use>
void read_mesh_or_refuse(Bytes bytes, const Use& use) {
  if (bytes.empty()) return;
  const InputFile file =
      chosen_file(bytes, std::array<std::string_view, 4>{".vtu", ".mesh", ".meshb", ".msh"});
  certet::Context context;
  context.threads = 1;
  read_or_refuse([&] { use(certet::read(file.path(), context), context); });
}

}  // namespace fuzz
