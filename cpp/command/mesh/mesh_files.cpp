#include "mesh_files.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "certet/error.hpp"
#include "outputs.hpp"

namespace certet::command {
namespace {

std::vector<std::filesystem::path> input_files(const MeshOptions& options) {
  std::vector<std::filesystem::path> files;
  if (!options.input.empty()) files.push_back(options.input);
  const auto add = [&files](const SolidChoice& solid) {
    if (!solid.file.empty()) files.push_back(solid.file);
  };
  for (const MaterialChoice& material : options.materials) add(material.solid);
  std::ranges::for_each(options.inside, add);
  std::ranges::for_each(options.without, add);
  return files;
}

}  // namespace

void check_outputs(const MeshOptions& options) {
  const bool json_file = options.run.has_json_file();
  for (const std::filesystem::path& input : input_files(options)) {
    if (!options.output.empty() && same_file(input, options.output))
      throw Error(ErrorCode::bad_option,
                  "input and output are the same file '" + input.string() + "'");
    if (json_file && same_file(input, options.run.json))
      throw Error(ErrorCode::bad_option,
                  "input and --json are the same file '" + input.string() + "'");
  }
  if (!options.output.empty()) {
    for (const std::filesystem::path& file : files_of(options.output, options.format))
      if (json_file && same_file(file, options.run.json))
        throw Error(ErrorCode::bad_option,
                    "output and --json are the same file '" + file.string() + "'");
    if (!options.dry_run) check_mesh_output(options.output, options.format);
  }
  if (json_file) check_output(options.run.json);
}

}  // namespace certet::command
