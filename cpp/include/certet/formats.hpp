#pragma once
/// \file
/// Mesh files.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certet/check.hpp"
#include "certet/mesh.hpp"
#include "certet/middle_nodes.hpp"
#include "certet/quality.hpp"
#include "certet/survey.hpp"

namespace certet {

enum class Format {
  vtu,           ///< VTK XML unstructured grid, raw appended binary (.vtu)
  vtu_zlib,      ///< the same, compressed
  medit,         ///< MEDIT, ASCII (.mesh)
  medit_binary,  ///< MEDIT, binary (.meshb)
  gmsh,          ///< Gmsh 4.1, binary (.msh)
  gmsh22,        ///< Gmsh 2.2, ASCII
  abaqus,        ///< Abaqus input: nodes, elements and sets (.inp)
  febio,         ///< FEBio 4.0: the mesh alone (.feb)
  nastran,       ///< Nastran bulk data: the mesh alone (.bdf, .nas)
  dyna,          ///< LS-DYNA keywords: the mesh alone (.k, .key)
  mfem,          ///< MFEM mesh v1.0 (.mfem)
  polymesh,      ///< OpenFOAM's folder polyMesh, ASCII
  xdmf,          ///< XDMF 3, with its numbers in HDF5: .xdmf, _surfaces.xdmf and .h5
  vtkhdf,        ///< VTKHDF 1.0, an unstructured grid (.vtkhdf)
  tetgen,        ///< three files: .node, .ele and .face
  vtp,           ///< VTK XML surfaces: the boundary and all interfaces, raw (.vtp)
  stl,           ///< the boundary or a chosen surface alone, binary (.stl)
  ply,           ///< the same, binary (.ply)
};

/// The format that a file name's extension stands for.
std::optional<Format> format_of(const std::filesystem::path& file);
/// The format of a name: vtu, vtu-zlib, medit, meditb, msh, msh22, inp, feb,
/// bdf, k, mfem, polymesh, xdmf, vtkhdf, tetgen, vtp, stl, ply.
std::optional<Format> format_named(std::string_view name);
std::string_view name(Format format);
/// All names, for sentences.
std::string format_names();
/// The extensions of files that hold meshes, and of those that hold surfaces alone, for sentences.
std::string mesh_extensions();
std::string surface_extensions();

/// All files that are written for this one: more than one for TetGen and XDMF, and for OpenFOAM those
/// in the folder.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& file, Format format);

/// Whether `vtu_zlib` was built in; without it compressed files cannot be read
/// either.
bool can_compress();

/// Whether `xdmf` and `vtkhdf` were built in.
bool has_hdf5();

/// Whether a format has tetrahedra of ten nodes: .vtu, .mesh, .meshb, .msh, .inp, .feb, .bdf, .k,
/// .xdmf, .vtkhdf, .mfem and TetGen.
bool holds_middle_nodes(Format format);

/// Whether a format has the patches of the boundary apart: all but .vtu and .vtkhdf, which hold
/// tetrahedra alone, and .stl and .ply, which hold one surface.
bool has_patches(Format format);

/// Whether a writer needs to know the mesh's survey beforehand.
bool needs_survey(Format format);

/// All that a file says about its size, known before the first number is written.
struct MeshSize {
  std::uint64_t points = 0;  ///< with the middle nodes
  std::uint64_t tets = 0;
  bool labels = false;  ///< whether tetrahedra have labels
  /// Where the format needs it; it must be the survey of the mesh that follows.
  std::shared_ptr<const Survey> survey = nullptr;
  /// Which way the axes go in a patient, LPS or RAS, where that is known: .vtu, .stl and .ply
  /// have it as a comment, SPACE=LPS, as 3D Slicer looks for it.
  std::string space = {};
  /// Of tetrahedra of ten nodes; these come behind the corners, by their numbers.
  std::shared_ptr<const MiddleNodes> middles = nullptr;
};

/// Writes a mesh piece by piece, so that it never needs to be in memory whole:
/// first all points in order, then all tetrahedra in order, then `finish`.
/// The file grows under a temporary name beside its target and takes the
/// target's name in `finish`; a writer destroyed before that leaves nothing.
/// The bytes do not depend on how the mesh is cut in pieces.
/// All members throw Error `write_failed`; also where more or fewer points or
/// tetrahedra come than were announced, or an index without a point, and, in `finish`,
/// where the format's numbers cannot hold the mesh: .stl has single precision, in which
/// points must stay distinct and triangles keep an area and, but for 4.5 degrees, their
/// normals; .bdf and .k have fields of 16 characters, which may round by a thousand millionth of
/// the mesh's length.  All other formats have doubles, those of text in the shortest form that
/// reads back the same, but for .inp, whose numbers have at most 20 characters.
class MeshWriter {
 public:
  virtual ~MeshWriter() = default;
  virtual void points(std::span<const Point3> points) = 0;
  /// `labels` is empty or as long as `tets`.
  virtual void tets(std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels) = 0;
  virtual void tets(std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels) = 0;
  virtual void finish() = 0;
};

/// \throws Error `write_failed` if the file cannot be made: its folder is not
/// there or full, or the name is taken by a folder or by a read-only file; `bad_option` if the
/// format does not hold middle nodes and there are some.
std::unique_ptr<MeshWriter> open_writer(const std::filesystem::path& file, Format format,
                                        const MeshSize& size);

/// The exact size in bytes for binary formats, an estimate for others.
std::uint64_t file_bytes(Format format, const MeshSize& size);

/// How much memory a writer takes that grows with the mesh: OpenFOAM's, whose faces are in the order
/// of cells, holds it whole.
std::uint64_t held_bytes(Format format, const MeshSize& size);

/// What a format cannot hold of a mesh's labels and what became of it, a sentence each.
/// Gmsh's groups, Nastran's properties, LS-DYNA's parts and MFEM's attributes have positive numbers,
/// the second and third of up to 8 digits: all other labels have the next that are free there, and
/// in Gmsh's files a comment by which `read` gives them back.
std::vector<std::string> label_losses(Format format, const Survey& survey);

/// Triangles that a file holds together, under a number and, where the format has them, a name.
struct FileSurface {
  std::int64_t number = 0;
  std::string name = {};
  std::vector<std::array<std::uint64_t, 3>> faces = {};  ///< as the file turns them
};

/// A mesh as a file holds it.
struct FileMesh {
  std::vector<Point3> points;
  std::vector<Tet<std::uint64_t>> tets;
  std::vector<std::int32_t> labels;  ///< empty, or one for each tetrahedron
  LabelNames names;                  ///< where the format has them
  std::string space = {};            ///< as `MeshSize` has it; where .vtu tells
  /// The points of faces of the patch `border`, in any order; where the format has them.
  std::vector<std::array<std::uint64_t, 3>> border;
  /// The same of other patches than `surface` and `border`, with their names: those of the sides of
  /// a box are `patch_names`.  What of them is not on the boundary is no patch's.
  std::vector<FileSurface> patches = {};
  /// All triangles of .mesh, .meshb and .msh files, by growing numbers: the patches, the
  /// interfaces, or whatever the writer meant by them.
  std::vector<FileSurface> surfaces = {};
  /// Of tetrahedra of ten nodes the middle nodes, in the order of the file; and of each
  /// tetrahedron their numbers, in the order of `tet_edges`.  Both are empty where
  /// tetrahedra have four nodes; `points` are the corners alone.
  std::vector<Point3> middle_points = {};
  std::vector<std::array<std::uint64_t, 6>> middles = {};
};

/// The regions, the boundary and the interfaces of what a file held, found anew, with the names
/// and the patches that it told.
/// \throws Error `cancelled`.
Survey survey(const FileMesh& mesh, Context& context);

/// How the triangles that a file holds compare with what its tetrahedra say.
struct SurfaceReport {
  std::int64_t number = 0;
  std::string name;
  std::uint64_t triangles = 0;
  std::uint64_t outer = 0;      ///< on the boundary
  std::uint64_t between = 0;    ///< between two labels
  std::uint64_t elsewhere = 0;  ///< neither; within one label, or no face of the mesh
  /// The interface that it is, by its name or number: then `missing` triangles of that are not
  /// in it, and `wrong` ones in it lie elsewhere.
  std::optional<std::array<std::int32_t, 2>> interface = std::nullopt;
  std::uint64_t missing = 0, wrong = 0;
};

/// What `compare_surfaces` found.
struct SurfaceComparison {
  std::vector<SurfaceReport> surfaces;  ///< as the file has them
  std::vector<std::string> failures;    ///< one sentence for each broken one
};

/// Compares them.  A surface is taken for an interface where it has the name that our writers
/// would give it or, in a file without names, the number, and most triangles agree; other
/// programs' surfaces may be anything, and are told of alone.  `found` is the survey of the mesh.
SurfaceComparison compare_surfaces(const FileMesh& mesh, const Survey& found);

/// Reads .vtu, .mesh, .meshb and .msh files, by their extension.  Looks at
/// everything but whether the indices are those of points: that is the task of
/// `check`.
/// \throws Error `bad_input` with one sentence that names the file; `cancelled`.
FileMesh read(const std::filesystem::path& file, const Context& context = {});

/// Writes a mesh in memory, in world coordinates: the same bytes as `certet mesh` writes
/// of it, with its regions, their names, and the patches of its boundary where the format
/// has them.  Without a format it is the one that the extension stands for.
/// \throws Error `bad_option` (an extension that is that of no format), `write_failed` (as
/// `open_writer` and `MeshWriter`, and where the doubles of the world cannot hold the
/// mesh), `check_failed` (angles beyond the bounds of the mesh's method: a bug),
/// `too_large`, `cancelled`.
/// \returns the `label_losses`.
std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file, Format format,
                               Context& context);
std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file,
                               Context& context);
std::vector<std::string> write(const Mesh& mesh, const std::filesystem::path& file);

/// The same with a node in the middle of each edge, as `curve` left them or straight.
/// \throws Error `bad_option` besides: nodes of another mesh, or a format that does not hold them.
std::vector<std::string> write(const Mesh& mesh, const MiddleNodes& middles,
                               const std::filesystem::path& file, Format format,
                               Context& context);
std::vector<std::string> write(const Mesh& mesh, const MiddleNodes& middles,
                               const std::filesystem::path& file);

/// The same of what a file held, as it is: its angles are not checked.
/// \throws Error `bad_input` besides, for tetrahedra that name points which are not there, and
/// for edges that have several middle nodes.
std::vector<std::string> write(const FileMesh& mesh, const std::filesystem::path& file,
                               Format format, Context& context);
std::vector<std::string> write(const FileMesh& mesh, const std::filesystem::path& file);

/// The middle nodes of what a file held, numbered and ordered as ours are.
struct FileMiddleNodes {
  std::shared_ptr<const MiddleNodes> middles;  ///< null where tetrahedra have four nodes
  std::vector<Point3> points;
};
/// \throws Error `bad_input`, naming the file that is to be written, where an edge has several, or
/// one is not there; `too_large`.
FileMiddleNodes file_middle_nodes(const FileMesh& mesh, const std::filesystem::path& file);

/// Verifies what a file held, as `check` of points and tetrahedra does.
CheckReport check(const FileMesh& mesh, Context& context);
CheckReport check(const FileMesh& mesh);

/// The dihedral angles (degrees) and the volume of what a file held, in its units, of those
/// tetrahedra that name points which are there.
Quality quality(const FileMesh& mesh);

/// Moves a mesh to 0, exactly: along each axis on which it is farther from 0 than it is
/// long, the end that is nearer to 0 comes to 0.  \returns where the new 0 is in the old
/// coordinates.
Point3 move_to_zero(FileMesh& mesh);

/// Multiplies all coordinates, from one unit of length to another.
/// \throws Error `bad_option` for what is no positive number, `bad_input` where coordinates
/// become infinite.
void scale(FileMesh& mesh, double factor);
/// The same of the frame of a mesh, whose points are whole numbers of steps.
void scale(Mesh& mesh, double factor);

/// A hash of the points, bit by bit, and the tetrahedra, but not of labels: the
/// same for all files of one mesh, whatever their format.
std::uint64_t checksum(const FileMesh& mesh);

}  // namespace certet
