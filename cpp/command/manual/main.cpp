// Writes man pages and completion into a folder:
//   certet_manual FOLDER DATE

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "command_line.hpp"
#include "pages.hpp"

namespace {

bool write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) std::fprintf(stderr, "certet_manual: cannot write '%s'\n", file.c_str());
  return static_cast<bool>(out);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace certet::command;
  if (argc != 3) {
    std::fputs("usage: certet_manual FOLDER DATE\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const CommandLine line;
  const std::vector<CommandText> all = definitions(line.app());
  bool written = write(folder / "bash" / "certet", bash_completion(all)) &&
                 write(folder / "zsh" / "_certet", zsh_completion(all)) &&
                 write(folder / "fish" / "certet.fish", fish_completion(all));
  for (const CommandText& command : all) {
    const std::string name = command.name.empty() ? "certet" : "certet-" + command.name;
    written = written && write(folder / "man1" / (name + ".1"), man_page(command, all, argv[2]));
  }
  return written ? 0 : 1;
}
