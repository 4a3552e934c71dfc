#include "voxelise_report.hpp"

#include <algorithm>
#include <numeric>

#include "json.hpp"
#include "table.hpp"

namespace certet::command {
namespace {

std::string name_of(const VoxeliseReport& report, std::int32_t label) {
  const auto named = report.names.find(label);
  return named == report.names.end() ? std::to_string(label) : named->second;
}

const LabelOverlap& worst(const VoxeliseReport& report) {
  return *std::ranges::min_element(report.overlaps, {}, &LabelOverlap::dice);
}

double mean(const VoxeliseReport& report) {
  const double sum = std::accumulate(
      report.overlaps.begin(), report.overlaps.end(), 0.0,
      [](double before, const LabelOverlap& one) { return before + one.dice(); });
  return sum / static_cast<double>(report.overlaps.size());
}

void add_comparison(Lines& lines, const VoxeliseReport& report) {
  if (report.compared.empty() || report.overlaps.empty()) return;
  const LabelOverlap& least = worst(report);
  lines.add("compared", "with {}: Dice {:.4f} on average over {} labels, least {:.4f} of label {}",
            report.compared, mean(report), report.overlaps.size(), least.dice(), least.label);
  std::string_view title = "dice";
  for (const LabelOverlap& one : report.overlaps) {
    const bool is_named = report.names.contains(one.label);
    lines.add(title, "{:.4f}  {}{}{}: {} voxels, {} in the image", one.dice(), one.label,
              is_named ? " " : "", is_named ? name_of(report, one.label) : std::string(),
              grouped(one.first), grouped(one.second));
    title = "";
  }
}

Json json_of(const VoxeliseReport& report, const LabelOverlap& one) {
  Json json = {{"label", one.label}, {"name", name_of(report, one.label)}, {"voxels", one.first}};
  if (report.compared.empty()) return json;
  json["image_voxels"] = one.second;
  json["both"] = one.both;
  json["dice"] = one.dice();
  return json;
}

}  // namespace

std::string table(const VoxeliseReport& report) {
  const Image& image = report.made.image;
  const auto& [nx, ny, nz] = image.size;
  Lines lines;
  lines.add("input", "{} ({} tetrahedra)", report.input, grouped(report.tets));
  if (!report.output.empty()) lines.add("output", "{} ({})", report.output, bytes(report.bytes));
  lines.add("voxels", "{} x {} x {} of {:.6g} x {:.6g} x {:.6g}, {} in the mesh", nx, ny, nz,
            image.spacing[0], image.spacing[1], image.spacing[2], grouped(report.made.held));
  add_comparison(lines, report);
  for (const std::string& warning : report.warnings) lines.add("warning", "{}", warning);
  lines.add("seconds", "{:.2f}", report.seconds);
  return std::move(lines).text();
}

std::string json(const VoxeliseReport& report) {
  const Image& image = report.made.image;
  Json json = json_of_command("voxelise");
  json["input"] = report.input;
  if (!report.output.empty())
    json["output"] = {{"file", report.output}, {"bytes", report.bytes}};
  json["grid"] = {{"size", image.size}, {"spacing", image.spacing}, {"origin", image.origin},
                  {"axes", image.axes}};
  json["mesh"] = {{"tets", report.tets}, {"flat_tets", report.made.flat_tets}};
  json["voxels"] = {{"held", report.made.held}, {"held_twice", report.made.held_twice}};
  json["labels"] = Json::array();
  for (const LabelOverlap& one : report.overlaps) json["labels"].push_back(json_of(report, one));
  if (!report.compared.empty() && !report.overlaps.empty())
    json["compared"] = {{"file", report.compared}, {"mean_dice", mean(report)},
                        {"least_dice", worst(report).dice()}};
  json["seconds"] = report.seconds;
  json["warnings"] = report.warnings;
  return print(json);
}

}  // namespace certet::command
