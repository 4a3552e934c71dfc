// The command line: its words are read, but nothing is carried out.  Values that
// `certet mesh` reads later are read too, and a shape is made of its name.

#include <CLI/CLI.hpp>

#include "certet/shape.hpp"
#include "command_line.hpp"
#include "mesh/mesh_options.hpp"
#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {
namespace {

using namespace certet::command;

/// One for each line, without zeros, which no word of a command line has.
std::vector<std::string> words_of(Bytes bytes) {
  std::vector<std::string> words{"certet"};
  bool begins = true;
  for (const std::uint8_t byte : bytes) {
    if (byte == 0) continue;
    if (begins) words.emplace_back();
    begins = byte == '\n';
    if (!begins) words.back() += static_cast<char>(byte);
  }
  return words;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size());
  for (std::string& word : words) pointers.push_back(word.data());
  return pointers;
}

void read_mesh_options(int count, char** words) {
  CLI::App app;
  const auto finish = declare_mesh_options(app);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError&) {
    return;
  }
  const MeshOptions options = finish();
  if (!options.shape.empty())
    certet::ShapeDomain(options.shape, options.bounds, options.size, options.margin);
}

}  // namespace

void options(Bytes bytes) {
  std::vector<std::string> words = words_of(bytes);
  std::vector<char*> pointers = pointers_to(words);
  const int count = static_cast<int>(pointers.size());
  read_or_refuse([&] { CommandLine().parse(count, pointers.data()); });
  // The second word is the subcommand.
  if (count > 1) read_or_refuse([&] { read_mesh_options(count - 1, pointers.data() + 1); });
}

}  // namespace fuzz
