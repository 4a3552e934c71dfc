import os
from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

_Point = Sequence[float]

version: str

class Options:
    def __init__(self, method: str, threads: int) -> None: ...

class Mesh:
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def positions(self) -> NDArray[np.int32]: ...
    @property
    def tets(self) -> NDArray[np.unsignedinteger[Any]]: ...
    @property
    def labels(self) -> NDArray[np.int32] | None: ...
    @property
    def size(self) -> float: ...
    @property
    def origin(self) -> list[float]: ...
    @property
    def axes(self) -> list[list[float]]: ...
    @property
    def method(self) -> Literal["embedded", "angles", "embedding", "midpoint"]: ...
    @property
    def names(self) -> dict[int, str]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def losses(self) -> list[str]: ...
    @property
    def warp(self) -> dict[str, Any]: ...
    def checksum(self) -> int: ...
    def quality(self) -> dict[str, Any]: ...

class FileMesh:
    @property
    def points(self) -> NDArray[np.float64]: ...
    @property
    def tets(self) -> NDArray[np.uint64]: ...
    @property
    def labels(self) -> NDArray[np.int32] | None: ...
    @property
    def names(self) -> dict[int, str]: ...
    def quality(self) -> dict[str, Any]: ...

def read(file: str | os.PathLike[str]) -> FileMesh: ...
def write(mesh: Mesh | FileMesh, file: str | os.PathLike[str], format: str | None) -> list[str]: ...
def check(mesh: Mesh | FileMesh) -> dict[str, Any]: ...
def interfaces(
    mesh: Mesh | FileMesh,
) -> list[tuple[tuple[int, int], NDArray[np.uint64], float]]: ...
def pieces(mesh: Mesh | FileMesh) -> dict[str, Any]: ...
def voxelise(
    mesh: Mesh | FileMesh,
    size: Sequence[int],
    spacing: _Point,
    origin: _Point,
    direction: Sequence[_Point],
) -> tuple[NDArray[np.int32], list[str]]: ...
def mesh_image(
    array: NDArray[Any],
    spacing: _Point,
    origin: _Point,
    direction: Sequence[_Point],
    labels: Sequence[tuple[int, int]],
    iso: tuple[float, float] | None,
    smooth: float | None,
    merges: Sequence[tuple[int, int, int, str]],
    size: float,
    margin: int,
    options: Options,
) -> Mesh: ...
def mesh_function(
    function: Callable[[NDArray[np.float64]], Any],
    low: _Point,
    high: _Point,
    size: float,
    margin: int,
    options: Options,
) -> Mesh: ...
def mesh_surface(
    points: NDArray[np.float64],
    triangles: NDArray[np.int64],
    size: float,
    margin: int,
    repair: bool,
    options: Options,
) -> Mesh: ...

class Solid: ...

def solid_of_function(
    name: str, function: Callable[[NDArray[np.float64]], Any], low: _Point, high: _Point
) -> Solid: ...
def solid_of_surface(
    name: str, points: NDArray[np.float64], triangles: NDArray[np.int64]
) -> Solid: ...
def mesh_solids(
    solids: Sequence[Solid],
    priority: Sequence[str],
    size: float,
    margin: int,
    repair: bool,
    options: Options,
) -> Mesh: ...
