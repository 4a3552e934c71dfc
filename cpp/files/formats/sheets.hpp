#pragma once
/// \file
/// The named surfaces of a mesh: the patches of its boundary, and its interfaces.

#include <cstdint>
#include <string>
#include <vector>

#include "certet/survey.hpp"
#include "names.hpp"

namespace certet::formats {

/// A surface of triangles with a name.
struct Sheet {
  std::string name;
  std::int32_t number;  ///< from 1: the patches, then the interfaces
  std::uint64_t faces;  ///< never 0
};

/// An interface is called after both of its regions.  Its faces are those of the
/// region of the lesser label.  `surface` has the number 1, `border` 2.  Where the boundary has no
/// other patches, interfaces follow from 3 on; else the sides of the box have 3 to 8, patches
/// with names of their own those from 9 on, and interfaces those behind.
class Sheets {
 public:
  static constexpr std::int32_t number_of(Patch patch) {
    return static_cast<std::int32_t>(patch) + 1;
  }
  /// The number of the first interface of a mesh without other patches than `surface` and
  /// `border`, and of one with sides and none with names of their own.
  static constexpr std::int32_t first_of_few = static_cast<std::int32_t>(Patch::border) + 2;
  static constexpr std::int32_t first_behind_sides = static_cast<std::int32_t>(patch_names.size()) + 1;
  /// The number of the first interface, if there is one.
  static std::int32_t first_interface(const Survey& survey);

  /// `survey` must live as long.
  Sheets(const Survey& survey, NameRule rule);

  /// By growing numbers.
  [[nodiscard]] const std::vector<Sheet>& all() const { return all_; }

  /// Whether one is a patch of the boundary, and not an interface.
  [[nodiscard]] bool is_patch(const Sheet& sheet) const { return sheet.number < first_interface_; }

  /// Calls visit(face) for the faces of one.
  template <class Visit>
  void for_each_face(const Sheet& sheet, const Visit& visit) const {
    if (sheet.number >= first_interface_) {
      for (const BoundaryFace& face :
           survey_.interfaces[static_cast<std::size_t>(sheet.number - first_interface_)].faces)
        visit(face);
      return;
    }
    for (const BoundaryFace& face : survey_.boundary)
      if (number_of(face.patch) == sheet.number) visit(face);
  }

  /// Calls visit(face, number) for the boundary, whose patches alternate, and then for the
  /// interfaces, one after the other.
  template <class Visit>
  static void for_each_face(const Survey& survey, const Visit& visit) {
    for (const BoundaryFace& face : survey.boundary) visit(face, number_of(face.patch));
    std::int32_t number = first_interface(survey);
    for (const Interface& interface : survey.interfaces) {
      for (const BoundaryFace& face : interface.faces) visit(face, number);
      ++number;
    }
  }

 private:
  const Survey& survey_;
  std::int32_t first_interface_;
  std::vector<Sheet> all_;
};

}  // namespace certet::formats
