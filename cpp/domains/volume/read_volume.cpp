#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "certet/error.hpp"
#include "domains/refused_file.hpp"
#include "vdb_file.hpp"
#include "volume_state.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

bool is_real(const openvdb::GridBase& grid) {
  return grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>();
}

std::string names_of(const std::vector<openvdb::GridBase::Ptr>& grids) {
  std::string names;
  for (const auto& grid : grids) names += (names.empty() ? "" : ", ") + grid->getName();
  return names;
}

/// By its name, or the one that speaks for itself.
openvdb::GridBase::Ptr choose(const fs::path& file, const openvdb::GridPtrVec& all,
                              const std::string& name) {
  std::vector<openvdb::GridBase::Ptr> real;
  for (const auto& grid : all)
    if (is_real(*grid)) real.push_back(grid);
  if (real.empty()) refuse(file, "has no grid of real numbers");
  if (!name.empty()) {
    for (const auto& grid : real)
      if (grid->getName() == name) return grid;
    refuse(file, "has no grid of real numbers named '" + name + "', but " + names_of(real));
  }
  for (const auto& grid : real)
    if (grid->getGridClass() == openvdb::GRID_LEVEL_SET) return grid;
  if (real.size() > 1) refuse(file, "has several grids, choose one by name: " + names_of(real));
  return real.front();
}

/// The headers first: only the grid that was chosen is read.  Nothing is, before it was
/// looked at.
openvdb::GridBase::Ptr read(const fs::path& file, const std::string& name) {
  VdbFile structure(file);
  openvdb::io::File input(file.string());
  input.open(false);  // what is damaged is to be found out now, not when it is used
  const auto grids = input.readAllGridMetadata();
  const auto chosen = choose(file, *grids, name);
  // Grids of the same name have a number behind it.
  auto at = input.beginName();
  for (const auto& grid : *grids) {
    if (grid == chosen || at == input.endName()) break;
    ++at;
  }
  const std::string unique_name = at == input.endName() ? chosen->getName() : *at;
  structure.check_trees(unique_name);
  return input.readGrid(unique_name);
}

/// Doubles are rounded: the engine asks for signs, at places that are rounded too.
openvdb::FloatGrid::ConstPtr as_floats(const openvdb::GridBase::Ptr& grid) {
  if (const auto floats = openvdb::gridPtrCast<openvdb::FloatGrid>(grid)) return floats;
  const auto doubles = openvdb::gridConstPtrCast<openvdb::DoubleGrid>(grid);
  const auto result = std::make_shared<openvdb::FloatGrid>(
      std::make_shared<openvdb::FloatTree>(doubles->tree()));
  result->setTransform(doubles->transform().copy());
  result->setGridClass(doubles->getGridClass());
  result->setName(doubles->getName());
  return result;
}

}  // namespace

bool can_read_volumes() { return true; }

Volume read_volume(const fs::path& file, const std::string& grid) {
  check_is_file(file);
  openvdb::initialize();
  const auto state = std::make_shared<Volume::State>();
  try {
    state->grid = as_floats(read(file, grid));
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "'" + file.string() + "' needs more memory than there is");
  } catch (const std::exception&) {
    refuse(file, "is not an OpenVDB file, or it is damaged");
  }
  if (!state->grid->transform().isLinear())
    refuse(file, "has a transform that is not affine");
  state->name = file.string();
  return Volume(state);
}

}  // namespace certet
