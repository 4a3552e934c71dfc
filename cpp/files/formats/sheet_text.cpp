#include "sheet_text.hpp"

#include "line.hpp"
#include "sheets.hpp"

namespace certet::formats {

SheetText::SheetText(const Survey& survey, NameRule rule)
    : faces(face_count(survey)), regions(survey.regions.size()) {
  const Sheets all(survey, rule);
  sheets = all.all().size();
  for (const Sheet& sheet : all.all()) {
    number_digits += sheet.faces * digits_of(sheet.number);
    sheet_names += sheet.name.size();
  }
  for (const Region& region : survey.regions)
    label_digits += region.tets * digits_of(region.label);
  for (const std::string& name : names_of(survey.regions, rule)) region_names += name.size();
}

}  // namespace certet::formats
