// A mesh in memory, to a file.

#include <algorithm>
#include <memory>
#include <string>

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

}  // namespace

std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file, Format format,
                               Context& context) {
  const Buffer<Point3> world = world_points(mesh);
  refuse_unsound(mesh, world, file);
  return std::visit(
      [&]<class Index>(const Buffer<Tet<Index>>& buffer) {
        const std::span<const Tet<Index>> tets = buffer;
        MeshSize size{mesh.points.size(), tets.size(), !mesh.labels.empty()};
        if (needs_survey(format))
          size.survey = std::make_shared<const Survey>(survey(mesh, context));
        const std::unique_ptr<MeshWriter> writer = open_writer(file, format, size);
        writer->points(world);
        write_tets<Index>(*writer, tets, mesh.labels, context);
        writer->finish();
        return losses_of(format, size);
      },
      mesh.tets);
}

std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file,
                               Context& context) {
  return write(mesh, file, format_told_by(file), context);
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
  MeshSize size{mesh.points.size(), mesh.tets.size(), !mesh.labels.empty()};
  size.space = mesh.space;
  if (needs_survey(format)) size.survey = std::make_shared<const Survey>(survey(mesh, context));
  const std::unique_ptr<MeshWriter> writer = open_writer(file, format, size);
  writer->points(mesh.points);
  write_tets<std::uint64_t>(*writer, mesh.tets, mesh.labels, context);
  writer->finish();
  return losses_of(format, size);
}

std::vector<std::string> write(const FileMesh& mesh, const std::filesystem::path& file) {
  Context context;
  return write(mesh, file, format_told_by(file), context);
}

Survey survey(const FileMesh& mesh, Context& context) {
  Survey found = survey(mesh.points.size(), std::span<const Tet<std::uint64_t>>(mesh.tets),
                        mesh.labels, context);
  set_border(found, mesh.border);
  name_regions(found, mesh.names);
  return found;
}

CheckReport check(const FileMesh& mesh, Context& context) {
  return check(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets), context);
}

CheckReport check(const FileMesh& mesh) {
  Context context;
  return check(mesh, context);
}

Quality quality(const FileMesh& mesh) {
  return check(mesh).quality;
}

}  // namespace certet
