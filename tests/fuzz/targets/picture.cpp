// What `certet report` and `certet picture` make of a mesh.

#include "certet/page.hpp"
#include "certet/picture.hpp"
#include "reader.hpp"
#include "targets.hpp"

namespace fuzz {

void picture(Bytes bytes) {
  if (bytes.empty()) return;
  const InputFile file = mesh_file_of(bytes);
  certet::Context context;
  context.threads = 1;
  read_or_refuse([&] {
    const certet::FileMesh mesh = certet::read(file.path(), context);
    const certet::Page page = certet::make_page(mesh, {.name = "a <mesh>", .rows = {}, .bounds = {}, .defects = {}});
    if (page.html.find("a <mesh>") != page.html.npos) throw Finding("a name is not quoted");
    certet::draw(mesh, {.width = 48, .height = 24});
    certet::draw(mesh, {.width = 16, .height = 16, .view = certet::PictureView::cut,
                        .color = certet::PictureColor::angle, .axis = 2});
  });
}

}  // namespace fuzz
