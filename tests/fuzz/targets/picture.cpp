// What `certet report` and `certet picture` make of a mesh.

#include "certet/page.hpp"
#include "certet/picture.hpp"
#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void picture(Bytes bytes) {
  read_mesh_or_refuse(bytes, [](const certet::FileMesh& mesh, certet::Context&) {
    const certet::Page page = certet::make_page(mesh, {.name = "a <mesh>", .rows = {}, .bounds = {}, .defects = {}});
    if (page.html.find("a <mesh>") != page.html.npos) throw Finding("a name is not quoted");
    certet::draw(mesh, {.width = 48, .height = 24});
    certet::draw(mesh, {.width = 16, .height = 16, .view = certet::PictureView::cut,
                        .color = certet::PictureColor::angle, .axis = 2});
  });
}

}  // namespace fuzz
