"""Time and memory per tetrahedron against the size of the mesh, as an SVG."""


def draw(series, file):
    """Raises ImportError without matplotlib."""
    import matplotlib

    matplotlib.use("SVG")
    from matplotlib import pyplot

    matplotlib.rcParams.update({"font.size": 10, "svg.fonttype": "path", "svg.hashsalt": "certet"})
    figure, (above, below) = pyplot.subplots(2, 1, figsize=(7, 6.4), sharex=True,
                                             constrained_layout=True)
    draw_time(above, series)
    draw_memory(below, series)
    below.set_xscale("log")
    below.set_xlabel("size of the mesh (tetrahedra)")
    for axes in (above, below):
        axes.grid(True, which="major", color="0.88")
        axes.set_ylim(bottom=0)
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(frameon=False)
    figure.savefig(file)
    pyplot.close(figure)


def per_tet(runs, key, scale=1):
    return [run["tets"] for run in runs], [run[key] * scale / run["tets"] for run in runs]


def draw_time(axes, series):
    for threads, color in ((1, "tab:blue"), (2, "tab:orange")):
        runs = [run for run in series if run["threads"] == threads]
        if runs:
            axes.plot(*per_tet(runs, "seconds", 1e9), "o-", color=color,
                      label=f"engine, {threads} thread{'s' * (threads > 1)}")
    runs = [run for run in series if run["threads"] == 1]
    axes.plot(*per_tet(runs, "copy_warm_seconds", 1e9), "s--", color="0.45",
              label="memcpy of the mesh, warm")
    axes.set_title("Torus: from sampling to the mesh in memory", loc="left")
    axes.set_ylabel("time (ns per tetrahedron)")


def draw_memory(axes, series):
    runs = [run for run in series if "peak_bytes" in run]
    axes.plot(*per_tet(runs, "peak_bytes"), "o-", color="tab:blue",
              label="peak of the process, 1 thread")
    axes.plot(*per_tet(runs, "mesh_bytes"), "s--", color="0.45", label="the mesh itself")
    axes.set_ylabel("memory (bytes per tetrahedron)")
