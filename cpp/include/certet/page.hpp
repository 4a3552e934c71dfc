#pragma once
/// \file
/// A web page about a mesh: what it is, how good it is, and a view of it to turn
/// around and to cut open.

#include <string>
#include <vector>

#include "certet/check.hpp"
#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "certet/quality.hpp"

namespace certet {

/// A line of a table.
struct PageRow {
  std::string title, text;
};

/// What a mesh file does not tell about itself.
struct PageFacts {
  std::string name;           ///< of the mesh, the title of the page
  std::vector<PageRow> rows;  ///< where it comes from
  /// That a mesh made as this one is said to be has; where there are several, it is not
  /// known which.  Angles outside of a single one are a defect.
  std::vector<AngleBounds> bounds;
  /// Whether the mesh is known to be, bit by bit, what a run under these bounds wrote;
  /// only then is their theorem said to cover it.
  bool is_of_run = false;
  std::vector<std::string> defects;  ///< that are known before the mesh is looked at
};

/// A page and what it says of the mesh.
struct Page {
  std::string html;  ///< UTF-8; needs no other file and no network
  CheckReport report;  ///< with the defects of the facts and of angles
};

/// Checks and measures a mesh and packs what the view needs of it: the surface,
/// if need be in coarser triangles, and the tetrahedra along planes, as many
/// planes as make a page of some 15 MB at most.
/// \throws std::bad_alloc
Page make_page(const FileMesh& mesh, const PageFacts& facts);
/// Of a mesh that was examined.
Page make_page(const FileMesh& mesh, const PageFacts& facts, Examination found);

/// Whether the view was built in; without it a page has tables and histograms.
bool can_view_pages();

}  // namespace certet
