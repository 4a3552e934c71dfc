#include "run_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>

#include "certet/error.hpp"
#include "certet/method.hpp"
#include "distance.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {
namespace {

constexpr const char* not_a_run = "is not what `certet mesh --json` writes";
constexpr const char* other_theorem = "names another theorem or other bounds than such a run has";

[[noreturn]] void refuse_run(const char* reason) { throw Error(ErrorCode::bad_input, reason); }

std::string text(const Json& value) { return value.get<std::string>(); }

/// "0x0123456789abcdef"
std::uint64_t hexadecimal(const std::string& digits) {
  std::uint64_t number = 0;
  const char* const end = digits.data() + digits.size();
  if (digits.size() != 18 || !digits.starts_with("0x")) refuse_run(not_a_run);
  const auto [stop, failure] = std::from_chars(digits.data() + 2, end, number, 16);
  if (failure != std::errc() || stop != end) refuse_run(not_a_run);
  return number;
}

/// The method that the run used in the end.  Runs of older versions name a guarantee
/// with cuts in the middle too, where it had no part in the mesh.
Method method_of(const Json& json) {
  const std::string cuts = text(json.at("lattice").at("cuts"));
  const std::optional<Method> used = method_named(text(json.at("guarantee").at("used")));
  if (!used) refuse_run(not_a_run);
  const Method method = cuts == name(Cuts::midpoint) ? Method::midpoint : *used;
  if (cuts != name(facts(method).cuts)) refuse_run(not_a_run);
  return method;
}

/// The bounds are the product's own, never those that a file claims.
AngleBounds bounds_of(const Json& json) {
  const Method method = method_of(json);
  const Json& guarantee = json.at("guarantee");
  AngleBounds bounds = facts(method).bounds;
  if (facts(method).interfaces && text(guarantee.at("theorem")) != bounds.theorem)
    bounds = certet::bounds_of(method, true);
  if (json.value("theorem", std::string(bounds.theorem)) != bounds.theorem) refuse_run(other_theorem);
  if (json.contains("method") && text(json.at("method").at("name")) != name(method))
    refuse_run(other_theorem);
  if (text(guarantee.at("theorem")) != bounds.theorem ||
      guarantee.at("min_dihedral").get<double>() != bounds.min_dihedral ||
      guarantee.at("max_dihedral").get<double>() != bounds.max_dihedral)
    refuse_run(other_theorem);
  if (!guarantee.at("holds").get<bool>()) refuse_run("does not tell of a mesh that was written");
  return bounds;
}

std::vector<PageRow> rows_of(const Json& json) {
  std::vector<PageRow> rows;
  const auto add = [&rows](const char* title, std::string value) {
    rows.push_back({title, std::move(value)});
  };
  const Json& input = json.at("input");
  const Json& lattice = json.at("lattice");
  const Json& guarantee = json.at("guarantee");
  const auto cells = lattice.at("cells").get<std::array<std::int64_t, 3>>();
  add("input", fmt::format("{} ({})", text(input.at("name")), text(input.at("kind"))));
  add("lattice", fmt::format("{} × {} × {} cells of size {:g}", cells[0], cells[1], cells[2],
                             lattice.at("size").get<double>()));
  add("cuts", text(lattice.at("cuts")));
  const std::string used{name(method_of(json))};
  const bool fell_back = text(guarantee.at("used")) != text(guarantee.at("asked"));
  add("method", fell_back ? used + ", instead of " + text(guarantee.at("asked")) : used);
  if (json.contains("distance")) {
    const auto rows_of_distance = page_rows(distance_of(json.at("distance")));
    rows.insert(rows.end(), rows_of_distance.begin(), rows_of_distance.end());
  }
  add("checksum", text(json.at("mesh").at("checksum")));
  add("time", fmt::format("{:.2f} s", json.at("seconds").at("total").get<double>()));
  add("memory", bytes(json.at("memory").at("peak").get<std::uint64_t>()));
  add("made by", "certet " + text(json.at("certet")));
  return rows;
}

/// Throws nlohmann's exceptions where a key is missing or of another type, and Error
/// with what is wrong with the file.
RunFile understand(const Json& json) {
  RunFile run;
  if (text(json.at("command")) != "mesh" || json.at("dry_run").get<bool>())
    refuse_run("does not tell of a mesh that was written");
  const Json& mesh = json.at("mesh");
  run.points = mesh.at("points").get<std::uint64_t>();
  run.tets = mesh.at("tets").get<std::uint64_t>();
  run.bounds = bounds_of(json);
  run.rows = rows_of(json);
  run.edge = json.at("lattice").at("size").get<double>() * json.at("output").value("scale", 1.0);
  if (!mesh.contains("file_checksum"))
    refuse_run("does not tell what its output holds (mesh.file_checksum)");
  run.file_checksum = hexadecimal(text(mesh.at("file_checksum")));
  return run;
}

}  // namespace

RunFile read_run(const std::filesystem::path& file) {
  const auto refuse_file = [&file](const std::string& reason) {
    throw Error(ErrorCode::bad_input, "'" + file.string() + "' " + reason);
  };
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse_file("cannot be read");
  RunFile run;
  try {
    run = understand(Json::parse(stream));
  } catch (const Json::exception&) {
    refuse_file(not_a_run);
  } catch (const Error& error) {
    refuse_file(error.what());
  }
  run.file = file;
  return run;
}

std::string content_defect(const RunFile& run, const std::filesystem::path& file,
                           const FileMesh& mesh, std::uint64_t checksum) {
  if (run.points != mesh.points.size() || run.tets != mesh.tets.size())
    throw Error(ErrorCode::bad_input, "'" + run.file.string() + "' tells of another mesh than '" +
                                          file.string() + "'");
  if (checksum == run.file_checksum) return {};
  return fmt::format("the points and tetrahedra are not those that the run of '{}' wrote (checksum "
                     "0x{:016x} instead of 0x{:016x}), so that no theorem is known to cover them",
                     run.file.string(), checksum, run.file_checksum);
}

}  // namespace certet::command
