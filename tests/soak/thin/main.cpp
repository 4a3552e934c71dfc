/// \file
/// certet_thin_soak: meshes random label images with thin parts and random fields of signs by a
/// method that keeps their shape, and judges each mesh by independent counts.
///
///     certet_thin_soak [--images N] [--fields N] [--seed S] [--only image:N|field:N]
///                      [--method embedded|key] [--threads N] [--plant NAME] [--report FILE.md]
///
/// Ends with status 1 if a mesh has a fault, 2 on wrong usage.

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "../campaign.hpp"
#include "thin_trial.hpp"

namespace {

using thin::Source;
using thin::Verdict;

struct Arguments : soak::CampaignArguments {
  std::array<std::uint64_t, 2> count{100, 100}, first{0, 0};
  certet::Method method{};
  thin::Plant plant{};
};

void only(Arguments& arguments, const std::string& value) {
  const std::size_t colon = value.find(':');
  if (colon == std::string::npos) throw std::invalid_argument(value + " has no colon");
  const std::size_t source = soak::number_of(thin::source_names, value.substr(0, colon));
  arguments.count = {0, 0};
  arguments.count[source] = 1;
  arguments.first[source] = std::stoull(value.substr(colon + 1));
}

certet::Method method_of(const std::string& name) {
  const std::optional<certet::Method> method = certet::method_named(name);
  if (!method || !certet::facts(*method).settles)
    throw std::invalid_argument(name + " is not a method by which vertices settle");
  return *method;
}

/// \throws std::exception on wrong usage
Arguments parse(int argc, char** argv) {
  Arguments arguments;
  soak::read_options(argc, argv, [&](const std::string& name, const std::string& value) {
    if (name == "--images") arguments.count[0] = std::stoull(value);
    else if (name == "--fields") arguments.count[1] = std::stoull(value);
    else if (name == "--plant") arguments.plant = static_cast<thin::Plant>(soak::number_of(thin::plant_names, value));
    else if (name == "--only") only(arguments, value);
    else if (name == "--method") arguments.method = method_of(value);
    else return arguments.take(name, value);
    return true;
  });
  return arguments;
}

/// An exception is a fault too.
Verdict judged(Source source, std::uint64_t number, const Arguments& arguments) {
  try {
    return thin::judge(source, arguments.seed, number, arguments.method, arguments.plant);
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
  soak::MeshCounts sum;
  std::uint64_t faulty = 0;
  std::ostringstream sentences;
  for (std::size_t n = 0; n < verdicts.size(); ++n) {
    const Verdict& v = verdicts[n];
    sum += v;
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
  soak::tell(arguments, table.str());
  return faulty;
}

}  // namespace

int main(int argc, char** argv) {
  return soak::campaign("certet_thin_soak", [&] { return parse(argc, argv); }, tell_all);
}
