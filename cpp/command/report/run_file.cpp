#include "run_file.hpp"

#include <fmt/format.h>

#include <fstream>

#include "certet/error.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {
namespace {

/// Throws nlohmann's exceptions where a key is missing or of another type.
RunFile understand(const Json& json) {
  RunFile run;
  const auto text = [](const Json& value) { return value.get<std::string>(); };
  if (text(json.at("command")) != "mesh" || json.at("dry_run").get<bool>())
    throw Error(ErrorCode::bad_input, "");
  run.points = json.at("mesh").at("points").get<std::uint64_t>();
  run.tets = json.at("mesh").at("tets").get<std::uint64_t>();
  const Json& input = json.at("input");
  const Json& lattice = json.at("lattice");
  const Json& guarantee = json.at("guarantee");
  const auto cells = lattice.at("cells").get<std::array<std::int64_t, 3>>();
  run.theorem = text(guarantee.at("theorem"));
  run.bounds = {guarantee.at("min_dihedral").get<double>(),
                guarantee.at("max_dihedral").get<double>(), {}};
  const auto add = [&run](const char* title, std::string value) {
    run.rows.push_back({title, std::move(value)});
  };
  add("input", fmt::format("{} ({})", text(input.at("name")), text(input.at("kind"))));
  add("lattice", fmt::format("{} × {} × {} cells of size {:g}", cells[0], cells[1], cells[2],
                             lattice.at("size").get<double>()));
  add("cuts", text(lattice.at("cuts")));
  const std::string used = text(guarantee.at("used")), asked = text(guarantee.at("asked"));
  add("guarantee", used == asked ? used : used + ", instead of " + asked);
  add("proven", fmt::format("{:g}° to {:g}°, {}", run.bounds.min_dihedral,
                            run.bounds.max_dihedral, run.theorem));
  add("checksum", text(json.at("mesh").at("checksum")));
  add("time", fmt::format("{:.2f} s", json.at("seconds").at("total").get<double>()));
  add("memory", bytes(json.at("memory").at("peak").get<std::uint64_t>()));
  add("made by", "certet " + text(json.at("certet")));
  return run;
}

}  // namespace

RunFile read_run(const std::filesystem::path& file) {
  const auto refuse = [&file](const char* reason) {
    throw Error(ErrorCode::bad_input, "'" + file.string() + "' " + reason);
  };
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse("cannot be read");
  try {
    return understand(Json::parse(stream));
  } catch (const Json::exception&) {
    refuse("is not what `certet mesh --json` writes");
  } catch (const Error&) {
    refuse("does not tell of a mesh that was written");
  }
  return {};
}

}  // namespace certet::command
