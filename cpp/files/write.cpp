// A mesh in memory, to a file.

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certet/curved_quality.hpp"
#include "certet/error.hpp"
#include "certet/formats.hpp"
#include "certet/placed_quality.hpp"

namespace certet {
namespace {

/// Tetrahedra that are written between two looks at whether to go on.
constexpr std::size_t tets_at_a_time = std::size_t{1} << 20;

Format format_told_by(const std::filesystem::path& file) {
  if (const std::optional<Format> format = format_of(file)) return *format;
  throw Error(ErrorCode::bad_option, "the extension of '" + file.string() +
                                         "' is that of no known format, which are " +
                                         format_names());
}

template <class Index>
void write_tets(MeshWriter& writer, std::span<const Tet<Index>> tets,
                std::span<const std::int32_t> labels, const Context& context) {
  for (std::size_t begin = 0; begin < tets.size(); begin += tets_at_a_time) {
    stop_if_cancelled(context);
    const std::size_t count = std::min(tets_at_a_time, tets.size() - begin);
    writer.tets(tets.subspan(begin, count), labels.empty() ? labels : labels.subspan(begin, count));
  }
  stop_if_cancelled(context);
}

std::vector<std::string> losses_of(Format format, const MeshSize& size) {
  return size.survey == nullptr ? std::vector<std::string>() : label_losses(format, *size.survey);
}

/// What `certet mesh` refuses to write is not written here either.
void refuse_unsound(const Mesh& mesh, std::span<const Point3> world,
                    const std::filesystem::path& file) {
  switch (standing_of(measure_placed(mesh, world), facts(mesh.method).bounds)) {
    case Standing::within: return;
    case Standing::blurred:
      throw Error(ErrorCode::write_failed,
                  "cannot write '" + file.string() + "': so far from the origin double precision "
                  "cannot hold the mesh; with a frame whose origin is 0 it can");
    case Standing::outside:
      throw Error(ErrorCode::check_failed,
                  "'" + file.string() + "' was not written: the mesh has angles that " +
                      std::string(bounds_of(mesh).theorem) + " rules out");
  }
}

/// `middles` is null where tetrahedra have four nodes.
std::vector<std::string> write_nodes(const Mesh& mesh, std::shared_ptr<const MiddleNodes> middles,
                                     const std::filesystem::path& file, Format format,
                                     Context& context) {
  const Buffer<Point3> world = world_points(mesh);
  refuse_unsound(mesh, world, file);
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& buffer) {
        const std::span<const Tet<Index>> tets = buffer;
        MeshSize size{mesh.points.size(), tets.size(), !mesh.labels.empty()};
        if (middles != nullptr) size.points += middles->count();
        size.middles = middles;
        if (needs_survey(format))
          size.survey = std::make_shared<const Survey>(survey(mesh, context));
        const std::unique_ptr<MeshWriter> writer = open_writer(file, format, size);
        writer->points(world);
        if (middles != nullptr) writer->points(middle_points(mesh, *middles));
        write_tets<Index>(*writer, tets, mesh.labels, context);
        writer->finish();
        return losses_of(format, size);
      },
      mesh.tets);
}

/// Takes away the names of patches that have no faces.
void drop_empty_patches(Survey& survey) {
  std::vector<std::uint16_t> numbers(patch_names.size() + survey.named_patches.size());
  for (const BoundaryFace& face : survey.boundary) numbers[static_cast<std::size_t>(face.patch)] = 1;
  std::vector<std::string> names;
  for (std::size_t i = patch_names.size(); i < numbers.size(); ++i) {
    if (numbers[i] == 0) continue;
    numbers[i] = static_cast<std::uint16_t>(patch_names.size() + names.size());
    names.push_back(std::move(survey.named_patches[i - patch_names.size()]));
  }
  for (BoundaryFace& face : survey.boundary)
    if (static_cast<std::size_t>(face.patch) >= patch_names.size())
      face.patch = static_cast<Patch>(numbers[static_cast<std::size_t>(face.patch)]);
  survey.named_patches = std::move(names);
}

/// By their names; of a surface that is nowhere on the boundary nothing is left.
void set_patches(Survey& survey, const FileMesh& mesh) {
  constexpr std::size_t most = std::numeric_limits<std::uint16_t>::max();
  std::map<std::string_view, std::size_t> numbers;
  for (std::size_t i = 0; i < patch_names.size(); ++i) numbers.emplace(patch_names[i], i);
  std::vector<PatchFace> faces;
  for (const auto& points : mesh.border) faces.push_back({points, Patch::border});
  for (const FileSurface& patch : mesh.patches) {
    const auto [known, is_new] = numbers.emplace(patch.name, numbers.size());
    if (known->second > most) break;
    if (is_new) survey.named_patches.push_back(patch.name);
    for (const auto& points : patch.faces)
      faces.push_back({points, static_cast<Patch>(known->second)});
  }
  certet::set_patches(survey, std::move(faces));
  drop_empty_patches(survey);
}

}  // namespace

std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file, Format format,
                               Context& context) {
  return write_nodes(mesh, nullptr, file, format, context);
}

std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file,
                               Context& context) {
  return write(mesh, file, format_told_by(file), context);
}

std::vector<std::string> write(const Mesh& mesh, const MiddleNodes& middles,
                               const std::filesystem::path& file, Format format,
                               Context& context) {
  if (middles.corners() != mesh.points.size())
    throw Error(ErrorCode::bad_option, "the middle nodes are those of another mesh");
  // Not a copy: the caller's nodes outlive the writer.
  return write_nodes(mesh, {std::shared_ptr<const MiddleNodes>(), &middles}, file, format, context);
}

std::vector<std::string> write(const Mesh& mesh, const MiddleNodes& middles,
                               const std::filesystem::path& file) {
  Context context;
  return write(mesh, middles, file, format_told_by(file), context);
}

std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file) {
  Context context;
  return write(mesh, file, context);
}

std::vector<std::string> write(const FileMesh& mesh, const std::filesystem::path& file,
                               Format format, Context& context) {
  for (const Tet<std::uint64_t>& tet : mesh.tets)
    for (const std::uint64_t point : tet)
      if (point >= mesh.points.size())
        throw Error(ErrorCode::bad_input, "cannot write '" + file.string() +
                                              "': a tetrahedron names a point that is not there");
  const FileMiddleNodes nodes = file_middle_nodes(mesh, file);
  MeshSize size{mesh.points.size() + nodes.points.size(), mesh.tets.size(), !mesh.labels.empty()};
  size.space = mesh.space;
  size.middles = nodes.middles;
  if (needs_survey(format)) size.survey = std::make_shared<const Survey>(survey(mesh, context));
  const std::unique_ptr<MeshWriter> writer = open_writer(file, format, size);
  writer->points(mesh.points);
  writer->points(nodes.points);
  write_tets<std::uint64_t>(*writer, mesh.tets, mesh.labels, context);
  writer->finish();
  return losses_of(format, size);
}

std::vector<std::string> write(const FileMesh& mesh, const std::filesystem::path& file) {
  Context context;
  return write(mesh, file, format_told_by(file), context);
}

FileMiddleNodes file_middle_nodes(const FileMesh& mesh, const std::filesystem::path& file) {
  if (mesh.middles.empty()) return {};
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorCode::bad_input, "cannot write '" + file.string() + "': " + what);
  };
  FileMiddleNodes nodes{
      std::make_shared<const MiddleNodes>(middle_nodes(mesh.points.size(), mesh.tets)), {}};
  constexpr std::uint64_t none = ~std::uint64_t{0};
  std::vector<std::uint64_t> node_of(nodes.middles->count(), none);
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    const auto edges = nodes.middles->of(mesh.tets[i]);
    for (std::size_t e = 0; e < 6; ++e) {
      const std::uint64_t node = mesh.middles[i][e];
      if (node >= mesh.middle_points.size()) fail("a tetrahedron names a point that is not there");
      if (node_of[edges[e]] != none && node_of[edges[e]] != node)
        fail("an edge has several middle nodes");
      node_of[edges[e]] = node;
    }
  }
  for (const std::uint64_t node : node_of) nodes.points.push_back(mesh.middle_points[node]);
  return nodes;
}

Survey survey(const FileMesh& mesh, Context& context) {
  Survey found = survey(mesh.points.size(), std::span<const Tet<std::uint64_t>>(mesh.tets),
                        mesh.labels, context);
  set_patches(found, mesh);
  name_regions(found, mesh.names);
  return found;
}

CheckReport check(const FileMesh& mesh, Context& context) {
  CheckReport report =
      check(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets), context);
  if (mesh.middles.empty()) return report;
  const CurvedQuality curved =
      measure_curved(mesh.points, mesh.tets, mesh.middle_points, mesh.middles, context);
  report.failures.insert(report.failures.end(), curved.failures.begin(), curved.failures.end());
  return report;
}

CheckReport check(const FileMesh& mesh) {
  Context context;
  return check(mesh, context);
}

Quality quality(const FileMesh& mesh) {
  return check(mesh).quality;
}

}  // namespace certet
