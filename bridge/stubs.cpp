/// \file
/// What OCaml calls back: each stub finds its closure and runs it.

#define CAML_NAME_SPACE
#include <caml/callback.h>
#include <caml/fail.h>
#include <caml/memory.h>
#include <caml/mlvalues.h>

#include "closures.hpp"
#include "narrow.hpp"
#include "runtime.hpp"

namespace certified {
namespace {

/// Runs `closure` on the closures of a frame.  Nothing that it throws crosses
/// an OCaml frame: it is put aside, and OCaml is told once every C++ scope is
/// left.
/// \returns whether `result` was set
template <class Closures, class Closure>
bool run(value frame, std::int64_t& result, const Closure& closure) noexcept {
  runtime::Frame& caller = runtime::Frame::of(Long_val(frame));
  try {
    result = closure(*static_cast<const Closures*>(caller.closures()));
    if (result < Min_long || result > Max_long)
      throw Failure(std::to_string(result) + " does not fit in 63 bits");
    return true;
  } catch (...) {
    caller.park(std::current_exception());
    return false;
  }
}

value to_ocaml(bool done, std::int64_t result) {
  if (!done) caml_raise_constant(*caml_named_value("certified.parked"));
  return Val_long(result);
}

Coord3 coord3(value array, std::size_t at) {
  return {narrow(Long_val(Field(array, at))), narrow(Long_val(Field(array, at + 1))),
          narrow(Long_val(Field(array, at + 2)))};
}

}  // namespace
}  // namespace certified

using namespace certified;

extern "C" {

value certified_get_sign(value frame, value vertex) {
  CAMLparam2(frame, vertex);
  std::int64_t result = 0;
  const bool done = run<closures::Stencil>(frame, result, [&](const closures::Stencil& c) {
    return static_cast<std::int64_t>(c.get_sign(Long_val(vertex)));
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_get_intersection(value frame, value a, value b) {
  CAMLparam3(frame, a, b);
  std::int64_t result = 0;
  const bool done = run<closures::Stencil>(frame, result, [&](const closures::Stencil& c) {
    return c.get_intersection(Long_val(a), Long_val(b));
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_get_key(value frame, value a, value b) {
  CAMLparam3(frame, a, b);
  std::int64_t result = 0;
  const bool done = run<closures::Stencil>(frame, result, [&](const closures::Stencil& c) {
    return (*c.get_key)(Long_val(a), Long_val(b));
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_get_material(value frame, value vertex) {
  CAMLparam2(frame, vertex);
  std::int64_t result = 0;
  const bool done =
      run<closures::MaterialStencil>(frame, result, [&](const closures::MaterialStencil& c) {
        return c.get_material(Long_val(vertex)).value_or(-1);
      });
  CAMLreturn(to_ocaml(done, result));
}

value certified_material_intersection(value frame, value a, value b) {
  CAMLparam3(frame, a, b);
  std::int64_t result = 0;
  const bool done =
      run<closures::MaterialStencil>(frame, result, [&](const closures::MaterialStencil& c) {
        return c.get_intersection(Long_val(a), Long_val(b));
      });
  CAMLreturn(to_ocaml(done, result));
}

value certified_neighbor_sign(value frame, value direction) {
  CAMLparam2(frame, direction);
  std::int64_t result = 0;
  const bool done = run<closures::Warp>(frame, result, [&](const closures::Warp& c) {
    return static_cast<std::int64_t>(c.neighbor_sign(Int_val(direction)));
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_neighbor_cut(value frame, value direction) {
  CAMLparam2(frame, direction);
  std::int64_t result = 0;
  const bool done = run<closures::Warp>(
      frame, result, [&](const closures::Warp& c) { return c.cut(Int_val(direction)); });
  CAMLreturn(to_ocaml(done, result));
}

value certified_sign_at_step(value frame, value step) {
  CAMLparam2(frame, step);
  std::int64_t result = 0;
  const bool done = run<closures::Bisect>(frame, result, [&](const closures::Bisect& c) {
    return static_cast<std::int64_t>(c.sign(Long_val(step)));
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_domain_sign(value frame, value point) {
  CAMLparam2(frame, point);
  std::int64_t result = 0;
  const bool done = run<closures::Stuffing>(frame, result, [&](const closures::Stuffing& c) {
    return static_cast<std::int64_t>(c.domain.sign(coord3(point, 0)));
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_domain_cut(value frame, value edge) {
  CAMLparam2(frame, edge);
  std::int64_t result = 0;
  const bool done = run<closures::Stuffing>(frame, result, [&](const closures::Stuffing& c) {
    const Coord3 plus = coord3(edge, 0);
    const Coord3 minus = coord3(edge, 3);
    return c.domain.cut(plus, minus);
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_holds(value frame, value voxel) {
  CAMLparam2(frame, voxel);
  std::int64_t result = 0;
  const bool done = run<closures::Voxels>(frame, result, [&](const closures::Voxels& c) {
    return std::int64_t{c.holds(coord3(voxel, 0)) ? 1 : 0};
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_emit(value frame, value positions) {
  CAMLparam2(frame, positions);
  std::int64_t result = 0;
  const bool done = run<closures::Stuffing>(frame, result, [&](const closures::Stuffing& c) {
    c.out.push_back({coord3(positions, 0), coord3(positions, 3), coord3(positions, 6),
                     coord3(positions, 9)});
    return std::int64_t{0};
  });
  CAMLreturn(to_ocaml(done, result));
}

value certified_domain_material(value frame, value point) {
  CAMLparam2(frame, point);
  std::int64_t result = 0;
  const bool done =
      run<closures::MaterialMesh>(frame, result, [&](const closures::MaterialMesh& c) {
        return c.domain.material(coord3(point, 0));
      });
  CAMLreturn(to_ocaml(done, result));
}

value certified_material_cut(value frame, value edge) {
  CAMLparam2(frame, edge);
  std::int64_t result = 0;
  const bool done =
      run<closures::MaterialMesh>(frame, result, [&](const closures::MaterialMesh& c) {
        const Coord3 higher = coord3(edge, 0);
        const Coord3 lower = coord3(edge, 3);
        return c.domain.cut(higher, lower);
      });
  CAMLreturn(to_ocaml(done, result));
}

value certified_emit_material(value frame, value material, value positions) {
  CAMLparam3(frame, material, positions);
  std::int64_t result = 0;
  const bool done =
      run<closures::MaterialMesh>(frame, result, [&](const closures::MaterialMesh& c) {
        c.out.push_back({Long_val(material),
                         {coord3(positions, 0), coord3(positions, 3), coord3(positions, 6),
                          coord3(positions, 9)}});
        return std::int64_t{0};
      });
  CAMLreturn(to_ocaml(done, result));
}

}  // extern "C"
