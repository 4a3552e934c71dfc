#include "certet/formats.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "certet/checksum.hpp"
#include "certet/error.hpp"
#include "gmsh_labels.hpp"
#include "polymesh_files.hpp"
#include "registry.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using namespace formats;

struct Entry {
  Format format;
  std::string_view name;
  std::array<std::string_view, 3> extensions;  ///< none where another format has them
  bool needs_survey;
  OpenWriter* open;
  FileBytes* bytes;
  ReadFile* read;                 ///< null: it is only written
  LabelLosses* losses = nullptr;  ///< null: it has every label
};

constexpr Entry registry[] = {
    {Format::vtu, "vtu", {".vtu"}, false, open_vtu, vtu_bytes, read_vtu},
    {Format::vtu_zlib, "vtu-zlib", {}, false, open_vtu_zlib, vtu_zlib_bytes, read_vtu},
    {Format::medit, "medit", {".mesh"}, true, open_medit, medit_bytes, read_medit},
    {Format::medit_binary, "meditb", {".meshb"}, true, open_medit_binary, medit_binary_bytes,
     read_medit_binary},
    {Format::gmsh, "msh", {".msh"}, true, open_gmsh, gmsh_bytes, read_gmsh,
     gmsh_label_losses},
    {Format::gmsh22, "msh22", {}, true, open_gmsh22, gmsh22_bytes, read_gmsh,
     gmsh_label_losses},
    {Format::abaqus, "inp", {".inp"}, true, open_abaqus, abaqus_bytes, nullptr},
    {Format::febio, "feb", {".feb"}, true, open_febio, febio_bytes, nullptr},
    {Format::nastran, "bdf", {".bdf", ".nas"}, true, open_nastran, nastran_bytes, nullptr,
     nastran_label_losses},
    {Format::dyna, "k", {".k", ".key"}, true, open_dyna, dyna_bytes, nullptr, dyna_label_losses},
    {Format::mfem, "mfem", {".mfem"}, true, open_mfem, mfem_bytes, nullptr, mfem_label_losses},
    {Format::polymesh, "polymesh", {}, true, open_polymesh, polymesh_bytes, nullptr},
    {Format::xdmf, "xdmf", {".xdmf"}, true, open_xdmf, xdmf_bytes, nullptr},
    {Format::vtkhdf, "vtkhdf", {".vtkhdf"}, false, open_vtkhdf, vtkhdf_bytes, nullptr},
    {Format::tetgen, "tetgen", {".node", ".ele", ".face"}, true, open_tetgen, tetgen_bytes,
     nullptr},
    {Format::vtp, "vtp", {".vtp"}, true, open_vtp, vtp_bytes, nullptr},
    {Format::stl, "stl", {".stl"}, true, open_stl, stl_bytes, nullptr},
    {Format::ply, "ply", {".ply"}, true, open_ply, ply_bytes, nullptr},
};

/// OpenFOAM's folder has no extension, but always this name.
bool is_polymesh(const fs::path& file) {
  return (file.has_filename() ? file : file.parent_path()).filename() == "polyMesh";
}

const Entry& entry_of(Format format) {
  return *std::ranges::find(registry, format, &Entry::format);
}

const Entry* entry_of(const fs::path& file) {
  if (is_polymesh(file)) return &entry_of(Format::polymesh);
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const Entry& entry : registry)
    for (const std::string_view known : entry.extensions)
      if (!known.empty() && known == extension) return &entry;
  return nullptr;
}

void append_word(std::string& words, std::string_view word) {
  words.append(words.empty() ? "" : ", ").append(word);
}

constexpr bool is_surface(Format format) {
  return format == Format::vtp || format == Format::stl || format == Format::ply;
}

std::string first_extensions(bool surfaces) {
  std::string words;
  for (const Entry& entry : registry)
    if (!entry.extensions[0].empty() && is_surface(entry.format) == surfaces) {
      append_word(words, entry.extensions[0]);
      if (entry.format == Format::tetgen) words += " (with .ele, .face)";
      if (entry.format == Format::xdmf) words += " (with _surfaces.xdmf, .h5)";
    }
  if (!surfaces) append_word(words, "a folder polyMesh (OpenFOAM)");
  return words;
}

}  // namespace

std::optional<Format> format_of(const fs::path& file) {
  const Entry* entry = entry_of(file);
  if (entry == nullptr) return std::nullopt;
  return entry->format;
}

std::optional<Format> format_named(std::string_view name) {
  const auto found = std::ranges::find(registry, name, &Entry::name);
  if (found == std::end(registry)) return std::nullopt;
  return found->format;
}

std::string_view name(Format format) { return entry_of(format).name; }

std::string format_names() {
  std::string names;
  for (const Entry& entry : registry) append_word(names, entry.name);
  return names;
}

std::string mesh_extensions() { return first_extensions(false); }
std::string surface_extensions() { return first_extensions(true); }

std::vector<fs::path> files_of(const fs::path& file, Format format) {
  if (format == Format::xdmf) {
    const fs::path name = file.parent_path() / file.stem();
    return {file, fs::path(name).concat("_surfaces.xdmf"), fs::path(name).concat(".h5")};
  }
  if (format == Format::polymesh) {
    std::vector<fs::path> files;
    for (const std::string_view name : polymesh_files) files.push_back(file / name);
    return files;
  }
  if (format != Format::tetgen) return {file};
  std::vector<fs::path> files;
  for (const std::string_view extension : entry_of(format).extensions)
    files.push_back(fs::path(file).replace_extension(extension));
  return files;
}

bool needs_survey(Format format) { return entry_of(format).needs_survey; }

bool has_patches(Format format) {
  return needs_survey(format) && format != Format::stl && format != Format::ply;
}

bool holds_middle_nodes(Format format) {
  switch (format) {
    case Format::vtu:
    case Format::vtu_zlib:
    case Format::medit:
    case Format::medit_binary:
    case Format::gmsh:
    case Format::gmsh22:
    case Format::abaqus:
    case Format::febio:
    case Format::nastran:
    case Format::dyna:
    case Format::mfem:
    case Format::xdmf:
    case Format::vtkhdf:
    case Format::tetgen: return true;
    default: return false;
  }
}

std::unique_ptr<MeshWriter> open_writer(const fs::path& file, Format format,
                                        const MeshSize& size) {
  if (size.middles != nullptr && !holds_middle_nodes(format))
    throw Error(ErrorCode::bad_option, "cannot write '" + file.string() + "': the format " +
                                           std::string(name(format)) +
                                           " has no tetrahedra of ten nodes");
  return entry_of(format).open(file, size);
}

std::uint64_t file_bytes(Format format, const MeshSize& size) {
  return entry_of(format).bytes(size);
}

std::uint64_t held_bytes(Format format, const MeshSize& size) {
  return format == Format::polymesh ? polymesh_bytes_of_tet * size.tets : 0;
}

std::vector<std::string> label_losses(Format format, const Survey& survey) {
  const Entry& entry = entry_of(format);
  return entry.losses == nullptr ? std::vector<std::string>() : entry.losses(survey);
}

FileMesh read(const fs::path& file, const Context& context) {
  const Entry* entry = entry_of(file);
  if (entry != nullptr && entry->read != nullptr) return entry->read(file, context);
  std::string known;
  for (const Entry& e : registry)
    if (e.read != nullptr && !e.extensions[0].empty()) append_word(known, e.extensions[0]);
  throw Error(ErrorCode::bad_input,
              "cannot read '" + file.string() + "': its extension is none of " + known);
}

std::uint64_t checksum(const FileMesh& mesh) {
  Checksum sum;
  sum.points(0, std::span<const Point3>(mesh.points));
  sum.tets(0, std::span<const Tet<std::uint64_t>>(mesh.tets));
  return sum.value();
}

}  // namespace certet
