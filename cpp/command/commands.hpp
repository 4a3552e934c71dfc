#pragma once
/// \file
/// The subcommands.  Each has a folder of its name; it declares its options on
/// an empty CLI11 app and gives what is to be done once they have been read.

#include <CLI/App.hpp>
#include <array>
#include <functional>
#include <memory>

#include "status.hpp"

namespace certet::command {

/// Carries out a subcommand.  \throws Error.
using Run = std::function<Status()>;

/// A subcommand whose options are one struct: `declare` tells where each is read to, the notes
/// stand at the end of its help.
template <class Options, class CarryOut>
Run subcommand(CLI::App& app, void (*declare)(CLI::App&, Options&), const char* notes,
               const CarryOut& carry_out) {
  const auto options = std::make_shared<Options>();
  declare(app, *options);
  app.footer(notes);
  return [options, carry_out] { return carry_out(*options); };
}

/// From an image, a surface, a volume, a formula or a shape to a mesh file.
Run declare_mesh(CLI::App& app);

struct Together;

/// The same by several processes, which outlive what is returned; the first of them tells of it.
Run declare_shared_mesh(CLI::App& app, const Together& together);

/// From one mesh file to another.
Run declare_convert(CLI::App& app);

/// From a mesh file to an image of labels.
Run declare_voxelise(CLI::App& app);

/// Reads a mesh file and verifies it anew.
Run declare_check(CLI::App& app);

/// Writes the cases by which another implementation can check itself.
Run declare_conformance(CLI::App& app);

/// A web page about a mesh file.
Run declare_report(CLI::App& app);

/// Draws a mesh file into a PNG.
Run declare_picture(CLI::App& app);

struct Subcommand {
  const char* name;
  const char* description;
  std::function<Run(CLI::App&)> declare;
};

/// In the order of the help.
inline const std::array subcommands{
    Subcommand{"mesh", "Mesh an image, a surface, a volume, a formula or a shape", declare_mesh},
    Subcommand{"convert", "Write a mesh file in another format", declare_convert},
    Subcommand{"voxelise", "Make an image of labels of a mesh", declare_voxelise},
    Subcommand{"check", "Verify a mesh anew, from its file alone", declare_check},
    Subcommand{"report", "A page about a mesh, with a view to turn around", declare_report},
    Subcommand{"picture", "Draw a mesh into a PNG", declare_picture},
    Subcommand{"conformance", "Write test cases for other implementations", declare_conformance},
};

}  // namespace certet::command
