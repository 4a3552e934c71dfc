#include "mesh_notes.hpp"

namespace certet::command {

const char* const mesh_notes = R"(
Formulas: + - * / ^ (-x^2 is -(x^2)), < <= > >= == != && || and c ? a : b, where
true is 1; min max sum avg hypot length of any number of operands; abs sign sqrt
exp log log2 log10 sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh
floor ceil round trunc not; atan2(y,x) pow(a,b) fmod(a,b) clamp(v,low,high)
mix(a,b,t) if(c,a,b); pi and e.  The union of two solids is min(a,b), the part
they share max(a,b), the first without the second max(a,-b).  A union that is
rounded over about 1/k world units is -log(exp(-k*a)+exp(-k*b))/k.

Shapes, around the origin of the world: sphere:R, torus:R,r (around z), box:a,b,c
(lengths of the edges), cylinder:R,H (along z), gyroid:PERIOD,THICKNESS[,SIDE] (a
wall at least THICKNESS thick, in a cube of SIDE; default: two periods), as well as
primitive, diamond, iwp and neovius; struts:CELL,RADIUS[,SIDE] (round bars along the
edges of cubic cells).  Of these last six table and JSON tell the part of the box that
the mesh fills.

--expr @FILE and --material NAME=@FILE read a formula from a file, on lines as one likes,
with # before comments.  A formula may begin with definitions, like r = hypot(x,y);
max(r - 1, abs(z) - 2): each ends with a semicolon, and it and the formula have at most
20,000 bytes.

Several files, and the solids of --material, are materials of one mesh: labels 1, 2, ... in
the order of INPUT and then of --material, called after the files or as --material says.
Labels of an image in INPUT are so each for itself, with their own numbers, after the
greatest of which the others are numbered.  What starts like a shape (sphere:1) is one, what
is a file or ends like one (.stl .obj .ply .off .vdb .nrrd .nii ...) is a file, all else is a
formula, which needs --bounds; these cut off shapes too, but no files.  Of an image
--material NAME=FILE takes all labels for one solid, FILE@labels=1,5-9 some, FILE@iso=300 or
FILE@iso=A..B what is gray; --labels and --iso hold for files without such a choice.  What is
in several belongs to the strongest solid, the last one or the first in --priority, and is
cut apart at the surface of the stronger: a wall that two have in common is one interface.
The lattice is that of the first image or, without one, around all of them, along the axes
of the world; its long edge is then, without --size, a 64th of the longest side of their
box.  With --method paper they are meshed as one solid, and each tetrahedron has the label at
its centre.  A material that is not in the mesh, or by more than 2 % not with the volume that it
has (estimated, of what is in no stronger solid), is named in a warning.

--inside and --subtract trim all that is meshed, whatever it is made of, by solids that are
named in the same way; the lattice and its size stay those of what is trimmed, labels keep
their numbers, and formulas and shapes need no --bounds where --inside gives them room.

World coordinates are the image's own: millimetres, LPS (x to the left, y to the back, z to the
head), as ITK has them, for NIfTI too, whose sform is taken where it is set, else its qform.
--frame ras gives what nibabel, FreeSurfer and models of 3D Slicer have; table and JSON tell the
axes of the output, and .vtu, .stl and .ply have them in a comment, SPACE=LPS.  --crop means LPS
all the same, and all lengths are those before --scale; surfaces, volumes, formulas and shapes
beside an image have the axes of the output.  The slices of a DICOM series, and the frames of a
DICOM file, are ordered by their positions.  The first voxel of a TIFF file is at the origin, x
along its rows, y down its columns, z through its pages.

With --iso A..B the solid is where the lesser of the distances to both values,
interpolated between the centres of voxels, is positive: between a voxel below both and
one above both there is none.

Values are those that an image's file means: slope and intercept of NIfTI and DICOM
are applied.  Labels may be floating point numbers that are whole.  A file of several
volumes, or of several numbers per voxel, is read with --volume.  The segments of 3D
Slicer (.seg.nrrd) and of DICOM SEG are labels with the names that the file has;
where they overlap the later one wins, which a note counts.

Surfaces of labels, between two of them and to the outside, are smooth.  Each label has a
field, its share of the voxels around, weighted by (1 4 6 4 1)/16 along every axis or, with
--smooth SIGMA, by a Gaussian (SIGMA is at most 4 voxels along any axis); the greatest field
wins.  Thin parts are smoothed less, a constant for each label gives its region about the
volume of its voxels, and at the centre of a voxel its own label wins, so that no label is
lost, and no piece of one.  --smooth 0 keeps the faces of voxels, with their steps.

Labels that touch each other are cut where they meet, but not by --method paper, where
each tetrahedron has the label at its centre, the surface follows the faces of voxels, and
--smooth SIGMA smooths the outside alone.  Formats with named surfaces have one for
each pair that touches, called after both.

The boundary has the patch surface and, where the edge of an image, --crop or --bounds cut the
shape off, the sides xmin to zmax, called after the axes of the output.  A triangle there belongs
to the side at which most of its corners are, of several to the first.  --patch NAME=xmin (or any
patch) gives one a name, --patch NAME=z:12.5 to what lies at a plane of the output: triangles with all
corners within half a long edge of it, which lean by at most 60 degrees.  Of several the last one
has a triangle; a patch without any is refused.

A label that the lattice is too coarse for is named in a warning, and so is one that
has more or fewer pieces among the lattice's points than in the image, where voxels may
touch at edges and corners or not.  That is looked at unless every voxel has a point of the
lattice at its centre or, with --smooth 0, --size is at most the smallest voxel spacing, for
then no label and no piece is lost; not with --crop.  With --iso the pieces are those of the
mesh, at any size.  With --iso, and with --smooth and --method paper, a size is looked for that
keeps them all, and the volume.

The pieces of every mesh are counted, by faces and by vertices, and of several labels those of
each; with --method paper the latter by --label-pieces alone, for it takes long.  So are the
edges and vertices at which its surface is no manifold, of which --method paper may leave some.
By the other methods there is no such edge, and of one label no such vertex; of several, two and
the outside may leave some, as three may on the surface of one of them: at the cut of an edge
between two, where the third is on opposite sides of the edge and not between, or all around.
--keep largest drops all pieces by faces but the one of the most tetrahedra, --keep N all but
the N largest, --keep percolating:x (y, z) all that do not go from one end of the solid to the
other along that axis of the lattice, which is the image's or the world's, but for a --size at
either end.  What was dropped is told.

A surface need not be clean: equal corners that differ by rounding, triangles that are
repeated, turned or without an area, T-junctions, and walls between two solids that are
stored once are mended, with the least tolerance that closes the surface, and what was
done is said.  An open surface is refused.  With --repair its solid is what it winds
around by more than one half: the winding number is the generalised one, the share of the
sphere around a point that the triangles cover, each with its sign.  So flat holes close
flat, and triangles that are all apart are a solid as if there were no gaps; those that
face another way than the ones around them are turned.  Where the
winding number does not tell inside from outside, as of a flat sheet or of triangles that
face any way, the surface is refused all the same.  Where the
solid behind a fiftieth of the surface is thin, the default size is a quarter of its
thickness, as far as about 4 million tetrahedra or 32 million cells of the lattice.

The volume of the mesh is compared with that of the solid: of a closed surface and of
all shapes but the gyroid the true one, of others an estimate.  So are its pieces: a
closed surface has as many as outer shells, a shape one.  Of formulas, volumes, gyroids,
shapes cut by --bounds, several materials together, and surfaces that are open or pass
through themselves, those are counted that the lattice's points have at a quarter of the
size, or at half of it, where not so many cells would be sampled for it as the mesh has
pairs of tetrahedra; where more would, the table and the JSON say that they were not
compared, and how many.  Beyond 2 %,
or with other pieces, a warning names a size that has been tried and keeps both; the
sentence where nothing is inside has one that keeps the volume.  At most 16 sizes are
tried, each a fifth smaller than the one before, later a third, up to 10 million
tetrahedra, and until 64 million cells that the surface may pass through, or 400 million
in all, are spent; where none of them does, that is said.

A solid far from the origin of the world may be finer than the numbers of a file are
apart there.  A mesh that they cannot hold is not written (status 6): in .stl, of
single precision, where points would fall together or triangles lose their area or
turn by more than 4.5 degrees; elsewhere, where points would fall together, or
tetrahedra turn over, or angles leave their bounds by what tables show of them.

With --method key or embedded a vertex that a cut is too close to (violated) moves onto the
surface only where that keeps the shape, and not past a neighbour (shortened: of two
that would pass each other either gives up one half); otherwise, or where to stay is
nearer, it stays, and the cuts around it are moved away from it (clamped), by at most
0.4 of an edge.  Pieces, tunnels and cavities of the mesh are those of the
samples, which are + where the lattice's points are inside.  With --method key, the default, a
vertex is violated by a nearer cut, so that no move has to be shortened, and of a quadrilateral's
two diagonals that one is taken which ends at the lesser cut, the nearer to its end inside in parts
of its edge.  It is of one material: where several meet the mesh is made by embedded, and table
and JSON say so.

With --order 2 middle nodes come behind the corners, by the lower and then the higher end of
their edges; mesh.points counts the corners.  Each format has its own order of the ten nodes.
All that is said of angles, and of theorems, is of the tetrahedra with straight edges.  --curved
looks for the surface along the mean normal of the triangles around an edge, within a quarter of
its length, and puts the middle node there.  Edges stay straight where more than two regions
meet, and where else the Jacobian determinant of an element could fall below a quarter of what
it is while straight: this is bounded by its Bernstein coefficients, in whole numbers.

--distance measures at vertices, edge middles and centroids of the mesh's surface how far that of
the shape is, and back; the root mean square is over the area.  Of a closed surface distances
are to its triangles and from them, cut into parts of half a long edge, exactly.  Of all else the
surface is where the shape's answers change, at its interfaces too, and where it is cut off:
looked for around each point of the mesh, and found to a hundredth within a long edge, at corners
to a few; and back from where lines half a long edge apart along the axes of the lattice pass
through it.  Of labels these are the smooth surfaces, or with --smooth 0 the faces of voxels.
Pieces that --keep dropped are far from the mesh.

With --optimise vertices move one by one, each only where of all angles around it the one nearest
to 0 or to 180 grows away from that; none comes to be less than the least of the mesh was, or
greater than the greatest, so that the theorem's bounds hold still, and the angles in the end are
those that were checked.  Pieces, numbers and labels stay.  A vertex inside moves by at most half
a long edge, one of a surface along it by at most a quarter, found anew by bisection, and where
more than two regions meet along the line where they do by at most an eighth, as cuts do that had
been moved away from the surface.  For an angle below 15 that nothing else helps, a vertex leaves
its surface by at most an eighth.  What is proved of overlaps is of the mesh before; afterwards
all tetrahedra are positive.  The mesh is held in memory, some 40 bytes for each point and 24 for
each tetrahedron, and more at those short of the goal; a dry run does not move anything.

With --grade tetrahedra away from the surface and from where labels meet belong to an octree of
cells, each level of which doubles the edges; beside one are none of more than twice its size.
What touches the surface is, bit by bit, as without.  Several labels are graded where they are
cut apart, so not by --method paper; vertices do not move, so that --features auto stays off.
--target-tets counts what there is once graded.  A size field is asked for its size at the centre of
each cell inside, in the input's coordinates and before --scale; an image of sizes is trilinear
between voxel centres and has to cover the shape.

Keys of the JSON: certet, command, dry_run, input {kind, name, notes}, output {file, format,
bytes, origin, frame (lps, ras, or input where the axes are not known), scale}, lattice {cells,
size, cuts, and with --target-tets: target_tets, tries}, method {name, and of key and embedded:
violated, stayed, shortened, missed (the surface, by shortened moves) {greatest, rms,
greatest_edges, rms_edges}, clamped {cuts and the same}}, theorem, mesh {points, tets, volume,
volume_fraction (of shapes without an end), checksum, file_checksum, pieces {by_faces,
by_vertices, largest_tets}, of a graded mesh: graded {levels, greatest_edge, uniform_tets (of one
size, in the place of which it is), interior {theorem, min_dihedral, max_dihedral}, size_field
(where there is one)}, nonmanifold {edges, vertices, edge_places, vertex_places: in the
world, of the first 8}}, where the boundary has others than surface, and the format has patches: patches [{name, triangles,
area (of the output)}], with --order 2: order2 {middle_nodes, curved, and with --curved:
surface_edges, moved, on_surface, straight {guarded (would spoil an element), far (from the
surface), seams}, greatest_move, greatest_move_edges, least_jacobian (a lower bound, of what it
is while straight)}, with --optimise: optimised {goal, rounds, moved (vertices),
moved_on_surface, moved_on_seams (where several surfaces meet), left_surface, greatest_move,
greatest_move_edges, greatest_move_on_surface_edges, short_before, short_after (tetrahedra with an
angle nearer to 0 or 180 than the goal)}, features {asked, chosen (degrees, or off), why, where
the shape's faces are known flat, sharp (shares of the length of its edges), loose_ends, and
where vertices moved length (of sharp edges), followed_length (of what is between two vertices
on it, joined by an edge), followed_percent, kept_length (of that, what these edges are within 2 %
of a long edge of), kept_percent, corners, kept_corners, greatest_distance and
greatest_distance_edges (of a sharp edge from the edges of the mesh's surface), moved (vertices),
greatest_move_edges}, with --distance: distance {against (what the shape's
surface is), exact (to triangles), edge (the long edge), to_shape and to_mesh {greatest, rms,
greatest_edges, rms_edges, at (where it is the greatest), points}}, with --keep: dropped {keep,
pieces, kept, tets, volume}, dihedral {min, max, lattice_min, lattice_max, rounding, histogram},
guarantee {asked, used, theorem, min_dihedral, max_dihedral, inverted_tets, holds, with
--optimise or features: angles (checked), of several labels: surface (a sentence on it)}, seconds {read,
sample, cut, warp, count, pieces, optimise, features, distance, emit, measure, write, total}, memory
{limit, needed, least, peak}, of certet-mpi: ranks [{layers, points, tets, memory_peak,
processor_seconds}], warnings, where pieces were not compared: losses {not_compared (a
sentence), size (of the finer lattice), cells (of it, to be looked at)}, and for images regions
[{label, voxels, tets, name where the file or --label-names has one, volume, voxel_volume,
change_percent, pieces (by faces) and pieces_by_vertices; of several labels with --method paper
by --label-pieces alone, else pieces is of the samples, and told where the image's are:
image_pieces {by_corners, by_faces}}], of several solids regions [{label, name, tets, volume,
solid_volume (estimated), pieces, pieces_by_vertices}], of labels that are smoothed: smoothing
{sigma (left out where it is one voxel), voxel_volume, mesh_volume, change}.  Lengths are in
world units, volumes and places in those of the output, angles in degrees, memory in bytes; the
histogram has 36 bins of 5 degrees, counted before coordinates are rounded; rounding is what the
doubles of the world can turn an angle by; output.origin is where in the world the output has
its 0; file_checksum is what `certet check` tells of a file with this mesh, checksum is of the
lattice and the same wherever the mesh is; the seconds of emit, measure and write overlap and
are those of all threads together; a dry run leaves out what it does not know.)";

}  // namespace certet::command
