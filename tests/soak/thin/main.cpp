/// \file
/// certet_thin_soak: meshes random label images with thin parts and random fields of signs
/// by default, and judges each mesh by independent counts.
///
///     certet_thin_soak [--images N] [--fields N] [--seed S] [--only image:N|field:N]
///                      [--threads N] [--plant NAME] [--report FILE.md]
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <stdexcept>

#include "../campaign.hpp"
#include "thin_trial.hpp"

namespace {

using thin::Source;
using thin::Verdict;

struct Arguments {
  std::array<std::uint64_t, 2> count{100, 100}, first{0, 0};
  std::uint64_t seed = std::random_device{}();
  unsigned threads = 2;
  thin::Plant plant{};
  std::string report;
};

template <class Names>
std::size_t number_of(const Names& names, const std::string& name) {
  const auto at = std::ranges::find(names, name);
  if (at == names.end()) throw std::invalid_argument("there is no " + name);
  return static_cast<std::size_t>(at - names.begin());
}

void only(Arguments& arguments, const std::string& value) {
  const std::size_t colon = value.find(':');
  if (colon == std::string::npos) throw std::invalid_argument(value + " has no colon");
  const std::size_t source = number_of(thin::source_names, value.substr(0, colon));
  arguments.count = {0, 0};
  arguments.count[source] = 1;
  arguments.first[source] = std::stoull(value.substr(colon + 1));
}

/// \throws std::exception on wrong usage
Arguments parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) throw std::invalid_argument(name + " has no value");
    const std::string value = argv[i + 1];
    if (name == "--images") arguments.count[0] = std::stoull(value);
    else if (name == "--fields") arguments.count[1] = std::stoull(value);
    else if (name == "--seed") arguments.seed = std::stoull(value);
    else if (name == "--threads") arguments.threads = static_cast<unsigned>(std::stoul(value));
    else if (name == "--report") arguments.report = value;
    else if (name == "--plant") arguments.plant = static_cast<thin::Plant>(number_of(thin::plant_names, value));
    else if (name == "--only") only(arguments, value);
    else throw std::invalid_argument(name + " is no option");
  }
  return arguments;
}

/// An exception is a fault too.
Verdict judged(Source source, std::uint64_t number, const Arguments& arguments) {
  try {
    return thin::judge(source, arguments.seed, number, arguments.plant);
  } catch (const std::exception& error) {
    Verdict verdict;
    verdict.fault = std::string("an exception: ") + error.what();
    return verdict;
  }
}

std::vector<Verdict> run(Source source, const Arguments& arguments) {
  const auto s = static_cast<std::size_t>(source);
  return soak::verdicts_of(arguments.count[s], arguments.threads, [&](std::uint64_t i) {
    return judged(source, arguments.first[s] + i, arguments);
  });
}

/// A row of the table, and a sentence for each of the first faults.
std::uint64_t tell(std::ostream& out, Source source, const std::vector<Verdict>& verdicts,
                   std::uint64_t first) {
  Verdict sum;
  std::uint64_t faulty = 0;
  std::ostringstream sentences;
  for (std::size_t n = 0; n < verdicts.size(); ++n) {
    const Verdict& v = verdicts[n];
    sum.tets += v.tets;
    sum.pairs += v.pairs;
    sum.pieces += v.pieces;
    sum.tunnels += v.tunnels;
    sum.cavities += v.cavities;
    sum.min_dihedral = std::min(sum.min_dihedral, v.min_dihedral);
    sum.max_dihedral = std::max(sum.max_dihedral, v.max_dihedral);
    if (v.fault && ++faulty <= 20)
      sentences << "- " << thin::source_names[static_cast<std::size_t>(source)] << ':'
                << first + n << ": " << *v.fault << '\n';
  }
  out << "| " << thin::source_names[static_cast<std::size_t>(source)] << " | " << verdicts.size()
      << " | " << sum.tets << " | " << sum.pieces << " | " << sum.tunnels << " | " << sum.cavities
      << " | " << sum.min_dihedral << " | " << sum.max_dihedral << " | " << sum.pairs << " | "
      << faulty << " |\n"
      << sentences.str();
  return faulty;
}

std::uint64_t tell_all(const Arguments& arguments) {
  std::ostringstream table;
  table << "seed " << arguments.seed << "\n\n| of | meshes | tetrahedra | pieces | tunnels | cavities | "
           "least angle | greatest | pairs compared | with a fault |\n|---|---|---|---|---|---|---|---|---|---|\n";
  std::uint64_t faulty = 0;
  for (const Source source : {Source::image, Source::field})
    faulty += tell(table, source, run(source, arguments),
                   arguments.first[static_cast<std::size_t>(source)]);
  std::cout << table.str();
  if (!arguments.report.empty()) std::ofstream(arguments.report) << table.str();
  return faulty;
}

}  // namespace

int main(int argc, char** argv) {
  return soak::campaign("certet_thin_soak", [&] { return parse(argc, argv); }, tell_all);
}
