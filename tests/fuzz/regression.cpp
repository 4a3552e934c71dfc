/// \file
/// Runs a target on its corpus, and on damaged copies of it.
///
///     certet_fuzz_regression TARGET FOLDER|FILE... [--cuts N] [--mutations N] [--seed S]
///                            [--last FILE]
///
/// A folder that is not there is passed over.  Each input is tried cut off at N places
/// too, and N damaged copies of all are made.  Each damaged input lies in FILE (TARGET.last) while it is worked on, and stays
/// there when the program dies of it.  Ends with status 1 if there is a finding,
/// 2 on wrong usage.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "mutate.hpp"
#include "target.hpp"

namespace {

namespace fs = std::filesystem;
using fuzz::Input;

struct Arguments {
  std::string target, last;
  std::vector<fs::path> corpora;
  std::uint64_t cuts = 0, mutations = 0, seed = 1;
};

/// \throws std::exception on wrong usage
Arguments parse(int argc, char** argv) {
  if (argc < 3) throw std::invalid_argument("a target and a corpus are needed");
  Arguments arguments{argv[1], std::string(argv[1]) + ".last", {}};
  int i = 2;
  for (; i < argc && argv[i][0] != '-'; ++i) arguments.corpora.emplace_back(argv[i]);
  for (; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--mutations") arguments.mutations = std::stoull(value);
    else if (name == "--cuts") arguments.cuts = std::stoull(value);
    else if (name == "--seed") arguments.seed = std::stoull(value);
    else if (name == "--last") arguments.last = value;
    else throw std::invalid_argument("there is no option " + name);
  }
  return arguments;
}

Input read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return Input(std::istreambuf_iterator<char>(stream), {});
}

void write(const fs::path& file, const Input& input) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(input.data()),
               static_cast<std::streamsize>(input.size()));
}

/// In the order of their names, for the same run everywhere.
std::vector<fs::path> files_of(const fs::path& corpus) {
  if (fs::is_regular_file(corpus)) return {corpus};
  std::vector<fs::path> files;
  if (!fs::exists(corpus)) return files;
  for (const auto& entry : fs::directory_iterator(corpus)) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// \returns whether all is well.
bool runs(const fuzz::Target& target, const Input& input, const std::string& what) {
  try {
    target.run(input);
    return true;
  } catch (const std::exception& finding) {
    std::cout << "finding: " << target.name << ", " << what << ": " << finding.what() << '\n';
    return false;
  }
}

/// Evenly spaced, and without the last byte.
bool runs_cut(const fuzz::Target& target, const Input& input, const Arguments& arguments) {
  for (std::uint64_t cut = 0; cut < arguments.cuts && !input.empty(); ++cut) {
    Input begin = input;
    begin.resize(cut == 0 ? input.size() - 1 : input.size() * cut / arguments.cuts);
    write(arguments.last, begin);
    if (!runs(target, begin, "cut to " + std::to_string(begin.size()) + ", in " + arguments.last))
      return false;
  }
  return true;
}

int run(const Arguments& arguments) {
  const fuzz::Target& target = fuzz::target_named(arguments.target);
  std::vector<Input> inputs;
  for (const fs::path& corpus : arguments.corpora)
    for (const fs::path& file : files_of(corpus)) {
      inputs.push_back(read(file));
      write(arguments.last, inputs.back());
      if (!runs(target, inputs.back(), file.string())) return 1;
      if (!runs_cut(target, inputs.back(), arguments)) return 1;
    }
  if (inputs.empty()) throw std::invalid_argument("the corpus is empty");
  std::cout << target.name << ": " << inputs.size() << " inputs, " << arguments.mutations
            << " mutations, seed " << arguments.seed << std::endl;
  std::mt19937_64 random(arguments.seed);
  for (std::uint64_t number = 0; number < arguments.mutations; ++number) {
    const Input& one = inputs[random() % inputs.size()];
    const Input& other = inputs[random() % inputs.size()];
    const Input input = fuzz::mutated(one, other, random);
    write(arguments.last, input);
    if (!runs(target, input, "mutation " + std::to_string(number) + ", in " + arguments.last))
      return 1;
  }
  fs::remove(arguments.last);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parse(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "certet_fuzz_regression: " << error.what() << '\n';
    return 2;
  }
}
