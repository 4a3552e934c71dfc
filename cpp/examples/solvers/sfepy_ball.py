# For sfepy-run simple: -Δu = 1 in a ball, u = 0 around it: certet mesh --shape sphere:1 --size 0.3 -o ball.bdf
filename_mesh = "ball.bdf"
regions = {"ball": "all", "around": ("vertices of surface", "facet")}
fields = {"temperature": ("real", 1, "ball", 2)}
variables = {"u": ("unknown field", "temperature", 0), "v": ("test field", "temperature", "u")}
ebcs = {"cold": ("around", {"u.0": 0.0})}
integrals = {"i": 4}
materials = {"heat": ({"k": 1.0, "f": 1.0},)}
equations = {"heat": "dw_laplace.i.ball(heat.k, v, u) = dw_integrate.i.ball(heat.f, v)"}
solvers = {"direct": ("ls.scipy_direct", {}), "newton": ("nls.newton", {"i_max": 1})}

def post_process_hook(out, problem, state, extend=False):
    print("u in the middle is", state().max(), "and of a true ball 1/6")
    return out
options = {"post_process_hook": "post_process_hook"}
