// Surfaces that a file holds, beside what its tetrahedra say.

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "certet/formats.hpp"
#include "formats/names.hpp"
#include "formats/sheets.hpp"

namespace certet {
namespace {

using Triangle = std::array<std::uint64_t, 3>;
using formats::Sheets;

Triangle sorted(Triangle face) {
  std::ranges::sort(face);
  return face;
}

std::string triangles(std::uint64_t count) {
  return std::to_string(count) + (count == 1 ? " triangle" : " triangles");
}

class Comparison {
 public:
  Comparison(const FileMesh& mesh, const Survey& survey)
      : mesh_(mesh), survey_(survey), first_interface_(Sheets::first_interface(survey)),
        names_(formats::names_of_interfaces(survey, formats::NameRule::quoted)) {
    Sheets::for_each_face(survey, [this](const BoundaryFace& face, std::int32_t sheet) {
      known_.push_back({sorted(face.points), sheet});
    });
    std::ranges::sort(known_);
  }

  SurfaceComparison run() {
    for (const FileSurface& surface : mesh_.surfaces) look_at(surface);
    if (has_names() || most_agree()) compare_with_interfaces();
    return std::move(found_);
  }

 private:
  struct Known {
    Triangle points;
    std::int32_t sheet;
    friend auto operator<=>(const Known&, const Known&) = default;
  };
  static constexpr std::int32_t nowhere = 0;

  [[nodiscard]] std::int32_t sheet_of(const Triangle& face) const {
    const Triangle points = sorted(face);
    const auto at = std::ranges::lower_bound(known_, points, {}, &Known::points);
    return at == known_.end() || at->points != points ? nowhere : at->sheet;
  }

  void look_at(const FileSurface& surface) {
    SurfaceReport report{surface.number, surface.name, surface.faces.size()};
    for (const Triangle& face : surface.faces) {
      const std::int32_t sheet = sheet_of(face);
      if (sheet == nowhere)
        ++report.elsewhere;
      else
        ++(sheet < first_interface_ ? report.outer : report.between);
    }
    found_.surfaces.push_back(std::move(report));
  }

  [[nodiscard]] bool has_names() const {
    return std::ranges::any_of(mesh_.surfaces, [](const auto& surface) { return !surface.name.empty(); });
  }

  /// The interface that a surface is to be; as many as there are if it is none.
  [[nodiscard]] std::size_t interface_of(const FileSurface& surface) const {
    if (has_names())
      return static_cast<std::size_t>(std::ranges::find(names_, surface.name) - names_.begin());
    const std::int64_t place = surface.number - first_interface_;
    return place < 0 || !std::in_range<std::int32_t>(surface.number)
               ? names_.size()
               : std::min(static_cast<std::size_t>(place), names_.size());
  }

  /// Whether the numbers are those that our writers give.
  [[nodiscard]] bool most_agree() const {
    std::uint64_t agreeing = 0, all = 0;
    for (const FileSurface& surface : mesh_.surfaces) {
      const std::size_t place = interface_of(surface);
      if (place >= names_.size()) continue;
      all += surface.faces.size();
      for (const Triangle& face : surface.faces)
        if (sheet_of(face) == surface.number) ++agreeing;
    }
    return 2 * agreeing > all;
  }

  void compare_with_interfaces() {
    std::vector<bool> is_there(names_.size());
    for (std::size_t n = 0; n < mesh_.surfaces.size(); ++n) {
      const std::size_t place = interface_of(mesh_.surfaces[n]);
      if (place >= names_.size()) continue;
      is_there[place] = true;
      compare(mesh_.surfaces[n], place, found_.surfaces[n]);
    }
    if (std::ranges::find(is_there, true) == is_there.end()) return;
    for (std::size_t place = 0; place < names_.size(); ++place)
      if (!is_there[place])
        found_.failures.push_back("the file has no surface between the regions " + pair(place) +
                                  ", which touch in " +
                                  triangles(survey_.interfaces[place].faces.size()));
  }

  void compare(const FileSurface& surface, std::size_t place, SurfaceReport& report) {
    const Interface& interface = survey_.interfaces[place];
    const std::int32_t sheet = first_interface_ + static_cast<std::int32_t>(place);
    std::vector<Triangle> right;
    for (const Triangle& face : surface.faces)
      if (sheet_of(face) == sheet) right.push_back(sorted(face));
    report.interface = interface.labels;
    report.wrong = surface.faces.size() - right.size();
    std::ranges::sort(right);
    const auto once = std::unique(right.begin(), right.end());
    const auto repeated = static_cast<std::uint64_t>(right.end() - once);
    report.missing = interface.faces.size() - (right.size() - repeated);
    const std::string whose =
        surface.name.empty() ? "the file's surface " + std::to_string(surface.number)
                             : "the file's surface '" + surface.name + "'";
    if (report.missing > 0)
      found_.failures.push_back(whose + " lacks " + std::to_string(report.missing) + " of the " +
                                triangles(interface.faces.size()) + " between the regions " +
                                pair(place));
    if (report.wrong > 0)
      found_.failures.push_back(whose + " has " + triangles(report.wrong) +
                                " elsewhere than between the regions " + pair(place));
    if (repeated > 0)
      found_.failures.push_back(whose + " has " + triangles(repeated) + " twice");
  }

  [[nodiscard]] std::string pair(std::size_t place) const {
    const auto& [lesser, greater] = survey_.interfaces[place].labels;
    return std::to_string(lesser) + " and " + std::to_string(greater);
  }

  const FileMesh& mesh_;
  const Survey& survey_;
  std::int32_t first_interface_;    ///< the number of its sheet
  std::vector<std::string> names_;  ///< of the interfaces
  std::vector<Known> known_;        ///< the faces of all sheets, by their points
  SurfaceComparison found_;
};

}  // namespace

SurfaceComparison compare_surfaces(const FileMesh& mesh, const Survey& found) {
  return Comparison(mesh, found).run();
}

}  // namespace certet
