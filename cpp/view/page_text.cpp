#include "page_text.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "histogram.hpp"
#include "packing.hpp"
#include "palette.hpp"

namespace certet::view {
namespace {

std::string hexadecimal(const Rgb& color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : color) {
    text += digits[part >> 4];
    text += digits[part & 15];
  }
  return text;
}

std::string swatch(const Rgb& color) {
  return "<i class=\"swatch\" style=\"background:" + hexadecimal(color) + "\"></i>";
}

std::string row(const std::string& title, const std::string& text) {
  return "<tr><th>" + title + "</th><td>" + text + "</td></tr>\n";
}

/// A row with a number that a program can read too.
std::string row(const std::string& title, const std::string& key, double value,
                const std::string& text) {
  return "<tr><th>" + title + "</th><td data-key=\"" + key + "\" data-value=\"" +
         shortened(value, 17) + "\">" + text + "</td></tr>\n";
}

std::string count_row(const std::string& title, const std::string& key, std::uint64_t count) {
  return "<tr><th>" + title + "</th><td data-key=\"" + key + "\" data-value=\"" +
         std::to_string(count) + "\">" + grouped_digits(count) + "</td></tr>\n";
}

std::string degrees(double angle) {
  // Rounding to thousandths, as the table of `certet check`.
  return shortened(std::round(angle * 1000) / 1000, 7) + "°";
}

/// Whether a theorem is known to cover the mesh: it was made under one, and nothing that
/// was found since speaks against it.
bool is_covered(const PageFacts& facts, const CheckReport& report) {
  return facts.is_of_run && facts.bounds.size() == 1 && report.failures.empty();
}

std::string bounds_sentence(const PageFacts& facts, const CheckReport& report) {
  if (facts.bounds.empty()) return "";
  if (facts.bounds.size() > 1) {
    std::vector<std::string> ranges;
    for (const AngleBounds& b : facts.bounds) {
      const std::string range = shortened(b.min_dihedral) + "–" + shortened(b.max_dihedral) + "°";
      if (std::ranges::find(ranges, range) == ranges.end()) ranges.push_back(range);
    }
    std::string list;
    for (const std::string& range : ranges) list += (list.empty() ? "" : ", ") + range;
    return "Which theorem covers this mesh is not known; the light lines are the proven bounds "
           "of the methods: " + list + ".";
  }
  const AngleBounds& b = facts.bounds.front();
  const std::string range =
      shortened(b.min_dihedral) + "° to " + shortened(b.max_dihedral) + "°";
  if (!is_covered(facts, report))
    return "The lines are at " + range + ", the bounds of a mesh made as this one is said to be; "
           "that they cover this file is not known.";
  return "The lines are the bounds of the theorem <code>" + escaped(b.theorem) + "</code>: " +
         range + ".";
}

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

/// The beginning of a wide table, with what its columns are.
std::string table_of(std::initializer_list<const char*> columns) {
  std::string text = "<div class=\"scroll\"><table class=\"regions\"><thead><tr>";
  for (const char* const column : columns) text += "<th>" + std::string(column) + "</th>";
  return text + "</tr></thead><tbody>";
}

/// Those between which the dihedral angles of a region are.
std::string angles(const Quality& quality) {
  return degrees(quality.min_dihedral) + "–" + degrees(quality.max_dihedral);
}

std::string figure(const Histogram& histogram, const std::string& note) {
  return "<figure><figcaption>" + histogram.title + "</figcaption>\n" + svg(histogram) + "<p>" +
         note + "</p></figure>\n";
}

std::string dihedral_figure(const CheckReport& report, const PageFacts& facts) {
  Histogram h{"dihedral", "Dihedral angles", report.quality.histogram, 0, 180, "°", 30, {}};
  for (const AngleBounds& b : facts.bounds)
    for (const double at : {b.min_dihedral, b.max_dihedral})
      h.marks.push_back({at, facts.bounds.size() == 1});
  return figure(h, "All six angles of each tetrahedron. " + bounds_sentence(facts, report));
}

std::string aspect_figure(const ShapeSurvey& shapes) {
  std::size_t bins = shapes.aspects.size();
  // Empty bins at the end tell nothing, down to a range that is nice to look at.
  while (bins > 12 && shapes.aspects[bins - 1] == 0) --bins;
  bins = (bins + 3) / 4 * 4;
  const bool all = bins >= shapes.aspects.size();
  const auto shown = std::span(shapes.aspects).first(std::min(bins, shapes.aspects.size()));
  const double high = 1 + ShapeSurvey::aspect_step * static_cast<double>(shown.size());
  return figure({"aspect", "Aspect", shown, 1, high, "", all ? 3.0 : high > 6 ? 2.0 : 1.0, {}, all},
                "The longest edge of a tetrahedron over its shortest altitude: 1.225 if it is "
                "regular, 1.414 in the lattice, more as it grows flat. The greatest is " +
                    shortened(shapes.greatest_aspect, 4) + ".");
}

std::string edge_figure(const ShapeSurvey& shapes) {
  return figure({"edges", "Edge lengths", shapes.edges, shapes.shortest_edge,
                 shapes.longest_edge, "", 0, {}},
                "In world units, each edge once for every tetrahedron around it: " +
                    shortened(shapes.shortest_edge, 4) + " to " +
                    shortened(shapes.longest_edge, 4) + ".");
}

/// What a region is called: its name and its label, or the label alone.
std::string called(std::int32_t label, const LabelNames& names) {
  const auto named = names.find(label);
  if (named == names.end()) return std::to_string(label);
  return escaped(named->second) + " (" + std::to_string(label) + ")";
}

std::string called(const std::array<std::int32_t, 2>& labels, const LabelNames& names) {
  return called(labels[0], names) + " | " + called(labels[1], names);
}

/// Which part of the mesh is to be seen; nothing to choose where there is one.
std::string part_choice(const Regions& regions, std::span<const InterfaceReport> interfaces,
                        const LabelNames& names) {
  if (regions.all().size() < 2) return "";
  const auto option = [](const std::string& value, const std::string& text) {
    return "<option value=\"" + value + "\">" + text + "</option>";
  };
  std::string text = "<fieldset><legend>Part</legend><select id=\"part\" aria-label=\"part\">" +
                     option("all", "all regions");
  if (!interfaces.empty()) text += option("interfaces", "all interfaces");
  text += "<optgroup label=\"region\">";
  for (const MeasuredRegion& region : regions.all())
    text += option("r" + std::to_string(regions.place(region.label)), called(region.label, names));
  text += "</optgroup>";
  if (!interfaces.empty()) text += "<optgroup label=\"interface\">";
  for (const InterfaceReport& interface : interfaces)
    text += option("i" + std::to_string(regions.place(interface.labels[0])) + "," +
                       std::to_string(regions.place(interface.labels[1])),
                   called(interface.labels, names));
  if (!interfaces.empty()) text += "</optgroup>";
  return text + "</select></fieldset>\n";
}

std::string legend(const Regions& regions, const LabelNames& names) {
  constexpr std::size_t most = 12;
  const auto& all = regions.all();
  std::string text = "<div class=\"legend\" id=\"legend-region\">";
  for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
    text += "<span>" + swatch(regions.color(i)) + called(all[i].label, names) +
            "</span>";
  if (all.size() > most)
    text += "<span>… <a href=\"#regions\">all " + std::to_string(all.size()) + "</a></span>";
  text += "</div><div class=\"legend\" id=\"legend-angle\" hidden><span>0°</span><i class=\"ramp\" "
          "style=\"background:linear-gradient(90deg";
  for (int i = 0; i <= 6; ++i) text += "," + hexadecimal(angle_color(best_angle * i / 6));
  return text + ")\"></i><span>70.5°</span><span>how far the angles keep from 0° and 180°</span>"
                "</div>";
}

}  // namespace

std::string title_text(const PageFacts& facts) { return escaped(facts.name); }

std::string verdict_text(const CheckReport& report) {
  if (report.failures.empty())
    return "<p class=\"verdict good\">Valid, positive, conforming and closed</p>";
  std::string text = "<div class=\"verdict bad\">Broken:<ul>";
  for (const std::string& failure : report.failures) text += "<li>" + escaped(failure) + "</li>";
  return text + "</ul></div>";
}

std::string view_text(const Regions& regions, std::span<const InterfaceReport> interfaces,
                      const LabelNames& names) {
  return R"(<div id="stage"><canvas id="canvas" tabindex="0" aria-label="The mesh in three dimensions"></canvas></div>
<form id="panel" autocomplete="off">
)" + part_choice(regions, interfaces, names) + R"(<fieldset><legend>Cut</legend>
<label><input type="radio" name="axis" value="none" checked>none</label>
<label><input type="radio" name="axis" value="0">x</label>
<label><input type="radio" name="axis" value="1">y</label>
<label><input type="radio" name="axis" value="2">z</label>
<input type="range" id="plane" min="0" max="0" value="0" step="1" aria-label="place of the cut" disabled>
<output id="place"></output>
<label><input type="checkbox" id="flip">other side</label>
</fieldset>
<fieldset><legend>Colour</legend>
<label><input type="radio" name="color" value="region" checked>region</label>
<label><input type="radio" name="color" value="angle">worst angle</label>
</fieldset>
<fieldset><legend>Show</legend>
<label><input type="checkbox" id="edges" checked>edges</label>
<button type="button" id="reset">reset view</button>
</fieldset>
</form>
)" + legend(regions, names);
}

std::string no_view_text() {
  return "<p class=\"fallback\">There is no view: the script library for it was not built in, or "
         "the mesh has nothing to be seen.</p>";
}

std::string view_note(const Scene& scene, const CheckReport& report) {
  const bool interfaces = scene.interface_faces > 0;
  const std::string is = interfaces ? "are" : "is";
  std::string text = "<p class=\"note\">Drag to turn, scroll or pinch to zoom. <span id=\"drawn\">"
                     "</span> The surface " + std::string(interfaces ? "and the interfaces " : "");
  if (scene.coarse > 0)
    text += is + " drawn in " + grouped_digits(scene.surface_triangles) +
            " triangles instead of " +
            grouped_digits(scene.border_faces + scene.interface_faces) + ": points within " +
            shortened(scene.coarse, 3) + " units are drawn together.";
  else
    text += is + " drawn whole.";
  const int planes = scene.planes.count(0);
  text += " Cuts remove whole tetrahedra, by their centroids, at " + std::to_string(planes) +
          (planes == 1 ? " place" : " places") + " along each axis, and show every tetrahedron "
          "there as it is";
  return text + "; of the " + grouped_digits(report.quality.tets) +
         " in all, only those on the surface or beside such a place are in this page.</p>";
}

std::string facts_text(const PageFacts& facts, const CheckReport& report) {
  std::string text = "<table>";
  for (const PageRow& fact : facts.rows) text += row(escaped(fact.title), escaped(fact.text));
  if (is_covered(facts, report)) {
    const AngleBounds& b = facts.bounds.front();
    text += row("proven", shortened(b.min_dihedral) + "° to " + shortened(b.max_dihedral) + "°, " +
                              escaped(b.theorem));
  }
  return text + "</table>";
}

std::string counts_text(const CheckReport& report, const ShapeSurvey& shapes) {
  const Quality& quality = report.quality;
  std::string text = "<table>";
  text += count_row("tetrahedra", "tets", quality.tets);
  text += count_row("points", "points", report.points);
  text += count_row("faces on the border", "boundary_faces", report.boundary_faces);
  text += row("volume", "volume", quality.volume, shortened(quality.volume, 9));
  text += row("least dihedral angle", "min", quality.min_dihedral, degrees(quality.min_dihedral));
  text += row("greatest dihedral angle", "max", quality.max_dihedral,
              degrees(quality.max_dihedral));
  text += row("greatest aspect", "aspect", shapes.greatest_aspect,
              shortened(shapes.greatest_aspect, 4));
  text += count_row("turned over or flat", "nonpositive_tets", quality.nonpositive);
  return text + "</table>";
}

std::string histograms_text(const CheckReport& report, const ShapeSurvey& shapes,
                            const PageFacts& facts) {
  return dihedral_figure(report, facts) + aspect_figure(shapes) + edge_figure(shapes);
}

std::string regions_text(const Regions& regions, std::span<const RegionReport> reports,
                         const LabelNames& names) {
  if (reports.empty()) return "<p>The mesh has no labels: it is one region.</p>";
  std::string text = table_of({"region", "tetrahedra", "volume", "area", "angles", "pieces"});
  for (const RegionReport& region : reports)
    text += "<tr><th>" + swatch(regions.color(regions.place(region.label))) + called(region.label, names) +
            "</th>" + cell(grouped_digits(region.quality.tets)) +
            cell(shortened(region.quality.volume, 7)) + cell(shortened(region.area, 7)) +
            cell(angles(region.quality)) + cell(grouped_digits(region.pieces.by_faces)) +
            "</tr>\n";
  return text + "</tbody></table></div>";
}

std::string interfaces_text(const Regions& regions, std::span<const InterfaceReport> interfaces,
                            const LabelNames& names) {
  if (interfaces.empty()) return "";
  std::string text = "<section id=\"interfaces\"><h2>Interfaces</h2>" +
                     table_of({"between", "triangles", "area", "not manifold at"});
  for (const InterfaceReport& interface : interfaces) {
    text += "<tr><th>";
    for (const std::int32_t label : interface.labels)
      text += swatch(regions.color(regions.place(label)));
    const std::uint64_t vertices = interface.nonmanifold.vertices;
    text += called(interface.labels, names) + "</th>" + cell(grouped_digits(interface.triangles)) +
            cell(shortened(interface.area, 7)) +
            cell(vertices == 0   ? "–"
                 : vertices == 1 ? "1 vertex"
                                 : grouped_digits(vertices) + " vertices") +
            "</tr>\n";
  }
  return text + "</tbody></table></div></section>";
}

std::string data_text(const Scene& scene, const Regions& regions) {
  std::string text = "<script type=\"application/json\" id=\"about\">{\"low\":[";
  const auto list = [](const auto& values, auto print) {
    std::string items;
    for (const auto& value : values) items += (items.empty() ? "" : ",") + print(value);
    return items;
  };
  text += list(scene.box.low, [](double v) { return shortened(v, 17); }) + "],\"high\":[" +
          list(scene.box.high, [](double v) { return shortened(v, 17); }) + "],\"coarse\":" +
          (scene.coarse > 0 ? "true" : "false") + ",\"places\":[";
  for (int axis = 0; axis < 3; ++axis) {
    text += axis > 0 ? ",[" : "[";
    for (int plane = 0; plane < scene.planes.count(axis); ++plane)
      text.append(plane > 0 ? "," : "").append(shortened(scene.planes.place(axis, plane), 9));
    text += "]";
  }
  const std::size_t count = regions.all().size();
  text += "],\"regions\":[";
  for (std::size_t i = 0; i < count; ++i)
    text.append(i > 0 ? ",\"" : "\"").append(hexadecimal(regions.color(i))).append("\"");
  text += "],\"angles\":[";
  for (int i = 0; i < 256; ++i)
    text.append(i > 0 ? ",\"" : "\"")
        .append(hexadecimal(angle_color(best_angle * i / 255)))
        .append("\"");
  return text + "]}</script>\n<script type=\"text/plain\" id=\"scene\">" + scene.data +
         "</script>";
}

}  // namespace certet::view
