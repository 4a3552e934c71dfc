#include "vtu_layout.hpp"

#include <limits>
#include <utility>

namespace certet::formats {
namespace {

/// The narrower integer type that holds 0 to `greatest`.
std::pair<std::string_view, std::uint64_t> integer_for(std::uint64_t greatest) {
  if (greatest <= std::uint64_t{std::numeric_limits<std::int32_t>::max()}) return {"Int32", 4};
  return {"Int64", 8};
}

std::string data_array(std::string_view name, const VtuArray& array,
                       std::string_view more = "") {
  std::string line = "        <DataArray type=\"";
  line.append(array.type).append("\" Name=\"").append(name).append("\"").append(more);
  return line + " format=\"appended\" offset=\"" + std::to_string(array.offset) + "\"/>\n";
}

}  // namespace

std::string vtu_header_of(const VtuLayout& layout, const MeshSize& size, bool compressed) {
  std::string header = "<?xml version=\"1.0\"?>\n";
  if (!size.space.empty()) header += "<!-- SPACE=" + size.space + " -->\n";
  header.append("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"")
      .append(vtu_byte_order)
      .append("\" header_type=\"UInt64\"")
      .append(compressed ? " compressor=\"vtkZLibDataCompressor\">\n" : ">\n");
  header += "  <UnstructuredGrid>\n";
  header += "    <Piece NumberOfPoints=\"" + std::to_string(size.points) +
            "\" NumberOfCells=\"" + std::to_string(size.tets) + "\">\n";
  header += "      <Points>\n" +
            data_array("Points", layout.points, " NumberOfComponents=\"3\"") +
            "      </Points>\n";
  header += "      <Cells>\n" + data_array("connectivity", layout.connectivity) +
            data_array("offsets", layout.offsets) + data_array("types", layout.types) +
            "      </Cells>\n";
  if (size.labels)
    header += "      <CellData Scalars=\"label\">\n" + data_array("label", layout.label) +
              "      </CellData>\n";
  return header + "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
}

VtuLayout::VtuLayout(const MeshSize& size)
    : per_tet(size.middles == nullptr ? 4 : 10),
      cell_type(size.middles == nullptr ? vtk_tetra : vtk_quadratic_tetra),
      footer("\n  </AppendedData>\n</VTKFile>\n") {
  std::uint64_t end = 0;
  const auto place_next = [&end](std::string_view type, std::uint64_t bytes) {
    const VtuArray array{type, bytes, end};
    end += sizeof(std::uint64_t) + bytes;
    return array;
  };
  const auto [index_type, index_bytes] = integer_for(size.points);
  const auto [offset_type, offset_bytes] = integer_for(per_tet * size.tets);
  points = place_next("Float64", size.points * 3 * sizeof(double));
  connectivity = place_next(index_type, size.tets * per_tet * index_bytes);
  offsets = place_next(offset_type, size.tets * offset_bytes);
  types = place_next("UInt8", size.tets);
  if (size.labels) label = place_next("Int32", size.tets * sizeof(std::int32_t));
  header = vtu_header_of(*this, size, false);
  file_bytes = header.size() + end + footer.size();
}

}  // namespace certet::formats
